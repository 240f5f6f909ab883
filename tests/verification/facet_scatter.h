// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope::verification {

/// The tube of V9 in a round die of flat facets that stand half a facet off the symmetry planes (V22).
struct FacetScatter {
  double facet_angle = 0.0;  ///< theta [deg]; 90 degrees are a whole number of facets
  double mean = 0.0;         ///< contact pressure, of nodal forces over nodal areas [MPa]
  double rms = 0.0;          ///< scatter about the mean [MPa]
  double largest = 0.0;      ///< largest distance from the mean [MPa]
  double bound = 0.0;        ///< E' (t/R) theta^2 / 8 (mechanics 6.3) [MPa]
  int free_nodes = 0;        ///< that do not touch
  int releases = 0;          ///< nodes let go on the way up: none should
  std::string message;       ///< empty when the run was completed
};

/// `surface`: exact | facets | smooth | nagata. Pressure rises to `pressure` [MPa] with `elements` in a
/// quarter. `is_elastic`: a wall that does not yield, against which the bound is derived.
FacetScatter measure_facet_scatter(const std::string& surface, int facets_in_quarter, int elements,
                                   double pressure, bool is_elastic);

}  // namespace hydroscope::verification
