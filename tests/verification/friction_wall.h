// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/verification/plane_strain_ring.h"

namespace hydroscope::verification {

/// Corner filling of a square die in plane strain with Coulomb friction, as a membrane of its own
/// equations (mechanics V10), nothing of the solver's. An eighth of the mid-surface is a flat of length
/// l = r0 - rho and a free arc of rho pi/4.
///
/// In the arc the tension is even, N = p rho. The wall on the flat slides towards the corner, and the
/// die's friction mu p holds it back: N(x) = p (rho - mu (l - x)), x from the middle of the flat. Where
/// that is less than the wall has carried before, it rests: its strain and its tension stay. Hence each
/// piece has e = max(e before, e_N(N(x))), e_N the inverse of the tension N(e) = s_th t of the elastic-
/// plastic wall, which only loads. The pressure is the one for which the pieces are together as long as
/// the section.
struct CornerState {
  double rho = 0.0;               ///< mid-surface radius of the corner [mm]
  double pressure = 0.0;          ///< [MPa]
  double corner_strain = 0.0;     ///< hoop strain of the arc
  double corner_thickness = 0.0;  ///< [mm]
  std::vector<double> position;   ///< of the middle of each piece along the wall, from the flat's middle [mm]
  std::vector<double> thickness;  ///< of each piece [mm]
};

class FrictionWall {
 public:
  struct Section {
    double radius, thickness;  ///< r0 and t0 [mm]
    double friction;           ///< mu
  };
  /// `pieces` equal parts of the eighth, rho falling in `steps` equal parts down to `last_rho` [mm] or to
  /// the neck, whichever comes first.
  FrictionWall(const Metal& metal, const Section& section, double last_rho, int pieces, int steps);

  const std::vector<CornerState>& states() const { return states_; }
  /// Between the two nearest states, pieces left out.
  CornerState at(double rho) const;
  /// The state nearest to `rho`, with its pieces.
  const CornerState& nearest(double rho) const;
  /// Smallest radius before the arc cannot carry more force: the wall necks there [mm].
  double last_radius() const { return states_.back().rho; }
  /// Hoop strain at which the tension of the wall is largest.
  double neck_strain() const { return neck_strain_; }
  double thickness_at(double hoop_strain) const;

 private:
  /// Inverse of the tension per width [N/mm]; the neck's strain when it is above all.
  double find_strain(double tension) const;
  /// Length of the eighth at `pressure`, and the strains that make it.
  double calc_length(double rho, double pressure, std::vector<double>& strains) const;

  Section section_;
  double piece_ = 0.0;  ///< length of a piece before straining [mm]
  double neck_strain_ = 0.0;
  std::vector<double> strain_table_, tension_table_, thinning_table_;  ///< up to the neck
  std::vector<double> strains_;                                        ///< of the last state
  std::vector<CornerState> states_;
};

}  // namespace hydroscope::verification
