// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/sheet_shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "render/image/colour_map.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Builds the wall of the modelled piece, face by face.
class WallBuilder {
 public:
  WallBuilder(const Snapshot& snapshot, const std::vector<Vec3>& normals, const NodePaint* paint)
      : snapshot_(snapshot), normals_(normals), paint_(paint) {}

  void add_face(const std::vector<std::array<int, 4>>& quads, double side);
  void add_coarse_face(const std::vector<std::array<int, 4>>& quads, const QuadBlocks& blocks, double side);
  void add_rim_quad(int a, int b);
  Surface take() { return std::move(surface_); }

 private:
  Vec3 face_point(int node, double side) const {
    return snapshot_.points[at(node)] +
           0.5 * side * snapshot_.thickness[at(node)] * snapshot_.directors[at(node)];
  }
  int kind(int node) const {
    if (paint_ == nullptr) return 0;
    if (!paint_->colours.empty()) {
      const Rgb& c = paint_->colours[at(node)];
      return (c[0] << 16) + (c[1] << 8) + c[2];
    }
    if (!paint_->classes.empty()) return static_cast<int>(paint_->classes[at(node)]);
    return std::isfinite(paint_->values[at(node)]) ? 0 : 1;
  }
  int add_vertex(const Vec3& x, const Vec3& n, int painted_as);
  int face_vertex(int node, double side);
  void add_quad(std::array<int, 4> corners, double side) {
    if (side < 0.0) std::swap(corners[1], corners[3]);
    surface_.polygons.push_back(corners);
  }
  bool is_uniform(const std::array<int, 4>& quad) const {
    const int first = kind(quad[0]);
    return kind(quad[1]) == first && kind(quad[2]) == first && kind(quad[3]) == first;
  }
  void add_whole(const std::array<int, 4>& quad, double side) {
    add_quad({face_vertex(quad[0], side), face_vertex(quad[1], side), face_vertex(quad[2], side),
              face_vertex(quad[3], side)},
             side);
  }
  void add_painted(const std::array<int, 4>& quad, double side) {
    is_uniform(quad) ? add_whole(quad, side) : add_quarters(quad, side);
  }
  void add_quarters(const std::array<int, 4>& quad, double side);

  const Snapshot& snapshot_;
  const std::vector<Vec3>& normals_;
  const NodePaint* paint_;
  std::vector<int> vertex_of_;  ///< of the face being built, by node; -1 none yet
  Surface surface_;
};

int WallBuilder::add_vertex(const Vec3& x, const Vec3& n, int painted_as) {
  if (paint_ != nullptr && !paint_->classes.empty())
    surface_.colours.push_back(class_colour(paint_->classes[at(painted_as)]));
  if (paint_ != nullptr && !paint_->colours.empty())
    surface_.colours.push_back(paint_->colours[at(painted_as)]);
  if (paint_ != nullptr && !paint_->values.empty())
    surface_.values.push_back(static_cast<float>(paint_->values[at(painted_as)]));
  return surface_.add_point(x, n);
}

int WallBuilder::face_vertex(int node, double side) {
  int& vertex = vertex_of_[at(node)];
  if (vertex < 0) vertex = add_vertex(face_point(node, side), side * normals_[at(node)], node);
  return vertex;
}

void WallBuilder::add_face(const std::vector<std::array<int, 4>>& quads, double side) {
  vertex_of_.assign(snapshot_.points.size(), -1);
  for (const auto& quad : quads) add_painted(quad, side);
}

void WallBuilder::add_coarse_face(const std::vector<std::array<int, 4>>& quads, const QuadBlocks& blocks,
                                  double side) {
  vertex_of_.assign(snapshot_.points.size(), -1);
  for (const QuadBlocks::Block& block : blocks.blocks) {
    // All four meet in the middle: uniform ones are of one kind.
    const bool is_one =
        std::all_of(block.quads.begin(), block.quads.end(), [&](int q) { return is_uniform(quads[at(q)]); });
    if (is_one) add_whole(block.corners, side);
    for (const int q : block.quads)
      if (!is_one) add_painted(quads[at(q)], side);
  }
  for (const int q : blocks.singles) add_painted(quads[at(q)], side);
}

void WallBuilder::add_quarters(const std::array<int, 4>& quad, double side) {
  std::array<Vec3, 4> x, n;
  Vec3 centre = Vec3::Zero(), centre_normal = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = face_point(quad[k], side);
    n[k] = side * normals_[at(quad[k])];
    centre += 0.25 * x[k];
    centre_normal += n[k];
  }
  centre_normal.normalize();
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4, last = (k + 3) % 4;
    const int after = add_vertex(0.5 * (x[k] + x[next]), (n[k] + n[next]).normalized(), quad[k]);
    const int middle = add_vertex(centre, centre_normal, quad[k]);
    const int before = add_vertex(0.5 * (x[k] + x[last]), (n[k] + n[last]).normalized(), quad[k]);
    add_quad({face_vertex(quad[k], side), after, middle, before}, side);
  }
}

