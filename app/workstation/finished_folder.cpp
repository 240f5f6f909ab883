// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/finished_folder.h"

#include <algorithm>
#include <map>

#include "app/inspect/contact_log.h"
#include "app/results/json.h"
#include "app/results/result_folder.h"
#include "app/results/state_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {

namespace {

Limiter parse_limiter(const std::string& text) {
  for (int i = 0; i <= static_cast<int>(Limiter::kError); ++i) {
    if (text == to_string(static_cast<Limiter>(i))) return static_cast<Limiter>(i);
  }
  return Limiter::kNone;
}

std::vector<std::string> read_quantity_names(const ResultFolder& folder) {
  const std::string text = read_whole_file(folder.history());
  std::vector<std::string> names;
  const std::string head = text.substr(0, text.find('\n')) + ",";
  for (std::size_t start = 0, end; (end = head.find(',', start)) != std::string::npos; start = end + 1) {
    if (head.compare(start, 2, "q.") == 0) names.push_back(head.substr(start + 2, end - start - 2));
  }
  return names;
}

std::vector<IncrementReport> read_rows(const CsvTable& table, const std::vector<std::string>& quantities) {
  std::vector<IncrementReport> rows(table.rows());
  const auto fill = [&](const std::string& name, const auto& put) {
    const std::optional<std::size_t> column = table.find_column(name);
    if (!column) return;
    for (std::size_t i = 0; i < rows.size(); ++i) put(rows[i], i, *column);
  };
  const auto number = [&](const std::string& name, double IncrementReport::*member) {
    fill(name, [&](IncrementReport& row, std::size_t i, std::size_t c) { row.*member = table.number(i, c); });
  };
  const auto count = [&](const std::string& name, int IncrementReport::*member) {
    fill(name,
         [&](IncrementReport& row, std::size_t i, std::size_t c) { row.*member = table.whole_number(i, c); });
  };
  using R = IncrementReport;
  count("increment", &R::increment);
  number("time_s", &R::time);
  number("pressure_MPa", &R::pressure);
  number("feed_mm", &R::feed);
  number("step_fraction", &R::step_fraction);
  fill("limited_by",
       [&](R& row, std::size_t i, std::size_t c) { row.limited_by = parse_limiter(table.text(i, c)); });
  count("limited_at", &R::limited_at);
  count("n_contact", &R::n_contact);
  count("n_stick", &R::n_stick);
  count("n_slip", &R::n_slip);
  count("n_detached", &R::n_detached);
  number("residual", &R::residual);
  number("tangential_rest", &R::tangential_rest);
  count("iterations", &R::iterations);
  count("factorisations", &R::factorisations);
  number("thickness_min_mm", &R::thickness_min);
  number("thickness_max_mm", &R::thickness_max);
  for (const std::string& name : quantities)
    fill("q." + name,
         [&](R& row, std::size_t i, std::size_t c) { row.quantities.push_back(table.number(i, c)); });
  return rows;
}

/// Outcome, message and warnings; all empty where the run was broken off.
struct FinishedSummary {
  std::string outcome, message;
  double end_time = 0.0, solver_s = 0.0;
  std::vector<Warning> warnings;
};

FinishedSummary read_summary(const ResultFolder& folder) {
  FinishedSummary summary;
  if (!std::filesystem::exists(folder.summary())) {
    summary.message = "the run was broken off: it has no summary";
    return summary;
  }
  const Json json = Json::parse(read_whole_file(folder.summary()));
  summary.outcome = json.at("outcome").text();
  summary.message = json.at("message").text();
  summary.end_time = json.at("end_time_s").number();
  for (const auto& [phase, seconds] : json.at("wall_s").members()) {
    if (phase != "total" && phase != "render" && phase != "write") summary.solver_s += seconds.number();
  }
  for (const Json& item : json.at("warnings").items())
    summary.warnings.push_back({static_cast<int>(item.at("increment").number()), item.at("time_s").number(),
                                item.at("kind").text(), item.at("text").text()});
  return summary;
}

/// Increments of the states, from their times in the index and the history; times are exact in both.
std::vector<std::pair<int, double>> find_stamps(const ResultFolder& folder, std::size_t n_states,
                                                const std::vector<IncrementReport>& rows) {
  std::map<double, int> increments = {{0.0, 0}};
  for (const IncrementReport& row : rows) increments[row.time] = row.increment;
  const std::string index = read_whole_file(folder.state_index());
  std::vector<std::pair<int, double>> stamps;
  const std::string mark = "timestep=\"";
  for (std::size_t at = index.find(mark); at != std::string::npos; at = index.find(mark, at + 1)) {
    const double time = std::stod(index.substr(at + mark.size(), 40));
    const auto found = increments.find(time);
    if (found == increments.end() || stamps.size() == n_states) break;
    stamps.emplace_back(found->second, time);
  }
  return stamps;
}

void add_states(const ResultFolder& folder, int branch, int from, const std::vector<IncrementReport>& rows,
                const std::vector<ContactEvent>& events, Board& board) {
  const std::vector<std::filesystem::path> files = find_states(folder);
  const auto stamps = find_stamps(folder, files.size(), rows);
  auto event = events.begin();
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    KeptState kept;
    kept.branch = branch;
    std::tie(kept.increment, kept.time) = stamps[i];
    if (kept.increment > 0)
      kept.pressure = rows[static_cast<std::size_t>(kept.increment - rows.front().increment)].pressure;
    for (; event != events.end() && event->increment <= kept.increment; ++event) {
      kept.touched += event->kind == EventKind::kTouch ? 1 : 0;
      kept.retouched += event->kind == EventKind::kRetouch ? 1 : 0;
      kept.slipped += event->kind == EventKind::kSlip ? 1 : 0;
      kept.detached += event->kind == EventKind::kDetach ? 1 : 0;
    }
    kept.why = i == 0 ? "first" : i + 1 == stamps.size() ? "last" : "planned";
    if (branch == 0 || kept.increment > from) board.add_kept(kept, files[i]);
  }
}

