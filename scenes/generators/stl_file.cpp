// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/generators/stl_file.h"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

static_assert(std::endian::native == std::endian::little, "STL is little-endian");

Vec3 calc_normal(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  const Vec3& a = mesh.points[static_cast<std::size_t>(t[0])];
  const Vec3& b = mesh.points[static_cast<std::size_t>(t[1])];
  const Vec3& c = mesh.points[static_cast<std::size_t>(t[2])];
  return (b - a).cross(c - a).normalized();
}

void append(std::string& content, const Vec3& v) {
  for (int i = 0; i < 3; ++i) {
    const auto value = static_cast<float>(v[i]);
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    content.append(bytes, sizeof value);
  }
}

std::string format(const char* word, const Vec3& v) {
  char line[128];
  // Nine digits bring every float back unchanged.
  std::snprintf(
      line, sizeof line, "%s %.9g %.9g %.9g\n", word, static_cast<double>(static_cast<float>(v.x())),
      static_cast<double>(static_cast<float>(v.y())), static_cast<double>(static_cast<float>(v.z())));
  return line;
}

}  // namespace

std::string make_binary_stl(const TriangleMesh& mesh, const std::string& title) {
  // A header that began with "solid" would be taken for text.
  std::string content = "Hydroscope tool mesh [mm]: " + title;
  content.resize(80, '\0');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  content.append(reinterpret_cast<const char*>(&count), sizeof count);
  content.reserve(84 + 50 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    append(content, calc_normal(mesh, t));
    for (int p : t) append(content, mesh.points[static_cast<std::size_t>(p)]);
    content.append(2, '\0');
  }
  return content;
}

std::string make_text_stl(const TriangleMesh& mesh, const std::string& title) {
  std::string content = "solid " + title + "\n";
  for (const auto& t : mesh.triangles) {
    content += format("facet normal", calc_normal(mesh, t));
    content += "  outer loop\n";
    for (int p : t) content += format("    vertex", mesh.points[static_cast<std::size_t>(p)]);
    content += "  endloop\nendfacet\n";
  }
  content += "endsolid " + title + "\n";
  return content;
}

void write_file(const std::string& path, const std::string& content) {
  const std::string temporary = path + ".part";
  {
    std::ofstream file(temporary, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) {
      std::remove(temporary.c_str());
      throw EnvironmentError(path + ": cannot be written");
    }
  }
  std::error_code code;
  std::filesystem::rename(temporary, path, code);
  if (code) throw EnvironmentError(path + ": " + code.message());
}

}  // namespace hydroscope
