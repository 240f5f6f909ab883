// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/loading/pressure.h"

#include "solver/shell/shell_element.h"

namespace hydroscope {

namespace {

struct FacePoint {
  ShapeFunctions s;
  Vec3 g1 = Vec3::Zero(), g2 = Vec3::Zero();
};

FacePoint evaluate_face(const std::array<Vec3, 4>& x, int gauss) {
  const Vec2 at = gauss_point(gauss);
  FacePoint p{calc_shape_functions(at[0], at[1])};
  for (std::size_t a = 0; a < 4; ++a) {
    p.g1 += p.s.n1[a] * x[a];
    p.g2 += p.s.n2[a] * x[a];
  }
  return p;
}

}  // namespace

Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0;
  return m;
}

std::array<Vec3, 4> calc_pressure_load(const std::array<Vec3, 4>& x) {
  std::array<Vec3, 4> f;
  f.fill(Vec3::Zero());
  for (int i = 0; i < kGaussPoints; ++i) {
    const FacePoint p = evaluate_face(x, i);
    const Vec3 area = p.g1.cross(p.g2);
    for (std::size_t a = 0; a < 4; ++a) f[a] += p.s.n[a] * area;
  }
  return f;
}

std::array<std::array<Mat3, 4>, 4> calc_pressure_stiffness(const std::array<Vec3, 4>& x) {
  std::array<std::array<Mat3, 4>, 4> k;
  for (auto& row : k) row.fill(Mat3::Zero());
  for (int i = 0; i < kGaussPoints; ++i) {
    const FacePoint p = evaluate_face(x, i);
    const Mat3 s1 = 0.5 * skew(p.g1), s2 = 0.5 * skew(p.g2);
    const auto& [n, n1, n2] = p.s;
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 4; ++b) {  // (3.105), (3.106) in the symmetric form
        k[a][b] += (n[a] * n2[b] - n2[a] * n[b]) * s1 - (n[a] * n1[b] - n1[a] * n[b]) * s2;
      }
    }
  }
  return k;
}

}  // namespace hydroscope
