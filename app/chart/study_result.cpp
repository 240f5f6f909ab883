// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_result.h"

#include <algorithm>
#include <cmath>

#include "app/chart/closed_forms.h"
#include "app/results/json.h"
#include "app/results/result_folder.h"
#include "render/view_text.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

std::optional<Json> read_summary(const fs::path& folder) {
  std::error_code error;
  const fs::path file = ResultFolder{folder}.summary();
  if (!fs::exists(file, error)) return std::nullopt;
  return Json::parse(read_whole_file(file));
}

std::optional<HistoryTable> read_history(const fs::path& folder) {
  std::error_code error;
  const fs::path file = ResultFolder{folder}.history();
  if (!fs::exists(file, error)) return std::nullopt;
  HistoryTable table(file);
  if (table.rows() == 0) return std::nullopt;
  return table;
}

std::string format_share(double fraction) {
  return format_number(std::round(1000.0 * fraction) / 10.0) + " % of the path";
}

/// What went wrong by the exit code; empty when nothing did that would spoil the values.
std::string describe_end(const RunEnd& end, const RunResult& result) {
  const std::string at = " at " + format_share(result.fraction);
  if (end.time_limit > 0.0) return "time limit " + format_number(end.time_limit) + " s" + at;
  if (end.exit_code < 0) return "killed by signal " + std::to_string(-end.exit_code) + at;
  if (end.exit_code == 0 || end.exit_code == 3) return {};
  const std::string what = result.outcome.empty() ? end.message : result.outcome;
  return (what.empty() ? "ended" : what) + (end.exit_code == 2 ? "" : at) + " (exit code " +
         std::to_string(end.exit_code) + ")";
}

void read_values(const StudyCase& one, const HistoryTable& history, RunResult& result) {
  for (const StudyQuantity& quantity : one.quantities) {
    std::vector<ComparedValue> values;
    if (quantity.driver.empty()) {
      ComparedValue last;
      last.value = history.column(quantity.column).back();
      values.push_back(last);
    }
    for (const double at : quantity.at)
      values.push_back({at, history.find_at(quantity.column, quantity.driver, at).value_or(kUnknown)});
    result.values.push_back(std::move(values));
  }
}

/// The first value that is missing, in words.
std::string describe_missing(const StudyCase& one, const RunResult& result) {
  for (std::size_t q = 0; q < result.values.size(); ++q)
    for (const ComparedValue& value : result.values[q]) {
      if (std::isfinite(value.value)) continue;
      const StudyQuantity& quantity = one.quantities[q];
      const std::string ended = result.outcome + " at " + format_share(result.fraction);
      if (quantity.driver.empty()) return quantity.label + " is no number: " + ended;
      return quantity.driver + " never came to " + format_number(value.at) + ": " + ended;
    }
  return {};
}

double find_reference(const StudyQuantity& quantity, std::size_t q, std::size_t k, const CaseResult& result,
                      const Scene& scene, double at) {
  using Reference = StudyQuantity::Reference;
  if (quantity.reference == Reference::kFormula) return calc_closed_form(quantity.formula, scene, at);
  if (quantity.reference == Reference::kTable) return quantity.values[k];
  if (!result.finest || result.finest->is_failed() || !result.finest->is_known) return kUnknown;
  return result.finest->values[q][k].value;
}

/// Errors of one run against its references.
void compare_run(const CaseResult& result, const std::vector<std::vector<double>>& references,
                 RunResult& run) {
  double largest = 0.0, squares = 0.0;
  int count = 0;
  for (std::size_t q = 0; q < run.values.size(); ++q)
    for (std::size_t k = 0; k < run.values[q].size(); ++k) {
      ComparedValue& value = run.values[q][k];
      value.reference = references[q][k];
      const double scale = result.one->quantities[q].scale.value_or(std::abs(value.reference));
      value.error_percent = 100.0 * std::abs(value.value - value.reference) / scale;
      largest = std::max(largest, value.error_percent);
      squares += value.error_percent * value.error_percent;
      ++count;
      if (!std::isfinite(value.error_percent)) largest = squares = kUnknown;
    }
  if (count > 0) run.error_percent = result.one->is_rms ? std::sqrt(squares / count) : largest;
}

}  // namespace

double calc_median(std::vector<double> values) {
  if (values.empty()) return kUnknown;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double RunResult::wall() const { return calc_median(walls); }

double read_solving_time(const fs::path& folder) {
  const auto summary = read_summary(folder);
  if (!summary) return kUnknown;
  double sum = 0.0;
  for (const char* phase : {"search", "assemble", "factorise", "solve", "update"})
    sum += summary->at("wall_s").at(phase).number();
  return sum;
}

RunResult read_run_result(const StudyCase& one, const StudyRun& run, const fs::path& folder,
                          const std::optional<RunEnd>& end) {
  RunResult result{.run = run, .folder = folder};
  if (!end) {
    result.cause = "not run";
    return result;
  }
  result.is_known = true;
  result.exit_code = end->exit_code;
  try {
    const auto history = read_history(folder);
    if (const auto summary = read_summary(folder)) {
      result.outcome = summary->at("outcome").text();
      result.increments = static_cast<int>(summary->at("increments").number());
      result.factorisations = summary->at("factorisations").number();
      const double all = summary->at("end_time_s").number();
      result.fraction = all > 0.0 ? summary->at("time_s").number() / all : 0.0;
      result.own_wall = read_solving_time(folder);
    } else if (history) {
      result.increments = static_cast<int>(history->rows());
      const double all = read_scene(one.scene, run.overrides).end_time();
      result.fraction = all > 0.0 ? history->column("time_s").back() / all : 0.0;
      result.own_wall = end->elapsed;
    }
    result.cause = describe_end(*end, result);
    if (!history) {
      if (result.cause.empty()) result.cause = "no increment was accepted";
      return result;
    }
    read_values(one, *history, result);
    if (result.cause.empty()) result.cause = describe_missing(one, result);
  } catch (const InputError& error) {
    result.cause = error.what();
  }
  return result;
}

void compare_case(CaseResult& result) {
  const StudyCase& one = *result.one;
  if (one.quantities.empty()) return;
  for (RunResult& run : result.runs) {
    if (run.is_failed() || run.values.size() != one.quantities.size()) continue;
    const Scene scene = read_scene(one.scene, run.run.overrides);
    std::vector<std::vector<double>> references;
    for (std::size_t q = 0; q < one.quantities.size(); ++q) {
      references.emplace_back();
      for (std::size_t k = 0; k < run.values[q].size(); ++k)
        references.back().push_back(
            find_reference(one.quantities[q], q, k, result, scene, run.values[q][k].at));
    }
    compare_run(result, references, run);
    if (!std::isfinite(run.error_percent))
      run.cause = result.finest && result.finest->is_failed()
                      ? "no reference: the finest run failed (" + result.finest->cause + ")"
                      : "no reference";
  }
}

}  // namespace hydroscope
