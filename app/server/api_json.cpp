// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/api_json.h"

#include <algorithm>

#include "render/view_range.h"

namespace hydroscope {
namespace {

const char* phase_name(WorkstationStatus::Phase phase) {
  switch (phase) {
    case WorkstationStatus::Phase::kPaused:
      return "paused";
    case WorkstationStatus::Phase::kRunning:
      return "running";
    case WorkstationStatus::Phase::kEnded:
      break;
  }
  return "ended";
}

Json make_names_json(const std::vector<std::string>& names) {
  Json::Array array;
  for (const std::string& name : names) array.emplace_back(name);
  return array;
}

Json make_quantities_json(const std::vector<double>& values, const std::vector<std::string>& names) {
  Json::Object object;
  for (std::size_t i = 0; i < std::min(values.size(), names.size()); ++i)
    object.emplace_back(names[i], values[i]);
  return object;
}

Json make_row_json(const IncrementReport& row, const std::vector<std::string>& quantities) {
  return Json::Object{{"increment", row.increment},
                      {"time_s", row.time},
                      {"pressure_MPa", row.pressure},
                      {"feed_mm", row.feed},
                      {"n_contact", row.n_contact},
                      {"n_stick", row.n_stick},
                      {"n_slip", row.n_slip},
                      {"n_detached", row.n_detached},
                      {"residual", row.residual},
                      {"tangential_rest", row.tangential_rest},
                      {"limited_by", to_string(row.limited_by)},
                      {"limited_at", row.limited_at < 0 ? Json() : Json(row.limited_at)},
                      {"iterations", row.iterations},
                      {"factorisations", row.factorisations},
                      {"negative_pivots", row.negative_pivots},
                      {"thickness_min_mm", row.thickness_min},
                      {"thickness_max_mm", row.thickness_max},
                      {"step_fraction", row.step_fraction},
                      {"quantities", make_quantities_json(row.quantities, quantities)}};
}

}  // namespace

std::string to_line(const Json& json) {
  // Line breaks within texts are escaped: each one that is seen comes from the writer, as does the indent.
  const std::string pretty = json.write();
  std::string line;
  for (std::size_t i = 0; i < pretty.size(); ++i) {
    if (pretty[i] != '\n') {
      line += pretty[i];
      continue;
    }
    while (i + 1 < pretty.size() && pretty[i + 1] == ' ') ++i;
  }
  return line;
}

Json make_status_json(const WorkstationStatus& status, const ViewerFacts& viewers,
                      const FrameFigures& frames) {
  return Json::Object{{"version", static_cast<double>(status.version)},
                      {"phase", phase_name(status.phase)},
                      {"can_steer", status.can_steer},
                      {"title", status.title},
                      {"branch", status.branch},
                      {"increment", status.increment},
                      {"time_s", status.time},
                      {"end_time_s", status.end_time},
                      {"pressure_MPa", status.pressure},
                      {"feed_mm", status.feed},
                      {"n_contact", status.n_contact},
                      {"n_stick", status.n_stick},
                      {"n_slip", status.n_slip},
                      {"residual", status.residual},
                      {"thickness_min_mm", status.thickness_min},
                      {"limited_by", status.limited_by},
                      {"until", status.until},
                      {"message", status.message},
                      {"outcome", status.outcome},
                      {"n_warnings", status.n_warnings},
                      {"n_kept", status.n_kept},
                      {"n_events", status.n_events},
                      {"solver_s", status.solver_s},
                      {"viewers", viewers.viewers},
                      {"steering_viewer", viewers.steering.empty() ? Json() : Json(viewers.steering)},
                      {"you_steer", !viewers.self.empty() && viewers.self == viewers.steering},
                      {"renderer", frames.renderer},
                      {"draw_ms", frames.draw_ms},
                      {"fps", frames.fps}};
}

Json make_reply_json(const CommandReply& reply) {
  return Json::Object{{"done", reply.is_done}, {"text", reply.text}, {"increment", reply.increment}};
}

Json make_timeline_json(const std::vector<KeptState>& kept) {
  Json::Array states;
  for (const KeptState& state : kept) {
    states.emplace_back(Json::Object{{"branch", state.branch},
                                     {"increment", state.increment},
                                     {"time_s", state.time},
                                     {"pressure_MPa", state.pressure},
                                     {"touched", state.touched},
                                     {"slipped", state.slipped},
                                     {"detached", state.detached},
                                     {"retouched", state.retouched},
                                     {"can_restore", state.can_restore},
                                     {"why", state.why}});
  }
  return Json::Object{{"kept", std::move(states)}};
}

Json make_history_json(const std::vector<IncrementReport>& rows, const std::vector<std::string>& quantities) {
  Json::Array array;
  for (const IncrementReport& row : rows) array.push_back(make_row_json(row, quantities));
  Json::Array columns;
  const Json shape = make_row_json({}, quantities);
  for (const auto& [key, value] : shape.members()) columns.emplace_back(key);
  return Json::Object{{"columns", std::move(columns)},
                      {"quantities", make_names_json(quantities)},
                      {"rows", std::move(array)}};
}

Json make_warning_json(const Warning& warning) {
  return Json::Object{{"increment", warning.increment},
                      {"time_s", warning.time},
                      {"kind", warning.kind},
                      {"text", warning.text}};
}

Json make_warnings_json(const std::vector<Warning>& warnings) {
  Json::Array array;
  for (const Warning& warning : warnings) array.push_back(make_warning_json(warning));
  return Json::Object{{"warnings", std::move(array)}};
}

Json make_contact_json(const ContactCounts& counts) {
  return Json::Object{{"increment", counts.increment},
                      {"touched", counts.touched},
                      {"slipped", counts.slipped},
                      {"detached", counts.detached},
                      {"retouched", counts.retouched}};
}

Json make_files_json(const std::vector<RunFile>& files) {
  Json::Array array;
  for (const RunFile& file : files)
    array.emplace_back(Json::Object{{"name", file.name}, {"bytes", static_cast<double>(file.size)}});
  return Json::Object{{"files", std::move(array)}};
}

Json make_error_json(const std::string& text) { return Json::Object{{"error", text}}; }

Json make_vector_json(const Vec3& vector) { return Json::Array{vector.x(), vector.y(), vector.z()}; }

Json make_model_json(const Snapshot& first, const std::vector<std::string>& quantities,
                     const std::vector<std::string>& settable) {
  Json::Array tools;
  for (const SnapshotModel::Tool& tool : first.model->tools) tools.emplace_back(tool.name);
  Vec3 least = Vec3::Zero(), greatest = Vec3::Zero();
  if (!first.points.empty()) least = greatest = first.points.front();
  for (const Vec3& point : first.points) {
    least = least.cwiseMin(point);
    greatest = greatest.cwiseMax(point);
  }
  return Json::Object{{"title", first.model->title},
                      {"nodes", static_cast<int>(first.points.size())},
                      {"elements", static_cast<int>(first.model->quads.size())},
                      {"tools", std::move(tools)},
                      {"views", make_names_json(view_names())},
                      {"quantities", make_names_json(quantities)},
                      {"box", Json::Array{make_vector_json(least), make_vector_json(greatest)}},
                      {"mirrors", static_cast<int>(first.model->mirrors.size())},
                      {"settable", make_names_json(settable)}};
}

}  // namespace hydroscope
