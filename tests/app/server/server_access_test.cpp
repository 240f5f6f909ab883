// SPDX-License-Identifier: GPL-3.0-or-later
// Who is let in, and what becomes of requests that nobody should send. A stand-in paints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "tests/app/server/served_scene.h"

namespace hydroscope::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

/// One server for all of these: none of them changes anything.
class ServerAccess : public testing::Test {
 protected:
  static void SetUpTestSuite() { scene_ = new ServedScene(make_stand_in(std::make_shared<Gate>())); }
  static void TearDownTestSuite() {
    delete scene_;
    scene_ = nullptr;
  }
  httplib::Headers headers(const std::string& name, const std::string& value) const {
    httplib::Headers all = scene_->own_headers();
    all.erase(name);
    all.emplace(name, value);
    return all;
  }
  int status_with(const std::string& name, const std::string& value) const {
    return scene_->request("GET", "/api/status", headers(name, value)).status;
  }
  static ServedScene* scene_;
};
ServedScene* ServerAccess::scene_ = nullptr;

TEST_F(ServerAccess, NothingWithoutTheToken) {
  const httplib::Headers bare = {{"Host", scene_->own_host()}};
  for (const char* target :
       {"/", "/page/main.js", "/api/status", "/api/frame?viewer=a", "/api/events?viewer=a", "/api/files",
        "/nowhere", "/?token=", "/?token=0", "/api/status?token=0"}) {
    const Got got = scene_->request("GET", target, bare);
    EXPECT_EQ(got.status, 401) << target;
    EXPECT_THAT(got.body, HasSubstr("token")) << target;
  }
  EXPECT_EQ(scene_->request("POST", "/api/command?viewer=a", bare, "run").status, 401);
  EXPECT_EQ(status_with("Authorization", "Bearer " + std::string(40, '0')), 401);
  // In the address it is for the page alone: addresses end up in logs.
  EXPECT_EQ(scene_->request("GET", "/api/status?token=" + scene_->server->token(), bare).status, 401);
}

