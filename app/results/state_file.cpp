// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/state_file.h"

#include <limits>

#include "app/results/json.h"
#include "app/results/poly_data_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

constexpr const char* kQuantity = "q.";

std::vector<double> flatten(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) numbers.insert(numbers.end(), v.data(), v.data() + 3);
  return numbers;
}

std::vector<Vec3> gather(const std::vector<double>& numbers) {
  std::vector<Vec3> vectors;
  vectors.reserve(numbers.size() / 3);
  for (size_t i = 0; i + 2 < numbers.size(); i += 3)
    vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return vectors;
}

std::vector<std::int32_t> count_up(size_t from, size_t step, size_t number) {
  std::vector<std::int32_t> counted(number);
  for (size_t i = 0; i < number; ++i) counted[i] = static_cast<std::int32_t>(from + i * step);
  return counted;
}

template <size_t N>
void set_cells(const std::vector<std::array<int, N>>& cells, PolyData& data) {
  data.connectivity.reserve(N * cells.size());
  for (const auto& cell : cells) data.connectivity.insert(data.connectivity.end(), cell.begin(), cell.end());
  data.offsets = count_up(N, N, cells.size());
}

template <size_t N>
std::vector<std::array<int, N>> get_cells(const PolyData& data) {
  std::vector<std::array<int, N>> cells(data.offsets.size());
  if (data.connectivity.size() != N * cells.size()) {
    throw InputError("cells of " + std::to_string(N) + " points expected");
  }
  for (size_t i = 0; i < data.connectivity.size(); ++i) cells[i / N][i % N] = data.connectivity[i];
  return cells;
}

/// The solver leaves out arrays that a run has no use for; a file has all of them.
template <class Value>
std::vector<Value> fill_up(std::vector<Value> values, size_t size, Value missing = {}) {
  require(values.empty() || values.size() == size, "snapshot: an array has another length than points");
  values.resize(size, missing);
  return values;
}

std::vector<std::uint8_t> get_states(const Snapshot& snapshot) {
  std::vector<std::uint8_t> states;
  for (const ContactClass state : snapshot.contact_state) states.push_back(static_cast<std::uint8_t>(state));
  return states;
}

PolyData make_poly_data(const Snapshot& s) {
  const size_t nodes = s.points.size();
  const auto vectors = [nodes](const std::vector<Vec3>& v) { return fill_up(flatten(v), 3 * nodes); };
  PolyData data;
  data.points = flatten(s.points);
  set_cells(s.model->quads, data);
  data.point_arrays = {
      {"thickness_mm", 1, fill_up(s.thickness, nodes)},
      {"plastic_strain", 1, fill_up(s.plastic_strain, nodes)},
      {"contact_state", 1, fill_up(get_states(s), nodes)},
      {"gap_mm", 1, fill_up(s.gap, nodes, std::numeric_limits<double>::quiet_NaN())},
      {"contact_pressure_MPa", 1, fill_up(s.contact_pressure, nodes)},
      {"contact_force_N", 3, vectors(s.contact_force)},
      {"tool_normal", 3, vectors(s.tool_normal)},
      {"slip_mm", 3, vectors(s.slip)},
      {"slip_increment_mm", 3, vectors(s.slip_increment)},
      {"node_id", 1, count_up(0, 1, nodes)},
      {"director", 3, vectors(s.directors)},
      {"contact_tool", 1,
       fill_up(std::vector<std::int32_t>(s.contact_tool.begin(), s.contact_tool.end()), nodes, -1)},
  };
  if (!s.support_force.empty()) data.point_arrays.push_back({"support_force_N", 3, vectors(s.support_force)});
  if (!s.toggles.empty()) {
    constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
    data.point_arrays.push_back({"let_go_time_s", 1, fill_up(s.let_go_time, nodes, kNever)});
    data.point_arrays.push_back(
        {"toggles", 1, fill_up(std::vector<std::int32_t>(s.toggles.begin(), s.toggles.end()), nodes)});
    data.point_arrays.push_back({"release_reference_N", 1, fill_up(s.release_reference, nodes)});
    data.point_arrays.push_back({"release_threshold_N", 1, fill_up(s.release_threshold, nodes)});
  }
  data.field_arrays = {
      {"TimeValue", 1, std::vector<double>{s.time}},  // the name by which ParaView knows it
      {"increment", 1, std::vector<std::int32_t>{s.increment}},
      {"time_s", 1, std::vector<double>{s.time}},
      {"pressure_MPa", 1, std::vector<double>{s.pressure}},
      {"feed_mm", 1, std::vector<double>{s.feed}},
      {"tool_translation_mm", 3, flatten(s.tool_translation)},
      {"tool_force_N", 3, flatten(s.tool_force)},
  };
  for (const auto& [name, value] : s.quantities)
    data.field_arrays.push_back({kQuantity + name, 1, std::vector<double>{value}});
  return data;
}

