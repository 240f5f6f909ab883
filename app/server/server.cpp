// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/server.h"

#include <cstdint>
#include <set>

#include "app/server/access.h"
#include "app/server/api.h"
#include "app/server/api_json.h"
#include "app/server/event_stream.h"
#include "app/server/http_server.h"
#include "app/server/page_files.h"
#include "app/server/request_facts.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

using Handling = httplib::Server::HandlerResponse;

const char* const kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";
const char* const kNoToken =
    "This address needs the token that hydroscope serve printed when it started: open the whole address from "
    "its line \"Open http://...\" (each start has a token of its own).";

httplib::Headers make_headers() {
  return {{"Content-Security-Policy", kPolicy},
          {"X-Content-Type-Options", "nosniff"},
          {"X-Frame-Options", "DENY"},
          {"Referrer-Policy", "no-referrer"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Cache-Control", "no-store"}};
}

void send_file(const std::shared_ptr<const OpenFile>& file, const std::string& type,
               httplib::Response& response) {
  response.set_content_provider(file->size(), type,
                                [file](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                  constexpr std::size_t kPiece = 256 * 1024;
                                  const std::string bytes = file->read(offset, std::min(length, kPiece));
                                  return !bytes.empty() && sink.write(bytes.data(), bytes.size());
                                });
}

void send(const ApiReply& reply, httplib::Response& response) {
  response.status = reply.status;
  for (const auto& [name, value] : reply.headers) response.set_header(name, value);
  if (reply.file != nullptr && reply.file->size() > 0)
    send_file(reply.file, reply.type, response);
  else if (reply.status != 204)
    response.set_content(reply.body, reply.type);
}

void send_error(int status, const std::string& text, httplib::Response& response) {
  send(make_error_reply(status, text), response);
}

}  // namespace

struct Server::Impl {
  Impl(Workstation& workstation, const ServerOptions& options)
      : desk(workstation, options.settable, options.painter, options.most_viewers),
        http(options.write_patience) {
    rules.token = make_token();
    shown_host = options.host;
    rules.any_address = options.host == "0.0.0.0" || options.host == "::";
    const bool is_six = options.host.find(':') != std::string::npos;
    if (rules.any_address) shown_host = is_six ? "::1" : "127.0.0.1";
    if (shown_host.find(':') != std::string::npos) shown_host = "[" + shown_host + "]";
    for (const std::string& name : {shown_host, find_own_name()}) rules.hosts.push_back(to_lower_case(name));
    set_routes();
    rules.port = http.open(options.host, options.port);
    http.start();
  }
  ~Impl() {
    desk.close();
    http.finish();
  }

  static std::string find_own_name();
  static std::string to_lower_case(std::string text);
  void set_routes();
  bool handle(const httplib::Request& request, httplib::Response& response);
  void send_page(const RequestFacts& facts, const RequestTarget& target, httplib::Response& response) const;
  void send_events(const RequestTarget& target, httplib::Response& response);

  AccessRules rules;
  std::string shown_host;
  Desk desk;
  HttpServer http;
};

std::string Server::Impl::find_own_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "localhost";
}

std::string Server::Impl::to_lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

void Server::Impl::set_routes() {
  http.set_default_headers(make_headers());
  // Before the library looks for patterns and reads a body.
  http.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    if (request.has_header("Content-Length") || request.has_header("Transfer-Encoding"))
      response.set_header("Connection", "close");
    return handle(request, response) ? Handling::Handled : Handling::Unhandled;
  });
  const auto post = [this](const httplib::Request& request, httplib::Response& response) {
    const RequestTarget target = split_target(request.target);
    send(answer_api(desk, target.path, target.query, request.body), response);
  };
  http.Post("/api/command", post);
  http.Post("/api/steer", post);
  http.set_exception_handler([](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
    send_error(500, "a fault of the program", response);
  });
  http.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    static const std::set<int> kLast = {400, 401, 403, 413, 414, 421};  // nothing good will follow
    if (kLast.count(response.status) > 0) HttpServer::end_connection(response);
    if (!response.body.empty()) return;
    send_error(response.status,
               response.status == 413 ? "the request is too large" : "the request is malformed", response);
  });
}

