// SPDX-License-Identifier: GPL-3.0-or-later
// What a draw list gets on top for one picture: clip plane and marks.
#include <algorithm>
#include <cmath>

#include "render/shape/rings.h"
#include "render/shape/wall_section.h"
#include "render/views.h"

namespace hydroscope {
namespace {

constexpr Rgb kMark{255, 255, 255}, kMarkBorder{16, 18, 22};
constexpr double kRing = 9.4;  // radius [px] in a picture of 720 rows

/// Before the translucent shapes, which would hide what is drawn after them.
void insert_opaque(DrawList& list, SurfaceItem item) {
  const auto place = std::find_if(list.surfaces.begin(), list.surfaces.end(),
                                  [](const SurfaceItem& other) { return other.opacity < 1.0; });
  list.surfaces.insert(place, std::move(item));
}

}  // namespace

void Views::add_clip(DrawList& list, const std::string& view, const Snapshot& snapshot,
                     const Plane& plane) const {
  list.clip = plane;
  // Just behind the plane: the meshes' own edges on a plane of symmetry would only graze it.
  const Plane behind{plane.point - 1e-4 * bounds_.diagonal() * plane.normal, plane.normal};
  if (view != "tool-normals") {
    WallSection section = calc_wall_section(snapshot, sheet_.reflections(), plane);
    insert_opaque(list, {.surface = std::make_shared<const Surface>(std::move(section.area)),
                         .colour = theme_->section,
                         .is_clipped = false});
    list.lines.push_back({.lines = std::make_shared<const LineSet>(std::move(section.borders)),
                          .colour = theme_->line,
                          .width = 1.3,
                          .is_clipped = false});
  }
  const bool has_tools = view == "tool-normals" || options_.tool_opacity > 0.0;
  for (std::size_t i = 0; i < tools_.size() && has_tools; ++i) {
    const Vec3& translation = snapshot.tool_translation[i];
    if (!translation.allFinite()) continue;
    list.lines.push_back(
        {.lines = std::make_shared<const LineSet>(tools_[i].shape.make_section(translation, behind)),
         .colour = theme_->tool_line,
         .width = 2.0,
         .is_cut = options_.is_tool_cut,
         .is_clipped = false});
  }
}

void Views::add_marks(DrawList& list, const std::vector<int>& nodes, const Snapshot& snapshot,
                      const Vec3& towards_viewer, double pixel) const {
  std::vector<Vec3> centres;
  for (const int node : nodes)
    for (const Reflection& reflection : sheet_.reflections()) {
      const auto i = static_cast<std::size_t>(node);
      const Vec3 director = reflection.vector(snapshot.directors[i]);
      const double side = director.dot(towards_viewer) >= 0.0 ? 0.5 : -0.5;
      const Vec3 place = reflection.point(snapshot.points[i]) + side * snapshot.thickness[i] * director;
      const double slope = std::abs(director.dot(towards_viewer));
      if (list.clip && list.clip->normal.dot(place - list.clip->point) > 0.0) continue;
      // Towards the viewer, so that a wall seen at a slant does not hide half of a ring.
      const double lift = std::min(std::sqrt(1.0 - std::min(slope * slope, 1.0)) / std::max(slope, 0.1), 2.5);
      centres.push_back(place + kRing * (0.3 + lift) * pixel * towards_viewer);
    }
  if (centres.empty()) return;
  const auto add = [&](double inner, double outer, Rgb colour) {
    insert_opaque(list, {.surface = std::make_shared<const Surface>(
                             make_rings(centres, inner * pixel, outer * pixel, towards_viewer)),
                         .colour = colour,
                         .is_clipped = false});
  };
  add(3.6, 5.0, kMarkBorder);
  add(5.0, 8.0, kMark);
  add(8.0, kRing, kMarkBorder);
}

}  // namespace hydroscope