TEST_F(ServerAccess, TheAddressThatIsPrintedSetsACookieThatOpensEverything) {
  const std::string token = scene_->server->token();
  EXPECT_EQ(scene_->server->url(), "http://" + scene_->own_host() + "/?token=" + token);
  const Got entry = scene_->request("GET", "/?token=" + token, {{"Host", scene_->own_host()}});
  EXPECT_EQ(entry.status, 303);
  EXPECT_EQ(entry.header("Location"), "/");
  const std::string cookie = entry.header("Set-Cookie");
  EXPECT_THAT(cookie, StartsWith("hydroscope_" + std::to_string(scene_->server->port()) + "="));
  EXPECT_THAT(cookie, HasSubstr("HttpOnly"));
  EXPECT_THAT(cookie, HasSubstr("SameSite=Strict"));
  const httplib::Headers with_cookie = {{"Host", scene_->own_host()},
                                        {"Cookie", cookie.substr(0, cookie.find(';'))}};
  const Got page = scene_->request("GET", "/", with_cookie);
  EXPECT_EQ(page.status, 200);
  EXPECT_THAT(page.body, HasSubstr("<html"));
  EXPECT_THAT(page.header("Content-Security-Policy"), HasSubstr("frame-ancestors 'none'"));
  EXPECT_EQ(page.header("X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(page.header("Cache-Control"), "no-store");
  const Got script = scene_->request("GET", "/page/main.js", with_cookie);
  EXPECT_EQ(script.status, 200);
  EXPECT_THAT(script.header("Content-Type"), StartsWith("text/javascript"));
}

TEST_F(ServerAccess, ForeignHostsAndOriginsAreRefused) {
  const std::string port = std::to_string(scene_->server->port());
  EXPECT_EQ(status_with("Host", "localhost:" + port), 200);
  EXPECT_EQ(status_with("Host", "evil.example:" + port), 421);
  EXPECT_EQ(status_with("Host", "127.0.0.1:1"), 421);
  EXPECT_EQ(status_with("Origin", "http://" + scene_->own_host()), 200);
  EXPECT_EQ(status_with("Origin", "http://evil.example"), 403);
  EXPECT_EQ(status_with("Origin", "null"), 403);
  EXPECT_EQ(status_with("Sec-Fetch-Site", "cross-site"), 403);
  EXPECT_EQ(scene_->request("POST", "/api/command?viewer=a", headers("Origin", "http://evil.example"), "run")
                .status,
            403);
  EXPECT_EQ(scene_->workstation->status().phase, WorkstationStatus::Phase::kPaused);
}

TEST_F(ServerAccess, UnknownAddressesAndMethods) {
  for (const char* target :
       {"/nowhere", "/api", "/api/", "/api/nothing", "/api/node/", "/api/node/1/2", "/page/", "/page/none.js",
        "/index.html", "/page/../server.cpp", "/page/%2e%2e%2fserver.cpp", "/page/..%2f..%2fserver.cpp",
        "//etc/passwd", "/../../etc/passwd"})
    EXPECT_EQ(scene_->get(target).status, 404) << target;
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE"})
    EXPECT_EQ(scene_->request(method, "/api/status", scene_->own_headers()).status, 405) << method;
  const Got refused = scene_->get("/api/command?viewer=a");
  EXPECT_EQ(refused.status, 405);
  EXPECT_EQ(refused.header("Allow"), "POST");
}

TEST_F(ServerAccess, NoFileOutsideOfTheRunFolder) {
  EXPECT_EQ(scene_->get("/api/file?name=scene.toml").status, 200);
  std::filesystem::create_symlink("/etc/passwd", scene_->results() + "/link");
  for (const char* name : {"../scene.toml", "..%2Fscene.toml", "%2e%2e/scene.toml", "..%252Fscene.toml",
                           "/etc/passwd", "states/../../scene.toml", "link", ".", "states", "./scene.toml"})
    EXPECT_EQ(scene_->get(std::string("/api/file?name=") + name).status, 404) << name;
  EXPECT_EQ(scene_->get("/api/file?name=scene.toml%00.png").status, 400);
  EXPECT_THAT(scene_->get("/api/files").body, testing::Not(HasSubstr("\"link\"")));
}

TEST_F(ServerAccess, ParametersAreReadStrictly) {
  const std::string frame = "/api/frame?viewer=a&";
  for (const std::string& target : {frame + "zoon=2",
                                    frame + "az=north",
                                    frame + "w=1e9",
                                    frame + "w=10",
                                    frame + "view=none",
                                    frame + "state=7",
                                    frame + "state=0.0&after=1",
                                    frame + "q=0",
                                    frame + "format=bmp",
                                    frame + "az=1&az=2",
                                    frame + "lo=3&hi=2",
                                    frame + "marked=a",
                                    frame + "az=%",
                                    std::string("/api/frame"),
                                    std::string("/api/frame?viewer=a%20b"),
                                    std::string("/api/node/x"),
                                    std::string("/api/node/100000"),
                                    std::string("/api/node/-1"),
                                    std::string("/api/history?from=-1"),
                                    std::string("/api/status?x=1"),
                                    std::string("/api/events"),
                                    std::string("/api/pick?viewer=a&x=1"),
                                    std::string("/api/file")}) {
    const Got got = scene_->get(target);
    EXPECT_EQ(got.status, 400) << target;
    EXPECT_NE(got.error(), "") << target;
  }
  EXPECT_THAT(scene_->get(frame + "zoon=2").error(), HasSubstr("did you mean 'zoom'"));
  EXPECT_EQ(scene_->get(frame + "state=0.77").status, 404);
  EXPECT_EQ(scene_->post("/api/steer?viewer=a").status, 400);
  EXPECT_EQ(scene_->post("/api/command?viewer=a", "").status, 400);
}

TEST_F(ServerAccess, OversizeRequestsAreRefused) {
  EXPECT_EQ(scene_->post("/api/command?viewer=a", std::string(65 * 1024, 'x')).status, 413);
  EXPECT_EQ(scene_->get("/api/status?viewer=" + std::string(10'000, 'a')).status, 414);
  EXPECT_EQ(scene_->get("/" + std::string(2'000, 'a')).status, 400);
  EXPECT_EQ(status_with("X-Long", std::string(10'000, 'a')), 400);
  EXPECT_EQ(scene_->get("/api/status").status, 200);
}

TEST_F(ServerAccess, AHeadWithoutEndIsCutOff) {
  const RawConnection connection(scene_->server->port());
  connection.send("GET /api/status HTTP/1.1\r\n");
  const std::string line = "X-Filler: " + std::string(1000, 'a') + "\r\n";
  for (int i = 0; i < 400; ++i) connection.send(line);
  EXPECT_THAT(connection.read_all(), AnyOf(StartsWith("HTTP/1.1 400"), ""));
  EXPECT_EQ(scene_->get("/api/status").status, 200);
}

TEST_F(ServerAccess, AnEndlessBodyInPiecesIsCutOff) {
  const RawConnection connection(scene_->server->port());
  connection.send("POST /api/command?viewer=a HTTP/1.1\r\nHost: " + scene_->own_host() +
                  "\r\nAuthorization: Bearer " + scene_->server->token() +
                  "\r\nTransfer-Encoding: chunked\r\n\r\n");
  const std::string piece = "1000\r\n" + std::string(0x1000, 'a') + "\r\n";
  for (int i = 0; i < 100; ++i) connection.send(piece);
  EXPECT_THAT(connection.read_all(), testing::Not(HasSubstr(" 200 ")));
  EXPECT_EQ(scene_->get("/api/status").status, 200);
}

TEST_F(ServerAccess, MalformedRequestsAreAnsweredAndHarmNobody) {
  const std::string host = "Host: " + scene_->own_host() + "\r\n";
  for (const std::string& bytes :
       {std::string("\r\n\r\n"), std::string("nonsense\r\n\r\n"), std::string("GET\r\n\r\n"),
        std::string("GET / HTTP/9.9\r\n\r\n"), std::string("FETCH / HTTP/1.1\r\n") + host + "\r\n",
        std::string("GET http://[::1/ HTTP/1.1\r\n") + host + "\r\n", std::string("GET / HTTP/1.1\r\n\r\n"),
        "GET / HTTP/1.1\r\n" + host + host + "\r\n", std::string("\0\x01\x02\xff\xfe garbage \r\n\r\n", 20),
        "POST /api/command?viewer=a HTTP/1.1\r\n" + host + "Authorization: Bearer " +
            scene_->server->token() + "\r\nContent-Length: 99999999999999999999\r\n\r\nrun"}) {
    const RawConnection connection(scene_->server->port());
    connection.send(bytes);
    EXPECT_THAT(connection.read_all(), StartsWith("HTTP/1.1 4")) << bytes;
  }
  EXPECT_EQ(scene_->get("/api/status").status, 200);
  EXPECT_EQ(scene_->workstation->status().phase, WorkstationStatus::Phase::kPaused);
}

TEST_F(ServerAccess, WhatARefusedRequestCarriesIsNotReadAsTheNextOne) {
  const std::string hidden = "POST /api/command?viewer=a HTTP/1.1\r\nHost: " + scene_->own_host() +
                             "\r\nAuthorization: Bearer " + scene_->server->token() +
                             "\r\nContent-Length: 3\r\n\r\nrun";
  const RawConnection connection(scene_->server->port());
  connection.send("POST /api/command?viewer=a HTTP/1.1\r\nHost: evil.example\r\nContent-Length: " +
                  std::to_string(hidden.size()) + "\r\n\r\n" + hidden);
  const std::string answers = connection.read_all();
  EXPECT_THAT(answers, StartsWith("HTTP/1.1 421"));
  EXPECT_EQ(answers.find("HTTP/1.1", 1), std::string::npos);
  EXPECT_EQ(scene_->workstation->status().phase, WorkstationStatus::Phase::kPaused);
}

TEST_F(ServerAccess, APortIsHadOnce) {
  ServerOptions options;
  options.port = scene_->server->port();
  options.painter = make_stand_in(std::make_shared<Gate>());
  try {
    const Server second(*scene_->workstation, options);
    FAIL() << "two servers at one port";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr(std::to_string(options.port)));
  }
}

}  // namespace
}  // namespace hydroscope::test
