// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/chart/line_chart.h"
#include "tests/stability/gallery.h"

namespace hydroscope::stability {

LineChart make_chart(const std::string& title, const std::string& x, const std::string& y);
ChartSeries make_series(const std::string& name, const std::vector<double>& x, const std::vector<double>& y);
/// A quantity over another, from the first increment after `from` [s].
ChartSeries make_series(const std::string& name, const History& history, const std::string& x,
                        const std::string& y, double from = 0.0);

// Charts of docs/stability.md, by the names of their scenes; each runs what it needs.
LineChart chart_coarse_drum();
LineChart chart_facet_noise();
LineChart chart_force_loss();
LineChart chart_one_step_behind();
LineChart chart_penalty();
LineChart chart_pressure_maximum();
LineChart chart_reversal();
LineChart chart_sharp_corner();
LineChart chart_thick_shell();
LineChart chart_wrinkling();

}  // namespace hydroscope::stability
