// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/quad_prism.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hydroscope {

namespace {

constexpr int kIterations = 16;
// Newton squares its error: a step below this leaves nothing but rounding.
constexpr double kLastStep = 1e-8;
// Part of the quad's own volume that is left; at the focal distance it is zero.
constexpr double kFocal = 1e-6;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Place, columns dx/dxi, dx/deta, dx/dg of the prism map, and its determinant.
struct QuadJacobian {
  Vec3 point, m;     // of the surface, and its normal, not normalised
  Vec3 m_xi, m_eta;  // dm/dxi, dm/deta
  Vec3 a, b;         // dx/dxi, dx/deta at height g
  Vec3 b_x_m;
  double det;

  QuadJacobian(const QuadPrism& q, double xi, double eta, double g)
      : point(q.x0 + xi * q.a + eta * q.b + xi * eta * q.c),
        m(q.v0 + xi * q.p + eta * q.q + xi * eta * q.r),
        m_xi(q.p + eta * q.r),
        m_eta(q.q + xi * q.r),
        a(q.a + eta * q.c + g * m_xi),
        b(q.b + xi * q.c + g * m_eta),
        b_x_m(b.cross(m)),
        det(a.dot(b_x_m)) {}
};

/// The quad of two facets with a common edge that they run along in opposite ways.
std::optional<std::array<int, 4>> join_facets(const std::array<int, 3>& s, const std::array<int, 3>& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int from = s[(i + 1) % 3];
      const int to = s[(i + 2) % 3];
      if (from == t[(j + 2) % 3] && to == t[(j + 1) % 3] && s[i] != t[j]) {
        return std::array<int, 4>{from, t[j], to, s[i]};
      }
    }
  }
  return std::nullopt;
}

bool is_convex(const TriangleMesh& mesh, const std::array<int, 4>& quad) {
  const auto x = [&](std::size_t k) { return mesh.points[at(quad[k % 4])]; };
  const Vec3 whole = (x(2) - x(0)).cross(x(3) - x(1));
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 corner = (x(k + 1) - x(k)).cross(x(k + 3) - x(k));
    if (!(corner.dot(whole) > 1e-6 * corner.norm() * whole.norm())) return false;
  }
  return true;
}

}  // namespace

QuadPrism make_quad_prism(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& normals) {
  QuadPrism quad;
  quad.x0 = corners[0];
  quad.a = corners[1] - corners[0];
  quad.b = corners[3] - corners[0];
  quad.c = corners[0] - corners[1] + corners[2] - corners[3];
  quad.v0 = normals[0];
  quad.p = normals[1] - normals[0];
  quad.q = normals[3] - normals[0];
  quad.r = normals[0] - normals[1] + normals[2] - normals[3];
  quad.area2 = (corners[2] - corners[0]).cross(corners[3] - corners[1]).norm();
  return quad;
}

QuadPoint locate_in_quad(const QuadPrism& quad, const Vec3& x) {
  QuadPoint at;
  const QuadJacobian middle(quad, at.xi, at.eta, 0.0);
  at.g = middle.m.dot(x - middle.point) / middle.m.squaredNorm();
  const double size = std::sqrt(quad.area2);
  for (int i = 0; i < kIterations; ++i) {
    const QuadJacobian j(quad, at.xi, at.eta, at.g);
    if (!(j.det > kFocal * quad.area2)) return at;
    const Vec3 rest = x - j.point - at.g * j.m;
    const Vec3 a_x_rest = j.a.cross(rest);
    const double dxi = rest.dot(j.b_x_m) / j.det;
    const double deta = a_x_rest.dot(j.m) / j.det;
    const double dg = -a_x_rest.dot(j.b) / j.det;
    at.xi += dxi;
    at.eta += deta;
    at.g += dg;
    if (std::abs(dxi) < kLastStep && std::abs(deta) < kLastStep && std::abs(dg) < kLastStep * size) {
      at.is_valid = true;
      return at;
    }
  }
  return at;
}

FootPoint make_foot_point(const QuadPrism& quad, const QuadPoint& at, const Vec3& x) {
  const QuadJacobian j(quad, at.xi, at.eta, at.g);
  const double size = j.m.norm();
  FootPoint foot;
  foot.point = j.point;
  foot.normal = j.m / size;  // (4.2), normalised: interpolated normals are shorter than 1
  foot.gap = foot.normal.dot(x - foot.point);
  // Rows of the inverse Jacobian: how xi, eta and g change with x.
  const Vec3 dxi_dx = j.b_x_m / j.det;
  const Vec3 deta_dx = j.m.cross(j.a) / j.det;
  const Vec3 dg_dx = j.a.cross(j.b) / j.det;
  const Mat3 dm_dx = j.m_xi * dxi_dx.transpose() + j.m_eta * deta_dx.transpose();  // (4.30)
  foot.normal_gradient = (dm_dx - foot.normal * (foot.normal.transpose() * dm_dx)) / size;
  foot.gap_gradient = size * dg_dx + at.g * (dm_dx.transpose() * foot.normal);
  return foot;
}

FootPoint make_fixed_foot(const QuadPrism& quad, double xi, double eta, const Vec3& x) {
  const QuadJacobian j(quad, xi, eta, 0.0);
  FootPoint foot;
  foot.point = j.point;
  foot.normal = foot.gap_gradient = j.m.normalized();
  foot.gap = foot.normal.dot(x - foot.point);
  return foot;
}

QuadCover cover_with_quads(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& pairs) {
  QuadCover cover;
  cover.halves.resize(mesh.triangles.size());
  for (const auto& pair : pairs) {
    const auto quad = join_facets(mesh.triangles[at(pair[0])], mesh.triangles[at(pair[1])]);
    if (!quad || !is_convex(mesh, *quad)) continue;
    for (int facet : pair) {
      QuadHalf& half = cover.halves[at(facet)];
      half.quad = static_cast<int>(cover.quads.size());
      for (std::size_t k = 0; k < 3; ++k) {
        const auto place = std::find(quad->begin(), quad->end(), mesh.triangles[at(facet)][k]);
        half.corner[k] = static_cast<int>(place - quad->begin());
      }
    }
    cover.quads.push_back(*quad);
  }
  return cover;
}

}  // namespace hydroscope
