// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "solver/loading/pressure.h"

namespace hydroscope {
namespace {

using Faces = std::vector<std::array<std::size_t, 4>>;

/// A closed box of 2 x 2 warped faces a side, all normals outward, its nodes pushed about.
struct Box {
  std::vector<Vec3> x;
  Faces faces;

  Box() {
    std::map<std::array<int, 3>, std::size_t> numbers;
    const auto node = [&](const std::array<int, 3>& at) {
      const auto [found, is_new] = numbers.try_emplace(at, x.size());
      if (is_new) {
        const double s = static_cast<double>(x.size());
        x.push_back(Vec3(at[0], 1.3 * at[1], 0.7 * at[2]) +
                    0.2 * Vec3(std::sin(3.1 * s), std::sin(5.3 * s + 1), std::cos(7.7 * s)) + Vec3(4, -3, 2));
      }
      return found->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 2}) {
        for (int i = 0; i < 2; ++i) {
          for (int j = 0; j < 2; ++j) {
            const auto corner = [&](int a, int b) {
              std::array<int, 3> at{};
              at[axis] = side;
              at[(axis + 1) % 3] = a;
              at[(axis + 2) % 3] = b;
              return node(at);
            };
            std::array<std::size_t, 4> face{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                            corner(i, j + 1)};
            if (side == 0) std::swap(face[1], face[3]);
            faces.push_back(face);
          }
        }
      }
    }
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(3 * x.size()); }

  std::array<Vec3, 4> corners(const std::array<std::size_t, 4>& face) const {
    return {x[face[0]], x[face[1]], x[face[2]], x[face[3]]};
  }

  Eigen::VectorXd calc_load() const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(size());
    for (const auto& face : faces) {
      const auto load = calc_pressure_load(corners(face));
      for (std::size_t a = 0; a < 4; ++a) f.segment<3>(static_cast<Eigen::Index>(3 * face[a])) += load[a];
    }
    return f;
  }

  Eigen::MatrixXd calc_stiffness() const {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size(), size());
    for (const auto& face : faces) {
      const auto part = calc_pressure_stiffness(corners(face));
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
          k.block<3, 3>(static_cast<Eigen::Index>(3 * face[a]), static_cast<Eigen::Index>(3 * face[b])) +=
              part[a][b];
        }
      }
    }
    return k;
  }

  /// Volume by Gauss' theorem with its own quadrature: 3 x 3 points of (x . g1 x g2) / 3.
  double calc_volume() const {
    const double p = std::sqrt(0.6);
    const std::array<double, 3> at{-p, 0.0, p}, weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    double volume = 0.0;
    for (const auto& face : faces) {
      const auto c = corners(face);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const double r = at[i], s = at[j];
          const Vec3 g1 = 0.25 * ((1 - s) * (c[1] - c[0]) + (1 + s) * (c[2] - c[3]));
          const Vec3 g2 = 0.25 * ((1 - r) * (c[3] - c[0]) + (1 + r) * (c[2] - c[1]));
          const Vec3 y = 0.25 * ((1 - r) * (1 - s) * c[0] + (1 + r) * (1 - s) * c[1] +
                                 (1 + r) * (1 + s) * c[2] + (1 - r) * (1 + s) * c[3]);
          volume += weight[i] * weight[j] * y.dot(g1.cross(g2)) / 3.0;
        }
      }
    }
    return volume;
  }

  double& coordinate(Eigen::Index i) { return x[static_cast<std::size_t>(i / 3)][i % 3]; }
};

/// Fluid in a closed vessel pushes it nowhere and turns it nowhere (V25).
TEST(Pressure, ClosedSurfaceHasNoResultant) {
  const Box box;
  const Eigen::VectorXd f = box.calc_load();
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t i = 0; i < box.x.size(); ++i) {
    const Vec3 part = f.segment<3>(static_cast<Eigen::Index>(3 * i));
    force += part;
    moment += box.x[i].cross(part);
  }
  EXPECT_LT(force.norm(), 1e-13 * f.norm());
  EXPECT_LT(moment.norm(), 1e-12 * f.norm() * box.x[0].norm());
}

/// f = dV/dx (V25). V is linear in each single coordinate (triple products of different nodes), so
/// differences of any width are exact but for rounding.
TEST(Pressure, LoadIsTheGradientOfTheVolume) {
  Box box;
  const Eigen::VectorXd f = box.calc_load();
  ASSERT_GT(box.calc_volume(), 0.0);  // outward normals
  for (Eigen::Index i = 0; i < box.size(); ++i) {
    const double at = box.coordinate(i);
    box.coordinate(i) = at + 0.5;
    const double high = box.calc_volume();
    box.coordinate(i) = at - 0.5;
    const double low = box.calc_volume();
    box.coordinate(i) = at;
    EXPECT_NEAR(high - low, f[i], 1e-10 * f.norm()) << "coordinate " << i;
  }
}

/// The assembled K_p is the Hessian of the volume: symmetric, and every column the difference of the
/// load (exact for any width, as above).
TEST(Pressure, StiffnessIsTheDifferenceOfTheLoad) {
  Box box;
  const Eigen::MatrixXd k = box.calc_stiffness();
  EXPECT_LT((k - k.transpose()).norm(), 1e-13 * k.norm());
  for (Eigen::Index i = 0; i < box.size(); ++i) {
    const double at = box.coordinate(i);
    box.coordinate(i) = at + 0.5;
    const Eigen::VectorXd high = box.calc_load();
    box.coordinate(i) = at - 0.5;
    const Eigen::VectorXd low = box.calc_load();
    box.coordinate(i) = at;
    EXPECT_LT((high - low - k.col(i)).norm(), 1e-10 * k.norm()) << "coordinate " << i;
  }
}

/// A single flat face: its whole load is area times normal, a quarter at each node of a parallelogram.
TEST(Pressure, ParallelogramSharesItsLoadEqually) {
  const Vec3 o(1, 2, 3), a(2, 0.5, -1), b(-0.3, 1.5, 0.4);
  const auto f = calc_pressure_load({o, o + a, o + a + b, o + b});
  for (const Vec3& part : f) EXPECT_LT((part - 0.25 * a.cross(b)).norm(), 1e-15 * a.cross(b).norm() + 1e-15);
}

TEST(Pressure, SkewIsTheCrossProduct) {
  const Vec3 a(1, -2, 3), b(0.5, 4, -1);
  EXPECT_EQ(Vec3(skew(a) * b), a.cross(b));
}

}  // namespace
}  // namespace hydroscope
