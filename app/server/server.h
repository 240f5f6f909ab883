// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/server/frame_service.h"
#include "app/workstation/workstation.h"

namespace hydroscope {

struct ServerOptions {
  std::string host = "127.0.0.1";     ///< address to listen at
  int port = 0;                       ///< 0: any free one
  std::vector<std::string> settable;  ///< keys that `set` may change
  PicturePainterFactory painter;      ///< empty: make_live_painter(); another one for tests
  int most_viewers = 64;
  std::chrono::milliseconds write_patience{5000};  ///< who reads nothing for so long is dropped
};

/// Shows and steers a workstation over HTTP (docs/workstation_api.md). Answers on threads of its own from its
/// making to its end; the workstation lives longer.
class Server {
 public:
  /// Throws EnvironmentError when the port cannot be had or the renderer does not work.
  Server(Workstation& workstation, const ServerOptions& options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const;
  const std::string& token() const;
  /// With the token; for the user alone.
  std::string url() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Throws EnvironmentError when a server could not listen there now: to be asked before anything is written.
void check_address(const std::string& host, int port);

/// Whether only this machine can reach it: 127.x.x.x, ::1 or localhost.
bool is_loopback(const std::string& host);

}  // namespace hydroscope