void WallBuilder::add_rim_quad(int a, int b) {
  const Vec3 along = snapshot_.points[at(b)] - snapshot_.points[at(a)];
  const Vec3 normal = along.cross(snapshot_.directors[at(a)] + snapshot_.directors[at(b)]).normalized();
  const Vec3 outer_middle = 0.5 * (face_point(a, 1.0) + face_point(b, 1.0));
  const Vec3 inner_middle = 0.5 * (face_point(a, -1.0) + face_point(b, -1.0));
  const bool is_split = kind(a) != kind(b);
  const auto strip = [&](const Vec3& inner_0, const Vec3& inner_1, const Vec3& outer_1, const Vec3& outer_0,
                         int node_0, int node_1) {
    surface_.polygons.push_back({add_vertex(inner_0, normal, node_0), add_vertex(inner_1, normal, node_1),
                                 add_vertex(outer_1, normal, node_1), add_vertex(outer_0, normal, node_0)});
  };
  if (is_split) {
    strip(face_point(a, -1.0), inner_middle, outer_middle, face_point(a, 1.0), a, a);
    strip(inner_middle, face_point(b, -1.0), face_point(b, 1.0), outer_middle, b, b);
  } else {
    strip(face_point(a, -1.0), face_point(b, -1.0), face_point(b, 1.0), face_point(a, 1.0), a, b);
  }
}

}  // namespace

SheetShape::SheetShape(const Snapshot& first, bool is_mirrored) : quads_(first.model->quads) {
  check_snapshot(first);
  // The faces are told apart by the directors; a mesh listed the other way round would be inside out.
  const std::vector<Vec3> normals = calc_normals(first);
  double agreement = 0.0;
  for (std::size_t node = 0; node < normals.size(); ++node)
    agreement += normals[node].dot(first.directors[node]);
  if (agreement < 0.0)
    for (auto& quad : quads_) std::swap(quad[1], quad[3]);
  if (is_mirrored) mirrors_ = first.model->mirrors;
  reflections_ = calc_reflections(mirrors_);
  const double tolerance = 1e-6 * calc_bounds(first, {Reflection{}}).diagonal();
  for (const Plane& plane : mirrors_) {
    mirror_nodes_.emplace_back();
    for (std::size_t node = 0; node < first.points.size(); ++node) {
      if (std::abs(plane.normal.dot(first.points[node] - plane.point)) > tolerance) continue;
      mirror_nodes_.back().push_back(static_cast<int>(node));
    }
  }
  find_edges(first, tolerance);
}

void SheetShape::find_edges(const Snapshot& first, double tolerance) {
  // Ordered by node, so that the drawing does not depend on a hash.
  std::map<std::pair<int, int>, std::pair<Edge, int>> owners;
  for (const auto& quad : quads_)
    for (std::size_t k = 0; k < 4; ++k) {
      const Edge edge{quad[k], quad[(k + 1) % 4]};
      ++owners.try_emplace(std::minmax(edge.a, edge.b), edge, 0).first->second.second;
    }
  // An edge of one quad is on the rim unless another copy continues there. Told
  // by its middle: a sector's copies meet at some of its mirror planes, not at all.
  struct Middle {
    Vec3 x;
    std::size_t copy;
    Edge edge;
  };
  std::vector<Middle> middles;
  for (const auto& [nodes, owner] : owners) {
    const Edge edge = owner.first;
    edges_.push_back(edge);
    if (owner.second != 1) continue;
    const Vec3 middle = 0.5 * (first.points[at(edge.a)] + first.points[at(edge.b)]);
    for (std::size_t copy = 0; copy < reflections_.size(); ++copy)
      middles.push_back({reflections_[copy].point(middle), copy, edge});
  }
  // Sorted along a skew direction, partners lie close together.
  const Vec3 skew(0.61, 0.53, 0.59);
  std::stable_sort(middles.begin(), middles.end(),
                   [&](const Middle& a, const Middle& b) { return skew.dot(a.x) < skew.dot(b.x); });
  std::vector<bool> has_partner(middles.size(), false);
  for (std::size_t i = 0; i < middles.size(); ++i)
    for (std::size_t j = i + 1; j < middles.size() && skew.dot(middles[j].x - middles[i].x) <= tolerance; ++j)
      if ((middles[j].x - middles[i].x).norm() <= tolerance) has_partner[i] = has_partner[j] = true;
  rim_.resize(reflections_.size());
  for (std::size_t i = 0; i < middles.size(); ++i)
    if (!has_partner[i]) rim_[middles[i].copy].push_back(middles[i].edge);
}

