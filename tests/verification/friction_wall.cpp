// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/friction_wall.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hydroscope::verification {

namespace {

constexpr double kEighth = std::numbers::pi / 4.0;

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto i = static_cast<std::size_t>(above - x.begin());
  const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + share * (y[i] - y[i - 1]);
}

}  // namespace

FrictionWall::FrictionWall(const Metal& metal, const Section& section, double last_rho, int pieces, int steps)
    : section_(section), piece_(kEighth * section.radius / pieces) {
  const double reach = std::max(metal.n + 0.02, 0.1);  // the neck's strain is n - (sqrt3/2) eps0
  const PlaneStrainWall wall(metal, reach);
  for (double e = 0.0; e < reach; e += 1e-5) {
    const WallState s = wall.at(e);
    const double tension = s.hoop_stress * section.thickness * std::exp(-s.thinning);
    if (!tension_table_.empty() && tension <= tension_table_.back()) break;
    strain_table_.push_back(e);
    tension_table_.push_back(tension);
    thinning_table_.push_back(s.thinning);
  }
  neck_strain_ = strain_table_.back();
  strains_.assign(static_cast<std::size_t>(pieces), 0.0);
  for (int step = 1; step <= steps; ++step) {
    const double rho = section.radius + (last_rho - section.radius) * step / steps;
    const double wanted = section.radius - rho + kEighth * rho;
    double low = 0.0, high = tension_table_.back() / rho;
    std::vector<double> strains = strains_;
    if (calc_length(rho, high, strains) < wanted) break;  // the arc would have to carry more than it can
    for (int i = 0; i < 60 && high - low > 1e-13 * high; ++i) {
      const double middle = 0.5 * (low + high);
      (calc_length(rho, middle, strains) < wanted ? low : high) = middle;
    }
    calc_length(rho, high, strains);
    strains_ = strains;
    CornerState s{rho, high, find_strain(high * rho), 0.0, {}, {}};
    s.corner_thickness = thickness_at(s.corner_strain);
    double x = 0.0;
    for (const double e : strains_) {
      const double length = piece_ * std::exp(e);
      s.position.push_back(x + 0.5 * length);
      s.thickness.push_back(thickness_at(e));
      x += length;
    }
    states_.push_back(std::move(s));
  }
  if (states_.empty()) throw std::invalid_argument("the wall necks at once");
}

double FrictionWall::find_strain(double tension) const {
  return interpolate(tension_table_, strain_table_, std::min(tension, tension_table_.back()));
}

double FrictionWall::thickness_at(double hoop_strain) const {
  return section_.thickness * std::exp(-interpolate(strain_table_, thinning_table_, hoop_strain));
}

// From the 45 degree line back to the middle of the flat. The tension of a piece is that at its middle;
// its length is taken from its last strain: an error of second order in the piece.
double FrictionWall::calc_length(double rho, double pressure, std::vector<double>& strains) const {
  double length = 0.0;
  for (std::size_t i = strains.size(); i-- > 0;) {
    const double middle = length + 0.5 * piece_ * std::exp(strains_[i]);
    const double on_flat = std::max(middle - kEighth * rho, 0.0);  // l - x
    const double tension = pressure * (rho - section_.friction * on_flat);
    strains[i] = std::max(strains_[i], tension > 0.0 ? find_strain(tension) : 0.0);
    length += piece_ * std::exp(strains[i]);
  }
  return length;
}

CornerState FrictionWall::at(double rho) const {
  for (std::size_t i = 0; i + 1 < states_.size(); ++i) {
    const CornerState &a = states_[i], &b = states_[i + 1];
    if ((a.rho - rho) * (b.rho - rho) > 0.0) continue;
    const double share = (rho - a.rho) / (b.rho - a.rho);
    const auto mix = [&](double x, double y) { return x + share * (y - x); };
    return {rho,
            mix(a.pressure, b.pressure),
            mix(a.corner_strain, b.corner_strain),
            mix(a.corner_thickness, b.corner_thickness),
            {},
            {}};
  }
  throw std::out_of_range("the wall does not reach this corner radius");
}

const CornerState& FrictionWall::nearest(double rho) const {
  return *std::min_element(states_.begin(), states_.end(), [&](const CornerState& a, const CornerState& b) {
    return std::abs(a.rho - rho) < std::abs(b.rho - rho);
  });
}

}  // namespace hydroscope::verification
