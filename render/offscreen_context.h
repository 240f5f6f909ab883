// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "render/image/image.h"

class vtkRenderWindow;

namespace hydroscope {

/// Who draws: as the GL library names itself.
struct RendererInfo {
  std::string renderer;  ///< GL_RENDERER
  std::string version;   ///< GL_VERSION
};

/// A window without a screen: VTK draws through OSMesa into memory. Belongs to
/// the thread that makes it; every call and the destruction happen there.
class OffscreenContext {
 public:
  struct Options {
    int width = 1280;            ///< [px]
    int height = 720;            ///< [px]
    int rasteriser_threads = 1;  ///< of the whole process: only the first context's value counts
  };

  /// Throws EnvironmentError when libOSMesa is missing or broken, has no core
  /// profile 3.2, is a renderer that we do not know, or fails the self-test.
  explicit OffscreenContext(const Options& options);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  vtkRenderWindow& window();
  /// Of the next pictures [px].
  void resize(int width, int height);
  const RendererInfo& info() const;

  /// Draws the window's renderers and reads the picture back, `reduction` times
  /// smaller each way. Throws EnvironmentError when VTK reported an error on the way.
  Image draw(int reduction = 1);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Draws a known picture in a fresh context and names the renderer, for
/// logs; throws EnvironmentError as the context does. As the first context of a process it
/// decides on the rasteriser's threads.
std::string describe_renderer(int rasteriser_threads = 1);

/// Whether pictures of this GL_RENDERER can be trusted: softpipe, for one,
/// silently leaves out colours of cells.
bool is_trusted_renderer(const std::string& gl_renderer);

}  // namespace hydroscope
