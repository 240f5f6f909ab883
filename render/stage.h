// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "render/draw_list.h"
#include "render/image/image.h"
#include "render/offscreen_context.h"

namespace hydroscope {

/// Draws draw lists with VTK. Belongs to the thread that makes it. Holds what one
/// view has sent to the renderer; one stage serves several views by `slot`.
class Stage {
 public:
  struct Options {
    int width = 1280;            ///< [px]
    int height = 720;            ///< [px]
    int smoothing = 2;           ///< drawn larger by this factor each way, then averaged; 1 = rough edges
    bool is_flat = false;        ///< no light, plain ground: colours come out exactly
    int rasteriser_threads = 1;  ///< see OffscreenContext
    /// Shapes are sent whole, so that another direction needs no sending. Otherwise what the
    /// viewer sees of them is sent: cheaper where most pictures show other shapes.
    bool is_turned_often = false;
  };
  explicit Stage(const Options& options);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const RendererInfo& info() const;

  /// Pictures of another size from now on; what has been sent to the renderer stays there.
  void resize(int width, int height, int smoothing);

  /// Picture of the shapes alone, without text.
  Image draw(const DrawList& list, const CameraPose& camera, const Theme& theme, int slot = 0);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydroscope
