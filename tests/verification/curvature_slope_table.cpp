// SPDX-License-Identifier: GPL-3.0-or-later
// Writes curvature_slope.csv: the tangential rest of one node on springs after one slide inside a facet,
// against the length of the slide, without curvature and with K_C whole and symmetrised
// (docs/verification.md). Usage: hydroscope_curvature_slope_table > curvature_slope.csv
#include <cstdio>

#include "tests/solver/curvature_slope.h"

int main() {
  using namespace hydroscope;
  constexpr double kNormalForce = 200.0, kOffset = 0.75, kFirstForce = 200.0;
  std::puts("tool,treatment,slide_mm,rest_transported_N,rest_balanced_N");
  for (const SlopeCase& c : make_slope_cases()) {
    const SpringNode node = make_spring_node(*c.tool, c.at, kOffset, kNormalForce);
    const auto rows = measure_slopes(*c.tool, node, kFirstForce, 12);
    for (const SlopeRow& row : rows) {
      const struct {
        const char* name;
        const TangentialRest& rest;
      } treatments[] = {{"none", row.none}, {"full", row.full}, {"symmetric", row.symmetric}};
      for (const auto& t : treatments) {
        std::printf("%s,%s,%.6e,%.6e,%.6e\n", c.name.c_str(), t.name, t.rest.slide, t.rest.transported,
                    t.rest.balanced);
      }
    }
  }
}