void read_branch(const ResultFolder& folder, int parent, int from, const SnapshotModel& model, Board& board) {
  const std::vector<std::string> names = read_quantity_names(folder);
  const CsvTable history = CsvTable::read(folder.history());
  const std::vector<IncrementReport> rows = read_rows(history, names);
  LogBounds bounds;
  for (const auto& quad : model.quads)
    bounds.nodes = std::max(bounds.nodes, 1 + *std::max_element(quad.begin(), quad.end()));
  for (const auto& tool : model.tools) bounds.tools.push_back(tool.name);
  const ContactLog log = make_contact_log(CsvTable::read(folder.events()), history, bounds);
  const FinishedSummary summary = read_summary(folder);
  const int number = board.add_branch(-1, 0, folder.path);
  board.set_parent(number, parent, from);
  for (const IncrementReport& row : rows) board.add_increment(row);
  board.add_events(log.events);
  board.add_warnings(summary.warnings);
  add_states(folder, number, from, rows, log.events, board);
  board.update([&](WorkstationStatus& s) {
    s.phase = WorkstationStatus::Phase::kEnded;
    s.can_steer = false;
    s.title = model.title;
    const IncrementReport last = rows.empty() ? IncrementReport{} : rows.back();
    s.increment = last.increment;
    s.time = last.time;
    s.end_time = summary.end_time > 0.0 ? summary.end_time : last.time;
    s.pressure = last.pressure;
    s.feed = last.feed;
    s.n_contact = last.n_contact;
    s.n_stick = last.n_stick;
    s.n_slip = last.n_slip;
    s.residual = last.residual;
    s.thickness_min = last.thickness_min;
    s.limited_by = to_string(last.limited_by);
    s.outcome = summary.outcome;
    s.message = summary.message;
    s.solver_s = summary.solver_s;
  });
}

}  // namespace

void read_finished_folder(const std::filesystem::path& results, Board& board) {
  const ResultFolder folder{results};
  if (!std::filesystem::exists(folder.history()))
    throw InputError(results.string() + ": holds no results of a run (history.csv)");
  const auto model = read_model(results, find_states(folder).front());
  board.set_model(model, read_quantity_names(folder));
  read_branch(folder, -1, 0, *model, board);
  for (int k = 1;; ++k) {
    const ResultFolder branch{results / "branches" / std::to_string(k)};
    if (!std::filesystem::exists(branch.path / "branch.json")) break;
    const Json json = Json::parse(read_whole_file(branch.path / "branch.json"));
    read_branch(branch, static_cast<int>(json.at("parent").number()),
                static_cast<int>(json.at("increment").number()), *model, board);
  }
  const WorkstationStatus status = board.status();
  board.set_newest(board.kept(status.branch, board.kept_states().back().increment));
}

}  // namespace hydroscope
