// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/api.h"
#include "app/server/api_json.h"
#include "app/server/node_values.h"
#include "render/live/pick.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr double kFarPixel = 1e5;

/// A state that a request asks for, with the branch it belongs to.
struct AskedState {
  std::shared_ptr<const Snapshot> snapshot;
  int branch = 0;
};

AskedState find_asked(const Desk& desk, const Query& query) {
  const std::optional<StateKey> key = read_state_key(query, "state");
  AskedState asked{desk.find_state(key), key ? key->branch : desk.workstation.status().branch};
  return asked;
}

ApiReply make_missing(const Query& query) {
  return make_error_reply(404, "state " + query.text("state", "live") + " was not kept (see /api/timeline)");
}

/// What the page sends with every request for a picture is not looked at here.
std::vector<std::string> pick_parameters(std::vector<std::string> corners) {
  for (const char* name : {"viewer", "slot", "state", "after", "q"}) corners.emplace_back(name);
  return with_view_parameters(std::move(corners));
}

double read_pixel(const Query& query, const std::string& name) {
  query.need(name);
  return query.number(name, -kFarPixel, kFarPixel, 0.0);
}

}  // namespace

ApiReply answer_pick(Desk& desk, const Query& query) {
  query.allow(pick_parameters({"x", "y"}));
  const LiveView view = make_live_view(query);
  const double x = read_pixel(query, "x"), y = read_pixel(query, "y");
  const AskedState asked = find_asked(desk, query);
  if (asked.snapshot == nullptr) return make_missing(query);
  const std::optional<Pick> pick = pick_point(view, *desk.first, *asked.snapshot, x, y);
  if (!pick || pick->node < 0) return make_json_reply(Json::Object{{"node", Json()}});
  Json::Object record = make_node_record(*asked.snapshot, *desk.first, pick->node, asked.branch);
  const Json element = make_element_record(*asked.snapshot, pick->element);
  record.insert(record.begin() + 1, {{"element", pick->element},
                                     {"place", make_vector_json(pick->place)},
                                     {"image", pick->image},
                                     {"element_values", element}});
  return make_json_reply(record);
}

ApiReply answer_pick_box(Desk& desk, const Query& query) {
  query.allow(pick_parameters({"x0", "y0", "x1", "y1"}));
  const LiveView view = make_live_view(query);
  const double x0 = read_pixel(query, "x0"), y0 = read_pixel(query, "y0");
  const double x1 = read_pixel(query, "x1"), y1 = read_pixel(query, "y1");
  const AskedState asked = find_asked(desk, query);
  if (asked.snapshot == nullptr) return make_missing(query);
  const std::vector<int> nodes = pick_rectangle(view, *desk.first, *asked.snapshot, x0, y0, x1, y1);
  Json::Array names;
  for (const int node : nodes) names.emplace_back(node);
  return make_json_reply(Json::Object{{"branch", asked.branch},
                                      {"increment", asked.snapshot->increment},
                                      {"nodes", std::move(names)},
                                      {"summary", make_nodes_summary(*asked.snapshot, nodes)}});
}

ApiReply answer_node(Desk& desk, int node, const Query& query) {
  query.allow({"viewer", "state"});
  const AskedState asked = find_asked(desk, query);
  if (asked.snapshot == nullptr) return make_missing(query);
  return make_json_reply(make_node_record(*asked.snapshot, *desk.first, node, asked.branch));
}

ApiReply answer_node_history(Desk& desk, int node, const Query& query) {
  query.allow({"viewer"});
  NodeHistory history(node);
  for (const StateKey& key : desk.list_line(desk.workstation.status().branch)) {
    const auto snapshot = desk.find_state(key);
    if (snapshot != nullptr) history.add(*snapshot);
  }
  return make_json_reply(history.make_json());
}

ApiReply answer_ledger(Desk& desk) {
  const WorkstationStatus status = desk.workstation.status();
  const auto text = desk.ledger.get(desk.workstation.folder(), {status.branch, status.increment},
                                    status.phase == WorkstationStatus::Phase::kRunning);
  ApiReply reply;
  reply.body = *text;
  return reply;
}

}  // namespace hydroscope
