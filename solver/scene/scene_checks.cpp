// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene_checks.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"
#include "solver/scene/number_text.h"
#include "solver/scene/scene_choices.h"

namespace hydroscope {
namespace {

template <class Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& items) {
  std::vector<std::string> names;
  for (const auto& [name, item] : items) names.push_back(name);
  return names;
}

/// "; did you mean 'x'?" or a list of what there is.
std::string suggest(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = find_nearest_name(name, known);
  if (!nearest.empty()) return "; did you mean '" + nearest + "'?";
  if (known.empty()) return "; the scene has none";
  std::string list;
  for (const std::string& item : known) list += (list.empty() ? "" : ", ") + item;
  return "; there is: " + list;
}

void check_sheet(const GivenKeys& given, Scene& scene) {
  for (const char* table : {"tube", "strip", "mesh"}) {
    if (!given.has(table)) continue;
    if (!scene.sheet.empty()) {
      given.fail_at(table, "table [" + std::string(table) + "] contradicts [" + scene.sheet +
                               "]: exactly one of [tube], [strip] and [mesh] describes the sheet");
    }
    scene.sheet = table;
  }
  if (scene.sheet.empty()) {
    throw InputError(given.file() + ": the sheet is missing: give one of [tube], [strip] and [mesh]");
  }
}

void check_grading(const GivenKeys& given, const TubeScene& tube) {
  const double low = tube.extent == "half" ? 0.0 : -tube.length / 2;
  for (const auto& [z, size] : tube.grading_along) {
    if (z >= low - 1e-9 && z <= tube.length / 2 + 1e-9) continue;
    given.fail("tube.grading_along", "z = " + format_exact(z) +
                                         " lies outside the modelled length; allowed: " + format_exact(low) +
                                         " to " + format_exact(tube.length / 2));
  }
}

void check_tube(const GivenKeys& given, TubeScene& tube, bool is_mesh_chosen) {
  const bool mid = given.has("tube.radius_mm"), outer = given.has("tube.outer_radius_mm");
  if (mid && outer) given.fail("tube.outer_radius_mm", "contradicts 'radius_mm'; give one of them");
  if (!mid && !outer) given.fail_at("tube", "key 'tube.radius_mm' is missing (or 'tube.outer_radius_mm')");
  const char* key = mid ? "tube.radius_mm" : "tube.outer_radius_mm";
  if (outer) tube.radius = tube.outer_radius - tube.thickness / 2;
  if (tube.thickness >= tube.radius) {
    given.fail("tube.thickness_mm", format_exact(tube.thickness) + " is too thick for a shell of radius " +
                                        format_exact(tube.radius) + " mm (see '" + key + "')");
  }
  if (!outer) tube.outer_radius = tube.radius + tube.thickness / 2;
  if (tube.extent == "slice" && tube.elements_along != 1) {
    given.fail("tube.elements_along", "a slice has one row of elements; leave this out");
  }
  check_grading(given, tube);
  if (is_mesh_chosen) return;
  if (!given.has("tube.elements_around")) given.fail_at("tube", "key 'tube.elements_around' is missing");
  if (tube.elements_around * tube.elements_along < 2) {
    given.fail("tube.elements_around", "a mesh of one element cannot bend; take 2 or more");
  }
  if (tube.section == "full" && tube.elements_around < 3) {
    given.fail("tube.elements_around",
               std::to_string(tube.elements_around) + " do not close a tube; allowed: at least 3");
  }
}

void check_strip(const GivenKeys& given, const StripScene& strip, bool is_mesh_chosen) {
  const auto check_part = [&given, is_mesh_chosen](const char* length_key, double length,
                                                   const char* count_key, int count) {
    if (length > 0 && count < 1 && !is_mesh_chosen)
      given.fail(count_key, "at least 1 is needed, as '" + std::string(length_key) + "' is not 0");
    if (length <= 0 && count > 0)
      given.fail(count_key, "elements without a length: give '" + std::string(length_key) + "'");
  };
  check_part("lead_in_mm", strip.lead_in, "strip.elements_lead_in", strip.elements_lead_in);
  check_part("arc_angle_deg", strip.arc_angle, "strip.elements_arc", strip.elements_arc);
  check_part("lead_out_mm", strip.lead_out, "strip.elements_lead_out", strip.elements_lead_out);
  if (strip.arc_angle > 0 && strip.arc_radius <= strip.thickness / 2) {
    given.fail("strip.arc_radius_mm",
               format_exact(strip.arc_radius) + " is out of range; allowed: more than half the thickness");
  }
  if (!is_mesh_chosen && strip.elements_lead_in + strip.elements_arc + strip.elements_lead_out < 2) {
    given.fail_at("strip", "table [strip]: a mesh of one element cannot bend; take 2 or more");
  }
}

void check_material(const GivenKeys& given, const MaterialScene& material) {
  if (!given.has("material")) throw InputError(given.file() + ": table [material] is missing");
  if (material.hardening == "table") {
    if (material.table.front()[0] != 0.0)
      given.fail("material.table", "the first row must stand at plastic strain 0");
    for (size_t i = 1; i < material.table.size(); ++i) {
      if (material.table[i][1] < material.table[i - 1][1]) {
        given.fail("material.table", "the flow stress falls from " + format_exact(material.table[i - 1][1]) +
                                         " to " + format_exact(material.table[i][1]) +
                                         " MPa; softening is not modelled");
      }
    }
  }
}

void check_loads(const GivenKeys& given, const Scene& scene) {
  const bool is_strip = scene.sheet == "strip";
  if (is_strip && given.has("ends"))
    given.fail_at("ends", "table [ends] is for tubes; a strip has [edge.start] and [edge.end]");
  if (!is_strip && !scene.edges.empty())
    given.fail_at("edge", "table [edge]: only a [strip] has edges; a tube has [ends]");
  if (scene.load.control == "volume") {
    if (is_strip) given.fail("load.control", "\"volume\" needs a closed tube; a strip encloses none");
    if (scene.load.volume_ratio.empty())
      given.fail_at("load", "key 'load.volume_ratio' is missing (needed with control = \"volume\")");
  }
  const bool feeds = scene.ends.axial == "feed";
  if (feeds && scene.load.axial_feed.empty())
    given.fail_at("load", "key 'load.axial_feed_mm' is missing (needed with axial = \"feed\" in [ends])");
  if (!feeds && !scene.load.axial_feed.empty() && !given.is_override("ends.axial")) {
    given.fail("load.axial_feed_mm",
               "has no effect while the ends are " + scene.ends.axial + "; set axial = \"feed\" in [ends]");
  }
  if (scene.end_time() <= 0.0) {
    given.fail_at("load",
                  "nothing happens: no path (pressure_MPa, volume_ratio, axial_feed_mm, a tool's motion_mm, "
                  "an edge's path) runs to a time after 0 s");
  }
}

void check_edges(const GivenKeys& given, const Scene& scene) {
  for (const auto& [which, edge] : scene.edges) {
    const auto holds = [&held = edge.hold](const char* what) {
      return std::find(held.begin(), held.end(), what) != held.end();
    };
    const std::string path = "edge." + which + ".";
    if (holds("x") && !edge.move_x.empty()) given.fail(path + "move_x_mm", "contradicts hold = [\"x\"]");
    if (holds("y") && !edge.move_y.empty()) given.fail(path + "move_y_mm", "contradicts hold = [\"y\"]");
    if ((holds("x") || !edge.move_x.empty()) && !edge.force_x.empty())
      given.fail(path + "force_x_N_per_mm", "contradicts an x that is held or moved");
    if ((holds("y") || !edge.move_y.empty()) && !edge.force_y.empty())
      given.fail(path + "force_y_N_per_mm", "contradicts a y that is held or moved");
    if (holds("rotation") && !edge.moment.empty())
      given.fail(path + "moment_N", "contradicts hold = [\"rotation\"]");
  }
}

bool is_zero(const std::array<double, 3>& v) { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; }

void check_tool_surface(const GivenKeys& given, const std::string& path, const ToolScene& tool) {
  if (tool.shape != "mesh") return;
  if (tool.surface == "nagata" && tool.normals == "facet") {
    given.fail(given.has(path + ".normals") ? path + ".normals" : path + ".surface",
               "\"facet\" normals make no Nagata patches; choose plain, area, angle or max");
  }
  if (tool.surface == "points" && given.has(path + ".search")) {
    given.fail(path + ".search", "has no effect with surface = \"points\": x and y give the cell");
  }
  if (is_zero(tool.height_axis)) given.fail(path + ".height_axis", "[0, 0, 0] has no direction");
}

void check_tools(const GivenKeys& given, const Scene& scene) {
  for (const auto& [name, tool] : scene.tools) {
    const std::string path = "tool." + name;
    if (is_zero(tool.direction)) given.fail(path + ".direction", "[0, 0, 0] has no direction");
    check_tool_surface(given, path, tool);
    const bool is_exact = tool.shape != "mesh" && tool.shape != "points";
    if (scene.contact.curvature == "known-radius" && !is_exact && tool.known_radius <= 0.0) {
      given.fail_at(path, "table [" + path +
                              "]: key 'known_radius_mm' is missing; contact.curvature = \"known-radius\" "
                              "needs it for a tool from a file");
    }
    if (tool.shape == "box" && tool.corner_radius > std::min(tool.half_width, tool.half_height)) {
      given.fail(path + ".corner_radius_mm", format_exact(tool.corner_radius) +
                                                 " is out of range; allowed: 0 to " +
                                                 format_exact(std::min(tool.half_width, tool.half_height)) +
                                                 " (half of the smaller side)");
    }
    if (tool.shape == "torus" && tool.minor_radius >= tool.radius) {
      given.fail(path + ".minor_radius_mm",
                 format_exact(tool.minor_radius) +
                     " is out of range; allowed: less than radius_mm = " + format_exact(tool.radius));
    }
    if (!tool.motion.empty() && tool.motion.front()[0] < 0.0)
      given.fail(path + ".motion_mm", "times start before 0 s");
  }
}

void check_quantity_names(const GivenKeys& given, const Scene& scene) {
  for (const auto& [name, quantity] : scene.quantities) {
    const std::string path = "quantity." + name;
    for (const std::string& other : quantity.of) {
      if (scene.quantities.count(other) == 0)
        given.fail(path + ".of", "no quantity '" + other + "'" + suggest(other, names_of(scene.quantities)));
    }
    if (quantity.kind == "ratio" && quantity.of.size() != 2)
      given.fail(path + ".of", "a ratio takes two names, not " + std::to_string(quantity.of.size()));
    if (quantity.kind == "sum" && quantity.of.empty())
      given.fail(path + ".of", "a sum takes one name or more");
    if (!quantity.factors.empty() && quantity.factors.size() != quantity.of.size()) {
      given.fail(path + ".factors", std::to_string(quantity.factors.size()) + " factors for " +
                                        std::to_string(quantity.of.size()) + " names");
    }
    if (quantity.kind == "contact_force" && scene.tools.count(quantity.tool) == 0) {
      given.fail(path + ".tool",
                 "no tool '" + quantity.tool + "'" + suggest(quantity.tool, names_of(scene.tools)));
    }
  }
}

void check_quantity_sheet(const GivenKeys& given, const Scene& scene) {
  const bool is_strip = scene.sheet == "strip";
  static const std::set<std::string> tube_only = {"radius", "corner_radius", "volume"},
                                     strip_only = {"bend_radius", "bending_moment", "edge_force"};
  for (const auto& [name, quantity] : scene.quantities) {
    const std::string path = "quantity." + name + ".";
    if (is_strip && tube_only.count(quantity.kind) > 0)
      given.fail(path + "kind", "\"" + quantity.kind + "\" is measured on a tube, not on a strip");
    if (!is_strip && strip_only.count(quantity.kind) > 0)
      given.fail(path + "kind", "\"" + quantity.kind + "\" is measured on a strip");
    for (const char* key : {"angle_deg", "z_mm"}) {
      if (is_strip && given.has(path + key))
        given.fail(path + key, "is for tubes; give 'position' on a strip");
    }
    if (!is_strip && given.has(path + "position"))
      given.fail(path + "position", "is for strips; give 'angle_deg' and 'z_mm'");
  }
}

/// Quantities may combine quantities, but not in a circle.
void check_quantity_circles(const GivenKeys& given, const Scene& scene) {
  std::set<std::string> settled;
  bool progress = true;
  while (progress) {
    progress = false;
    for (const auto& [name, quantity] : scene.quantities) {
      const auto known = [&settled](const std::string& other) { return settled.count(other) > 0; };
      if (known(name) || !std::all_of(quantity.of.begin(), quantity.of.end(), known)) continue;
      settled.insert(name);
      progress = true;
    }
  }
  for (const auto& [name, quantity] : scene.quantities) {
    if (settled.count(name) == 0)
      given.fail("quantity." + name + ".of", "refers back to '" + name + "' in a circle");
  }
}

void check_stop(const GivenKeys& given, const Scene& scene) {
  if (!given.has("stop")) return;
  const StopScene& stop = scene.stop;
  if (scene.quantities.count(stop.quantity) == 0) {
    given.fail("stop.quantity",
               "no quantity '" + stop.quantity + "'" + suggest(stop.quantity, names_of(scene.quantities)));
  }
  if (!stop.below && !stop.above) given.fail_at("stop", "table [stop]: give 'below' or 'above'");
}

void check_increment(const GivenKeys& given, const Scene& scene) {
  const IncrementScene& increment = scene.increment;
  if (increment.smallest > increment.largest) {
    given.fail(given.has("increment.smallest") ? "increment.smallest" : "increment.largest",
               "smallest = " + format_exact(increment.smallest) +
                   " is above largest = " + format_exact(increment.largest));
  }
}

void check_accuracy(const GivenKeys& given, const Scene& scene) {
  constexpr double kFinest = 0.001;
  if (scene.accuracy > 0.0 && scene.accuracy < kFinest) {
    given.fail("accuracy", format_exact(scene.accuracy) + " is out of range; allowed: " +
                               format_exact(kFinest) + " to 0.2 (or 0: settings as given)");
  }
}

}  // namespace

