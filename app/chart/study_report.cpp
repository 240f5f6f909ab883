// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/chart/pareto.h"
#include "app/chart/study_charts.h"
#include "render/view_text.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

constexpr double kClearly = 0.1;  ///< share by which a variant must be better to be called so

std::string show(double value) { return std::isfinite(value) ? format_number(value) : "-"; }
std::string write(double value) { return std::isfinite(value) ? format_exact(value) : ""; }

std::string quote(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Text inside a cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\\|");
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::vector<CostPoint> find_points(const CaseResult& result, CostKind kind) {
  std::vector<CostPoint> points;
  for (const RunResult& run : result.runs)
    points.push_back(run.is_failed() ? CostPoint{kUnknown, kUnknown}
                                     : CostPoint{find_cost(run, kind), run.error_percent});
  return points;
}

std::vector<bool> find_front(const CaseResult& result, CostKind kind) {
  std::vector<bool> is_on_front(result.runs.size(), false);
  for (const std::size_t i : find_pareto_front(find_points(result, kind))) is_on_front[i] = true;
  return is_on_front;
}

std::string show_walls(const RunResult& run) {
  if (run.walls.empty()) return "-";
  const auto [low, high] = std::minmax_element(run.walls.begin(), run.walls.end());
  return show(run.wall()) + " (" + show(*low) + " to " + show(*high) + ")";
}

std::string make_run_table(const CaseResult& result) {
  const auto wall_front = find_front(result, CostKind::kWall),
             factorisation_front = find_front(result, CostKind::kFactorisations);
  std::string text =
      "| run | error % | wall s: median (range) | factorisations | increments | on the front of | ended |\n"
      "|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const RunResult& run = result.runs[i];
    const std::string front = std::string(wall_front[i] ? "wall" : "") +
                              (wall_front[i] && factorisation_front[i] ? ", " : "") +
                              (factorisation_front[i] ? "factorisations" : "");
    text += "| " + cell(run.run.label) + (run.run.id == result.one->standard ? " **(default)**" : "") +
            " | " + show(run.is_failed() ? kUnknown : run.error_percent) + " | " + show_walls(run) + " | " +
            show(run.factorisations) + " | " + std::to_string(run.increments) + " | " + front + " | " +
            cell(run.is_failed() ? "**failed**: " + run.cause : run.outcome) + " |\n";
  }
  return text;
}

std::string describe_reference(const StudyQuantity& q) {
  using Reference = StudyQuantity::Reference;
  std::string where = q.driver.empty() ? "at the end" : "at " + q.driver + " =";
  for (const double at : q.at) where += " " + format_number(at);
  const std::string what = q.reference == Reference::kFormula ? "closed form `" + q.formula + "`"
                           : q.reference == Reference::kTable ? "table: " + q.source
                                                              : "the finest run";
  return "- " + q.label + " (`" + q.column + "`), " + where + ", against " + what + "\n";
}

std::string describe_settings(const std::vector<SceneOverride>& overrides) {
  std::string text;
  for (const SceneOverride& item : overrides)
    text += (text.empty() ? "`" : ", `") + item.key + " = " + item.value + "`";
  return text.empty() ? "as in the scene" : text;
}

std::string make_elsewhere_table(const StudyCase& one) {
  if (one.elsewhere.empty()) return {};
  std::string text = "\nMeasured elsewhere:\n\n| program | error % | wall s | note |\n|---|---|---|---|\n";
  for (const StudyElsewhere& point : one.elsewhere)
    text += "| " + cell(point.label) + " | " + show(*point.error_percent) + " | " +
            show(point.wall_s.value_or(kUnknown)) + " | " + cell(point.note) + " |\n";
  return text;
}

std::string make_case_section(const ReportedCase& reported) {
  const CaseResult& result = *reported.result;
  const StudyCase& one = *result.one;
  std::string text =
      "\n## " + one.title + "\n\nScene `" + one.scene + "`, with " + describe_settings(one.set) + ".\n\n";
  if (!one.quantities.empty())
    text += std::string("Compared (the error of a run is the ") +
            (one.is_rms ? "root mean square" : "largest") + "):\n\n";
  for (const StudyQuantity& quantity : one.quantities) text += describe_reference(quantity);
  if (result.finest)
    text += "- finest run: " + describe_settings(result.finest->run.overrides) +
            (result.finest->is_failed() ? "; **failed**: " + result.finest->cause : "") + "\n";
  text += "\n" + make_run_table(result) + make_elsewhere_table(one) + "\n";
  for (const std::string& sentence : describe_default(result)) text += "- " + sentence + "\n";
  for (const std::string& chart : reported.charts) text += "\n![" + chart + "](" + chart + ".png)\n";
  return text;
}

}  // namespace