/// Empty when the file is older than the array.
template <class Number>
std::vector<Number> get_newer(const std::vector<DataArray>& arrays, const std::string& name) {
  for (const DataArray& array : arrays) {
    if (array.name != name) continue;
    if (const auto* numbers = std::get_if<std::vector<Number>>(&array.values)) return *numbers;
    throw InputError("array '" + name + "' has another type");
  }
  return {};
}

/// The end of contact; all of it, or none in an older file.
void get_contact_life(const PolyData& data, Snapshot& s) {
  const auto counts = get_newer<std::int32_t>(data.point_arrays, "toggles");
  s.toggles.assign(counts.begin(), counts.end());
  s.let_go_time = get_newer<double>(data.point_arrays, "let_go_time_s");
  s.release_reference = get_newer<double>(data.point_arrays, "release_reference_N");
  s.release_threshold = get_newer<double>(data.point_arrays, "release_threshold_N");
  for (const size_t size : {s.let_go_time.size(), s.release_reference.size(), s.release_threshold.size()})
    if (size != s.toggles.size())
      throw InputError("let_go_time_s, toggles, release_reference_N and release_threshold_N go together");
}

template <class Value>
Value get_one(const PolyData& data, const std::string& name) {
  const auto& values = data.field_array<Value>(name);
  if (values.size() != 1) throw InputError("array '" + name + "' should have one value");
  return values.front();
}

std::vector<ContactClass> get_classes(const PolyData& data) {
  std::vector<ContactClass> classes;
  for (const std::uint8_t code : data.point_array<std::uint8_t>("contact_state")) {
    if (code > static_cast<std::uint8_t>(ContactClass::kDetachedNow))
      throw InputError("contact_state has an unknown value");
    classes.push_back(static_cast<ContactClass>(code));
  }
  return classes;
}

Snapshot make_snapshot(const PolyData& data) {
  Snapshot s;
  s.increment = get_one<std::int32_t>(data, "increment");
  s.time = get_one<double>(data, "time_s");
  s.pressure = get_one<double>(data, "pressure_MPa");
  s.feed = get_one<double>(data, "feed_mm");
  s.points = gather(data.points);
  s.directors = gather(data.point_array<double>("director"));
  s.thickness = data.point_array<double>("thickness_mm");
  s.plastic_strain = data.point_array<double>("plastic_strain");
  s.contact_state = get_classes(data);
  const auto& tools = data.point_array<std::int32_t>("contact_tool");
  s.contact_tool.assign(tools.begin(), tools.end());
  s.gap = data.point_array<double>("gap_mm");
  s.contact_pressure = data.point_array<double>("contact_pressure_MPa");
  s.contact_force = gather(data.point_array<double>("contact_force_N"));
  s.support_force = gather(get_newer<double>(data.point_arrays, "support_force_N"));
  s.tool_normal = gather(data.point_array<double>("tool_normal"));
  s.slip = gather(data.point_array<double>("slip_mm"));
  s.slip_increment = gather(data.point_array<double>("slip_increment_mm"));
  s.tool_translation = gather(data.field_array<double>("tool_translation_mm"));
  s.tool_force = gather(get_newer<double>(data.field_arrays, "tool_force_N"));
  get_contact_life(data, s);
  for (const DataArray& array : data.field_arrays) {
    if (array.name.starts_with(kQuantity))
      s.quantities[array.name.substr(2)] = get_one<double>(data, array.name);
  }
  return s;
}

