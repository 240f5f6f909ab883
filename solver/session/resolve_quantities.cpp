// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/resolve_quantities.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& name, const std::string& why) {
  throw InputError(scene.file + ": quantity." + name + ": " + why);
}

struct Between {
  int low = 0, high = 0;
  double share = 0.0;  ///< weight of `high`
};

/// Neighbouring entries of an ascending list around a value.
Between locate(const std::vector<double>& at, double value) {
  const int n = static_cast<int>(at.size());
  int k = 0;
  while (k + 2 < n && at[static_cast<std::size_t>(k) + 1] < value) ++k;
  const double a = at[static_cast<std::size_t>(k)], b = at[static_cast<std::size_t>(std::min(k + 1, n - 1))];
  return {k, std::min(k + 1, n - 1), b > a ? std::clamp((value - a) / (b - a), 0.0, 1.0) : 0.0};
}

/// Interpolation nodes around (angle or position, z).
void locate_point(const SheetMesh& sheet, double around, double z, Quantity& q) {
  std::vector<double> columns = sheet.positions;
  if (sheet.is_ring) columns.push_back(360.0);
  const Between a = locate(columns, around), b = locate(sheet.z, z);
  for (const auto& [i, wi] : {std::pair(a.low, 1.0 - a.share), std::pair(a.high, a.share)}) {
    for (const auto& [j, wj] : {std::pair(b.low, 1.0 - b.share), std::pair(b.high, b.share)}) {
      q.nodes.push_back(sheet.node(i, j));
      q.weights.push_back(wi * wj);
    }
  }
}

void locate_patch(const SheetMesh& sheet, double from, double to, Quantity& q) {
  constexpr double kEdge = 1e-6;
  for (int j = 0; j < sheet.n_along; ++j) {
    for (int i = 0; i < sheet.n_around; ++i) {
      const double at = sheet.positions[static_cast<std::size_t>(i)];
      if (at >= from - kEdge && at <= to + kEdge) q.nodes.push_back(sheet.node(i, j));
    }
  }
}

/// Elements of a strip whose middle lies in a part of its length.
void locate_elements(const SheetMesh& sheet, double from, double to, Quantity& q) {
  for (int i = 0; i + 1 < sheet.n_around; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double middle = 0.5 * (sheet.positions[k] + sheet.positions[k + 1]);
    if (middle >= from && middle <= to) q.elements.push_back(i);  // one row of them along z
  }
}

int find_tool(const Scene& scene, const std::string& name, const Model& model, const std::string& tool) {
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    if (model.tools[t].name == tool) return static_cast<int>(t);
  }
  refuse(scene, name, "there is no tool \"" + tool + "\"");
}

void check_range(const Scene& scene, const SheetMesh& sheet, const std::string& name,
                 const QuantityScene& q) {
  if (scene.sheet == "mesh")
    refuse(scene, name, "places on an imported mesh cannot be named yet; use \"volume\"");
  if (scene.sheet == "strip") return;
  const double last = sheet.is_ring ? 360.0 : sheet.positions.back();
  if (q.angle < -1e-9 || q.angle > last + 1e-9) {
    refuse(scene, name,
           "angle_deg = " + std::to_string(q.angle) + " lies outside the modelled section, 0 to " +
               std::to_string(last));
  }
  if (q.z < sheet.z.front() - 1e-9 || q.z > sheet.z.back() + 1e-9) {
    refuse(scene, name,
           "z_mm = " + std::to_string(q.z) + " lies outside the modelled length, " +
               std::to_string(sheet.z.front()) + " to " + std::to_string(sheet.z.back()));
  }
}

void resolve_place(const Scene& scene, const SheetMesh& sheet, const Model& model, Quantity& q) {
  const QuantityScene& s = q.scene;
  if (s.kind == "volume") return;
  check_range(scene, sheet, q.name, s);
  if (s.kind == "contact_force") {
    q.tool = find_tool(scene, q.name, model, s.tool);
    locate_patch(sheet, s.range[0], s.range[1], q);
  } else if (s.kind == "edge_force") {
    q.nodes = s.edge == "start" ? sheet.start_nodes : sheet.end_nodes;
  } else if (s.kind == "bend_radius") {
    locate_patch(sheet, s.position_range[0], s.position_range[1], q);
    if (q.nodes.size() < 6) refuse(scene, q.name, "fewer than three node rows lie in its position_range");
  } else if (s.kind == "bending_moment") {
    locate_elements(sheet, s.position_range[0], s.position_range[1], q);
    if (q.elements.empty()) refuse(scene, q.name, "the middle of no element lies in its position_range");
  } else {
    locate_point(sheet, scene.sheet == "strip" ? s.position : s.angle, s.z, q);
  }
}

}  // namespace

void resolve_quantities(const Scene& scene, const SheetMesh& sheet, Model& model) {
  const auto find = [&](const std::string& name) {
    for (std::size_t k = 0; k < model.quantities.size(); ++k) {
      if (model.quantities[k].name == name) return static_cast<int>(k);
    }
    return -1;
  };
  std::vector<std::string> waiting;
  for (const auto& [name, q] : scene.quantities) {
    if (q.kind == "sum" || q.kind == "ratio") {
      waiting.push_back(name);
      continue;
    }
    Quantity quantity{name, q, {}, {}, -1, {}, {}};
    resolve_place(scene, sheet, model, quantity);
    model.quantities.push_back(quantity);
  }
  while (!waiting.empty()) {
    const auto ready = std::find_if(waiting.begin(), waiting.end(), [&](const std::string& name) {
      const auto& of = scene.quantities.at(name).of;
      return std::all_of(of.begin(), of.end(), [&](const std::string& n) { return find(n) >= 0; });
    });
    if (ready == waiting.end()) refuse(scene, waiting.front(), "refers to itself in a circle");
    Quantity quantity{*ready, scene.quantities.at(*ready), {}, {}, -1, {}, {}};
    for (const std::string& n : quantity.scene.of) quantity.of.push_back(find(n));
    model.quantities.push_back(quantity);
    waiting.erase(ready);
  }
  if (!scene.stop.quantity.empty()) model.stop_quantity = find(scene.stop.quantity);
}

}  // namespace hydroscope