std::vector<std::string> describe_default(const CaseResult& result) {
  const auto standard = std::find_if(result.runs.begin(), result.runs.end(), [&](const RunResult& run) {
    return run.run.id == result.one->standard;
  });
  if (standard == result.runs.end()) return {};
  if (standard->is_failed())
    return {"The default (" + standard->run.label + ") failed: " + standard->cause + "."};
  const auto place = static_cast<std::size_t>(standard - result.runs.begin());
  std::vector<std::string> sentences;
  for (const CostKind kind : {CostKind::kWall, CostKind::kFactorisations}) {
    const auto points = find_points(result, kind);
    if (!std::isfinite(points[place].cost)) continue;
    const std::string name = kind == CostKind::kWall ? "wall time" : "factorisations";
    std::string beaten, better;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::string& label = result.runs[i].run.label;
      if (is_better(points[place], points[i], kClearly)) beaten += (beaten.empty() ? "" : "; ") + label;
      if (is_better(points[i], points[place], kClearly)) better += (better.empty() ? "" : "; ") + label;
    }
    sentences.push_back("By " + name +
                        ", both cheaper and more accurate than the default by more than 10 %: " +
                        (better.empty() ? "none." : better + "."));
    sentences.push_back("By " + name + ", beaten by the default in both by more than 10 %: " +
                        (beaten.empty() ? "none." : beaten + "."));
  }
  return sentences;
}

std::string make_case_csv(const CaseResult& result) {
  std::string csv =
      "run,label,settings,is_default,failed,outcome,exit_code,fraction,increments,factorisations,wall_s,"
      "walls_s,error_percent\n";
  const auto add = [&](const RunResult& run) {
    std::string settings, walls;
    for (const SceneOverride& item : run.run.overrides)
      settings += (settings.empty() ? "" : "; ") + item.key + "=" + item.value;
    for (const double wall : run.walls) walls += (walls.empty() ? "" : "; ") + write(wall);
    csv += quote(run.run.id) + "," + quote(run.run.label) + "," + quote(settings) + "," +
           (run.run.id == result.one->standard ? "1" : "0") + "," + quote(run.cause) + "," +
           quote(run.outcome) + "," + std::to_string(run.exit_code) + "," + write(run.fraction) + "," +
           std::to_string(run.increments) + "," + write(run.factorisations) + "," + write(run.wall()) + "," +
           quote(walls) + "," + write(run.error_percent) + "\n";
  };
  for (const RunResult& run : result.runs) add(run);
  if (result.finest) add(*result.finest);
  return csv;
}

std::string make_values_csv(const CaseResult& result) {
  std::string csv = "run,quantity,driver,at,value,reference,error_percent\n";
  for (const RunResult& run : result.runs)
    for (std::size_t q = 0; q < run.values.size(); ++q)
      for (const ComparedValue& value : run.values[q]) {
        const StudyQuantity& quantity = result.one->quantities[q];
        csv += quote(run.run.id) + "," + quote(quantity.name) + "," + quote(quantity.driver) + "," +
               write(value.at) + "," + write(value.value) + "," + write(value.reference) + "," +
               write(value.error_percent) + "\n";
      }
  return csv;
}

std::string make_study_report(const Study& study, const std::vector<ReportedCase>& cases,
                              const std::vector<std::string>& plots, const ReportFacts& facts) {
  const Machine& m = facts.machine;
  std::string text = "# " + study.title + "\n\n";
  text += "| | |\n|---|---|\n";
  text += "| study | `" + study.file + "` |\n| date | " + m.date + " |\n";
  text += "| machine | " + cell(m.processor) + ", " + std::to_string(m.cores) + " cores, " +
          format_number(std::round(10.0 * m.memory_gb) / 10.0) + " GiB |\n";
  text += "| system | " + cell(m.system) + " |\n";
  text += "| program | Hydroscope " + facts.version + ", hash " + facts.program_hash + " |\n";
  if (!facts.revision.empty()) text += "| sources beside the study | " + cell(facts.revision) + " |\n";
  if (!facts.renderer.empty()) text += "| pictures | " + cell(facts.renderer) + " |\n";
  text += "| wall times | of solving (search, assembly, factorisation, solution, update), medians of " +
          std::to_string(study.repeats) + " interleaved repeats (from " +
          format_number(study.timed_once_from) + " s on: one), each run alone with " +
          std::to_string(study.threads) + (study.threads == 1 ? " thread |\n" : " threads |\n");
  for (const ReportedCase& one : cases) text += make_case_section(one);
  if (!plots.empty()) text += "\n## Tables\n";
  for (const std::string& plot : plots) text += "\n![" + plot + "](" + plot + ".png)\n";
  return text;
}

}  // namespace hydroscope
