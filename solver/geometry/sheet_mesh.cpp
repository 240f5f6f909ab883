// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/sheet_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double interpolate_size(const std::vector<std::array<double, 2>>& grading, double at) {
  if (grading.empty() || at <= grading.front()[0]) return grading.empty() ? 1.0 : grading.front()[1];
  if (at >= grading.back()[0]) return grading.back()[1];
  std::size_t k = 1;
  while (grading[k][0] < at) ++k;
  const double share = (at - grading[k - 1][0]) / (grading[k][0] - grading[k - 1][0]);
  return grading[k - 1][1] + share * (grading[k][1] - grading[k - 1][1]);
}

Vec3 radial(double degrees) { return {std::cos(degrees * kDegree), std::sin(degrees * kDegree), 0.0}; }

/// Quads of a grid of node columns and rows; closed around when `is_ring`.
void connect(SheetMesh& m) {
  const int cells = m.is_ring ? m.n_around : m.n_around - 1;
  for (int j = 0; j + 1 < m.n_along; ++j) {
    for (int i = 0; i < cells; ++i) {
      m.mesh.quads.push_back({m.node(i, j), m.node(i + 1, j), m.node(i + 1, j + 1), m.node(i, j + 1)});
    }
  }
}

std::vector<int> column(const SheetMesh& m, int i) {
  std::vector<int> nodes;
  for (int j = 0; j < m.n_along; ++j) nodes.push_back(m.node(i, j));
  return nodes;
}

std::vector<int> row(const SheetMesh& m, int j) {
  std::vector<int> nodes;
  for (int i = 0; i < m.n_around; ++i) nodes.push_back(m.node(i, j));
  return nodes;
}

double section_angle(const TubeScene& scene) {
  if (scene.section == "full") return 360.0;
  if (scene.section == "half") return 180.0;
  if (scene.section == "quarter") return 90.0;
  if (scene.section == "octant") return 45.0;
  return scene.sector_angle;
}

/// Plane through the axis at an angle from +x.
Vec3 plane_normal(double degrees) { return {-std::sin(degrees * kDegree), std::cos(degrees * kDegree), 0.0}; }

void add_section_symmetry(SheetMesh& m, double angle) {
  if (m.is_ring) return;
  m.symmetry.push_back({plane_normal(0.0), column(m, 0)});
  m.symmetry.push_back({plane_normal(angle), column(m, m.n_around - 1)});
  for (double a = angle; a < 180.0 - 1e-9; a *= 2.0) {
    if (std::abs(std::remainder(360.0, 2.0 * a)) > 1e-9)
      break;  // repeated mirroring would not close the ring
    m.mirrors.push_back({Vec3::Zero(), plane_normal(a)});
  }
  m.mirrors.push_back({Vec3::Zero(), -Vec3::UnitY()});
}

void add_length_symmetry(SheetMesh& m, const TubeScene& scene) {
  const std::vector<int> low = row(m, 0), high = row(m, m.n_along - 1);
  if (scene.extent == "slice") {
    m.symmetry.push_back({Vec3::UnitZ(), low});
    m.symmetry.push_back({Vec3::UnitZ(), high});
  } else if (scene.extent == "half") {
    m.symmetry.push_back({Vec3::UnitZ(), low});
    m.mirrors.push_back({Vec3::Zero(), -Vec3::UnitZ()});
    m.end_nodes = high;
  } else {
    m.start_nodes = low;
    m.end_nodes = high;
  }
}

void check_counts(const char* table, int around, int along) {
  if (around * along < 2) {
    throw InputError(std::string(table) + ": " + std::to_string(around) + " x " + std::to_string(along) +
                     " elements make no mesh; expected at least two elements");
  }
}

/// Points and outward normals along the path of a strip.
struct StripPath {
  std::vector<Vec3> points, directors;
  std::vector<double> lengths;

  void add(const Vec3& x, double direction, double s) {
    points.push_back(x);
    directors.emplace_back(std::sin(direction), -std::cos(direction), 0.0);  // to the right of the path
    lengths.push_back(s);
  }
};

