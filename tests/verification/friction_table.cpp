// SPDX-License-Identifier: GPL-3.0-or-later
// Writes friction.csv: corner thickness and pressure of the thin wall in the square die with Coulomb
// friction against FrictionWall, for materials, coefficients and meshes (docs/verification.md).
// Usage: hydroscope_friction_table [elements ...] [key=value ...] > friction.csv, in the project's folder.
#include <cstdio>
#include <string>

#include "tests/verification/friction_die.h"

namespace {

using namespace hydroscope::verification;

void print(const FrictionCase& run) {
  const FrictionComparison c = compare_friction(run, {25, 20, 18, 16, 15, 14.5, 14, 13.5, 12, 10, 9});
  for (const FrictionResultRow& r : c.rows) {
    std::printf("%s,%.2f,%d,%g,%.4f,%.4f,%.3f,%.5f,%.5f,%.3f\n", run.name.c_str(), run.friction, run.elements,
                r.rho, r.pressure, r.wanted_pressure, 100.0 * (r.pressure / r.wanted_pressure - 1.0),
                r.thickness, r.wanted_thickness, 100.0 * (r.thickness / r.wanted_thickness - 1.0));
  }
  std::fprintf(
      stderr,
      "%s mu %.2f, %d elements: ends at rho %.3f (neck %.3f), profile %.3f %% at %.1f mm, %.0f %% stick, %d "
      "increments, %.1f s %s\n",
      run.name.c_str(), run.friction, run.elements, c.end_rho, c.neck_rho, 100.0 * c.profile_error,
      c.profile_place, 100.0 * c.sticking_share, c.increments, c.seconds, c.message.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> meshes;
  std::vector<std::string> settings;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    if (text.find('=') != std::string::npos) {
      settings.push_back(text);
    } else {
      meshes.push_back(std::stoi(text));
    }
  }
  if (meshes.empty()) meshes = {36, 72, 144};
  std::puts("material,mu,elements,rho_mm,p_MPa,p_ref_MPa,p_error_percent,t_mm,t_ref_mm,t_error_percent");
  for (const int elements : meshes) {
    for (const double mu : {0.05, 0.1, 0.2}) {
      for (const char* material : {"M1", "M2"}) {
        FrictionCase run = make_friction_case(material, mu, elements);
        run.settings.insert(run.settings.end(), settings.begin(), settings.end());
        print(run);
      }
    }
  }
}
