// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/linear_shell.h"

#include <stdexcept>

#include "solver/system/linear_solver.h"

namespace hydroscope::verification {

namespace {

ElementNodes gather(const LinearShell& shell, const std::array<int, 4>& quad) {
  ElementNodes nodes;
  for (std::size_t a = 0; a < 4; ++a) {
    const auto i = static_cast<std::size_t>(quad[a]);
    nodes.x[a] = shell.x[i];
    nodes.triad[a] = shell.triad[i];
    nodes.thickness[a] = shell.thickness;
  }
  return nodes;
}

std::vector<ElementMatrix> calc_stiffnesses(const LinearShell& shell) {
  SheetMaterial material;
  material.youngs_modulus = shell.youngs_modulus;
  material.poisson = shell.poisson;
  const ShellLaw law{SheetLaw(material), make_thickness_rule("gauss", 3)};
  std::vector<ElementMatrix> stiffness(shell.quads.size());
  std::vector<LayerState> layers(static_cast<std::size_t>(kGaussPoints * law.rule.size()));
  std::vector<GaussState> gauss(kGaussPoints);
  for (std::size_t e = 0; e < shell.quads.size(); ++e) {
    const ElementNodes nodes = gather(shell, shell.quads[e]);
    initialise_element(nodes, (nodes.x[1] - nodes.x[0]).normalized(), law.rule, {layers, gauss});
    std::vector<LayerState> new_layers = layers;
    std::vector<GaussState> new_gauss = gauss;
    evaluate_element(law, nodes, nodes, {layers, gauss}, {}, {new_layers, new_gauss}, &stiffness[e]);
  }
  return stiffness;
}

}  // namespace

std::vector<int> LinearShell::add_patch(int n1, int n2, const std::function<SurfacePoint(int, int)>& point,
                                        double merge) {
  std::vector<int> nodes;
  for (int j = 0; j <= n2; ++j) {
    for (int i = 0; i <= n1; ++i) {
      const SurfacePoint p = point(i, j);
      int found = -1;
      for (std::size_t k = 0; merge > 0.0 && found < 0 && k < x.size(); ++k) {
        if ((x[k] - p.x).norm() < merge) found = static_cast<int>(k);
      }
      if (found < 0) {
        found = static_cast<int>(x.size());
        x.push_back(p.x);
        triad.push_back({p.tangent, p.normal.cross(p.tangent), p.normal});
      }
      nodes.push_back(found);
    }
  }
  const auto at = [&](int i, int j) { return nodes[static_cast<std::size_t>(j * (n1 + 1) + i)]; };
  for (int j = 0; j < n2; ++j) {
    for (int i = 0; i < n1; ++i) quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return nodes;
}

void LinearShell::finish_mesh() {
  is_held.assign(kDofs * x.size(), 0);
  load = Vector::Zero(static_cast<Eigen::Index>(kDofs * x.size()));
}

void LinearShell::hold(int node, const std::vector<int>& components) {
  for (const int k : components) is_held[static_cast<std::size_t>(kDofs * node + k)] = 1;
}

void LinearShell::add_area_load(const Vec3& per_area) {
  for (const auto& quad : quads) {
    for (int g = 0; g < kGaussPoints; ++g) {
      const Vec2 at = gauss_point(g);
      const ShapeFunctions shape = calc_shape_functions(at[0], at[1]);
      Vec3 g1 = Vec3::Zero(), g2 = Vec3::Zero();
      for (std::size_t a = 0; a < 4; ++a) {
        g1 += shape.n1[a] * x[static_cast<std::size_t>(quad[a])];
        g2 += shape.n2[a] * x[static_cast<std::size_t>(quad[a])];
      }
      const double area = g1.cross(g2).norm();
      for (std::size_t a = 0; a < 4; ++a) load.segment<3>(kDofs * quad[a]) += shape.n[a] * area * per_area;
    }
  }
}

Vector LinearShell::solve() const {
  BlockMatrix matrix(static_cast<int>(x.size()), quads);
  matrix.assemble(calc_stiffnesses(*this), std::vector<NodeBlock>(x.size(), NodeBlock::Zero()), 0, x.size());
  std::vector<double> values;
  matrix.eliminate(is_held, youngs_modulus * thickness, values);
  LinearSolver solver(matrix);
  const Factorisation f = solver.factorise(values);
  if (!f.is_usable || f.negative_pivots > 0) throw std::runtime_error("the shell is not held");
  Vector rhs = load;
  for (std::size_t k = 0; k < is_held.size(); ++k) {
    if (is_held[k] != 0) rhs[static_cast<Eigen::Index>(k)] = 0.0;
  }
  return solver.solve(rhs);
}

}  // namespace hydroscope::verification
