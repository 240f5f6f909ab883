// SPDX-License-Identifier: GPL-3.0-or-later
// Who may include whom: docs/decisions/0001-rooms-and-contracts.md. Tests run in the top folder.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace hydroscope::test {
namespace {

namespace fs = std::filesystem;

struct Source {
  std::string file, room;
  std::vector<std::string> includes;
};

std::string find_room(const std::string& path) {
  static const std::regex pattern("(solver/[a-z]+|render|app)/.*");
  std::smatch match;
  return std::regex_match(path, match, pattern) ? match[1].str() : "";
}

std::vector<Source> find_sources() {
  static const std::regex include(R"re(\s*#\s*include\s+[<"]([^>"]+)[>"].*)re");
  std::vector<Source> sources;
  for (const char* top : {"solver", "render", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp" && extension != ".inc") continue;
      Source source{entry.path().generic_string(), find_room(entry.path().generic_string()), {}};
      std::ifstream file(entry.path());
      std::smatch match;
      for (std::string line; std::getline(file, line);) {
        if (std::regex_match(line, match, include)) source.includes.push_back(match[1]);
      }
      sources.push_back(std::move(source));
    }
  }
  return sources;
}

/// The rooms that each room may know; itself and solver/base always.
const std::map<std::string, std::set<std::string>>& allowed_rooms() {
  static const std::map<std::string, std::set<std::string>> rooms = {
      {"solver/base", {}},
      {"solver/geometry", {"solver/scene"}},
      {"solver/import", {"solver/geometry", "solver/scene"}},
      {"solver/material", {}},
      {"solver/shell", {"solver/material", "solver/geometry"}},
      {"solver/contact", {"solver/material", "solver/geometry", "solver/shell", "solver/loading"}},
      {"solver/loading", {"solver/material", "solver/geometry", "solver/shell"}},
      {"solver/system",
       {"solver/shell", "solver/contact", "solver/loading", "solver/material", "solver/geometry"}},
      {"solver/snapshot", {}},
      {"solver/scene", {"solver/loading"}},
      {"solver/increment",
       {"solver/system", "solver/shell", "solver/contact", "solver/loading", "solver/material",
        "solver/geometry", "solver/snapshot", "solver/scene", "solver/import"}},
      {"solver/session",
       {"solver/increment", "solver/system", "solver/shell", "solver/contact", "solver/loading",
        "solver/material", "solver/geometry", "solver/snapshot", "solver/scene", "solver/import"}},
      {"render", {"solver/snapshot"}},
      {"app",
       {"render", "solver/session", "solver/increment", "solver/snapshot", "solver/scene", "solver/import",
        "solver/geometry"}},
  };
  return rooms;
}

TEST(IncludeEdges, RoomsKnowOnlyTheRoomsBelow) {
  int edges = 0;
  for (const Source& source : find_sources()) {
    ASSERT_EQ(allowed_rooms().count(source.room), 1U)
        << source.file << ": a room that the list does not know";
    for (const std::string& include : source.includes) {
      const std::string room = find_room(include);
      if (room.empty() || room == source.room || room == "solver/base") continue;
      ++edges;
      EXPECT_EQ(allowed_rooms().at(source.room).count(room), 1U) << source.file << " includes " << include;
    }
  }
  EXPECT_GT(edges, 10) << "the test runs in the wrong folder";
}

/// A third party, and the one room that may include its headers.
struct Wall {
  const char* name;
  std::regex header;
  std::regex room;
};

const std::vector<Wall>& walls() {
  static const std::vector<Wall> list = {
      {"SuiteSparse", std::regex("(suitesparse/)?(cholmod|umfpack|klu|SuiteSparse).*"),
       std::regex("solver/system/.*\\.cpp")},
      {"VTK", std::regex("vtk.*"), std::regex("render/.*")},
      {"assimp", std::regex("assimp/.*"), std::regex("solver/import/.*\\.cpp")},
      {"TOML", std::regex("toml.*"), std::regex("solver/scene/.*\\.cpp")},
      {"OpenGL", std::regex("(GL/|EGL/|X11/).*"), std::regex("render/offscreen_.*")},
      {"PNG, WebP, FFmpeg", std::regex("(png\\.h|webp/|libav|zlib\\.h).*"), std::regex("render/.*\\.cpp")},
  };
  return list;
}

const Wall* find_wall(const std::string& include) {
  for (const Wall& wall : walls()) {
    if (std::regex_match(include, wall.header)) return &wall;
  }
  return nullptr;
}

TEST(IncludeEdges, ThirdPartiesStayInTheirRoom) {
  for (const Source& source : find_sources()) {
    for (const std::string& include : source.includes) {
      const Wall* wall = find_wall(include);
      if (wall == nullptr) continue;
      EXPECT_TRUE(std::regex_match(source.file, wall->room))
          << source.file << " includes " << include << " (" << wall->name << ")";
    }
  }
}

/// What a room shows to others is free of third parties, however deep one looks.
TEST(IncludeEdges, HeadersForOtherRoomsShowNoThirdParty) {
  std::map<std::string, Source> sources;
  for (Source& source : find_sources()) sources.emplace(source.file, source);
  for (const auto& [file, source] : sources) {
    std::set<std::string> seen;
    std::vector<std::string> waiting = {file};
    while (!waiting.empty()) {
      const auto found = sources.find(waiting.back());
      waiting.pop_back();
      if (found == sources.end() || !seen.insert(found->first).second) continue;
      for (const std::string& include : found->second.includes) {
        waiting.push_back(include);
        EXPECT_TRUE(found->second.room == source.room || find_wall(include) == nullptr)
            << file << " sees " << include << " through " << found->first;
      }
    }
  }
}

TEST(IncludeEdges, EveryFileNamesTheLicence) {
  for (const Source& source : find_sources()) {
    std::ifstream file(source.file);
    std::string line;
    std::getline(file, line);
    EXPECT_NE(line.find("SPDX-License-Identifier: GPL-3.0-or-later"), std::string::npos) << source.file;
  }
}

}  // namespace
}  // namespace hydroscope::test
