// SPDX-License-Identifier: GPL-3.0-or-later
// The views of how contact ends: detachment, chatter and release-margin.
#include <algorithm>
#include <cmath>

#include "render/shape/markers.h"
#include "render/view_text.h"
#include "render/views.h"

namespace hydroscope {
namespace {

constexpr Rgb kTouching{188, 216, 240};
constexpr Rgb kNearest{204, 60, 150};
constexpr std::size_t kMostMarkers = 200;

std::shared_ptr<const Surface> share(Surface surface) {
  return std::make_shared<const Surface>(std::move(surface));
}

std::string label(const char* words, long count) { return std::string(words) + "  " + std::to_string(count); }

Rgb toggle_colour(std::size_t toggle_class) {
  if (toggle_class == 0) return kNoValueColour;
  const double s = static_cast<double>(toggle_class - 1) / (kToggleClasses - 2);
  return map_colour(colour_table(MapName::kEmber), 0.15 + 0.85 * s, 0.0, 1.0);
}

void note_unknown(DrawList& list, const ContactLife& life) {
  if (life.is_known) return;
  list.legend.notes.push_back("not known: the states");
  list.legend.notes.push_back("are of an older version");
}

}  // namespace

Vec3 Views::calc_outer_place(const Snapshot& snapshot, int node, double height) {
  const auto i = static_cast<std::size_t>(node);
  // The tool's normal points away from the tool.
  const double side = snapshot.tool_normal[i].dot(snapshot.directors[i]) > 0.0 ? -1.0 : 1.0;
  return snapshot.points[i] + (0.5 * snapshot.thickness[i] + height) * side * snapshot.directors[i];
}

void Views::draw_detachment(DrawList& list, const Snapshot& snapshot, const ContactLife& life,
                            const Range& range) const {
  list.legend.heading = find_view_text("detachment").heading;
  const ColourTable& table = colour_table(MapName::kSea);
  const Rgb now = class_colour(ContactClass::kDetachedNow);
  NodePaint paint;
  for (std::size_t i = 0; i < life.classes.size(); ++i) {
    switch (life.classes[i]) {
      case LifeClass::kNeverTouching:
        paint.colours.push_back(kNoValueColour);
        break;
      case LifeClass::kTouching:
        paint.colours.push_back(kTouching);
        break;
      case LifeClass::kLetGo:
        paint.colours.push_back(map_colour(table, life.age[i], range.low, range.high));
        break;
      case LifeClass::kLetGoNow:
        paint.colours.push_back(now);
        break;
    }
  }
  list.legend.bars.push_back({find_view_text("detachment").quantity, &table, range});
  const auto count = [&](LifeClass c) { return life.counts[static_cast<std::size_t>(c)]; };
  list.legend.swatches = {
      {now, label("let go in this frame", count(LifeClass::kLetGoNow))},
      {kTouching, label("touching", count(LifeClass::kTouching))},
      {kNoValueColour, label(life.is_known ? "has not touched" : "free", count(LifeClass::kNeverTouching))}};
  list.legend.notes.push_back(std::to_string(count(LifeClass::kLetGo)) + " nodes let go before");
  note_unknown(list, life);
  add_wall(list, snapshot, paint);
  add_tools(list);
}

void Views::draw_chatter(DrawList& list, const Snapshot& snapshot, const ContactLife& life) const {
  list.legend.heading = find_view_text("chatter").heading;
  constexpr std::array<const char*, kToggleClasses> kNames{"never",      "once",         "twice",
                                                           "3, 4 times", "5 to 8 times", "more often"};
  NodePaint paint;
  for (std::size_t i = 0; i < snapshot.points.size(); ++i)
    paint.colours.push_back(
        toggle_colour(life.is_known ? static_cast<std::size_t>(find_toggle_class(snapshot.toggles[i])) : 0U));
  for (std::size_t c = 0; c < kToggleClasses; ++c)
    list.legend.swatches.push_back({toggle_colour(c), label(kNames[c], life.toggle_counts[c])});
  list.legend.notes = {"lettings go and comings", "back, by nodes;",
                       std::to_string(life.toggles) + " in all nodes"};
  note_unknown(list, life);
  add_wall(list, snapshot, paint);
  add_tools(list);
}

void Views::draw_release_margin(DrawList& list, const Snapshot& snapshot, const ContactLife& life,
                                const Range& range) const {
  list.legend.heading = find_view_text("release-margin").heading;
  const ColourTable& table = colour_table(MapName::kTide);
  list.legend.bars.push_back({find_view_text("release-margin").quantity, &table, range});
  const auto without =
      std::count_if(life.margin.begin(), life.margin.end(), [](double m) { return std::isnan(m); });
  if (without > 0) list.legend.swatches.push_back({kNoValueColour, label("does not touch", without)});
  list.legend.notes = {"0: may let go; 1: the whole", "share p A of the fluid is left"};
  note_unknown(list, life);
  add_wall(list, snapshot, NodePaint{.values = life.margin, .classes = {}});
  list.surfaces.back().table = &table;
  list.surfaces.back().range = range;
  add_tools(list);
}

void Views::add_nearest(DrawList& list, const Snapshot& snapshot, const ContactLife& life,
                        double picture_scale) const {
  if (life.nearest.empty()) return;
  const double radius = 0.012 * picture_scale;            // a ball of 9 pixels in a picture of 720 rows
  std::vector<char> is_drawn(snapshot.points.size(), 0);  // a close-up leaves out most of the sheet
  for (const auto& quad : snapshot.model->quads)
    for (const int node : quad) is_drawn[static_cast<std::size_t>(node)] = 1;
  std::vector<Vec3> places;
  for (const int node : life.nearest)
    if (is_drawn[static_cast<std::size_t>(node)] != 0 && places.size() < kMostMarkers)
      places.push_back(calc_outer_place(snapshot, node, 0.0));
  list.surfaces.push_back({.surface = share(make_markers(places, radius, sheet_.reflections())),
                           .colour = kNearest,
                           .faces = SurfaceItem::Faces::kFront});
  const double least = life.margin[static_cast<std::size_t>(life.nearest.front())];
  list.legend.swatches.push_back(
      {kNearest, label(life.near_release > 0 ? "near release" : "nearest to release",
                       static_cast<long>(life.nearest.size()))});
  const std::string left =
      least >= 0.0 ? format_number(100.0 * least) + " % left" : std::string("past its threshold");
  list.legend.notes.push_back("nearest: node " + std::to_string(life.nearest.front()) + ", " + left);
}

}  // namespace hydroscope
