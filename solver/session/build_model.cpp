// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/build_model.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "solver/base/error.h"
#include "solver/geometry/sheet_mesh.h"
#include "solver/import/make_tool.h"
#include "solver/loading/pressure.h"
#include "solver/session/resolve_quantities.h"
#include "solver/session/sheet_file.h"
#include "solver/session/tool_checks.h"

namespace hydroscope {

namespace {

Hardening make_hardening(const MaterialScene& m) {
  static const std::map<std::string, Hardening::Kind> kKinds{{"elastic", Hardening::Kind::kElastic},
                                                             {"perfect", Hardening::Kind::kPerfect},
                                                             {"swift", Hardening::Kind::kSwift},
                                                             {"voce", Hardening::Kind::kVoce},
                                                             {"table", Hardening::Kind::kTable}};
  Hardening h;
  h.kind = kKinds.at(m.hardening);
  h.yield = m.yield_stress;
  h.k = m.swift_k;
  h.eps0 = m.swift_eps0;
  h.n = m.swift_n;
  h.q = m.voce_q;
  h.b = m.voce_b;
  h.table = m.table;
  return h;
}

SheetMaterial make_material(const MaterialScene& m) {
  const bool is_hill = m.yield == "hill48";
  return {m.youngs_modulus,      m.poisson,         is_hill ? m.r0 : 1.0, is_hill ? m.r45 : 1.0,
          is_hill ? m.r90 : 1.0, make_hardening(m), m.yield_rounding};
}

Triad make_triad(const Vec3& director) {
  const Vec3 v = director.normalized();
  const Vec3 reference = std::abs(v[2]) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 v1 = (reference - v.dot(reference) * v).normalized();
  return {v1, v.cross(v1), v};
}

int add_motion(Model& model, const Path& path, double factor) {
  Path scaled = path;
  for (double& v : scaled.values) v *= factor;
  model.motions.push_back(scaled);
  return static_cast<int>(model.motions.size()) - 1;
}

void add_support(Model& model, int node, Support::Kind kind, const Vec3& direction, int motion = -1) {
  model.supports[static_cast<std::size_t>(node)].push_back({kind, direction, motion});
}

/// One end of a tube; `outward` is +1 at high z, -1 at low z.
void add_tube_end(Model& model, const EndsScene& ends, const std::vector<int>& nodes, double outward) {
  if (nodes.empty()) return;
  const int motion = ends.axial == "feed" ? add_motion(model, model.feed, -outward) : -1;
  for (const int i : nodes) {
    if (ends.axial != "free") add_support(model, i, Support::Kind::kDisplacement, Vec3::UnitZ(), motion);
    if (ends.radial == "held") {
      const Vec3 r = model.triad0[static_cast<std::size_t>(i)].v;
      add_support(model, i, Support::Kind::kDisplacement, r);
      add_support(model, i, Support::Kind::kDisplacement, Vec3::UnitZ().cross(r));
    }
    if (ends.rotation == "held") add_support(model, i, Support::Kind::kClamp, Vec3::Zero());
  }
}

/// A closed ring that nothing holds sideways: statically determinate supports
/// without reactions, or the stiffness would be singular.
void add_ring_supports(Model& model, const SheetMesh& sheet) {
  const int quarter = sheet.n_around / 4, half = sheet.n_around / 2;
  for (const int j : {0, sheet.n_along - 1}) {
    add_support(model, sheet.node(0, j), Support::Kind::kDisplacement, Vec3::UnitY());
    add_support(model, sheet.node(quarter, j), Support::Kind::kDisplacement, Vec3::UnitX());
  }
  add_support(model, sheet.node(half, 0), Support::Kind::kDisplacement, Vec3::UnitY());
}

void add_edge(Model& model, const SheetMesh& sheet, const std::string& which, const EdgeScene& edge) {
  const bool is_start = which == "start";
  const std::vector<int>& nodes = is_start ? sheet.start_nodes : sheet.end_nodes;
  EdgeLoad load;
  load.force_x = edge.force_x;
  load.force_y = edge.force_y;
  load.tension = edge.tension;
  load.moment = edge.moment;
  load.lever = (model.x0[static_cast<std::size_t>(sheet.end_nodes.front())] -
                model.x0[static_cast<std::size_t>(sheet.start_nodes.front())])
                   .norm();
  for (const int i : nodes) {
    load.nodes.push_back(i);
    load.inner_nodes.push_back(is_start ? i + 1 : i - 1);
    load.widths.push_back(sheet.width / static_cast<double>(nodes.size()));
    const auto holds = [&](const char* what) {
      return std::find(edge.hold.begin(), edge.hold.end(), what) != edge.hold.end();
    };
    const auto hold = [&](const char* what, const Vec3& direction, const Path& motion) {
      if (!motion.empty()) {
        add_support(model, i, Support::Kind::kDisplacement, direction, add_motion(model, motion, 1.0));
      } else if (holds(what)) {
        add_support(model, i, Support::Kind::kDisplacement, direction);
      }
    };
    hold("x", Vec3::UnitX(), edge.move_x);
    hold("y", Vec3::UnitY(), edge.move_y);
    if (holds("rotation")) add_support(model, i, Support::Kind::kClamp, Vec3::Zero());
  }
  if (!load.force_x.empty() || !load.force_y.empty() || !load.tension.empty() || !load.moment.empty())
    model.edge_loads.push_back(load);
}

void add_sheet(Model& model, const Scene& scene, const SheetMesh& sheet) {
  model.x0 = sheet.mesh.points;
  model.quads = sheet.mesh.quads;
  for (const Vec3& d : sheet.directors) model.triad0.push_back(make_triad(d));
  model.mirrors = sheet.mirrors;
  model.slice_width = sheet.width > 0.0 ? sheet.width : 1.0;
  model.supports.resize(model.x0.size());
  for (const auto& plane : sheet.symmetry) {
    for (const int i : plane.nodes) add_support(model, i, Support::Kind::kSymmetry, plane.normal);
  }
  if (scene.sheet == "strip") {
    for (const auto& [which, edge] : scene.edges) add_edge(model, sheet, which, edge);
    return;
  }
  add_tube_end(model, scene.ends, sheet.start_nodes, -1.0);
  add_tube_end(model, scene.ends, sheet.end_nodes, 1.0);
  if (scene.sheet == "tube" && sheet.is_ring && scene.ends.radial != "held") add_ring_supports(model, sheet);
}

void add_neighbours(Model& model) {
  std::vector<std::set<int>> sets(model.x0.size());
  model.element_size = 1e300;
  for (const auto& quad : model.quads) {
    for (std::size_t a = 0; a < 4; ++a) {
      const auto i = static_cast<std::size_t>(quad[a]), j = static_cast<std::size_t>(quad[(a + 1) % 4]);
      sets[i].insert(static_cast<int>(j));
      sets[j].insert(static_cast<int>(i));
      model.element_size = std::min(model.element_size, (model.x0[i] - model.x0[j]).norm());
    }
  }
  for (const auto& set : sets) model.node_neighbours.emplace_back(set.begin(), set.end());
}

double calc_enclosed_volume(const Model& model) {
  double volume = 0.0;
  for (const auto& quad : model.quads) {
    std::array<Vec3, 4> x;
    for (std::size_t a = 0; a < 4; ++a) {
      const auto i = static_cast<std::size_t>(quad[a]);
      x[a] = model.x0[i] - (model.use_inner_surface ? 0.5 * model.thickness : 0.0) * model.triad0[i].v;
    }
    const auto load = calc_pressure_load(x);
    // Flat ends and symmetry planes through the axis add nothing to the flux of (x, y, 0)/2.
    for (std::size_t a = 0; a < 4; ++a) volume += 0.5 * load[a].head<2>().dot(x[a].head<2>());
  }
  return volume;
}

Tool make_tool(const ToolScene& t, const std::string& name, const Scene& scene, double extent) {
  Tool tool;
  tool.name = name;
  tool.surface = make_tool_surface(t, name, scene.directory, extent);
  for (const auto& row : t.motion) {
    for (std::size_t k = 0; k < 3; ++k) {
      tool.motion[k].times.push_back(row[0]);
      tool.motion[k].values.push_back(row[k + 1]);
    }
  }
  tool.friction = t.friction;
  tool.side = t.face == "inner" ? -1.0 : 1.0;
  if (t.leaves_at) tool.leaves_at = *t.leaves_at;
  tool.known_radius = t.known_radius;
  return tool;
}

SheetMesh make_sheet(const Scene& scene) {
  if (scene.sheet == "tube") return make_tube_mesh(scene.tube);
  if (scene.sheet == "strip") return make_strip_mesh(scene.strip);
  return read_sheet_mesh(scene);
}

double sheet_thickness(const Scene& scene) {
  if (scene.sheet == "tube") return scene.tube.thickness;
  return scene.sheet == "strip" ? scene.strip.thickness : scene.mesh.thickness;
}

double calc_extent(const Model& model) {
  double extent = 0.0;
  for (const Vec3& x : model.x0) extent = std::max(extent, x.cwiseAbs().maxCoeff());
  return extent;
}

/// The value that belongs to a name; the scene reader has let no other through.
template <class Value>
Value pick(const std::string& name, std::initializer_list<std::pair<const char*, Value>> values) {
  for (const auto& [key, value] : values) {
    if (name == key) return value;
  }
  throw ContractError("no treatment is called '" + name + "'");
}

void set_treatments(const Scene& scene, Model& model) {
  model.curvature = pick<Curvature>(scene.contact.curvature, {{"none", Curvature::kNone},
                                                              {"known-radius", Curvature::kKnownRadius},
                                                              {"symmetric", Curvature::kSymmetric},
                                                              {"full", Curvature::kFull}});
  model.friction_law =
      pick<FrictionLaw>(scene.contact.friction_law, {{"return-mapping", FrictionLaw::kReturnMapping},
                                                     {"one-step-behind", FrictionLaw::kOneStepBehind},
                                                     {"stick", FrictionLaw::kStick}});
  model.release = pick<ReleaseRule>(
      scene.contact.release,
      {{"full", ReleaseRule::kFull}, {"fluid", ReleaseRule::kFluid}, {"sign", ReleaseRule::kSign}});
  model.correction =
      pick<Correction>(scene.increment.correction, {{"newton", Correction::kNewton},
                                                    {"none", Correction::kNone},
                                                    {"one-step-behind", Correction::kOneStepBehind},
                                                    {"algoneq", Correction::kAlgoneq}});
  model.use_penalty = scene.contact.constraint == "penalty";
  model.controls_error = scene.increment.control == "error";
}

}  // namespace

Model build_model(const Scene& scene) {
  Model model;
  model.title = scene.title;
  model.thickness = sheet_thickness(scene);
  model.law = {SheetLaw(make_material(scene.material)),
               make_thickness_rule(scene.shell.thickness_rule, scene.shell.thickness_points)};
  model.law.director_stiffness = scene.shell.director_stiffness;
  model.law.curvature_terms = scene.shell.curvature_terms;
  model.use_volume_control = scene.load.control == "volume";
  model.use_inner_surface = scene.load.pressure_surface == "inner";
  model.use_load_stiffness = scene.load.load_stiffness;
  model.use_through_wall_stress = scene.shell.through_wall_stress == "mean";
  model.pressure = scene.load.pressure;
  model.volume_ratio = scene.load.volume_ratio;
  model.feed = scene.load.axial_feed;
  model.contact = scene.contact;
  model.increment = scene.increment;
  set_treatments(scene, model);
  model.limits = scene.limits;
  model.stop = scene.stop;
  model.end_time = scene.end_time();
  const SheetMesh sheet = make_sheet(scene);
  add_sheet(model, scene, sheet);
  add_neighbours(model);
  model.volume0 = calc_enclosed_volume(model);
  for (const auto& [name, tool] : scene.tools) {
    model.tools.push_back(make_tool(tool, name, scene, 1.3 * calc_extent(model)));
  }
  check_tools(model, scene);
  resolve_quantities(scene, sheet, model);
  return model;
}

SnapshotModel make_snapshot_model(const Model& model) {
  SnapshotModel result;
  result.title = model.title;
  result.quads = model.quads;
  result.mirrors = model.mirrors;
  result.is_pressure_inside = model.use_inner_surface;
  for (const Tool& tool : model.tools) {
    result.tools.push_back({tool.name, tool.surface->display_mesh(), tool.surface->display_normals()});
  }
  return result;
}

}  // namespace hydroscope