StripPath make_strip_path(const StripScene& scene) {
  StripPath path;
  double direction = scene.direction * kDegree, s = 0.0;
  Vec3 x(scene.start[0], scene.start[1], 0.0);
  path.add(x, direction, s);
  const auto straight = [&](double length, int n) {
    const Vec3 from = x;
    for (int i = 1; i <= n; ++i) {
      x = from + length * i / n * Vec3(std::cos(direction), std::sin(direction), 0.0);
      path.add(x, direction, s + length * i / n);
    }
    s += n > 0 ? length : 0.0;
  };
  straight(scene.lead_in, scene.elements_lead_in);
  const double turn = scene.arc_angle * kDegree;
  const Vec3 centre = x + scene.arc_radius * Vec3(-std::sin(direction), std::cos(direction), 0.0);
  const double first = direction;
  for (int i = 1; i <= scene.elements_arc; ++i) {
    direction = first + turn * i / scene.elements_arc;
    x = centre + scene.arc_radius * Vec3(std::sin(direction), -std::cos(direction), 0.0);
    path.add(x, direction, s + scene.arc_radius * turn * i / scene.elements_arc);
  }
  s += scene.elements_arc > 0 ? scene.arc_radius * turn : 0.0;
  straight(scene.lead_out, scene.elements_lead_out);
  return path;
}

}  // namespace

std::vector<double> divide(double from, double to, int n, const std::vector<std::array<double, 2>>& grading) {
  // Integrate the density 1/size finely and invert it.
  constexpr int kFine = 4000;
  std::vector<double> sum(kFine + 1, 0.0);
  for (int i = 0; i < kFine; ++i) {
    const double middle = from + (to - from) * (i + 0.5) / kFine;
    sum[static_cast<std::size_t>(i) + 1] =
        sum[static_cast<std::size_t>(i)] + 1.0 / interpolate_size(grading, middle);
  }
  std::vector<double> at{from};
  std::size_t k = 0;
  for (int i = 1; i < n; ++i) {
    const double wanted = sum.back() * i / n;
    while (sum[k + 1] < wanted) ++k;
    const double share = (wanted - sum[k]) / (sum[k + 1] - sum[k]);
    at.push_back(from + (to - from) * (static_cast<double>(k) + share) / kFine);
  }
  at.push_back(to);
  return at;
}

SheetMesh make_tube_mesh(const TubeScene& scene) {
  const bool is_slice = scene.extent == "slice";
  const int along = is_slice ? 1 : scene.elements_along;
  check_counts("tube", scene.elements_around, along);
  SheetMesh m;
  const double angle = section_angle(scene);
  m.is_ring = scene.section == "full";
  m.positions = divide(0.0, angle, scene.elements_around, scene.grading_around);
  if (m.is_ring) m.positions.pop_back();
  const bool is_full = scene.extent == "full";
  const double high = is_slice ? scene.length : 0.5 * scene.length;
  m.z = divide(is_full ? -high : 0.0, high, along, scene.grading_along);
  m.width = m.z.back() - m.z.front();
  m.n_around = static_cast<int>(m.positions.size());
  m.n_along = static_cast<int>(m.z.size());
  for (const double z : m.z) {
    for (const double a : m.positions) {
      m.directors.push_back(radial(a));
      m.mesh.points.push_back(scene.radius * radial(a) + z * Vec3::UnitZ());
    }
  }
  connect(m);
  add_section_symmetry(m, angle);
  add_length_symmetry(m, scene);
  return m;
}

SheetMesh make_strip_mesh(const StripScene& scene) {
  const StripPath path = make_strip_path(scene);
  check_counts("strip", static_cast<int>(path.points.size()) - 1, 1);
  SheetMesh m;
  m.n_around = static_cast<int>(path.points.size());
  m.n_along = 2;
  m.z = {0.0, scene.width};
  m.width = scene.width;
  for (const double s : path.lengths) m.positions.push_back(s / path.lengths.back());
  for (const double z : m.z) {
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      m.mesh.points.push_back(path.points[i] + z * Vec3::UnitZ());
      m.directors.push_back(path.directors[i]);
    }
  }
  connect(m);
  m.symmetry.push_back({Vec3::UnitZ(), row(m, 0)});
  m.symmetry.push_back({Vec3::UnitZ(), row(m, 1)});
  m.start_nodes = column(m, 0);
  m.end_nodes = column(m, m.n_around - 1);
  return m;
}

}  // namespace hydroscope
