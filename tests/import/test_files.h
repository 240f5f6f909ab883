// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "scenes/generators/stl_file.h"
#include "solver/base/error.h"
#include "solver/base/types.h"

namespace hydroscope::test {

/// A folder of its own for each test, removed at its end.
class Folder {
 public:
  Folder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "." + info->name();
    for (char& c : name) c = c == '/' ? '_' : c;
    path_ = std::filesystem::path(testing::TempDir()) / ("hydroscope_" + name);
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code code;
    std::filesystem::remove_all(path_, code);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path() const { return path_.string(); }
  std::string write(const std::string& name, const std::string& content) const {
    const std::string file = (path_ / name).string();
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }

 private:
  std::filesystem::path path_;
};

/// Four facets around (0, 0, 0) .. (1, 1, 1), closed, outwards.
inline TriangleMesh make_tetrahedron() {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

inline std::string make_obj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  for (const Vec3& p : mesh.points) text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& t : mesh.triangles) text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return text.str();
}

inline std::string make_ply(const TriangleMesh& mesh, bool is_binary) {
  std::ostringstream text;
  text.precision(9);
  text << "ply\nformat " << (is_binary ? "binary_little_endian" : "ascii") << " 1.0\ncomment made by a test\n"
       << "element vertex " << mesh.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\n"
       << "element face " << mesh.triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto put = [&](const auto& value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    text.write(bytes, sizeof value);
  };
  for (const Vec3& p : mesh.points) {
    if (is_binary) {
      for (int i = 0; i < 3; ++i) put(static_cast<float>(p[i]));
    } else {
      text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
  }
  for (const auto& t : mesh.triangles) {
    if (is_binary) {
      put(static_cast<unsigned char>(3));
      for (int p : t) put(p);
    } else {
      text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    }
  }
  return text.str();
}

/// The message of the InputError that `act` throws; "" when it throws none.
template <class Act>
std::string catch_input_error(Act&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace hydroscope::test
