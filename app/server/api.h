// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/server/desk.h"
#include "app/server/query.h"
#include "app/server/run_files.h"

namespace hydroscope {

struct ApiReply {
  int status = 200;  ///< HTTP
  std::string type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
  std::shared_ptr<const OpenFile> file;  ///< instead of the body
};

ApiReply make_json_reply(const Json& json, int status = 200);
ApiReply make_error_reply(int status, const std::string& text);

/// The methods that /api has at `path`: "GET", "POST", or empty when there is nothing.
std::string find_api_method(const std::string& path);

/// Answers everything below /api but the event stream. Never throws: errors are answers of 4xx and 5xx with
/// {"error"}. `path` is decoded, `query` what follows the question mark.
ApiReply answer_api(Desk& desk, const std::string& path, const std::string& query, const std::string& body);

// Its parts. They throw InputError for parameters that are wrong.

ApiReply answer_status(Desk& desk, const Query& query);
ApiReply answer_command(Desk& desk, const Query& query, const std::string& body);
ApiReply answer_steer(Desk& desk, const Query& query);
ApiReply answer_history(Desk& desk, const Query& query);
ApiReply answer_frame(Desk& desk, const Query& query);
ApiReply answer_animation(Desk& desk, const Query& query);
ApiReply answer_pick(Desk& desk, const Query& query);
ApiReply answer_pick_box(Desk& desk, const Query& query);
ApiReply answer_node(Desk& desk, int node, const Query& query);
ApiReply answer_node_history(Desk& desk, int node, const Query& query);
ApiReply answer_ledger(Desk& desk);
ApiReply answer_file(Desk& desk, const Query& query);

/// live_view_parameters() and others.
std::vector<std::string> with_view_parameters(std::vector<std::string> others);

}  // namespace hydroscope
