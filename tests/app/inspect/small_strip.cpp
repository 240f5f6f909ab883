// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/inspect/small_strip.h"

#include "app/results/state_file.h"
#include "solver/base/whole_file.h"
#include "solver/scene/number_text.h"

namespace hydroscope::test {
namespace {

constexpr int kNodes = 12;

Vec3 find_place(int node) { return {2.0 * (node % 6), node < 6 ? 0.0 : 2.0, 0.0}; }

constexpr const char* kScene = R"(title = "Strip"
[tube]
radius_mm = 30.0
thickness_mm = 1.5
length_mm = 2.0
section = "quarter"
extent = "slice"
elements_around = 5
[material]
youngs_modulus_MPa = 206e3
hardening = "swift"
swift_K_MPa = 550.0
swift_eps0 = 0.01
swift_n = 0.2
[load]
pressure_MPa = [[0.0, 0.0], [1.0, 30.0]]
[tool.die]
shape = "cylinder"
radius_mm = 32.7
side = "inside"
)";

}  // namespace

std::shared_ptr<const SnapshotModel> make_strip_model() {
  auto model = std::make_shared<SnapshotModel>();
  model->title = "Strip";
  for (int i = 0; i < 5; ++i) model->quads.push_back({i, i + 1, i + 7, i + 6});
  for (const char* name : {"die", "punch"}) {
    SnapshotModel::Tool tool;
    tool.name = name;
    tool.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    tool.mesh.triangles = {{0, 1, 2}};
    tool.normals = {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()};
    model->tools.push_back(tool);
  }
  return model;
}

Snapshot make_strip_state(int increment) {
  Snapshot s;
  s.model = make_strip_model();
  s.increment = increment;
  s.time = 0.1 * increment;
  s.pressure = increment < 9 ? 10.0 : 9.0;
  for (int i = 0; i < kNodes; ++i) {
    s.points.push_back(find_place(i));
    s.directors.push_back(Vec3::UnitZ());
  }
  s.thickness.assign(kNodes, 1.0);
  s.contact_state.assign(kNodes, ContactClass::kFree);
  s.contact_tool.assign(kNodes, -1);
  s.gap.assign(kNodes, 1.0);
  s.contact_pressure.assign(kNodes, 0.0);
  s.contact_force.assign(kNodes, Vec3::Zero());
  s.tool_normal.assign(kNodes, Vec3::Zero());
  s.tool_translation = {Vec3::Zero(), Vec3::Zero()};
  return s;
}

std::string make_event_line(int increment, const std::string& kind, int node, const std::string& rest) {
  const Vec3 place = find_place(node);
  return std::to_string(increment) + "," + format_exact(0.1 * increment) + "," + kind + "," +
         std::to_string(node) + "," + format_exact(place.x()) + "," + format_exact(place.y()) + ",0," + rest +
         "\n";
}

std::string make_history(int last) {
  std::string text = "increment,time_s,pressure_MPa,feed_mm,step_fraction,limited_by,limited_at,n_contact\n";
  for (int i = 1; i <= last; ++i)
    text += std::to_string(i) + "," + format_exact(0.1 * i) + "," + (i < 9 ? "10" : "9") + ",0," +
            (i == 9 ? "0.25,release,3" : "1,path,-1") + ",0\n";
  return text;
}

std::string make_events(const std::string& lines) {
  return "increment,time_s,kind,node,x_mm,y_mm,z_mm,tool,cause,force_before_N,force_after_N,gap_mm\n" + lines;
}

ContactLog make_log(const std::string& event_lines, int last) {
  return make_contact_log(CsvTable::parse(make_events(event_lines), "events.csv"),
                          CsvTable::parse(make_history(last), "history.csv"), {kNodes, {"die", "punch"}});
}

Ledger make_small_ledger(const std::string& event_lines, const std::vector<Snapshot>& states, int last) {
  SheetHistory sheet;
  for (const Snapshot& state : states) sheet.states.push_back(make_sheet_state(state));
  sheet.neighbours = find_neighbours(make_strip_model()->quads, kNodes);
  VerdictBounds bounds;
  bounds.opening = 0.002;
  Ledger ledger = make_ledger(make_log(event_lines, last), std::move(sheet), bounds);
  ledger.title = "Strip";
  ledger.tools = {"die", "punch"};
  return ledger;
}

void write_small_run(const std::filesystem::path& folder, const std::string& event_lines,
                     const std::vector<Snapshot>& states) {
  std::filesystem::create_directories(folder / "states");
  write_model(*make_strip_model(), folder);
  for (std::size_t i = 0; i < states.size(); ++i)
    write_state(states[i], folder / ResultFolder::state_name(static_cast<int>(i)));
  write_whole_file(folder / "scene.toml", kScene);
  write_whole_file(folder / "overrides.txt", "contact.tolerance_mm=0.004\n");
  write_whole_file(folder / "history.csv", make_history(30));
  write_whole_file(folder / "events.csv", make_events(event_lines));
}

}  // namespace hydroscope::test
