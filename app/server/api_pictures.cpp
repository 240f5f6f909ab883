// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>

#include "app/server/api.h"
#include "app/server/api_json.h"
#include "render/image/jpeg_file.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr std::chrono::seconds kWatchPatience{20};  ///< for something new
constexpr std::chrono::seconds kDrawPatience{60};   ///< for a picture that can be drawn

std::string to_text(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// "N" of any branch, or "B.N".
std::optional<StateKey> read_after(const Query& query) {
  if (!query.has("after")) return std::nullopt;
  const std::string text = query.text("after");
  if (text.find('.') != std::string::npos) return read_state_key(query, "after");
  return StateKey{kAnyBranch, parse_whole("after", text, -1, 1'000'000'000)};
}

void add_headers(const FrameAnswer& answer, ApiReply& reply) {
  reply.headers = {{"X-Branch", std::to_string(answer.state.branch)},
                   {"X-Increment", std::to_string(answer.state.increment)},
                   {"X-Time", to_text(answer.snapshot->time)},
                   {"X-Pressure", to_text(answer.snapshot->pressure)},
                   {"X-Draw-Ms", to_text(answer.draw_ms)}};
  if (answer.range)
    reply.headers.emplace_back("X-Range", to_text(answer.range->low) + "," + to_text(answer.range->high));
}

ApiReply make_no_picture(const FrameAnswer& answer) {
  switch (answer.kind) {
    case FrameAnswer::Kind::kStopped:
      return make_error_reply(503, "the program ends");
    case FrameAnswer::Kind::kBusy:
      return make_error_reply(503, "too many pictures are waited for");
    case FrameAnswer::Kind::kFailed:
      return make_error_reply(answer.is_view_at_fault ? 400 : 500, answer.error);
    case FrameAnswer::Kind::kDrawn:
    case FrameAnswer::Kind::kReplaced:
    case FrameAnswer::Kind::kNothingNew:
      break;
  }
  ApiReply reply;
  reply.status = 204;
  return reply;
}

/// On the thread of the request: the render thread goes on with the next picture.
void encode(const Query& query, const std::string& view, const FrameAnswer& answer, ApiReply& reply) {
  const std::string format = query.choice("format", {"jpeg", "png"}, "jpeg");
  if (format == "png") {
    reply.type = "image/png";
    reply.body = make_png(*answer.image, {}, PngSize::kFast);
  } else {
    reply.type = "image/jpeg";
    reply.body = make_jpeg(*answer.image, query.whole("q", 1, 100, 85));
  }
  if (query.flag("download", false))
    reply.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + view + "-" +
                                                          std::to_string(answer.state.increment) + "." +
                                                          (format == "png" ? "png" : "jpg") + "\"");
}

FrameOrder make_order(Desk& desk, const Query& query) {
  FrameOrder order;
  order.viewer = query.need_id("viewer");
  order.slot = query.has("slot") ? query.need_id("slot") : "a";
  order.view = make_live_view(query);
  order.after = read_after(query);
  const std::optional<StateKey> key = read_state_key(query, "state");
  if (key && order.after) throw InputError("parameter 'after': only with state=live");
  if (order.after) order.kind = FrameOrder::Kind::kWatch;
  if (key) {
    order.snapshot = desk.find_state(key);
    order.state = *key;
  }
  return order;
}

std::string make_missing_text(const Query& query) {
  return "state " + query.text("state") + " was not kept (see /api/timeline)";
}

}  // namespace

ApiReply answer_frame(Desk& desk, const Query& query) {
  query.allow(with_view_parameters({"viewer", "slot", "state", "after", "q", "format", "download"}));
  query.choice("format", {"jpeg", "png"}, "jpeg");
  query.whole("q", 1, 100, 85);
  query.flag("download", false);
  FrameOrder order = make_order(desk, query);
  if (query.text("state", "live") != "live" && order.snapshot == nullptr)
    return make_error_reply(404, make_missing_text(query));
  const std::string view = order.view.view;
  const FrameAnswer answer =
      desk.frames.draw(std::move(order), query.has("after") ? kWatchPatience : kDrawPatience);
  if (answer.kind != FrameAnswer::Kind::kDrawn) return make_no_picture(answer);
  ApiReply reply;
  add_headers(answer, reply);
  encode(query, view, answer, reply);
  return reply;
}

ApiReply answer_animation(Desk& desk, const Query& query) {
  query.allow(with_view_parameters({"viewer", "slot", "state", "after", "q", "format", "fps"}));
  FilmOrder order;
  order.view = make_live_view(query);
  order.kind = query.choice("format", {"webp", "mp4"}, "webp");
  order.frames_per_second = query.number("fps", 0.5, 60.0, 10.0);
  const int branch = desk.workstation.status().branch;
  order.states = desk.list_line(branch);
  order.key = query.need_id("viewer") + " " + std::to_string(branch);
  for (const std::string& name : with_view_parameters({"format", "fps"}))
    if (query.has(name)) order.key += "&" + name + "=" + query.text(name);
  const FilmProgress progress = desk.films.ask(order);
  if (!progress.error.empty()) return make_error_reply(500, progress.error);
  if (progress.film == nullptr)
    return make_json_reply(Json::Object{{"done", progress.done}, {"of", progress.of}}, 202);
  ApiReply reply;
  reply.type = order.kind == "webp" ? "image/webp" : "video/mp4";
  reply.body = *progress.film;
  reply.headers.emplace_back("Content-Disposition",
                             "attachment; filename=\"" + order.view.view + "." + order.kind + "\"");
  return reply;
}

}  // namespace hydroscope
