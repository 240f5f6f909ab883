// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/api.h"
#include "app/server/api_json.h"

namespace hydroscope {
namespace {

constexpr std::size_t kMostCommand = 64 * 1024;
constexpr const char* kOnlyLooked =
    "these are results on disk: they can be looked at, not steered (serve the scene to go on)";

Viewers::Time now() { return Viewers::Time::clock::now(); }

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r\n");
  if (from == std::string::npos) return "";
  return text.substr(from, text.find_last_not_of(" \t\r\n") - from + 1);
}

ApiReply refuse_second(const std::string& what) {
  return make_error_reply(409, "another viewer steers; " + what);
}

}  // namespace

ApiReply answer_status(Desk& desk, const Query& query) {
  query.allow({"viewer"});
  const std::string viewer = query.has("viewer") ? query.need_id("viewer") : "";
  return make_json_reply(desk.make_status(desk.workstation.status(), viewer));
}

ApiReply answer_command(Desk& desk, const Query& query, const std::string& body) {
  query.allow({"viewer"});
  const std::string viewer = query.need_id("viewer");
  if (body.size() > kMostCommand) return make_error_reply(413, "a command has at most 64 kB");
  const std::string text = trimmed(body);
  if (text.empty()) return make_error_reply(400, "the request has no command in its body");
  if (!desk.workstation.status().can_steer) return make_error_reply(409, kOnlyLooked);
  if (!desk.viewers.may_steer(viewer, now())) return refuse_second("take the wheel first");
  desk.news.touch();
  const CommandReply reply = desk.workstation.command(text, viewer);
  Json::Object members = make_reply_json(reply).members();
  if (!reply.is_done) members.emplace_back("error", reply.text);
  return make_json_reply(members, reply.is_done ? 200 : 400);
}

ApiReply answer_steer(Desk& desk, const Query& query) {
  query.allow({"viewer", "take", "force"});
  const std::string viewer = query.need_id("viewer");
  query.need("take");
  const bool is_taken = query.flag("take", true), by_force = query.flag("force", false);
  if (is_taken && !desk.viewers.take(viewer, by_force, now()))
    return refuse_second("ask for the wheel, or take it with force=1");
  if (!is_taken) desk.viewers.give(viewer);
  desk.news.touch();
  return make_json_reply(desk.make_status(desk.workstation.status(), viewer));
}

ApiReply answer_history(Desk& desk, const Query& query) {
  query.allow({"viewer", "from"});
  const int from = query.whole("from", 0, 1'000'000'000, 0);
  return make_json_reply(
      make_history_json(desk.workstation.history(from), desk.workstation.quantity_names()));
}

ApiReply answer_file(Desk& desk, const Query& query) {
  query.allow({"viewer", "name"});
  const std::string name = query.need("name");
  ApiReply reply;
  try {
    reply.file = std::make_shared<const OpenFile>(open_run_file(desk.folder, name));
  } catch (const std::exception& error) {
    return make_error_reply(404, error.what());
  }
  reply.type = find_media_type(name);
  return reply;
}

}  // namespace hydroscope
