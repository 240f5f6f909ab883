// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/frame_service.h"
#include "render/live/live_painter.h"

namespace hydroscope {
namespace {

class ScenePainter : public PicturePainter {
 public:
  explicit ScenePainter(std::shared_ptr<const Snapshot> first) : painter_(std::move(first)) {}

  std::string renderer() const override { return painter_.info().renderer; }
  PaintedFrame paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot) override {
    Image image = painter_.paint(view, snapshot);
    return {std::move(image), painter_.last_range()};
  }

 private:
  LivePainter painter_;
};

}  // namespace

PicturePainterFactory make_live_painter(std::shared_ptr<const Snapshot> first) {
  return [first = std::move(first)] { return std::make_unique<ScenePainter>(first); };
}

}  // namespace hydroscope
