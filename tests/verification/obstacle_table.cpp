// SPDX-License-Identifier: GPL-3.0-or-later
// Writes obstacle_course.csv: the shell obstacle course over meshes of 4 to 64 elements a side
// (docs/verification.md). Usage: hydroscope_obstacle_table [largest number of elements] > obstacle_course.csv
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/verification/obstacle_course.h"

int main(int argc, char** argv) {
  const int largest = argc > 1 ? std::stoi(argv[1]) : 64;
  std::puts("case,elements_a_side,displacement,reference,ratio,change_percent");
  for (const auto& obstacle : hydroscope::verification::list_obstacles()) {
    // Beams have six to nine times as many elements along as across.
    const bool is_beam = obstacle.name.find("beam") != std::string::npos || obstacle.name == "raasch_hook";
    double last = NAN;
    for (int n = is_beam ? 2 : 4; n <= (is_beam ? largest / 2 : largest); n *= 2) {
      const double value = obstacle.solve(n);
      std::printf("%s,%d,%.6e,%.6e,%.5f,%.3f\n", obstacle.name.c_str(), n, value, obstacle.reference,
                  value / obstacle.reference, 100.0 * (value / last - 1.0));
      std::fflush(stdout);
      last = value;
    }
  }
}