std::set<std::string> GivenKeys::list(bool only_overrides) const {
  std::set<std::string> paths;
  for (const auto& [path, place] : places_) {
    if (place.is_override || !only_overrides) paths.insert(path);
  }
  return paths;
}

void GivenKeys::add(const std::string& path, const std::string& where, bool is_override) {
  places_[path] = {where, is_override};
}

bool GivenKeys::is_override(const std::string& path) const {
  const auto found = places_.find(path);
  return found != places_.end() && found->second.is_override;
}

std::string GivenKeys::find_place(const std::string& path) const {
  for (std::string at = path;; at = at.substr(0, at.rfind('.'))) {
    const auto found = places_.find(at);
    if (found != places_.end()) return found->second.where;
    if (at.find('.') == std::string::npos) return file_;
  }
}

void GivenKeys::fail(const std::string& path, const std::string& text) const {
  throw InputError(find_place(path) + ": key '" + path + "': " + text);
}

void GivenKeys::fail_at(const std::string& path, const std::string& text) const {
  throw InputError(find_place(path) + ": " + text);
}

void check_scene(Scene& scene, const GivenKeys& given) {
  check_sheet(given, scene);
  if (scene.sheet == "tube") check_tube(given, scene.tube, scene.accuracy > 0.0);
  if (scene.sheet == "strip") check_strip(given, scene.strip, scene.accuracy > 0.0);
  check_material(given, scene.material);
  check_tools(given, scene);
  check_edges(given, scene);
  check_loads(given, scene);
  check_quantity_names(given, scene);
  check_quantity_sheet(given, scene);
  check_quantity_circles(given, scene);
  check_stop(given, scene);
  check_increment(given, scene);
  check_accuracy(given, scene);
  choose_explicit_limits(given, scene);
  scene.given = list_user_words(given);
}

void check_scene_files(const Scene& scene, const GivenKeys& given) {
  const auto check = [&](const std::string& path, const std::string& name) {
    const std::filesystem::path file = std::filesystem::path(scene.directory) / name;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) given.fail(path, "no such file: '" + file.string() + "'");
    if (!std::filesystem::is_regular_file(file, error))
      given.fail(path, "not a file: '" + file.string() + "'");
  };
  if (scene.sheet == "mesh") check("mesh.file", scene.mesh.file);
  for (const auto& [name, tool] : scene.tools) {
    if (tool.shape == "mesh" || tool.shape == "points") check("tool." + name + ".file", tool.file);
  }
}

}  // namespace hydroscope
