// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/shell/shell_element.h"

#include <cmath>

#include "solver/shell/bases.h"
#include "solver/shell/transverse_shear.h"

namespace hydroscope {

namespace {

using DirectorMap = Eigen::Matrix<double, 3, 2>;
using Generalised = Eigen::Matrix<double, 9, 1>;
using GeneralisedTangent = Eigen::Matrix<double, 9, 9>;

/// Through-thickness sums at a Gauss point: stress moments (n, m, k) conjugate
/// to the metric's three coefficients, and their tangent.
struct Section {
  Generalised stress = Generalised::Zero();
  GeneralisedTangent tangent = GeneralisedTangent::Zero();
  double trace = 0.0;  ///< mean of sigma11 + sigma22 + sigma33
  double strain_increment = 0.0, plastic_increment = 0.0, elastic_share = 1.0;
};

double calc_equivalent_strain(const Vec3& e) {
  const double e33 = -(e[0] + e[1]);
  return std::sqrt(2.0 / 3.0 * (e[0] * e[0] + e[1] * e[1] + e33 * e33 + 0.5 * e[2] * e[2]));
}

Section integrate_section(const ShellLaw& law, const MetricPolynomial& start, const MetricPolynomial& end,
                          std::span<const LayerState> layers, std::span<LayerState> out, double sigma33_start,
                          double sigma33_end, TangentKind tangent, double volume) {
  const auto n = static_cast<std::size_t>(law.rule.size());
  double total = 0.0;
  for (std::size_t k = 0; k < n; ++k) total += law.rule.weight[k] * std::sqrt(start(law.rule.zeta[k]).det());
  Section section;
  std::array<Mat3, 5> moments;
  moments.fill(Mat3::Zero());
  for (std::size_t k = 0; k < n; ++k) {
    const double z = law.rule.zeta[k];
    const Metric from = start(z);
    const LayerResponse r =
        advance_layer(law.sheet, layers[k], from, end(z), sigma33_end, sigma33_end - sigma33_start, tangent);
    out[k] = r.state;
    const double share = law.rule.weight[k] * std::sqrt(from.det()) / total;
    const double w = volume * share;
    double power = w;
    for (std::size_t i = 0; i < 5; ++i, power *= z) {
      if (tangent != TangentKind::kNone) moments[i] += power * r.tangent;
      if (i < 3) section.stress.segment<3>(static_cast<Eigen::Index>(3 * i)) += power * r.stress;
    }
    section.trace += share * (r.state.point.stress[0] + r.state.point.stress[1] + 3.0 * sigma33_end);
    section.strain_increment = std::max(section.strain_increment, calc_equivalent_strain(r.strain_increment));
    section.plastic_increment = std::max(section.plastic_increment, r.plastic_increment);
    section.elastic_share = std::min(section.elastic_share, r.elastic_share);
  }
  for (std::size_t i = 0; tangent != TangentKind::kNone && i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      section.tangent.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j)) =
          moments[i + j];
    }
  }
  if (!law.curvature_terms) {  // nothing turns with the third coefficient of the metric
    section.stress.tail<3>().setZero();
    section.tangent.rightCols<3>().setZero();
    section.tangent.bottomRows<3>().setZero();
  }
  return section;
}

/// Contracts a symmetric convected tensor t (11, 22, 12) with derivatives of node a: t^ij N_a,i v_j.
Vec3 contract(const Vec3& t, double n1, double n2, const Vec3& v1, const Vec3& v2) {
  return (t[0] * n1 + t[2] * n2) * v1 + (t[2] * n1 + t[1] * n2) * v2;
}

/// d (a_11, a_22, 2 a_12) / d v of v . w, where node a moves the base vectors by N_a,i v.
Mat3 calc_metric_rows(double n1, double n2, const Vec3& v1, const Vec3& v2) {
  Mat3 rows;
  rows << n1 * v1.transpose(), n2 * v2.transpose(), (n1 * v2 + n2 * v1).transpose();
  return rows;
}

