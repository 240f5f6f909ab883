// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/run_writer.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>

#include "app/results/json.h"
#include "app/results/state_file.h"
#include "solver/base/error.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

/// One line of a table.
class Row {
 public:
  Row& add(const std::string& cell) {
    text_ += (text_.empty() ? "" : ",") + cell;
    return *this;
  }
  Row& add(double number) { return add(format_exact(number)); }
  Row& add(int number) { return add(std::to_string(number)); }
  /// Text that may hold commas.
  Row& add_quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return add(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return add(quoted + "\"");
  }
  std::string end() const { return text_ + "\n"; }

 private:
  std::string text_;
};

std::string make_history_head(const std::vector<std::string>& quantity_names) {
  std::string head =
      "increment,time_s,pressure_MPa,feed_mm,step_fraction,limited_by,limited_at,"
      "n_contact,n_stick,n_slip,n_detached,residual,tangential_rest,iterations,factorisations,thickness_min_"
      "mm,thickness_max_mm";
  for (const std::string& name : quantity_names) head += ",q." + name;
  return head + "\n";
}

constexpr const char* kEventsHead =
    "increment,time_s,kind,node,x_mm,y_mm,z_mm,tool,cause,force_before_N,force_after_N,gap_mm,"
    "patch_pressure_MPa,threshold_N\n";

std::string make_history_row(const IncrementReport& r) {
  Row row;
  row.add(r.increment).add(r.time).add(r.pressure).add(r.feed).add(r.step_fraction);
  row.add_quoted(to_string(r.limited_by)).add(r.limited_at);
  row.add(r.n_contact).add(r.n_stick).add(r.n_slip).add(r.n_detached);
  row.add(r.residual).add(r.tangential_rest).add(r.iterations).add(r.factorisations);
  row.add(r.thickness_min).add(r.thickness_max);
  for (const double quantity : r.quantities) row.add(quantity);
  return row.end();
}

/// The lines of a table, without its head, whose first cell is at most `increment`.
std::string take_rows(const std::string& text, int increment) {
  std::string rows;
  std::size_t start = text.find('\n');
  start = start == std::string::npos ? text.size() : start + 1;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find('\n', start), text.size() - 1) + 1;
    if (std::atoi(text.c_str() + start) > increment) break;
    rows += text.substr(start, end - start);
    start = end;
  }
  return rows;
}

/// States never change once they are written: two folders may share one file.
void link_or_copy(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::create_hard_link(from, to, error);
  if (error) std::filesystem::copy_file(from, to, error);
  if (error) throw EnvironmentError(to.string() + ": cannot be written: " + error.message());
}

Json make_wall_times(const PhaseTimes& solver, const ProgramTimes& program) {
  return Json::Object{
      {"total", program.total},        {"search", solver.search},  {"assemble", solver.assemble},
      {"factorise", solver.factorise}, {"solve", solver.solve},    {"update", solver.update},
      {"snapshot", solver.snapshot},   {"render", program.render}, {"write", program.write}};
}

Json make_warnings(const std::vector<Warning>& warnings) {
  Json::Array list;
  for (const Warning& warning : warnings) {
    list.push_back(Json::Object{{"increment", warning.increment},
                                {"time_s", warning.time},
                                {"kind", warning.kind},
                                {"text", warning.text}});
  }
  return list;
}

Json make_texts(const std::vector<std::string>& texts) { return Json::Array(texts.begin(), texts.end()); }

Json make_estimate(const ErrorEstimate& estimate) {
  Json::Array list;
  for (const QuantityError& item : estimate.errors) {
    list.push_back(Json::Object{{"quantity", item.name},
                                {"time_s", item.time},
                                {"value", item.value},
                                {"error", item.error},
                                {"relative", item.relative}});
  }
  return Json::Object{{"worst", estimate.worst},
                      {"quantities", std::move(list)},
                      {"trouble", estimate.trouble},
                      {"factorisations", estimate.factorisations},
                      {"degrees_of_freedom", estimate.degrees_of_freedom},
                      {"wall_s", estimate.wall}};
}

Json make_accuracy(const RunRecord& record, const RunSummary& summary) {
  Json::Array choices;
  for (const Choice& choice : record.choices) {
    choices.push_back(Json::Object{{"key", choice.key}, {"value", choice.value}, {"reason", choice.reason}});
  }
  Json::Object accuracy{{"asked", record.accuracy}, {"choices", std::move(choices)}};
  if (summary.estimate) accuracy.emplace_back("estimate", make_estimate(*summary.estimate));
  return accuracy;
}

}  // namespace

