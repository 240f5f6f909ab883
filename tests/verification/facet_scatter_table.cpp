// SPDX-License-Identifier: GPL-3.0-or-later
// Writes facet_scatter.csv: contact pressure of the tube of V9 in round dies of facets
// (docs/verification.md). Usage: hydroscope_facet_scatter_table > facet_scatter.csv
#include <cstdio>

#include "tests/verification/facet_scatter.h"

int main() {
  using hydroscope::verification::FacetScatter;
  std::puts(
      "wall,surface,elements,theta_deg,p_MPa,mean_MPa,rms_MPa,largest_MPa,bound_MPa,free_nodes,releases,"
      "message");
  for (const bool is_elastic : {false, true}) {
    const double pressure = is_elastic ? 60.0 : 30.0;
    for (const int facets : {45, 23, 11}) {  // 2, 3.9, 8.2 degrees
      // Every node in the middle of its facet; nodes all over the facets; and a finer wall.
      for (const int elements : {facets, facets + 1, 2 * facets}) {
        for (const char* surface : {"exact", "facets", "smooth", "nagata"}) {
          const FacetScatter s = hydroscope::verification::measure_facet_scatter(surface, facets, elements,
                                                                                 pressure, is_elastic);
          std::printf("%s,%s,%d,%.3f,%g,%.4f,%.4f,%.4f,%.4f,%d,%d,%s\n", is_elastic ? "elastic" : "M1",
                      surface, elements, s.facet_angle, pressure, s.mean, s.rms, s.largest, s.bound,
                      s.free_nodes, s.releases, s.message.c_str());
          std::fflush(stdout);
        }
      }
    }
  }
}