/// Derivatives of the nine generalised strains at one node: its displacement turns the first six, its
/// fibre the last six.
struct StrainRows {
  Eigen::Matrix<double, 6, 3> shift;
  Eigen::Matrix<double, 6, 2> turn;
};

std::array<StrainRows, 4> calc_strain_rows(const Bases& b, const ShapeFunctions& s,
                                           const std::array<DirectorMap, 4>& w) {
  std::array<StrainRows, 4> rows;
  for (std::size_t a = 0; a < 4; ++a) {
    const Mat3 of_metric = calc_metric_rows(s.n1[a], s.n2[a], b.g1, b.g2),
               of_bending = calc_metric_rows(s.n1[a], s.n2[a], b.d1, b.d2);
    rows[a].shift << of_metric, of_bending;
    rows[a].turn << of_metric * w[a], of_bending * w[a];
  }
  return rows;
}

/// Material part of the upper blocks (a <= b); mirror_upper_blocks() does the rest. Products of this size are
/// written out by the compiler; a 9 x 20 matrix, half of it zeros, would go through a general one.
void add_material(const GeneralisedTangent& tangent, const std::array<StrainRows, 4>& rows,
                  ElementMatrix& k) {
  const Eigen::Matrix<double, 6, 6> shift_shift = tangent.topLeftCorner<6, 6>(),
                                    shift_turn = tangent.topRightCorner<6, 6>(),
                                    turn_turn = tangent.bottomRightCorner<6, 6>(),
                                    turn_shift = tangent.bottomLeftCorner<6, 6>();
  for (std::size_t b = 0; b < 4; ++b) {
    const auto ib = static_cast<Eigen::Index>(kDofs * b);
    const Eigen::Matrix<double, 6, 3> by_shift = shift_shift.lazyProduct(rows[b].shift),
                                      turned_by_shift = turn_shift.lazyProduct(rows[b].shift);
    const Eigen::Matrix<double, 6, 2> by_turn = shift_turn.lazyProduct(rows[b].turn),
                                      turned_by_turn = turn_turn.lazyProduct(rows[b].turn);
    for (std::size_t a = 0; a <= b; ++a) {
      const auto ia = static_cast<Eigen::Index>(kDofs * a);
      k.block<3, 3>(ia, ib) += rows[a].shift.transpose().lazyProduct(by_shift);
      k.block<3, 2>(ia, ib + 3) += rows[a].shift.transpose().lazyProduct(by_turn);
      k.block<2, 3>(ia + 3, ib) += rows[a].turn.transpose().lazyProduct(turned_by_shift);
      k.block<2, 2>(ia + 3, ib + 3) += rows[a].turn.transpose().lazyProduct(turned_by_turn);
    }
  }
}

void mirror_upper_blocks(ElementMatrix& k) {
  for (Eigen::Index b = 0; b < 4; ++b) {
    for (Eigen::Index a = 0; a < b; ++a) {
      k.block<kDofs, kDofs>(kDofs * b, kDofs * a) = k.block<kDofs, kDofs>(kDofs * a, kDofs * b).transpose();
    }
  }
}

/// Initial-stress part of the upper blocks: second variations of the metric's coefficients.
void add_initial_stress(const Generalised& stress, const ShapeFunctions& s,
                        const std::array<DirectorMap, 4>& w, ElementMatrix& k) {
  const auto bilinear = [&](Eigen::Index at, std::size_t a, std::size_t b) {
    return stress[at] * s.n1[a] * s.n1[b] + stress[at + 1] * s.n2[a] * s.n2[b] +
           stress[at + 2] * (s.n1[a] * s.n2[b] + s.n2[a] * s.n1[b]);
  };
  for (std::size_t b = 0; b < 4; ++b) {
    for (std::size_t a = 0; a <= b; ++a) {
      const auto ia = static_cast<Eigen::Index>(kDofs * a), ib = static_cast<Eigen::Index>(kDofs * b);
      k.block<3, 3>(ia, ib).diagonal().array() += bilinear(0, a, b);
      const double mixed = bilinear(3, a, b);
      k.block<3, 2>(ia, ib + 3) += mixed * w[b];
      k.block<2, 3>(ia + 3, ib) += mixed * w[a].transpose();
      k.block<2, 2>(ia + 3, ib + 3) += bilinear(6, a, b) * w[a].transpose() * w[b];
    }
  }
}

