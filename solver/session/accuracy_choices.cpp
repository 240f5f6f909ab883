// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/accuracy_choices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "solver/session/accuracy_rules.h"
#include "solver/session/part_symmetry.h"
#include "solver/session/reduce_part.h"

namespace hydroscope {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::string print_short(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

class Chooser {
 public:
  Chooser(Scene& scene, const std::map<std::string, MeshFacts>& facts)
      : scene_(scene), facts_(facts), least_(find_least_radius(scene, facts)) {}

  void choose_all() {
    forget_counts();
    if (scene_.sheet == "tube") choose_tube();
    if (scene_.sheet == "strip") choose_strip();
    if (scene_.sheet == "mesh")
      say("mesh.file", scene_.mesh.file, "its elements stay: no rule for imported meshes");
    choose_thickness_points();
    choose_increments();
    choose_treatment();
    choose_surfaces();
  }

 private:
  bool is_given(const std::string& key) const { return scene_.given.count(key) > 0; }
  void say(const std::string& key, const std::string& value, const std::string& reason) {
    scene_.choices.push_back({key, value, reason});
  }

  /// Counts of the file, where `accuracy` came later.
  void forget_counts() {
    const auto forget = [this](const char* key, int& count, int value) {
      if (!is_given(key)) count = value;
    };
    forget("tube.elements_around", scene_.tube.elements_around, 0);
    if (scene_.tube.extent != "slice") forget("tube.elements_along", scene_.tube.elements_along, 0);
    forget("strip.elements_lead_in", scene_.strip.elements_lead_in, 0);
    forget("strip.elements_arc", scene_.strip.elements_arc, 0);
    forget("strip.elements_lead_out", scene_.strip.elements_lead_out, 0);
    if (!is_given("tube.grading_around")) scene_.tube.grading_around.clear();
    if (!is_given("tube.grading_along")) scene_.tube.grading_along.clear();
  }

  /// What the rule asks for, or the user's own count where that is finer.
  void choose_count(const std::string& key, int& count, int needed, const std::string& reason) {
    if (is_given(key) && count >= needed) {
      say(key, std::to_string(count), "as given; " + std::to_string(needed) + " would do: " + reason);
      return;
    }
    const std::string before = is_given(key) ? "raised from " + std::to_string(count) + ": " : "";
    count = needed;
    say(key, std::to_string(count), before + reason);
  }

  std::string describe_size(double size) const {
    return "elements of " + print_short(size) + " mm, " + print_short(size / least_.value) +
           " of the least radius " + print_short(least_.value) + " mm " + least_.cause;
  }

  void choose_tube() {
    reduce_part(find_symmetry(scene_, facts_), scene_.accuracy < 0.002 ? 1.5 : 3.0, scene_);
    TubeScene& tube = scene_.tube;
    if (tube.section == "sector") {
      const int count = tube.extent == "slice" ? 2 : 1;
      choose_count("tube.elements_around", tube.elements_around, count, "all angles are alike");
    } else {
      choose_around();
    }
    if (tube.extent != "slice") choose_along();
  }

  /// A shell shorter than its wall is thick resolves nothing that is true.
  double find_tube_size(std::string& reason) const {
    constexpr double kShortest = 0.75;
    const double wanted = find_element_ratio(scene_, least_.is_filled) * least_.value,
                 shortest = kShortest * scene_.tube.thickness;
    reason = describe_size(std::max(wanted, shortest));
    if (wanted < shortest) reason += "; not less than three quarters of the wall, where a shell ends";
    return std::max(wanted, shortest);
  }

  void choose_around() {
    constexpr double kFewest = 6.0;  // over 45 degrees
    std::string reason;
    const double size = find_tube_size(reason), angle = find_section_angle(scene_.tube);
    const double wanted = angle * kDegree * scene_.tube.radius / size;
    const int count = static_cast<int>(std::ceil(std::max(wanted, kFewest * angle / 45.0) - 1e-9));
    choose_count("tube.elements_around", scene_.tube.elements_around, count, reason);
  }

  /// Whether a tool bends the wall along the tube.
  bool is_bent_along() const {
    return std::any_of(scene_.tools.begin(), scene_.tools.end(), [this](const auto& item) {
      const std::string& shape = item.second.shape;
      const auto found = facts_.find(item.first);
      if (shape == "torus" || shape == "points") return true;
      return shape == "mesh" && (found == facts_.end() || !found->second.is_prismatic);
    });
  }

  void choose_along() {
    TubeScene& tube = scene_.tube;
    const bool is_half = tube.extent == "half";
    const double half = 0.5 * tube.length;
    const bool has_end = scene_.ends.radial == "held" || scene_.ends.rotation == "held";
    int rows = count_graded_rows(scene_.accuracy, half, tube.radius, tube.thickness);
    std::string reason =
        "held ends bend the wall over " + print_short(std::sqrt(tube.radius * tube.thickness)) + " mm";
    if (is_bent_along()) {
      rows = std::max(rows, static_cast<int>(std::ceil(half / find_tube_size(reason))));
    } else if (has_end && !is_given("tube.grading_along")) {
      tube.grading_along = {{0.0, 2.0}, {0.6 * half, 1.5}, {half, 0.5}};
      if (!is_half) tube.grading_along.insert(tube.grading_along.begin(), {{-half, 0.5}, {-0.6 * half, 1.5}});
      say("tube.grading_along", "2 : 1.5 : 0.5", "shorter elements towards ends that are held");
    } else if (!has_end) {
      reason = "nothing bends the wall along the tube";
    }
    choose_count("tube.elements_along", tube.elements_along, is_half ? rows : 2 * rows, reason);
  }

  /// Shares of the strip where quantities of bending look; [0, 1] without any.
  std::array<double, 2> find_place_of_interest() const {
    std::array<double, 2> range{1.0, 0.0};
    for (const auto& [name, q] : scene_.quantities) {
      if (q.kind != "bending_moment" && q.kind != "bend_radius") continue;
      range = {std::min(range[0], q.position_range[0]), std::max(range[1], q.position_range[1])};
    }
    return range[0] < range[1] ? range : std::array<double, 2>{0.0, 1.0};
  }

  void choose_strip() {
    constexpr double kElsewhere = 7.0;  // elements where no quantity of bending looks, against the others
    StripScene& strip = scene_.strip;
    const double arc = strip.arc_radius * strip.arc_angle * kDegree,
                 length = strip.lead_in + arc + strip.lead_out;
    const bool is_bent = std::isfinite(least_.value);
    const double size = is_bent ? find_element_ratio(scene_, false) * least_.value : length / 40.0;
    const std::array<double, 2> place = find_place_of_interest();
    double from = 0.0;
    const auto choose = [&](const std::string& key, int& count, double part) {
      const double low = from / length, high = (from + part) / length;
      from += part;
      if (part <= 0.0) return;
      const bool looks = low < place[1] && high > place[0];
      const double local = looks ? size : kElsewhere * size;
      const std::string reason = (is_bent ? describe_size(local) : "a fortieth of the strip") +
                                 (looks ? "" : ", coarser as no quantity of bending looks here");
      choose_count("strip." + key, count, std::max(2, static_cast<int>(std::ceil(part / local - 1e-9))),
                   reason);
    };
    choose("elements_lead_in", strip.elements_lead_in, strip.lead_in);
    choose("elements_arc", strip.elements_arc, arc);
    choose("elements_lead_out", strip.elements_lead_out, strip.lead_out);
  }

  void choose_thickness_points() {
    const ThicknessChoice choice = find_thickness_points(scene_);
    if (is_given("shell.thickness_points") || is_given("shell.thickness_rule")) {
      say("shell.thickness_points", std::to_string(scene_.shell.thickness_points),
          "as given (" + scene_.shell.thickness_rule + ")");
      return;
    }
    scene_.shell.thickness_points = choice.points;
    scene_.shell.thickness_rule = choice.rule;
    say("shell.thickness_points", std::to_string(choice.points), choice.rule + ": " + choice.reason);
  }

  void choose_value(const std::string& key, double& value, double wanted, const std::string& reason) {
    if (!is_given(key)) value = wanted;
    say(key, print_short(value), is_given(key) ? "as given; " + print_short(wanted) + " would do" : reason);
  }

  void choose_increments() {
    const IncrementRule rule = find_increment_rule(scene_);
    IncrementScene& increment = scene_.increment;
    choose_value("increment.tolerance", increment.tolerance, rule.tolerance, "what forces may lack");
    choose_value("increment.largest", increment.largest, rule.largest,
                 asks_for_bending(scene_) ? "bending that is undone again remembers every increment"
                                          : "the wall's answer depends little on the increment");
    choose_value("increment.max_strain", increment.max_strain, rule.max_strain,
                 "goes with the largest increment");
    increment.smallest = std::min(increment.smallest, increment.largest);
  }

  /// The defaults are what the studies found best; a file's other treatment gives way to a later `accuracy`.
  void choose_treatment() {
    const auto choose = [this](const std::string& key, std::string& value, const std::string& best) {
      if (value == best) return;
      if (is_given(key)) {
        say(key, value, "as given; the rules were measured with " + best);
      } else {
        say(key, best, "instead of " + value);
        value = best;
      }
    };
    choose("increment.correction", scene_.increment.correction, "newton");
    choose("increment.control", scene_.increment.control, "r_min");
    choose("contact.curvature", scene_.contact.curvature, "symmetric");
    choose("contact.friction_law", scene_.contact.friction_law, "return-mapping");
    choose("contact.release", scene_.contact.release, "full");
  }

  void choose_surfaces() {
    for (auto& [name, tool] : scene_.tools) {
      if (tool.shape != "mesh") continue;
      const std::string key = "tool." + name + ".surface";
      if (!is_given(key)) tool.surface = "smooth";
      say(key, tool.surface,
          is_given(key) ? "as given" : "facets bent to fit their normals: the mesh's own radius");
    }
  }

  Scene& scene_;
  const std::map<std::string, MeshFacts>& facts_;
  LeastRadius least_;
};

}  // namespace

Scene choose_for_accuracy(const Scene& scene, const std::map<std::string, MeshFacts>& facts) {
  Scene chosen = scene;
  if (scene.accuracy <= 0.0 || !scene.choices.empty()) return chosen;
  Chooser(chosen, facts).choose_all();
  return chosen;
}

Scene choose_for_accuracy(const Scene& scene) {
  std::map<std::string, MeshFacts> facts;
  if (scene.accuracy > 0.0 && scene.choices.empty()) {
    for (const auto& [name, tool] : scene.tools) {
      if (tool.shape == "mesh") facts[name] = inspect_mesh(tool, name, scene.directory);
    }
  }
  return choose_for_accuracy(scene, facts);
}

Scene make_companion(const Scene& chosen) {
  Scene half = chosen;
  half.accuracy = 0.0;
  const auto halve = [](int& count, int least) { count = std::min(count, std::max(least, (count + 1) / 2)); };
  TubeScene& tube = half.tube;
  if (tube.section == "sector") {
    tube.sector_angle = std::min(90.0, 2.0 * tube.sector_angle);
  } else {
    halve(tube.elements_around, static_cast<int>(std::lround(4.0 * find_section_angle(tube) / 45.0)));
  }
  if (tube.extent != "slice") halve(tube.elements_along, 2);
  halve(half.strip.elements_lead_in, 1);
  halve(half.strip.elements_arc, 6);
  halve(half.strip.elements_lead_out, 1);
  halve(half.shell.thickness_points, 2);
  if (half.shell.thickness_rule == "split_gauss")
    half.shell.thickness_points += half.shell.thickness_points % 2;
  half.increment.largest = std::min(1.0, 2.0 * half.increment.largest);
  half.increment.max_strain *= 2.0;
  half.increment.tolerance = std::min(1e-2, 2.0 * half.increment.tolerance);
  half.states.number = 1;
  half.frames.pick = "number";
  half.frames.number = 1;
  return half;
}

std::string describe_choices(const Scene& scene) {
  if (scene.choices.empty()) return "";
  std::string text = "accuracy " + print_short(scene.accuracy) + " is asked for; chosen:\n";
  for (const Choice& choice : scene.choices)
    text += "  " + choice.key + " = " + choice.value + ": " + choice.reason + "\n";
  return text;
}

}  // namespace hydroscope
