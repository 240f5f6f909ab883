// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "render/offscreen_context.h"

namespace hydroscope {

/// Which pixels a machine makes of the same shapes: the name of the renderer says too
/// little (llvmpipe's colours differ by a few levels between makes of processor), so that a
/// probe picture with light, colour map, lines and a translucent wall is drawn and hashed, and lettering on
/// its own.
struct RendererFingerprint {
  RendererInfo renderer;
  std::string font;
  std::string probe;            ///< hash of the probe picture, 16 hexadecimal digits
  std::string lettering_probe;  ///< hash of a line of text

  /// Shapes can be compared pixel by pixel.
  bool is_same(const RendererFingerprint& other) const { return probe == other.probe; }
  /// Text can be compared at all.
  bool has_same_lettering(const RendererFingerprint& other) const {
    return lettering_probe == other.lettering_probe;
  }
};

/// Throws EnvironmentError when nothing can be drawn.
RendererFingerprint calc_renderer_fingerprint(int rasteriser_threads = 1);

}  // namespace hydroscope