/// False where the body has to be read first.
bool Server::Impl::handle(const httplib::Request& request, httplib::Response& response) {
  RequestTarget target;
  try {
    target = split_target(request.target);
  } catch (const InputError& error) {
    send_error(400, error.what(), response);
    return true;
  }
  const RequestFacts facts = make_facts(request, target);
  const bool is_api = target.path.rfind("/api/", 0) == 0;
  const std::string method = is_api ? find_api_method(target.path) : "GET";
  if (const std::optional<Refusal> refusal = check_place(rules, facts)) {
    refuse(*refusal, facts.is_page, response);
  } else if (!has_token(rules, facts)) {
    refuse({401, kNoToken}, facts.is_page, response);
  } else if (method.empty()) {
    send_error(404, "there is nothing at this address", response);
  } else if (request.method != method && (is_api || request.method != "HEAD")) {
    response.set_header("Allow", method);
    send_error(405, "this address takes " + method + " only", response);
  } else if (request.get_header_value<std::uint64_t>("Content-Length") > HttpServer::kMostBody) {
    send_error(413, "the request is too large", response);  // not waited for
  } else if (method == "POST") {
    return false;
  } else if (!is_api) {
    send_page(facts, target, response);
  } else if (target.path == "/api/events") {
    send_events(target, response);
  } else {
    send(answer_api(desk, target.path, target.query, ""), response);
  }
  return true;
}

void Server::Impl::send_page(const RequestFacts& facts, const RequestTarget& target,
                             httplib::Response& response) const {
  if (facts.url_token) {
    response.status = 303;
    response.set_header("Location", "/");
    if (is_equal_secret(*facts.url_token, rules.token))
      response.set_header(
          "Set-Cookie", cookie_name(rules.port) + "=" + rules.token + "; Path=/; HttpOnly; SameSite=Strict");
    return;
  }
  const std::string start = "/page/";
  const bool is_below = target.path.rfind(start, 0) == 0;
  const std::string name =
      target.path == "/" ? "index.html" : (is_below ? target.path.substr(start.size()) : std::string());
  const PageFile* file = find_page_file(name);
  if (file == nullptr) return send_error(404, "there is nothing at this address", response);
  response.status = 200;
  response.set_content(std::string(file->bytes), find_page_type(file->name));
}

void Server::Impl::send_events(const RequestTarget& target, httplib::Response& response) {
  std::string viewer;
  try {
    const Query query = Query::parse(target.query);
    query.allow({"viewer"});
    viewer = query.need_id("viewer");
  } catch (const InputError& error) {
    return send_error(400, error.what(), response);
  }
  if (!desk.viewers.enter(viewer, Viewers::Time::clock::now()))
    return send_error(503, "there are " + std::to_string(desk.viewers.most()) + " viewers already", response);
  const auto stream = std::make_shared<EventStream>(desk, viewer);
  response.status = 200;
  response.set_chunked_content_provider(
      "text/event-stream", [stream](std::size_t, httplib::DataSink& sink) { return stream->go_on(sink); });
}

Server::Server(Workstation& workstation, const ServerOptions& options)
    : impl_(std::make_unique<Impl>(workstation, options)) {}

Server::~Server() = default;

int Server::port() const { return impl_->rules.port; }

const std::string& Server::token() const { return impl_->rules.token; }

std::string Server::url() const {
  return "http://" + impl_->shown_host + ":" + std::to_string(port()) + "/?token=" + token();
}

void check_address(const std::string& host, int port) {
  HttpServer(std::chrono::seconds(1)).open(host, port);
}

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host.rfind("127.", 0) == 0;
}

}  // namespace hydroscope
