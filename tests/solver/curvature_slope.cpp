// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/solver/curvature_slope.h"

#include <cmath>
#include <stdexcept>

#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/geometry/nagata_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {

namespace {

using NodeForce = Eigen::Matrix<double, kDofs, 1>;
using Stiffness = Eigen::Matrix<double, kDofs, kDofs>;

Triad make_triad(const Vec3& director) {
  Triad t;
  t.v = director.normalized();
  t.v1 = t.v.cross(Vec3(0.3, -0.5, 0.9)).normalized();
  t.v2 = t.v.cross(t.v1);
  return t;
}

double calc_rest(const Vec3& force, const Vec3& normal) {
  return (force - normal.dot(force) * normal).norm();
}

}  // namespace

SpringNode SpringNode::moved(const NodeForce& q) const {
  SpringNode to = *this;
  to.x += q.head<3>();
  Triad& t = to.slave.triad;
  const Vec3 theta = q[3] * t.v1 + q[4] * t.v2;
  if (theta.norm() == 0.0) return to;
  const Mat3 turn = Eigen::AngleAxisd(theta.norm(), theta.normalized()).toRotationMatrix();
  t = {turn * t.v1, turn * t.v2, turn * t.v};
  return to;
}

FootPoint find_foot(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  const auto foot = tool.find_foot_point(x, 50.0, 50.0, hint);
  if (!foot) throw std::runtime_error("no foot point");
  return *foot;
}

SpringNode make_spring_node(const ToolSurface& tool, const Vec3& at, double offset, double normal_force) {
  SpringNode node;
  node.slave = {make_triad(find_foot(tool, at).normal + Vec3(0.04, -0.03, 0.05)), offset};
  node.x = at - offset * node.slave.triad.v;
  node.normal_force = normal_force;
  // Springs without symmetry of their own: 1000 N/mm, of the fibre 1000 N mm, and a coupling.
  node.springs = 1000.0 * Stiffness::Identity();
  for (int i = 0; i < kDofs; ++i) {
    for (int j = 0; j < kDofs; ++j) node.springs(i, j) += 120.0 * std::cos(1.3 * (i + j) + 0.2 * i * j);
  }
  return node;
}

TangentialRest slide_once(const ToolSurface& tool, const SpringNode& node, CurvatureInSlide curvature,
                          const NodeForce& force) {
  const FootPoint foot = find_foot(tool, node.point());
  const bool has_curvature = curvature != CurvatureInSlide::none;
  const NodeForce row = calc_gap_row(node.slave, foot.normal);
  const Stiffness contact = calc_contact_stiffness(node.slave, foot, node.normal_force, {}, has_curvature,
                                                   curvature == CurvatureInSlide::symmetric);
  // Springs, contact, and the row of the gap with the change of t_N as its multiplier.
  Eigen::Matrix<double, kDofs + 1, kDofs + 1> k;
  k << node.springs + contact, -row, row.transpose(), 0.0;
  Eigen::Matrix<double, kDofs + 1, 1> rhs;
  rhs << force, 0.0;
  const Eigen::Matrix<double, kDofs + 1, 1> solution = k.fullPivLu().solve(rhs);

  const NodeForce q = solution.head<kDofs>();
  const SpringNode after = node.moved(q);
  const FootPoint there = find_foot(tool, after.point());
  TangentialRest rest;
  rest.slide = (after.point() - node.point()).norm();
  rest.in_one_facet = there.facet == foot.facet;
  const Vec3 before = node.normal_force * foot.normal;
  Vec3 du = node.slave.calc_map() * q;  // of the slave point
  du -= foot.normal.dot(du) * foot.normal;
  rest.transported = calc_rest(
      has_curvature ? Vec3(before + node.normal_force * foot.normal_gradient * du) : before, there.normal);
  const NodeForce change = solution[kDofs] * row - contact * q;  // of the force on the node
  rest.balanced = calc_rest(before + change.head<3>(), there.normal);
  return rest;
}

std::vector<SlopeRow> measure_slopes(const ToolSurface& tool, const SpringNode& node, double first_force,
                                     int steps) {
  const Vec3 normal = find_foot(tool, node.point()).normal;
  const Vec3 along = normal.cross(Vec3(0.2, 0.7, -0.4)).normalized();
  NodeForce force = NodeForce::Zero();
  force.head<3>() = first_force * along;
  std::vector<SlopeRow> rows;
  for (int i = 0; i < steps; ++i, force *= 0.5) {
    rows.push_back({slide_once(tool, node, CurvatureInSlide::none, force),
                    slide_once(tool, node, CurvatureInSlide::full, force),
                    slide_once(tool, node, CurvatureInSlide::symmetric, force)});
  }
  return rows;
}

double fit_slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = std::log(x[i]), b = std::log(y[i]);
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::vector<SlopeCase> make_slope_cases() {
  TriangleMesh sphere = test::make_icosphere(10.0, 2);
  test::Dice dice(
      4);  // points shifted by a fifth of an edge: no facet is regular, no dn/dx symmetric by luck
  for (Vec3& x : sphere.points) x = 10.0 * (x + 0.5 * dice.direction()).normalized();
  const TriangleMesh torus = test::make_torus(20.0, 10.0, 48, 32);
  const auto inside = [](const TriangleMesh& mesh, std::size_t facet) {
    const auto& [a, b, c] = mesh.triangles[facet];
    return Vec3(0.45 * mesh.points[test::at(a)] + 0.3 * mesh.points[test::at(b)] +
                0.25 * mesh.points[test::at(c)]);
  };
  // The facet nearest to the torus' inner side.
  std::size_t saddle = 0;
  for (std::size_t k = 0; k < torus.triangles.size(); ++k) {
    const Vec3 x = inside(torus, k), y = inside(torus, saddle);
    if (x.head<2>().norm() < y.head<2>().norm()) saddle = k;
  }
  std::vector<SlopeCase> cases;
  const auto add = [&](const std::string& name, std::shared_ptr<const ToolSurface> tool, const Vec3& near,
                       bool is_symmetric) {
    const Vec3 at = find_foot(*tool, near).point;
    cases.push_back({name, std::move(tool), at, is_symmetric});
  };
  MeshSurfaceOptions flat, smooth;
  smooth.is_smooth = true;
  const struct {
    std::string name;
    const TriangleMesh& mesh;
    Vec3 near;
  } shapes[] = {{"sphere", sphere, inside(sphere, 100)}, {"saddle", torus, inside(torus, saddle)}};
  for (const auto& shape : shapes) {
    add(shape.name + " facets", std::make_shared<MeshSurface>(shape.mesh, flat), shape.near, false);
    add(shape.name + " smooth", std::make_shared<MeshSurface>(shape.mesh, smooth), shape.near, false);
    add(shape.name + " nagata", std::make_shared<NagataSurface>(shape.mesh), shape.near, true);
  }
  add("saddle exact", std::make_shared<TorusSurface>(Pose{}, 20.0, 10.0, Side::outside),
      inside(torus, saddle), true);
  add("cylinder exact", std::make_shared<CylinderSurface>(Pose{}, 10.0, Side::inside, 20.0), Vec3(6, 8, 3),
      true);
  return cases;
}

}  // namespace hydroscope