/// Runs `read` and puts the file's name before what goes wrong in it.
template <class Read>
auto read_file(const std::filesystem::path& path, const Read& read) {
  const PolyData data = parse_poly_data_file(read_whole_file(path), path.string());
  try {
    return read(data);
  } catch (const InputError& error) {
    throw InputError(path.string() + ": damaged state file: " + error.what());
  }
}

Json make_json(const Vec3& v) { return Json::Array{v.x(), v.y(), v.z()}; }

Vec3 get_vector(const Json& json) {
  const Json::Array& items = json.items();
  if (items.size() != 3) throw InputError("JSON: three numbers expected");
  return {items[0].number(), items[1].number(), items[2].number()};
}

void write_tool(const SnapshotModel::Tool& tool, const std::filesystem::path& folder) {
  PolyData data;
  data.points = flatten(tool.mesh.points);
  set_cells(tool.mesh.triangles, data);
  data.point_arrays = {{"Normals", 3, fill_up(flatten(tool.normals), data.points.size())}};
  write_whole_file(folder / (tool.name + ".vtp"), make_poly_data_file(data));
}

SnapshotModel::Tool read_tool(const std::string& name, const std::filesystem::path& folder) {
  return read_file(folder / (name + ".vtp"), [&name](const PolyData& data) {
    SnapshotModel::Tool tool;
    tool.name = name;
    tool.mesh.points = gather(data.points);
    tool.mesh.triangles = get_cells<3>(data);
    tool.normals = gather(data.point_array<double>("Normals"));
    return tool;
  });
}

}  // namespace

void write_state(const Snapshot& snapshot, const std::filesystem::path& path) {
  write_whole_file(path, make_poly_data_file(make_poly_data(snapshot)));
}

std::shared_ptr<const Snapshot> read_state(const std::filesystem::path& path,
                                           const std::shared_ptr<const SnapshotModel>& model) {
  return read_file(path, [&model](const PolyData& data) {
    auto snapshot = std::make_shared<Snapshot>(make_snapshot(data));
    snapshot->model = model;
    return std::shared_ptr<const Snapshot>(std::move(snapshot));
  });
}

void write_model(const SnapshotModel& model, const std::filesystem::path& folder) {
  Json::Array mirrors, tools;
  for (const Plane& plane : model.mirrors) {
    mirrors.push_back(
        Json::Object{{"point_mm", make_json(plane.point)}, {"normal", make_json(plane.normal)}});
  }
  std::error_code error;
  std::filesystem::create_directories(folder / "tools", error);
  if (error) throw EnvironmentError((folder / "tools").string() + ": cannot be made: " + error.message());
  for (const SnapshotModel::Tool& tool : model.tools) {
    tools.push_back(tool.name);
    write_tool(tool, folder / "tools");
  }
  const Json json = Json::Object{{"title", model.title},
                                 {"mirrors", mirrors},
                                 {"tools", tools},
                                 {"pressure_on_inner_face", model.is_pressure_inside}};
  write_whole_file(folder / "model.json", json.write() + "\n");
}

std::shared_ptr<const SnapshotModel> read_model(const std::filesystem::path& folder,
                                                const std::filesystem::path& any_state) {
  auto model = std::make_shared<SnapshotModel>();
  const std::filesystem::path file = folder / "model.json";
  const std::string text = read_whole_file(file);
  try {
    const Json json = Json::parse(text);
    model->title = json.at("title").text();
    for (const Json& mirror : json.at("mirrors").items()) {
      model->mirrors.push_back({get_vector(mirror.at("point_mm")), get_vector(mirror.at("normal"))});
    }
    if (const Json* inside = json.find("pressure_on_inner_face")) model->is_pressure_inside = inside->flag();
    for (const Json& name : json.at("tools").items())
      model->tools.push_back(read_tool(name.text(), folder / "tools"));
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
  model->quads = read_file(any_state, [](const PolyData& data) { return get_cells<4>(data); });
  return model;
}

}  // namespace hydroscope
