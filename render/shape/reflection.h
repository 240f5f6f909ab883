// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// x' = Q x + c, a product of mirror images. Forces, slips and normals are
/// true vectors: they turn with Q alone. `flips` when the sense of rotation
/// changes, so that polygons must be listed the other way round.
struct Reflection {
  Mat3 Q = Mat3::Identity();
  Vec3 c = Vec3::Zero();
  bool flips = false;

  Vec3 point(const Vec3& x) const { return Q * x + c; }
  Vec3 vector(const Vec3& v) const { return Q * v; }
};

/// The copies that make the whole part: each plane doubles what the planes
/// before it have made. The first one is the identity.
std::vector<Reflection> calc_reflections(const std::vector<Plane>& mirrors);

/// Those mirrors about which the points lie on one side, each turned so that its
/// normal points away from them. A tool may reach over a plane of symmetry by a margin; one that
/// reaches over it by more than half as far as to the other side is there as a whole already.
std::vector<Plane> find_open_mirrors(const std::vector<Plane>& mirrors, const std::vector<Vec3>& points);

}  // namespace hydroscope
