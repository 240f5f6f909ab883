// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/facet_scatter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/generators/die_meshes.h"
#include "scenes/generators/stl_file.h"
#include "tests/temporary_folder.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {

namespace {

constexpr double kDie = 32.703915;    // touches M1's wall of 1.5 mm when its mid radius is 32
constexpr double kElasticDie = 30.8;  // an elastic wall would need 500 MPa for that: 0.05 mm of clearance

std::string make_scene(const std::string& surface, const std::string& file, bool is_elastic) {
  const std::string radius = std::to_string(is_elastic ? kElasticDie : kDie);
  const std::string tool = surface == "exact"
                               ? "shape = \"cylinder\"\nradius_mm = " + radius + "\n"
                               : "file = \"" + file + "\"\nflip = true\nsurface = \"" + surface + "\"\n";
  const std::string law = is_elastic ? ""
                                     : "hardening = \"swift\"\nswift_K_MPa = 550.0\nswift_eps0 = 0.01\n"
                                       "swift_n = 0.2\n";
  return "[tube]\nradius_mm = 30.0\nthickness_mm = 1.5\nlength_mm = 2.0\nsection = \"quarter\"\n"
         "extent = \"slice\"\nelements_around = 45\n[material]\nyoungs_modulus_MPa = 206e3\npoisson = 0.3\n" +
         law + "[load]\npressure_MPa = [[0.0, 0.0], [1.0, 30.0]]\n[tool.die]\n" + tool;
}

void count_events(const History& h, FacetScatter& s) {
  for (const IncrementReport& row : h.rows) {
    for (const ContactEvent& event : row.events) s.releases += event.kind == EventKind::kDetach ? 1 : 0;
  }
}

void measure_nodes(const Snapshot& end, FacetScatter& s) {
  // One edge of the slice; nodes on the symmetry planes carry half an area and are left out.
  const std::size_t nodes = end.points.size() / 2;
  const double width = std::abs(end.points[nodes].z() - end.points[0].z());
  std::vector<double> pressure;
  for (std::size_t i = 1; i + 1 < nodes; ++i) {
    const double length = 0.5 * (end.points[i + 1] - end.points[i - 1]).norm();
    const double force = end.contact_force[i].dot(end.tool_normal[i]);
    s.free_nodes += end.contact_state[i] == ContactClass::kFree ? 1 : 0;
    pressure.push_back(std::abs(force) / (0.5 * width * length));
    s.mean += pressure.back() / static_cast<double>(nodes - 2);
  }
  for (const double p : pressure) {
    s.rms += (p - s.mean) * (p - s.mean) / static_cast<double>(pressure.size());
    s.largest = std::max(s.largest, std::abs(p - s.mean));
  }
  s.rms = std::sqrt(s.rms);
}

}  // namespace

FacetScatter measure_facet_scatter(const std::string& surface, int facets_in_quarter, int elements,
                                   double pressure, bool is_elastic) {
  FacetScatter s;
  s.facet_angle = 90.0 / facets_in_quarter;
  const TemporaryFolder folder;
  const std::string file = folder / "round_die.stl";
  Punch round;
  round.radius = is_elastic ? kElasticDie : kDie;
  round.start = 0.5 * s.facet_angle;
  round.end = round.start + 360.0;
  round.length = 12.0;
  round.facet_angle = s.facet_angle;
  write_file(file, make_binary_stl(make_punch(round), "round die"));
  const History h = run_text(make_scene(surface, file, is_elastic),
                             {"tube.elements_around=" + std::to_string(elements),
                              "load.pressure_MPa=[[0, 0], [1, " + std::to_string(pressure) + "]]"});
  if (h.summary.outcome != Outcome::kCompleted) s.message = h.summary.message;
  count_events(h, s);
  measure_nodes(*h.states.back(), s);
  const Snapshot& end = *h.states.back();
  const double plane_strain_modulus = 206e3 / (1.0 - 0.09), theta = s.facet_angle * std::numbers::pi / 180.0;
  s.bound =
      plane_strain_modulus * end.thickness[end.thickness.size() / 4] / round.radius * theta * theta / 8.0;
  return s;
}

}  // namespace hydroscope::verification
