// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/api.h"

#include <array>
#include <functional>

#include "app/server/api_json.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr std::size_t kMostListed = 20'000;

using Answer = std::function<ApiReply(Desk&, const Query&, const std::string& body)>;
struct Route {
  const char* path;
  const char* method;
  Answer answer;
};

/// For answers that take no parameters but the viewer.
template <class Make>
Answer plain(Make make) {
  return [make](Desk& desk, const Query& query, const std::string&) {
    query.allow({"viewer"});
    return make(desk);
  };
}

template <class Make>
Answer asked(Make make) {
  return [make](Desk& desk, const Query& query, const std::string&) { return make(desk, query); };
}

const std::vector<Route>& routes() {
  static const std::vector<Route> all = {
      {"/api/status", "GET", asked(answer_status)},
      {"/api/command", "POST", answer_command},
      {"/api/steer", "POST", asked(answer_steer)},
      {"/api/frame", "GET", asked(answer_frame)},
      {"/api/animation", "GET", asked(answer_animation)},
      {"/api/pick", "GET", asked(answer_pick)},
      {"/api/pick_box", "GET", asked(answer_pick_box)},
      {"/api/history", "GET", asked(answer_history)},
      {"/api/file", "GET", asked(answer_file)},
      {"/api/ledger", "GET", plain(answer_ledger)},
      {"/api/model", "GET", plain([](Desk& desk) {
         return make_json_reply(
             make_model_json(*desk.first, desk.workstation.quantity_names(), desk.settable));
       })},
      {"/api/timeline", "GET",
       plain([](Desk& desk) { return make_json_reply(make_timeline_json(desk.workstation.kept_states())); })},
      {"/api/warnings", "GET",
       plain([](Desk& desk) { return make_json_reply(make_warnings_json(desk.workstation.warnings())); })},
      {"/api/files", "GET", plain([](Desk& desk) {
         return make_json_reply(make_files_json(list_run_files(desk.folder, kMostListed)));
       })}};
  return all;
}

const Route* find_route(const std::string& path) {
  for (const Route& route : routes())
    if (path == route.path) return &route;
  return nullptr;
}

/// "/api/node/17" and "/api/node/17/history".
struct NodePath {
  std::string number;
  bool is_history = false;
};

std::optional<NodePath> find_node_path(const std::string& path) {
  const std::string start = "/api/node/", end = "/history";
  if (path.rfind(start, 0) != 0) return std::nullopt;
  NodePath found{path.substr(start.size()), false};
  if (found.number.size() > end.size() && found.number.ends_with(end)) {
    found.is_history = true;
    found.number.resize(found.number.size() - end.size());
  }
  const bool is_one_part = !found.number.empty() && found.number.find('/') == std::string::npos;
  return is_one_part ? std::optional(found) : std::nullopt;
}

ApiReply dispatch(Desk& desk, const std::string& path, const std::string& query_text,
                  const std::string& body) {
  const Query query = Query::parse(query_text);
  if (const Route* route = find_route(path)) return route->answer(desk, query, body);
  const std::optional<NodePath> node_path = find_node_path(path);
  if (!node_path) return make_error_reply(404, "there is nothing at this address");
  const int node = parse_whole("node", node_path->number, 0, static_cast<int>(desk.first->points.size()) - 1);
  return node_path->is_history ? answer_node_history(desk, node, query) : answer_node(desk, node, query);
}

}  // namespace

ApiReply make_json_reply(const Json& json, int status) {
  ApiReply reply;
  reply.status = status;
  reply.body = to_line(json);
  return reply;
}

ApiReply make_error_reply(int status, const std::string& text) {
  return make_json_reply(make_error_json(text), status);
}

std::vector<std::string> with_view_parameters(std::vector<std::string> others) {
  others.insert(others.end(), live_view_parameters().begin(), live_view_parameters().end());
  return others;
}

std::string find_api_method(const std::string& path) {
  if (path == "/api/events" || find_node_path(path)) return "GET";
  const Route* route = find_route(path);
  return route != nullptr ? route->method : "";
}

ApiReply answer_api(Desk& desk, const std::string& path, const std::string& query, const std::string& body) {
  try {
    return dispatch(desk, path, query, body);
  } catch (const InputError& error) {
    return make_error_reply(400, error.what());
  } catch (const EnvironmentError& error) {
    return make_error_reply(503, error.what());
  } catch (const std::exception& error) {
    return make_error_reply(500, std::string("a fault of the program: ") + error.what());
  }
}

}  // namespace hydroscope