std::vector<Vec3> SheetShape::calc_normals(const Snapshot& snapshot) const {
  std::vector<Vec3> normals(snapshot.points.size(), Vec3::Zero());
  for (const auto& quad : quads_) {
    const Vec3 d1 = snapshot.points[at(quad[2])] - snapshot.points[at(quad[0])];
    const Vec3 d2 = snapshot.points[at(quad[3])] - snapshot.points[at(quad[1])];
    const Vec3 area = d1.cross(d2);
    for (int node : quad) normals[at(node)] += area;
  }
  // Else a crease would show along the seams of the mirrored part.
  for (std::size_t m = 0; m < mirrors_.size(); ++m) {
    const Vec3 n = mirrors_[m].normal.normalized();
    for (int node : mirror_nodes_[m]) normals[at(node)] -= n * n.dot(normals[at(node)]);
  }
  for (std::size_t node = 0; node < normals.size(); ++node) {
    const double length = normals[node].norm();
    normals[node] = length > 0.0 ? Vec3(normals[node] / length) : snapshot.directors[node];
  }
  return normals;
}

const QuadBlocks& SheetShape::blocks() const {
  if (!blocks_) blocks_ = find_quad_blocks(quads_);
  return *blocks_;
}

Surface SheetShape::make_wall(const Snapshot& snapshot, const std::optional<NodePaint>& paint,
                              bool is_coarse) const {
  check_snapshot(snapshot);
  if (paint) {
    const std::size_t nodes = snapshot.points.size();
    const std::array<std::size_t, 3> given{paint->values.size(), paint->classes.size(),
                                           paint->colours.size()};
    require(std::count(given.begin(), given.end(), nodes) >= 1 && given[0] + given[1] + given[2] == nodes,
            "one colour a node");
  }
  const std::vector<Vec3> normals = calc_normals(snapshot);
  const NodePaint* painted = paint ? &*paint : nullptr;
  WallBuilder faces(snapshot, normals, painted);
  for (const double side : {1.0, -1.0})
    is_coarse ? faces.add_coarse_face(quads_, blocks(), side) : faces.add_face(quads_, side);
  Surface wall = calc_reflected(faces.take(), reflections_);
  for (std::size_t copy = 0; copy < reflections_.size(); ++copy) {
    WallBuilder rim(snapshot, normals, painted);
    for (const Edge& edge : rim_[copy]) rim.add_rim_quad(edge.a, edge.b);
    append(wall, calc_reflected(rim.take(), {reflections_[copy]}));
  }
  return wall;
}

LineSet SheetShape::make_rim(const Snapshot& snapshot) const {
  LineSet rim;
  for (std::size_t copy = 0; copy < reflections_.size(); ++copy)
    for (const Edge& edge : rim_[copy])
      for (double side : {1.0, -1.0}) {
        const auto face = [&](int node) -> Vec3 {
          return reflections_[copy].point(snapshot.points[at(node)] + 0.5 * side *
                                                                          snapshot.thickness[at(node)] *
                                                                          snapshot.directors[at(node)]);
        };
        rim.add_line(face(edge.a), face(edge.b));
      }
  return rim;
}

LineSet SheetShape::make_element_edges(const Snapshot& snapshot, bool is_coarse) const {
  LineSet piece;
  const int count = static_cast<int>(snapshot.points.size());
  for (double side : {1.0, -1.0})
    for (int node = 0; node < count; ++node)
      piece.points.push_back((snapshot.points[at(node)] +
                              0.5 * side * snapshot.thickness[at(node)] * snapshot.directors[at(node)])
                                 .cast<float>());
  const auto add = [&](int a, int b) {
    piece.lines.push_back({a, b});
    piece.lines.push_back({a + count, b + count});
  };
  if (!is_coarse)
    for (const Edge& edge : edges_) add(edge.a, edge.b);
  if (is_coarse) {
    std::set<std::pair<int, int>> around;
    const auto add_around = [&](const std::array<int, 4>& quad) {
      for (std::size_t k = 0; k < 4; ++k) around.insert(std::minmax({quad[k], quad[(k + 1) % 4]}));
    };
    for (const QuadBlocks::Block& block : blocks().blocks) add_around(block.corners);
    for (const int q : blocks().singles) add_around(quads_[at(q)]);
    for (const auto& [a, b] : around) add(a, b);
  }
  return calc_reflected(piece, reflections_);
}

double SheetShape::calc_edge_length(const Snapshot& snapshot) const {
  double sum = 0.0;
  for (const Edge& edge : edges_) sum += (snapshot.points[at(edge.b)] - snapshot.points[at(edge.a)]).norm();
  return edges_.empty() ? 0.0 : sum / static_cast<double>(edges_.size());
}

Bounds calc_bounds(const Snapshot& snapshot, const std::vector<Reflection>& reflections) {
  Bounds bounds;
  for (const Reflection& reflection : reflections)
    for (const Vec3& x : snapshot.points) bounds.include(reflection.point(x));
  return bounds;
}

Bounds calc_sheet_bounds(const Snapshot& snapshot, bool is_mirrored) {
  return calc_bounds(snapshot,
                     calc_reflections(is_mirrored ? snapshot.model->mirrors : std::vector<Plane>{}));
}

}  // namespace hydroscope
