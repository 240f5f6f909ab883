// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/wall_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/shape/reflection.h"

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Depth of a triangle under a pixel; NaN beside it. `inside`: least share of each corner.
double find_depth(const std::array<Vec3, 3>& t, double x, double y, double inside) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[0];
  const double area = a.x() * b.y() - a.y() * b.x();
  if (area == 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double px = x - t[0].x(), py = y - t[0].y();
  const double s = (px * b.y() - py * b.x()) / area, r = (a.x() * py - a.y() * px) / area;
  if (s < inside || r < inside || 1.0 - s - r < inside) return std::numeric_limits<double>::quiet_NaN();
  return t[0].z() + s * a.z() + r * b.z();
}

/// Triangles by the cells of a grid over a rectangle, so that each node asks a few of them.
class Cells {
 public:
  Cells(double x0, double y0, double x1, double y1)
      : x0_(x0), y0_(y0), dx_(std::max(x1 - x0, 1e-9) / kCells), dy_(std::max(y1 - y0, 1e-9) / kCells) {
    lists_.resize(at(kCells * kCells));
  }

  void add(const std::array<Vec3, 3>& x) {
    const auto [left, right] = std::minmax({x[0].x(), x[1].x(), x[2].x()});
    const auto [top, bottom] = std::minmax({x[0].y(), x[1].y(), x[2].y()});
    const int i0 = column(left), i1 = column(right), j0 = row(top), j1 = row(bottom);
    if (i1 < 0 || j1 < 0 || i0 >= kCells || j0 >= kCells) return;
    for (int j = std::max(j0, 0); j <= std::min(j1, kCells - 1); ++j)
      for (int i = std::max(i0, 0); i <= std::min(i1, kCells - 1); ++i)
        lists_[at(j * kCells + i)].push_back(static_cast<int>(triangles_.size()));
    triangles_.push_back(x);
  }

  template <typename Visitor>
  bool any(double x, double y, Visitor is_it) const {
    const int i = std::clamp(column(x), 0, kCells - 1), j = std::clamp(row(y), 0, kCells - 1);
    const auto& list = lists_[at(j * kCells + i)];
    return std::any_of(list.begin(), list.end(), [&](int t) { return is_it(triangles_[at(t)]); });
  }

 private:
  static constexpr int kCells = 64;
  static int bounded(double cell) {
    return static_cast<int>(std::floor(std::clamp(cell, -1.0, kCells + 1.0)));
  }
  int column(double x) const { return bounded((x - x0_) / dx_); }
  int row(double y) const { return bounded((y - y0_) / dy_); }

  double x0_, y0_, dx_, dy_;
  std::vector<std::vector<int>> lists_;
  std::vector<std::array<Vec3, 3>> triangles_;
};

}  // namespace

WallRays::WallRays(const LiveView& view, const Snapshot& first, const Snapshot& snapshot)
    : snapshot_(snapshot),
      projection_(view, calc_live_camera(view, calc_live_bounds(first, view.is_mirrored))),
      clip_(calc_clip_plane(view, calc_live_bounds(first, view.is_mirrored))),
      reflections_(calc_reflections(view.is_mirrored ? snapshot.model->mirrors : std::vector<Plane>{})) {
  check_snapshot(snapshot);
  corners_.reserve(2 * reflections_.size() * snapshot.points.size());
  for (const double side : {0.5, -0.5})
    for (const Reflection& reflection : reflections_)
      for (std::size_t i = 0; i < snapshot.points.size(); ++i)
        corners_.push_back(projection_.project(
            reflection.point(snapshot.points[i] + side * snapshot.thickness[i] * snapshot.directors[i])));
}

const Vec3& WallRays::corner(int face, int copy, int node) const {
  return corners_[(at(face) * reflections_.size() + at(copy)) * snapshot_.points.size() + at(node)];
}

int WallRays::find_face(int copy, int node) const {
  // The face that is nearer to the viewer.
  return corner(0, copy, node).z() >= corner(1, copy, node).z() ? 0 : 1;
}

WallRays::Triangle WallRays::triangle(int face, int copy, int quad, int half) const {
  const auto& q = snapshot_.model->quads[at(quad)];
  return {
      {corner(face, copy, q[0]), corner(face, copy, q[at(1 + half)]), corner(face, copy, q[at(2 + half)])},
      quad,
      copy,
      face};
}

bool WallRays::is_clipped(const Vec3& p) const {
  return clip_ && clip_->normal.dot(projection_.place(p.x(), p.y(), p.z()) - clip_->point) > 0.0;
}

template <typename Visitor>
void WallRays::visit_triangles(Visitor visit) const {
  const int quads = static_cast<int>(snapshot_.model->quads.size());
  for (const int face : {0, 1})
    for (int copy = 0; copy < copies(); ++copy)
      for (int quad = 0; quad < quads; ++quad)
        for (const int half : {0, 1}) visit(triangle(face, copy, quad, half));
}

int WallRays::find_nearest_node(const Triangle& hit, const Vec3& projected) const {
  const Vec3 place = projection_.place(projected.x(), projected.y(), projected.z());
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int node : snapshot_.model->quads[at(hit.quad)]) {
    const Vec3& x = corner(hit.face, hit.copy, node);
    const double distance = (projection_.place(x.x(), x.y(), x.z()) - place).norm();
    if (distance < least) nearest = node;
    least = std::min(least, distance);
  }
  return nearest;
}

std::optional<Pick> WallRays::find_hit(double x, double y) const {
  std::optional<Pick> pick;
  double nearest = -std::numeric_limits<double>::infinity();
  visit_triangles([&](const Triangle& t) {
    const double depth = find_depth(t.x, x, y, -1e-9);
    if (!(depth > nearest) || is_clipped({x, y, depth})) return;
    nearest = depth;
    const Vec3 projected(x, y, depth);
    pick = Pick{find_nearest_node(t, projected), t.quad, projection_.place(x, y, depth), t.copy};
  });
  return pick;
}

std::vector<int> WallRays::find_seen(double x0, double y0, double x1, double y1) const {
  x0 = std::max(x0, 0.0);
  y0 = std::max(y0, 0.0);
  x1 = std::min(x1, projection_.width);
  y1 = std::min(y1, projection_.height);
  std::vector<int> seen;
  if (!(x0 <= x1 && y0 <= y1)) return seen;
  Cells cells(x0, y0, x1, y1);
  std::vector<char> is_drawn(snapshot_.points.size(), 0);
  for (const auto& quad : snapshot_.model->quads)
    for (const int node : quad) is_drawn[at(node)] = 1;
  visit_triangles([&](const Triangle& t) { cells.add(t.x); });
  const auto is_seen = [&](int copy, int node) {
    const Vec3 p = find_place(copy, node);
    if (p.x() < x0 || p.x() > x1 || p.y() < y0 || p.y() > y1 || is_clipped(p)) return false;
    const double above = p.z() + 0.02 * snapshot_.thickness[at(node)];
    return !cells.any(p.x(), p.y(), [&](const std::array<Vec3, 3>& t) {
      const double depth = find_depth(t, p.x(), p.y(), -1e-9);
      return depth > above && !is_clipped({p.x(), p.y(), depth});
    });
  };
  const int nodes = static_cast<int>(snapshot_.points.size());
  for (int node = 0; node < nodes; ++node)
    for (int copy = 0; copy < copies() && is_drawn[at(node)] != 0; ++copy)
      if (is_seen(copy, node)) {
        seen.push_back(node);
        break;
      }
  return seen;
}

}  // namespace hydroscope