RunWriter::RunWriter(ResultFolder folder, const RunRecord& record, const SnapshotModel& model,
                     const std::vector<std::string>& quantity_names)
    : folder_(std::move(folder)), record_(record), history_(folder_.history()), events_(folder_.events()) {
  for (const SnapshotModel::Tool& tool : model.tools) tool_names_.push_back(tool.name);
  write_whole_file(folder_.scene(), record.scene_text);
  set_overrides(record.overrides);
  write_model(model, folder_.path);
  for (const auto& [name, report] : record.tool_reports) {
    write_whole_file(folder_.path / "tools" / (name + ".txt"), report);
  }
  history_.append(make_history_head(quantity_names));
  events_.append(kEventsHead);
}

std::string RunWriter::tool_name(int tool) const {
  return tool >= 0 && tool < static_cast<int>(tool_names_.size()) ? tool_names_[static_cast<size_t>(tool)]
                                                                  : "";
}

void RunWriter::add_increment(const IncrementReport& report) {
  std::string lines;
  for (const ContactEvent& event : report.events) {
    Row row;
    row.add(event.increment).add(event.time).add(to_string(event.kind)).add(event.node);
    row.add(event.position.x()).add(event.position.y()).add(event.position.z()).add(tool_name(event.tool));
    row.add_quoted(event.cause).add(event.force_before).add(event.force_after).add(event.gap);
    row.add(event.patch_pressure).add(event.threshold);
    lines += row.end();
  }
  // Events first: a history row says that its events are there, too.
  if (!lines.empty()) events_.append(lines);
  history_.append(make_history_row(report));
}

void RunWriter::add_state(const Snapshot& snapshot) {
  if (!state_increments_.empty() && snapshot.increment == state_increments_.back()) return;
  write_state(snapshot, folder_.path / ResultFolder::state_name(states()));
  state_times_.push_back(snapshot.time);
  state_increments_.push_back(snapshot.increment);
  write_state_index();
}

void RunWriter::write_state_index() {
  std::string index =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n  "
      "<Collection>\n";
  for (size_t i = 0; i < state_times_.size(); ++i) {
    index += "    <DataSet timestep=\"" + format_exact(state_times_[i]) + "\" part=\"0\" file=\"" +
             ResultFolder::state_name(static_cast<int>(i)) + "\"/>\n";
  }
  write_whole_file(folder_.state_index(), index + "  </Collection>\n</VTKFile>\n");
}

void RunWriter::set_overrides(const std::vector<std::string>& overrides) {
  record_.overrides = overrides;
  std::string text;
  for (const std::string& item : overrides) text += item + "\n";
  write_whole_file(folder_.overrides(), text);
}

void RunWriter::carry_over(const RunWriter& from, int increment) {
  events_.append(take_rows(read_whole_file(from.folder_.events()), increment));
  history_.append(take_rows(read_whole_file(from.folder_.history()), increment));
  for (std::size_t i = 0; i < from.state_increments_.size() && from.state_increments_[i] <= increment; ++i) {
    const std::string name = ResultFolder::state_name(states());
    link_or_copy(from.folder_.path / ResultFolder::state_name(static_cast<int>(i)), folder_.path / name);
    state_times_.push_back(from.state_times_[i]);
    state_increments_.push_back(from.state_increments_[i]);
  }
  write_state_index();
}

void RunWriter::finish(const RunSummary& summary, const ProgramTimes& times) {
  Json::Object quantities;
  const size_t known = std::min(summary.quantity_names.size(), summary.quantities.size());
  for (size_t i = 0; i < known; ++i)
    quantities.emplace_back(summary.quantity_names[i], summary.quantities[i]);
  Json::Object json{{"outcome", to_string(summary.outcome)},
                    {"message", summary.message},
                    {"time_s", summary.time},
                    {"end_time_s", record_.end_time},
                    {"increments", summary.increments},
                    {"factorisations", summary.factorisations},
                    {"degrees_of_freedom", summary.degrees_of_freedom},
                    {"peak_memory_mb", find_peak_memory()},
                    {"quantities", quantities},
                    {"wall_s", make_wall_times(summary.wall, times)},
                    {"warnings", make_warnings(summary.warnings)},
                    {"renderer", record_.renderer},
                    {"threads", record_.threads},
                    {"states", states()},
                    {"scene", record_.scene_file},
                    {"overrides", make_texts(record_.overrides)},
                    {"version", HYDROSCOPE_VERSION}};
  if (record_.accuracy > 0.0) json.emplace_back("accuracy", make_accuracy(record_, summary));
  write_whole_file(folder_.summary(), Json(json).write() + "\n");
}

double find_peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in kB
}

}  // namespace hydroscope
