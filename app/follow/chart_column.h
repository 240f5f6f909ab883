// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/follow/patch_story.h"

namespace hydroscope {

/// What the charts say beside their curves.
struct ChartMoments {
  double now = 0.0;     ///< time of the frame [s]: a line through all charts
  double let_go = 0.0;  ///< when the patch began to let go [s]: a broken line
};

/// The charts of a patch, one above the other, with the nodes' names and colours on top. Belongs
/// to one thread. Draws the curves once; a frame adds its moment.
class ChartColumn {
 public:
  ChartColumn(const Ledger& ledger, const std::vector<NodeStory>& stories, const LineChartOptions& options);

  Image draw(const ChartMoments& moments) const;
  /// Where the curves stand in it, from above.
  const std::vector<ChartPlace>& places() const { return places_; }
  /// Column of pixels of a time in a chart.
  static double find_column(const ChartPlace& place, double time);

 private:
  void draw_head(const std::vector<NodeStory>& stories);

  std::string theme_;
  Image curves_;
  int head_ = 0;  ///< height of the names [px]
  std::vector<ChartPlace> places_;
};

constexpr Rgb kTimeLine{40, 48, 60};

/// Copies a picture into a larger one.
void lay_picture(Image& frame, const Image& piece, int left, int top);

}  // namespace hydroscope
