// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/chart/chart_lettering.h"
#include "render/chart/plot_area.h"

namespace hydroscope {

/// Names of the lines right across the plot.
void draw_mark_labels(Canvas& canvas, const LineChart& chart, const ChartLayout& layout, const AxisScale& x,
                      const AxisScale& y, const Theme& colours);
/// What failed: crosses with their names above the plot.
void draw_failure_strip(Canvas& canvas, const LineChart& chart, const ChartLayout& layout, const AxisScale& x,
                        const Theme& colours, Rgb ground);
/// The legend in the corner where the fewest points are.
void draw_inside_legend(Canvas& canvas, const ChartLayout& layout, const PlotArea& area,
                        const Theme& colours);

/// `a` moved towards `b` by a share of 0..1.
Rgb mix_colours(Rgb a, Rgb b, double share);

}  // namespace hydroscope
