// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "render/offscreen_context.h"

namespace hydroscope {

/// Which pixels a machine makes of the same shapes: the name of the renderer says too
/// little (llvmpipe's colours differ by a few levels between makes of processor), so that a
/// probe picture with light, colour map, lines, a translucent wall and lettering is drawn and hashed.
struct RendererFingerprint {
  RendererInfo renderer;
  std::string font;
  std::string probe;  ///< hash of the probe picture, 16 hexadecimal digits

  /// Pictures can be compared pixel by pixel.
  bool is_same(const RendererFingerprint& other) const { return probe == other.probe; }
};

/// Throws EnvironmentError when nothing can be drawn.
RendererFingerprint calc_renderer_fingerprint();

}  // namespace hydroscope
