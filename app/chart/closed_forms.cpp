// SPDX-License-Identifier: GPL-3.0-or-later
// Tubes in plane strain: free expansion (V5), a circular die (V9), a square die (V10).
#include "app/chart/closed_forms.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "app/chart/plane_strain_wall.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr double kPi = std::numbers::pi;

/// sqrt(3), of plane strain under the yield function of von Mises.
const double kRoot = std::sqrt(3.0);

struct Tube {
  double r0 = 0.0, t0 = 0.0;  ///< mid radius and thickness [mm]
  SwiftSteel metal;
};

Tube find_tube(const Scene& scene, const std::string& name) {
  if (scene.sheet != "tube")
    throw InputError(scene.file + ": the closed form '" + name + "' is one of a tube");
  if (scene.material.hardening != "swift")
    throw InputError(scene.file + ": the closed form '" + name + "' needs hardening = \"swift\"");
  const MaterialScene& m = scene.material;
  return {scene.tube.radius,
          scene.tube.thickness,
          {m.youngs_modulus, m.poisson, m.swift_k, m.swift_eps0, m.swift_n}};
}

/// Hoop strain of a frictionless wall that lay against the four flats and now fills the corner down to `rho`:
/// an eighth has a flat of r0 - rho and an arc of pi rho / 4, and was pi r0 / 4 long.
double calc_square_strain(const Tube& tube, double rho) {
  return std::log((tube.r0 - rho * (1.0 - 0.25 * kPi)) / (0.25 * kPi * tube.r0));
}

/// Rigid-plastic hoop stress in plane strain.
double calc_rigid_stress(const Tube& tube, double strain) {
  return 2.0 / kRoot * tube.metal.k * std::pow(tube.metal.eps0 + 2.0 * strain / kRoot, tube.metal.n);
}

/// As far as the wall has come: the elastic-plastic integration.
WallPoint calc_wall(const Tube& tube, double strain) { return integrate_wall(tube.metal, strain); }

double calc_ring_force(const Tube& tube, double strain) {
  const WallPoint wall = calc_wall(tube, strain);
  return wall.hoop_stress * tube.t0 * std::exp(-wall.thinning);
}

/// Flat positions x from the middle, up to where the corner begins; the corner has one thickness.
double calc_sticking_thickness(const Tube& tube, double x, double rho) {
  const double reached = std::min(x, tube.r0 - rho);
  return tube.t0 * std::pow((tube.r0 - reached) / tube.r0, 4.0 / kPi - 1.0);
}

struct Touch {
  double radius = 0.0, pressure = 0.0, hoop_stress = 0.0;
};

/// The free wall expands until its outer face is at the die: r + t/2 = R.
Touch find_touch(const Tube& tube, const Scene& scene, const std::string& name) {
  const auto die = std::find_if(scene.tools.begin(), scene.tools.end(),
                                [](const auto& tool) { return tool.second.shape == "cylinder"; });
  if (die == scene.tools.end())
    throw InputError(scene.file + ": the closed form '" + name + "' needs a cylinder");
  const auto reach = [&](double strain) {
    return tube.r0 * std::exp(strain) + 0.5 * tube.t0 * std::exp(-calc_wall(tube, strain).thinning);
  };
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (reach(middle) < die->second.radius ? low : high) = middle;
  }
  const double radius = tube.r0 * std::exp(low);
  return {radius, calc_ring_force(tube, low) / radius, calc_wall(tube, low).hoop_stress};
}

using Form = std::function<double(const Tube&, const Scene&, double)>;

struct NamedForm {
  std::string name;
  Form form;
};

const std::vector<NamedForm>& forms() {
  static const std::vector<NamedForm> all = {
      {"square-die-frictionless-thickness",
       [](const Tube& t, const Scene&, double rho) { return t.t0 * std::exp(-calc_square_strain(t, rho)); }},
      {"square-die-frictionless-pressure",
       [](const Tube& t, const Scene&, double rho) {
         const double strain = calc_square_strain(t, rho);
         return calc_rigid_stress(t, strain) * t.t0 * std::exp(-strain) / rho;
       }},
      {"square-die-ring-thickness",
       [](const Tube& t, const Scene&, double rho) {
         return t.t0 * std::exp(-calc_wall(t, calc_square_strain(t, rho)).thinning);
       }},
      {"square-die-ring-pressure",
       [](const Tube& t, const Scene&, double rho) {
         return calc_ring_force(t, calc_square_strain(t, rho)) / rho;
       }},
      {"square-die-sticking-thickness",
       [](const Tube& t, const Scene&, double rho) { return calc_sticking_thickness(t, t.r0, rho); }},
      {"expansion-pressure",
       [](const Tube& t, const Scene&, double radius) {
         const double strain = std::log(radius / t.r0);
         return calc_rigid_stress(t, strain) * t.t0 * std::exp(-strain) / radius;
       }},
      {"expansion-ring-pressure",
       [](const Tube& t, const Scene&, double radius) {
         return calc_ring_force(t, std::log(radius / t.r0)) / radius;
       }},
      {"circular-die-contact-pressure",
       [](const Tube& t, const Scene& scene, double pressure) {
         return std::max(0.0, pressure - find_touch(t, scene, "circular-die-contact-pressure").pressure);
       }},
      {"circular-die-springback-radius", [](const Tube& t, const Scene& scene, double) {
         // The hoop stress is taken away elastically: ln(r / r_touch) = -(1 - nu^2) sigma / E.
         const Touch touch = find_touch(t, scene, "circular-die-springback-radius");
         const double nu = t.metal.poisson;
         return touch.radius * std::exp(-(1.0 - nu * nu) * touch.hoop_stress / t.metal.youngs_modulus);
       }}};
  return all;
}

}  // namespace

const std::vector<std::string>& closed_form_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const NamedForm& form : forms()) list.push_back(form.name);
    return list;
  }();
  return names;
}

double calc_closed_form(const std::string& name, const Scene& scene, double driver) {
  for (const NamedForm& form : forms())
    if (form.name == name) return form.form(find_tube(scene, name), scene, driver);
  throw ContractError("a closed form is one of closed_form_names()");
}

const std::vector<std::string>& profile_form_names() {
  static const std::vector<std::string> names = {"square-die-frictionless", "square-die-ring",
                                                 "square-die-sticking"};
  return names;
}

double calc_profile_form(const std::string& name, const Scene& scene, double angle, double rho) {
  const Tube tube = find_tube(scene, name);
  if (name == "square-die-sticking") return calc_sticking_thickness(tube, tube.r0 * std::tan(angle), rho);
  return calc_closed_form(name + "-thickness", scene, rho);
}

}  // namespace hydroscope
