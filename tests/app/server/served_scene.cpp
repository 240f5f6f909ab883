// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/server/served_scene.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>

#include "solver/scene/scene_reader.h"
#include "solver/session/scene_change.h"

namespace hydroscope::test {
namespace {

constexpr std::chrono::seconds kPatience{60};  // far more than is ever needed; only a failure waits for it

constexpr const char* kScene = R"(
title = "Slice in a square die"
[tube]
outer_radius_mm = 20.0
thickness_mm = 1.0
length_mm = 1.0
section = "octant"
extent = "slice"
elements_around = 8
[material]
youngs_modulus_MPa = 206e3
hardening = "swift"
swift_K_MPa = 500.0
swift_eps0 = 0.004
swift_n = 0.2
[load]
pressure_MPa = [[0.0, 0.0], [1.0, 25.0]]
[increment]
largest = 0.02
[states]
number = 5
[tool.die]
shape = "box"
half_width_mm = 20.5
half_height_mm = 20.5
corner_radius_mm = 6.0
friction = 0.05
[quantity.t_corner_mm]
kind = "thickness"
angle_deg = 45
)";

class StandIn : public PicturePainter {
 public:
  explicit StandIn(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {}

  std::string renderer() const override { return "stand-in"; }
  PaintedFrame paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot) override {
    gate_->pass();
    PaintedFrame painted;
    painted.image = make_image(view.width, view.height, {0, 0, 0});
    // Numerical Recipes' quick generator: noise does not compress.
    auto number = static_cast<std::uint32_t>(static_cast<int>(view.azimuth) + 1000 * snapshot->increment);
    for (std::uint8_t& value : painted.image.rgba) {
      number = 1664525U * number + 1013904223U;
      value = static_cast<std::uint8_t>(number >> 24U);
    }
    painted.range = Range{1.0, 2.5};
    return painted;
  }

 private:
  std::shared_ptr<Gate> gate_;
};

}  // namespace

void Gate::close() {
  const std::lock_guard lock(mutex_);
  is_open_ = false;
}

void Gate::open() {
  const std::lock_guard lock(mutex_);
  is_open_ = true;
  changed_.notify_all();
}

void Gate::pass() {
  std::unique_lock lock(mutex_);
  ++passes_;
  changed_.notify_all();
  changed_.wait_for(lock, kPatience, [this] { return is_open_; });
}

bool Gate::wait_for(int passes) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, kPatience, [&] { return passes_ >= passes; });
}

int Gate::passes() {
  const std::lock_guard lock(mutex_);
  return passes_;
}

PicturePainterFactory make_stand_in(std::shared_ptr<Gate> gate) {
  return [gate = std::move(gate)] { return std::make_unique<StandIn>(gate); };
}

std::string Got::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string() : found->second;
}

ServedScene::ServedScene(PicturePainterFactory painter, int most_viewers,
                         std::chrono::milliseconds write_patience) {
  std::ofstream(folder / "scene.toml") << kScene;
  const Scene scene = read_scene(folder / "scene.toml", {});
  WorkstationOptions options;
  options.threads = 1;
  options.output = results();
  workstation = std::make_unique<Workstation>(scene, options);
  ServerOptions server_options;
  server_options.settable = settable_keys(scene);
  server_options.painter = std::move(painter);
  server_options.most_viewers = most_viewers;
  server_options.write_patience = write_patience;
  serve(server_options);
}

void ServedScene::serve(const ServerOptions& options) {
  server.reset();
  server = std::make_unique<Server>(*workstation, options);
  port_ = server->port();
  token_ = server->token();
}

httplib::Headers ServedScene::own_headers() const {
  return {{"Host", own_host()}, {"Authorization", "Bearer " + token_}};
}

Got ServedScene::request(const std::string& method, const std::string& target,
                         const httplib::Headers& headers, const std::string& body) const {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(kPatience);
  client.set_url_encode(false);
  httplib::Request request;
  request.method = method;
  request.path = target;
  request.headers = headers;
  request.body = body;
  const httplib::Result result = client.send(request);
  if (!result) return {};
  return {result->status, result->body, result->headers};
}

Got ServedScene::get(const std::string& target) const { return request("GET", target, own_headers()); }

Got ServedScene::post(const std::string& target, const std::string& body) const {
  return request("POST", target, own_headers(), body);
}

std::string ServedScene::command(const std::string& text, const std::string& viewer) const {
  const Got got = post("/api/command?viewer=" + viewer, text);
  return got.status == 200 ? got.json().at("text").text() : "refused: " + got.body;
}

WorkstationStatus ServedScene::wait_for(const std::function<bool(const WorkstationStatus&)>& is_met) const {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  WorkstationStatus status = workstation->status();
  while (!is_met(status) && std::chrono::steady_clock::now() < end)
    status = workstation->wait_status(status.version, std::chrono::seconds(1));
  return status;
}

WorkstationStatus ServedScene::run_to_end() const {
  command("run");
  return wait_for([](const WorkstationStatus& s) { return s.phase == WorkstationStatus::Phase::kEnded; });
}

EventReader::EventReader(const ServedScene& scene, std::string viewer)
    : client_("127.0.0.1", scene.server->port()) {
  client_.set_read_timeout(kPatience);
  thread_ = std::thread([this, headers = scene.own_headers(), target = "/api/events?viewer=" + viewer] {
    client_.Get(target, headers, [this](const char* bytes, std::size_t size) {
      const std::lock_guard lock(mutex_);
      text_.append(bytes, size);
      changed_.notify_all();
      return !is_stopped_;
    });
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    changed_.notify_all();
  });
}

EventReader::~EventReader() { stop(); }

bool EventReader::wait_for(const std::string& text) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, kPatience, [&] { return text_.find(text) != std::string::npos; });
}

bool EventReader::wait_for_end() {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, kPatience, [&] { return has_ended_; });
}

void EventReader::stop() {
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  client_.stop();
  if (thread_.joinable()) thread_.join();
}

std::string EventReader::text() {
  const std::lock_guard lock(mutex_);
  return text_;
}

RawConnection::RawConnection(int port, int receive_buffer) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
  if (receive_buffer > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    close(socket_);
    socket_ = -1;
  }
}

RawConnection::~RawConnection() { close(socket_); }

void RawConnection::send(const std::string& bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t sent = ::send(socket_, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (sent <= 0) return;  // the other side has had enough
    done += static_cast<std::size_t>(sent);
  }
}

std::string RawConnection::read_all() const {
  std::string bytes;
  std::array<char, 4096> buffer{};
  pollfd entry{socket_, POLLIN, 0};
  while (poll(&entry, 1, 60'000) > 0) {
    const ssize_t got = recv(socket_, buffer.data(), buffer.size(), 0);
    if (got <= 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return bytes;
}

bool RawConnection::wait_for_hang_up() const {
  pollfd entry{socket_, POLLRDHUP, 0};
  return poll(&entry, 1, 60'000) > 0;
}

}  // namespace hydroscope::test
