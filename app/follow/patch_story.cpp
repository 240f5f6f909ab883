// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/follow/patch_story.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hydroscope {
namespace {

/// Values by time; at one time the last one counts.
class Timeline {
 public:
  void add(double time, double value) { values_[time] = value; }
  void write(std::vector<double>& times, std::vector<double>& values) const {
    for (const auto& [time, value] : values_) {
      times.push_back(time);
      values.push_back(value);
    }
  }

 private:
  std::map<double, double> values_;
};

/// Process time of the increment before; its own when there is none.
double find_time_before(const ContactLog& log, const ContactEvent& event) {
  const auto here = log.increments.find(event.increment);
  if (here == log.increments.begin() || here == log.increments.end()) return event.time;
  return std::prev(here)->second.time;
}

bool ends_contact(EventKind kind) { return kind == EventKind::kDetach; }

bool begins_contact(EventKind kind) { return kind == EventKind::kTouch || kind == EventKind::kRetouch; }

// Charts are a quarter of a frame high: lines and markers of a few pixels.
constexpr double kLineWidth = 7.0, kMarkerSize = 24.0;

LineChart make_chart(const std::string& title, double end) {
  LineChart chart;
  chart.y.title = title;
  chart.x.low = 0.0;
  chart.x.high = end;
  chart.legend = LineChart::Legend::kNone;
  return chart;
}

}  // namespace

const char* to_string(Phase phase) {
  return phase == Phase::kBefore ? "before" : phase == Phase::kAt ? "at" : "after";
}

std::vector<PatchFrame> find_patch_frames(const Ledger& ledger, const Patch& patch, int around) {
  const auto& states = ledger.sheet.states;
  std::vector<PatchFrame> before, frames, after;
  bool has_seen_all = false;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i].increment < patch.first_increment) {
      before.push_back({i, Phase::kBefore});
    } else if (!has_seen_all) {
      frames.push_back({i, Phase::kAt});
      has_seen_all = states[i].increment >= patch.last_increment;
    } else if (static_cast<int>(after.size()) < around) {
      after.push_back({i, Phase::kAfter});
    }
  }
  const auto count = std::min(before.size(), static_cast<std::size_t>(around));
  frames.insert(frames.begin(), before.end() - static_cast<std::ptrdiff_t>(count), before.end());
  frames.insert(frames.end(), after.begin(), after.end());
  return frames;
}

std::vector<int> find_patch_nodes(const Ledger& ledger, const Patch& patch) {
  std::set<int> nodes;
  for (const std::size_t i : patch.episodes) nodes.insert(ledger.episodes[i].node);
  return {nodes.begin(), nodes.end()};
}

int find_most_pulled(const Ledger& ledger, const Patch& patch) {
  int node = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : patch.episodes) {
    const Episode& episode = ledger.episodes[i];
    const ContactEvent& event = ledger.event(*episode.let_go);
    const double at_release = episode.figures.release.force;
    const double force = std::isnan(at_release) ? event.force_before : at_release;
    const double pull = episode.figures.fluid_share > 0.0 ? force / episode.figures.fluid_share : force;
    if (node >= 0 && !(pull < least)) continue;
    node = episode.node;
    least = pull;
  }
  return node;
}

NodeStory make_node_story(const Ledger& ledger, int node) {
  NodeStory story;
  story.node = node;
  const auto n = static_cast<std::size_t>(node);
  Timeline force, gap, contact;
  for (const SheetState& state : ledger.sheet.states) {
    force.add(state.time, state.normal_force[n]);
    gap.add(state.time, state.gap[n]);
    contact.add(state.time, state.contact_pressure[n]);
  }
  for (const ContactEvent& event : ledger.log.events) {
    if (event.node != node) continue;
    if (ends_contact(event.kind)) {
      force.add(find_time_before(ledger.log, event), event.force_before);
      force.add(event.time, event.force_after);  // 0, or what released it
      force.add(event.time * (1.0 + 1e-12), 0.0);
      gap.add(event.time, event.gap);
    } else if (begins_contact(event.kind)) {
      force.add(event.time, event.force_after);
      gap.add(event.time, event.gap);
    }
  }
  force.write(story.force_times, story.forces);
  gap.write(story.gap_times, story.gaps);
  contact.write(story.contact_times, story.pressures);
  return story;
}

Rgb find_node_colour(std::size_t index, const std::string& theme) {
  std::vector<Rgb> colours;
  for (const Rgb& colour : chart_colours())
    if (colour != kReleaseLine) colours.push_back(colour);
  Rgb colour = colours[index % colours.size()];
  if (theme == "dark")  // bright enough for a dark ground
    for (auto& channel : colour) channel = static_cast<std::uint8_t>(channel + (255 - channel) * 2 / 5);
  return colour;
}

std::vector<LineChart> make_patch_charts(const Ledger& ledger, const std::vector<NodeStory>& stories,
                                         const std::string& theme) {
  ChartSeries fluid;
  fluid.colour = Rgb{90, 100, 114};
  fluid.line_width = kLineWidth;
  for (const auto& [increment, row] : ledger.log.increments) {
    fluid.x.push_back(row.time);
    fluid.y.push_back(row.pressure);
  }
  const double end = fluid.x.empty() ? 1.0 : fluid.x.back();
  std::vector<LineChart> charts = {make_chart("normal force [N]", end), make_chart("gap [mm]", end),
                                   make_chart("contact [MPa]", end), make_chart("fluid [MPa]", end)};
  for (std::size_t k = 0; k < stories.size(); ++k) {
    const NodeStory& story = stories[k];
    ChartSeries series;
    series.colour = find_node_colour(k, theme);
    series.line_width = kLineWidth;
    series.marker = ChartMarker::kCircle;
    series.marker_size = kMarkerSize;
    const auto add = [&](LineChart& chart, const std::vector<double>& x, const std::vector<double>& y) {
      series.x = x;
      series.y = y;
      chart.series.push_back(series);
    };
    add(charts[0], story.force_times, story.forces);
    add(charts[1], story.gap_times, story.gaps);
    add(charts[2], story.contact_times, story.pressures);
  }
  charts[3].series.push_back(fluid);
  if (std::all_of(fluid.y.begin(), fluid.y.end(), [](double p) { return p == 0.0; }))
    charts[3].y = {.title = charts[3].y.title, .low = 0.0, .high = 1.0};
  charts.back().x.title = "time [s]";
  return charts;
}

}  // namespace hydroscope