/// Sums over the Gauss points that belong to the tied shear.
struct ShearSums {
  std::array<double, 4> stress{};
  Eigen::Matrix4d moduli = Eigen::Matrix4d::Zero();
};

/// Elastic update of the tied shear: S += kappa G (2/h)^2 a^ij dgamma_j with the start metric.
void advance_shear(const ShellLaw& law, const Metric& start, double half_thickness, const Vec2& at,
                   double volume, const TiedShear& from, const TiedShear& to, GaussState& gauss,
                   ShearSums& sums) {
  const auto weight = calc_tying_weights(at);
  Mat2 inverse;
  inverse << start.a22, -start.a12, -start.a12, start.a11;
  const double scale = law.shear_correction * law.sheet.material.shear_modulus() /
                       (half_thickness * half_thickness * start.det());
  const Mat2 moduli = scale * inverse;
  Vec2 increment = Vec2::Zero();
  for (std::size_t t = 0; t < 4; ++t) {
    increment[kTyingPoints[t].direction - 1] += weight[t] * (to.gamma[t] - from.gamma[t]);
  }
  gauss.shear += moduli * increment;
  for (std::size_t t = 0; t < 4; ++t) {
    const int i = kTyingPoints[t].direction - 1;
    sums.stress[t] += volume * weight[t] * gauss.shear[i];
    for (std::size_t r = 0; r < 4; ++r) {
      const int j = kTyingPoints[r].direction - 1;
      sums.moduli(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(r)) +=
          volume * weight[t] * weight[r] * moduli(i, j);
    }
  }
}

double interpolate(const std::array<double, 4>& nodal, const ShapeFunctions& s) {
  return nodal[0] * s.n[0] + nodal[1] * s.n[1] + nodal[2] * s.n[2] + nodal[3] * s.n[3];
}

/// Tables of the four Gauss points, evaluated once.
const std::array<ShapeFunctions, kGaussPoints>& gauss_shapes() {
  static const auto kShapes = [] {
    std::array<ShapeFunctions, kGaussPoints> shapes;
    for (int i = 0; i < kGaussPoints; ++i) {
      const Vec2 at = gauss_point(i);
      shapes[static_cast<std::size_t>(i)] = calc_shape_functions(at[0], at[1]);
    }
    return shapes;
  }();
  return kShapes;
}

}  // namespace

