// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/shell/layer.h"

#include <cmath>

namespace hydroscope {

namespace {

/// Upper-triangular G with G^T G = metric: base vectors in a frame whose first axis lies along g_1.
struct Frame {
  double g11, g12, g22;
};

Frame calc_frame(const Metric& a) {
  const double g11 = std::sqrt(a.a11);
  const double g12 = a.a12 / g11;
  return {g11, g12, std::sqrt(a.a22 - g12 * g12)};
}

struct Stretch {
  Vec3 strain;  ///< 2 (U - 1)(U + 1)^-1 in the start frame, engineering shear
  double spin;  ///< angle of the polar rotation between the two frames [rad]
};

/// F = G_end G_start^-1 is upper triangular; U = (F^T F + sqrt(det) 1) / sqrt(tr + 2 sqrt(det)).
Stretch calc_stretch(const Frame& start, const Frame& end) {
  const double f11 = end.g11 / start.g11;
  const double f22 = end.g22 / start.g22;
  const double f12 = (end.g12 - f11 * start.g12) / start.g22;
  const double det = f11 * f22;
  const double c11 = f11 * f11, c12 = f11 * f12, c22 = f12 * f12 + f22 * f22;
  const double scale = 1.0 / std::sqrt(c11 + c22 + 2.0 * det);
  const double u11 = (c11 + det) * scale, u12 = c12 * scale, u22 = (c22 + det) * scale;
  const double p11 = u11 + 1.0, p22 = u22 + 1.0;
  const double inverse = 2.0 / (p11 * p22 - u12 * u12);
  const double e11 = inverse * ((u11 - 1.0) * p22 - u12 * u12);
  const double e22 = inverse * ((u22 - 1.0) * p11 - u12 * u12);
  const double e12 = inverse * 2.0 * u12;
  return {Vec3(e11, e22, 2.0 * e12), std::atan2(-f12, f11 + f22)};
}

/// Strain components in axes turned by the angle with cosine c and sine s.
Vec3 turn_strain(const Vec3& e, double c, double s) {
  return {c * c * e[0] + s * s * e[1] + c * s * e[2], s * s * e[0] + c * c * e[1] - c * s * e[2],
          2.0 * c * s * (e[1] - e[0]) + (c * c - s * s) * e[2]};
}

/// T: covariant convected strains -> Cartesian strains in the material frame, eps = H^T E H.
Mat3 calc_push_forward(const Frame& g, double c, double s) {
  // H = G^-1 R(angle); columns are the material axes in convected components.
  const double i11 = 1.0 / g.g11, i22 = 1.0 / g.g22, i12 = -g.g12 * i11 * i22;
  const double h11 = i11 * c + i12 * s, h12 = -i11 * s + i12 * c;
  const double h21 = i22 * s, h22 = i22 * c;
  Mat3 t;
  t << h11 * h11, h21 * h21, h11 * h21, h12 * h12, h22 * h22, h12 * h22, 2.0 * h11 * h12, 2.0 * h21 * h22,
      h11 * h22 + h21 * h12;
  return t;
}

/// Voigt matrix of D sigma + sigma D in the plane (mechanics 1.2).
Mat3 calc_convective(const Vec3& s) {
  Mat3 q;
  q << 2.0 * s[0], 0.0, s[2], 0.0, 2.0 * s[1], s[2], s[2], s[2], 0.5 * (s[0] + s[1]);
  return q;
}

}  // namespace

LayerResponse advance_layer(const SheetLaw& law, const LayerState& state, const Metric& start,
                            const Metric& end, double sigma33, double sigma33_increment,
                            TangentKind tangent) {
  const Frame end_frame = calc_frame(end);
  const Stretch stretch = calc_stretch(calc_frame(start), end_frame);
  LayerResponse out;
  out.strain_increment = turn_strain(stretch.strain, std::cos(state.angle), std::sin(state.angle));
  const StressUpdate update =
      update_stress(law, state.point, out.strain_increment, sigma33_increment, tangent);
  out.state = {update.point, state.angle + stretch.spin};
  out.plastic_increment = update.plastic_increment;
  out.elastic_share = update.elastic_share;
  const Vec3 stress = update.point.stress + Vec3(sigma33, sigma33, 0.0);
  const Mat3 t = calc_push_forward(end_frame, std::cos(out.state.angle), std::sin(out.state.angle));
  out.stress = t.transpose() * stress;
  if (tangent == TangentKind::kNone) return out;
  out.tangent = t.transpose() * (update.tangent - calc_convective(stress)) * t;
  return out;
}

}  // namespace hydroscope
