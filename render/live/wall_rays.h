// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/live/live_camera.h"
#include "render/live/pick.h"

namespace hydroscope {

/// The drawn wall as seen through one camera: both faces of all copies, projected. A ray is a pixel.
class WallRays {
 public:
  WallRays(const LiveView& view, const Snapshot& first, const Snapshot& snapshot);

  /// The nearest place of the wall under a pixel.
  std::optional<Pick> find_hit(double x, double y) const;

  /// Nodes with an image in the rectangle that nothing hides, in rising order.
  std::vector<int> find_seen(double x0, double y0, double x1, double y1) const;

  const Projection& projection() const { return projection_; }
  /// Where the face of a node's image that is turned to the viewer is seen: pixels and depth.
  Vec3 find_place(int copy, int node) const { return corner(find_face(copy, node), copy, node); }
  int copies() const { return static_cast<int>(reflections_.size()); }

 private:
  struct Triangle {
    std::array<Vec3, 3> x;  ///< pixels and depth
    int quad, copy, face;
  };

  const Vec3& corner(int face, int copy, int node) const;
  int find_face(int copy, int node) const;
  Triangle triangle(int face, int copy, int quad, int half) const;
  bool is_clipped(const Vec3& projected) const;
  int find_nearest_node(const Triangle& hit, const Vec3& projected) const;
  template <typename Visitor>
  void visit_triangles(Visitor visit) const;

  const Snapshot& snapshot_;
  Projection projection_;
  std::optional<Plane> clip_;
  std::vector<Reflection> reflections_;
  std::vector<Vec3> corners_;  ///< by face (outer, inner), copy and node
};

}  // namespace hydroscope