ElementResponse evaluate_element(const ShellLaw& law, const ElementNodes& start, const ElementNodes& end,
                                 const ElementPart& state, const ElementSettings& settings,
                                 const ElementPartOut& out, ElementMatrix* stiffness) {
  ElementResponse response;
  std::array<Vec3, 4> force, fibre_force;  // conjugate to u and to h/2 V
  std::array<DirectorMap, 4> w;
  for (std::size_t a = 0; a < 4; ++a) {
    force[a] = fibre_force[a] = Vec3::Zero();
    w[a] << -end.triad[a].v2, end.triad[a].v1;
    w[a] *= 0.5 * end.thickness[a];
  }
  if (stiffness != nullptr) stiffness->setZero();
  const TangentKind tangent = stiffness == nullptr   ? TangentKind::kNone
                              : settings.assume_flow ? TangentKind::kFlow
                                                     : TangentKind::kConsistent;
  const TiedShear shear_start(start), shear_end(end);
  ShearSums shear;
  const auto n_z = static_cast<std::size_t>(law.rule.size());
  for (std::size_t i = 0; i < kGaussPoints; ++i) {
    const ShapeFunctions& s = gauss_shapes()[i];
    const Bases bases = calc_bases(end, s);
    const MetricPolynomial metric_start(calc_bases(start, s), law.curvature_terms),
        metric_end(bases, law.curvature_terms);
    GaussState& gauss = out.gauss[i] = state.gauss[i];
    const double volume = gauss.volume * gauss.dilatation;
    const double s33 = interpolate(settings.sigma33.end, s);
    const Section section = integrate_section(
        law, metric_start, metric_end, state.layers.subspan(i * n_z, n_z), out.layers.subspan(i * n_z, n_z),
        interpolate(settings.sigma33.start, s), s33, tangent, volume);
    advance_shear(law, metric_start.c0, 0.5 * interpolate(start.thickness, s),
                  gauss_point(static_cast<int>(i)), volume, shear_start, shear_end, gauss, shear);
    const SheetMaterial& m = law.sheet.material;
    gauss.dilatation = 1.0 + (1.0 - 2.0 * m.poisson) / m.youngs_modulus * section.trace;
    const Vec3 n = section.stress.segment<3>(0), mo = section.stress.segment<3>(3),
               k = section.stress.segment<3>(6);
    const double area = std::sqrt(metric_end.c0.det());
    for (std::size_t a = 0; a < 4; ++a) {
      force[a] += contract(n, s.n1[a], s.n2[a], bases.g1, bases.g2) +
                  contract(mo, s.n1[a], s.n2[a], bases.d1, bases.d2);
      fibre_force[a] += contract(mo, s.n1[a], s.n2[a], bases.g1, bases.g2) +
                        contract(k, s.n1[a], s.n2[a], bases.d1, bases.d2);
      response.area[a] += s.n[a] * area;
      response.volume[a] += s.n[a] * gauss.volume * gauss.dilatation;
    }
    response.strain_increment = std::max(response.strain_increment, section.strain_increment);
    response.elastic_share = std::min(response.elastic_share, section.elastic_share);
    response.plastic_increment = std::max(response.plastic_increment, section.plastic_increment);
    if (stiffness != nullptr) {
      add_material(section.tangent, calc_strain_rows(bases, s, w), *stiffness);
      add_initial_stress(section.stress, s, w, *stiffness);
    }
  }
  add_shear_force(shear_end, shear.stress, force, fibre_force);
  if (stiffness != nullptr) {
    add_shear_stiffness(shear_end, shear.stress, shear.moduli, w, *stiffness);
    mirror_upper_blocks(*stiffness);
  }
  for (std::size_t a = 0; a < 4; ++a) {
    const auto at = static_cast<Eigen::Index>(5 * a);
    response.force.segment<3>(at) = force[a];
    response.force.segment<2>(at + 3) = w[a].transpose() * fibre_force[a];
    if (stiffness != nullptr && law.director_stiffness) {  // second variation: -(d alpha^2 + d beta^2) V
      const double turn = 0.5 * end.thickness[a] * fibre_force[a].dot(end.triad[a].v);
      stiffness->block<2, 2>(at + 3, at + 3).diagonal().array() -= turn;
    }
  }
  return response;
}

void initialise_element(const ElementNodes& nodes, const Vec3& axis, const ThicknessRule& rule,
                        const ElementPartOut& out) {
  const auto n_z = static_cast<std::size_t>(rule.size());
  for (std::size_t i = 0; i < kGaussPoints; ++i) {
    const ShapeFunctions& s = gauss_shapes()[i];
    const Bases b = calc_bases(nodes, s);
    out.gauss[i] = {Vec2::Zero(), b.g1.cross(b.g2).norm() * interpolate(nodes.thickness, s), 1.0};
    for (std::size_t k = 0; k < n_z; ++k) {
      const double z = rule.zeta[k];
      const Vec3 g1 = (b.g1 + z * b.d1).normalized();
      const Vec3 normal = g1.cross(b.g2 + z * b.d2).normalized();
      const double angle = std::atan2(axis.dot(normal.cross(g1)), axis.dot(g1));
      out.layers[i * n_z + k] = {MaterialPoint{}, angle};
    }
  }
}

}  // namespace hydroscope
