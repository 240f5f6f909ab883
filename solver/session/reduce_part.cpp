// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/reduce_part.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

constexpr double kSame = 1e-9;

/// The angle's image in [0, section], by mirroring at both planes again and again.
double fold_angle(double angle, double section) {
  const double period = 2.0 * section;
  const double rest = angle - period * std::floor(angle / period);
  return rest <= section + kSame ? rest : period - rest;
}

/// How many whole sections a range of angles covers; 0 if it ends within one.
int count_sections(const std::array<double, 2>& range, double section) {
  const double from = range[0] / section, width = (range[1] - range[0]) / section;
  const bool is_whole =
      std::abs(from - std::round(from)) < kSame && std::abs(width - std::round(width)) < kSame;
  return is_whole ? static_cast<int>(std::lround(width)) : 0;
}

bool lies_within_one(const std::array<double, 2>& range, double section) {
  return std::floor(range[0] / section + kSame) == std::ceil(range[1] / section - kSame) - 1.0;
}

/// Name of the first quantity that cannot be taken from the section; empty when all can.
std::string find_unfoldable(const Scene& scene, double section) {
  for (const auto& [name, q] : scene.quantities) {
    if (q.kind == "contact_force" && count_sections(q.range, section) == 0 &&
        !lies_within_one(q.range, section))
      return name;
  }
  return "";
}

/// What the modelled part has of a quantity, times `factor`.
void multiply(Scene& scene, const std::string& name, double factor) {
  if (factor == 1.0) return;
  const std::string part = name + "_of_part";
  scene.quantities[part] = scene.quantities.at(name);
  QuantityScene sum;
  sum.kind = "sum";
  sum.of = {part};
  sum.factors = {factor};
  scene.quantities[name] = sum;
}

void fold_force(Scene& scene, const std::string& name, double section) {
  QuantityScene& q = scene.quantities.at(name);
  const int sections = count_sections(q.range, section);
  if (sections > 0) {
    q.range = {0.0, section};
    multiply(scene, name, sections);
    return;
  }
  const double a = fold_angle(q.range[0], section), b = fold_angle(q.range[1], section);
  q.range = {std::min(a, b), std::max(a, b)};
}

std::vector<std::string> list_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& [name, q] : scene.quantities) names.push_back(name);
  return names;
}

void fold_quantities(Scene& scene, double before, double section) {
  for (const std::string& name : list_names(scene)) {
    QuantityScene& q = scene.quantities.at(name);
    q.angle = fold_angle(q.angle, section);
    if (q.kind == "contact_force") {
      q.range[1] = std::min(q.range[1], std::max(before, q.range[0]));
      fold_force(scene, name, section);
    } else if (q.kind == "volume") {
      multiply(scene, name, before / section);
    }
  }
}

struct Section {
  std::string name;
  double angle = 0.0;
  std::string reason;
};

/// The smallest section that the symmetry allows.
Section find_section(const PartSymmetry& s, double before, double sector_angle) {
  if (s.around.holds) return {"sector", sector_angle, "tools and loads are the same at every angle"};
  const bool half = s.plane_0.holds || before < 360.0;
  const bool quarter = half && (s.plane_90.holds || before <= 90.0);
  if (quarter && s.plane_45.holds) return {"octant", 45.0, "tools and loads mirror at 0 and 45 degrees"};
  if (quarter) return {"quarter", 90.0, "tools and loads mirror at 0 and 90 degrees"};
  if (half) return {"half", 180.0, "tools and loads mirror at 0 degrees"};
  return {"full", 360.0, ""};
}

std::string find_obstacle(const PartSymmetry& s, const std::string& section) {
  if (section == "full") return s.plane_0.obstacle;
  return section == "half" ? s.plane_90.obstacle : s.plane_45.obstacle;
}

void reduce_section(const PartSymmetry& symmetry, double sector_angle, Scene& scene) {
  TubeScene& tube = scene.tube;
  const double before = find_section_angle(tube);
  const Section found = find_section(symmetry, before, sector_angle);
  if (found.angle >= before - kSame) {
    if (before > 45.0)
      scene.choices.push_back(
          {"tube.section", tube.section, "stays: " + find_obstacle(symmetry, tube.section)});
    return;
  }
  if (scene.given.count("tube.grading_around") > 0) {
    scene.choices.push_back({"tube.section", tube.section, "stays, as grading_around belongs to it"});
    return;
  }
  const std::string obstacle = find_unfoldable(scene, found.angle);
  if (!obstacle.empty()) {
    scene.choices.push_back(
        {"tube.section", tube.section, "stays: quantity '" + obstacle + "' ends inside " + found.name});
    return;
  }
  scene.choices.push_back({"tube.section", found.name, "instead of " + tube.section + ": " + found.reason});
  fold_quantities(scene, before, found.angle);
  if (tube.elements_around > 0) {
    tube.elements_around =
        std::max(1, static_cast<int>(std::ceil(tube.elements_around * found.angle / before - kSame)));
  }
  tube.section = found.name;
  tube.sector_angle = found.angle;
  tube.grading_around.clear();
}

void make_slice(Scene& scene) {
  TubeScene& tube = scene.tube;
  scene.choices.push_back(
      {"tube.extent", "slice",
       "instead of " + tube.extent + ": nothing varies along the tube, its ends are held"});
  const double modelled = tube.extent == "half" ? 0.5 * tube.length : tube.length;
  tube.length = std::min(tube.length, tube.thickness);
  for (const std::string& name : list_names(scene)) {
    scene.quantities.at(name).z = 0.0;
    if (scene.quantities.at(name).kind == "volume") multiply(scene, name, modelled / tube.length);
  }
  tube.extent = "slice";
  tube.elements_along = 1;
  tube.grading_along.clear();
}

void make_half(Scene& scene) {
  TubeScene& tube = scene.tube;
  scene.choices.push_back({"tube.extent", "half", "instead of full: tools and loads mirror at z = 0"});
  for (const std::string& name : list_names(scene)) {
    scene.quantities.at(name).z = std::abs(scene.quantities.at(name).z);
    if (scene.quantities.at(name).kind == "volume") multiply(scene, name, 2.0);
  }
  tube.extent = "half";
  tube.elements_along = (tube.elements_along + 1) / 2;
}

void reduce_extent(const PartSymmetry& symmetry, Scene& scene) {
  TubeScene& tube = scene.tube;
  if (tube.extent == "slice") return;
  const bool is_graded = scene.given.count("tube.grading_along") > 0;
  if (symmetry.along.holds && !is_graded) {
    make_slice(scene);
  } else if (tube.extent == "full" && symmetry.middle.holds && !is_graded) {
    make_half(scene);
  } else {
    const std::string obstacle =
        tube.extent == "full" && !symmetry.middle.holds ? symmetry.middle.obstacle : symmetry.along.obstacle;
    scene.choices.push_back(
        {"tube.extent", tube.extent, "stays: " + (is_graded ? "grading_along belongs to it" : obstacle)});
  }
}

}  // namespace

double find_section_angle(const TubeScene& tube) {
  if (tube.section == "full") return 360.0;
  if (tube.section == "half") return 180.0;
  if (tube.section == "quarter") return 90.0;
  return tube.section == "octant" ? 45.0 : tube.sector_angle;
}

void reduce_part(const PartSymmetry& symmetry, double sector_angle, Scene& scene) {
  reduce_section(symmetry, sector_angle, scene);
  reduce_extent(symmetry, scene);
}

}  // namespace hydroscope
