// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "app/results/json.h"
#include "app/server/http_library.h"
#include "app/server/server.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {

/// Holds the stand-in painter, and counts what it painted.
class Gate {
 public:
  void close();
  void open();
  void pass();
  /// Until so many have come to the gate, or a minute.
  bool wait_for(int passes);
  int passes();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_open_ = true;
  int passes_ = 0;
};

/// A painter without a renderer: noise that depends on azimuth and increment.
PicturePainterFactory make_stand_in(std::shared_ptr<Gate> gate);

/// What a client gets.
struct Got {
  int status = 0;  ///< 0: no answer
  std::string body;
  httplib::Headers headers;

  Json json() const { return Json::parse(body); }
  std::string header(const std::string& name) const;
  std::string error() const { return json().at("error").text(); }
};

/// A slice of a tube that is blown into a square die, served to clients of this process.
class ServedScene {
 public:
  /// Empty: the real painter.
  explicit ServedScene(PicturePainterFactory painter, int most_viewers = 64,
                       std::chrono::milliseconds write_patience = std::chrono::seconds(5));

  /// Instead of the present server, if any. Clients find it even when it has ended.
  void serve(const ServerOptions& options);

  /// With the token.
  Got get(const std::string& target) const;
  Got post(const std::string& target, const std::string& body = "") const;
  /// As given.
  Got request(const std::string& method, const std::string& target, const httplib::Headers& headers,
              const std::string& body = "") const;
  /// "Host" and token of a proper client.
  httplib::Headers own_headers() const;
  std::string own_host() const { return "127.0.0.1:" + std::to_string(port_); }
  /// `viewer` steers; the reply's text.
  std::string command(const std::string& text, const std::string& viewer = "a") const;
  WorkstationStatus wait_for(const std::function<bool(const WorkstationStatus&)>& is_met) const;
  /// Until it has ended.
  WorkstationStatus run_to_end() const;
  std::string results() const { return folder / "results"; }

  TemporaryFolder folder;
  std::unique_ptr<Workstation> workstation;
  std::unique_ptr<Server> server;

 private:
  int port_ = 0;
  std::string token_;
};

/// An event stream that somebody reads until told to stop, or until its end.
class EventReader {
 public:
  EventReader(const ServedScene& scene, std::string viewer);
  ~EventReader();
  EventReader(const EventReader&) = delete;
  EventReader& operator=(const EventReader&) = delete;

  /// Whether this came, within a minute.
  bool wait_for(const std::string& text);
  bool wait_for_end();
  void stop();
  std::string text();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string text_;
  bool is_stopped_ = false, has_ended_ = false;
  httplib::Client client_;
  std::thread thread_;
};

/// Bytes on a connection, as they are.
class RawConnection {
 public:
  /// `receive_buffer` > 0: as small as the system allows.
  explicit RawConnection(int port, int receive_buffer = 0);
  ~RawConnection();
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  void send(const std::string& bytes) const;
  /// All that comes until the other side closes, or for a minute without anything.
  std::string read_all() const;
  /// Until the other side has hung up, without reading.
  bool wait_for_hang_up() const;

 private:
  int socket_ = -1;
};

}  // namespace hydroscope::test
