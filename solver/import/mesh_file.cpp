// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/mesh_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr std::size_t kStlHeader = 84;  // 80 bytes of anything, then the number of facets
constexpr std::size_t kStlFacet = 50;
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 31;

std::string to_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// Words of a line, without a comment: a word that begins with '#' and what follows it.
std::vector<std::string_view> split_words(std::string_view line) {
  std::vector<std::string_view> words;
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 0; i < line.size() && line[i] != '#';) {
    if (is_space(line[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < line.size() && !is_space(line[end])) ++end;
    words.push_back(line.substr(i, end - i));
    i = end;
  }
  return words;
}

std::string in_line(std::size_t line) { return "line " + std::to_string(line) + ": "; }

void check_coordinate(const std::string& path, std::size_t line, std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code == std::errc::result_out_of_range) return;  // denormal or huge: judged after reading
  if (code != std::errc() || end != word.data() + word.size()) {
    refuse_mesh_file(path, in_line(line) + "\"" + std::string(word.substr(0, 40)) + "\" is not a number");
  }
  if (!std::isfinite(value)) {
    refuse_mesh_file(path, in_line(line) + "coordinate is " + std::string(word) + " (not a finite number)");
  }
}

/// Calls use(words, line number) for each line that has words.
template <class Use>
void for_each_line(const std::string& content, Use&& use) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < content.size();) {
    const std::size_t end = std::min(content.find('\n', i), content.size());
    ++number;
    const auto words = split_words(std::string_view(content).substr(i, end - i));
    if (!words.empty()) use(words, number);
    i = end + 1;
  }
}

struct TextStl {
  std::size_t facets = 0, corners = 0, line = 0;
  bool is_in_facet = false, is_closed = false;
};

/// One line of a text STL: what may follow what.
void check_stl_line(const std::string& path, const std::vector<std::string_view>& words, TextStl& stl) {
  const std::string word = to_lower(words[0]);
  if (word == "facet") {
    if (stl.is_in_facet) refuse_mesh_file(path, in_line(stl.line) + "facet inside a facet");
    stl.is_in_facet = true;
    stl.is_closed = false;
    stl.corners = 0;
  } else if (word == "vertex") {
    if (!stl.is_in_facet) refuse_mesh_file(path, in_line(stl.line) + "vertex outside a facet");
    if (words.size() != 4) refuse_mesh_file(path, in_line(stl.line) + "a vertex needs three coordinates");
    for (std::size_t k = 1; k < 4; ++k) check_coordinate(path, stl.line, words[k]);
    ++stl.corners;
  } else if (word == "endfacet") {
    if (!stl.is_in_facet || stl.corners != 3) {
      refuse_mesh_file(
          path, in_line(stl.line) + "a facet with " + std::to_string(stl.corners) + " vertices, expected 3");
    }
    stl.is_in_facet = false;
    ++stl.facets;
  } else if (stl.is_in_facet && word != "outer" && word != "endloop" && word != "endsolid") {
    refuse_mesh_file(path, in_line(stl.line) + "\"" + word.substr(0, 40) + "\" inside a facet");
  } else if (word == "endsolid") {
    if (stl.is_in_facet) refuse_mesh_file(path, in_line(stl.line) + "endsolid inside a facet");
    stl.is_closed = true;
  }
}

/// Facet normals are not used, and some programs write what no reader takes for a number
/// ("-nan(ind)"): puts zeros in their place.
void blank_normal(const std::string& path, const std::vector<std::string_view>& words, std::size_t line,
                  std::string& content) {
  if (words.size() != 5 || to_lower(words[1]) != "normal") {
    refuse_mesh_file(path, in_line(line) + "expected \"facet normal\" and three numbers");
  }
  for (std::size_t k = 2; k < 5; ++k) {
    const auto start = static_cast<std::size_t>(words[k].data() - content.data());
    std::fill_n(content.begin() + static_cast<std::ptrdiff_t>(start), words[k].size(), ' ');
    content[start] = '0';
  }
}

std::size_t check_text_stl(const std::string& path, std::string& content) {
  TextStl stl;
  for_each_line(content, [&](const std::vector<std::string_view>& words, std::size_t line) {
    stl.line = line;
    check_stl_line(path, words, stl);
    if (to_lower(words[0]) == "facet") blank_normal(path, words, line, content);
  });
  if (stl.is_in_facet) refuse_mesh_file(path, "truncated STL: the last facet is not complete");
  if (stl.facets == 0) refuse_mesh_file(path, "text STL without a facet");
  if (!stl.is_closed) refuse_mesh_file(path, "truncated STL: \"endsolid\" is missing at the end");
  return stl.facets;
}

std::size_t check_binary_stl(const std::string& path, const std::string& content) {
  std::uint32_t facets = 0;
  std::memcpy(&facets, content.data() + 80, sizeof facets);
  if (facets == 0) refuse_mesh_file(path, "binary STL with no facets");
  for (std::size_t f = 0; f < facets; ++f) {
    std::array<float, 9> corners{};
    std::memcpy(corners.data(), content.data() + kStlHeader + f * kStlFacet + 12, sizeof corners);
    for (float value : corners) {
      if (!std::isfinite(value)) {
        refuse_mesh_file(path, "facet " + std::to_string(f + 1) + ": coordinate is not a finite number");
      }
    }
  }
  return facets;
}

bool looks_like_text(const std::string& content) {
  return std::none_of(content.begin(),
                      content.begin() + static_cast<long>(std::min<std::size_t>(512, content.size())),
                      [](char c) { return c == '\0' || static_cast<unsigned char>(c) > 0xF4; });
}

std::size_t check_stl(const std::string& path, std::string& content) {
  static_assert(std::endian::native == std::endian::little, "STL is little-endian");
  std::uint32_t facets = 0;
  const bool has_header = content.size() >= kStlHeader;
  if (has_header) std::memcpy(&facets, content.data() + 80, sizeof facets);
  const std::size_t wanted = kStlHeader + kStlFacet * static_cast<std::size_t>(facets);
  if (has_header && content.size() == wanted) return check_binary_stl(path, content);
  if (looks_like_text(content)) {
    const std::size_t start = content.find_first_not_of(" \t\r\n");
    const bool is_solid = start != std::string::npos && to_lower(content.substr(start, 5)) == "solid";
    if (!is_solid) refuse_mesh_file(path, "text that is no mesh: an STL file begins with \"solid\"");
    return check_text_stl(path, content);
  }
  if (!has_header) refuse_mesh_file(path, "truncated STL: shorter than the header of 84 bytes");
  const std::size_t there = (content.size() - kStlHeader) / kStlFacet;
  refuse_mesh_file(path, std::string(content.size() < wanted ? "truncated STL" : "damaged STL") +
                             ": its header announces " + std::to_string(facets) + " facets, the file holds " +
                             std::to_string(there));
}

/// How many points, texture points and normals an OBJ has given so far.
using ObjCounts = std::array<long, 3>;

/// Checks one corner of a face, "point", "point/texture", "point//normal" or "point/texture/normal".
bool is_obj_corner(std::string_view corner, const ObjCounts& counts) {
  for (std::size_t slot = 0; slot < 3; ++slot) {
    const std::size_t slash = std::min(corner.find('/'), corner.size());
    const std::string_view word = corner.substr(0, slash);
    if (!word.empty() || slot == 0) {
      long index = 0;
      const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), index);
      const bool is_number = code == std::errc() && end == word.data() + word.size();
      if (!is_number || index == 0 || std::abs(index) > counts[slot]) return false;
    }
    if (slash == corner.size()) return true;
    corner.remove_prefix(slash + 1);
  }
  return false;
}

std::size_t check_obj(const std::string& path, const std::string& content) {
  if (content.find('\0') != std::string::npos) refuse_mesh_file(path, "binary data, an OBJ file is text");
  ObjCounts counts{};
  std::size_t faces = 0;
  for_each_line(content, [&](const std::vector<std::string_view>& words, std::size_t line) {
    if (words[0] == "v") {
      if (words.size() < 4) refuse_mesh_file(path, in_line(line) + "a point needs three coordinates");
      for (std::size_t k = 1; k < 4; ++k) check_coordinate(path, line, words[k]);
      ++counts[0];
    } else if (words[0] == "vt" || words[0] == "vn") {
      ++counts[words[0] == "vt" ? 1 : 2];
    } else if (words[0] == "f") {
      if (words.size() < 4) refuse_mesh_file(path, in_line(line) + "a face needs at least three points");
      for (std::size_t k = 1; k < words.size(); ++k) {
        if (is_obj_corner(words[k], counts)) continue;
        refuse_mesh_file(path, in_line(line) + "face with point \"" + std::string(words[k].substr(0, 40)) +
                                   "\", there are " + std::to_string(counts[0]));
      }
      ++faces;
    }
  });
  if (counts[0] == 0) refuse_mesh_file(path, "text that is no mesh: no points (\"v x y z\") in the OBJ file");
  if (faces == 0) refuse_mesh_file(path, "no facets (\"f 1 2 3\") in the OBJ file");
  return faces;
}

}  // namespace

void refuse_mesh_file(const std::string& path, const std::string& what) {
  // Broken files are quoted: no control codes for the terminal, and no pages of them.
  std::string shown = what.substr(0, 200);
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  throw InputError(path + ": " + shown);
}

std::string read_mesh_content(const std::string& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) refuse_mesh_file(path, "no such file");
  if (std::filesystem::is_directory(status)) refuse_mesh_file(path, "is a directory, expected a file");
  if (!std::filesystem::is_regular_file(status)) refuse_mesh_file(path, "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (!code && size == 0) refuse_mesh_file(path, "the file is empty");
  if (!code && size >= kLargestFile) refuse_mesh_file(path, "larger than 2 GB: make it coarser");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse_mesh_file(path, std::string("cannot be read: ") + std::strerror(errno));
  std::ostringstream content;
  content << file.rdbuf();
  if (!file) refuse_mesh_file(path, std::string("cannot be read: ") + std::strerror(errno));
  return std::move(content).str();
}

MeshFile read_mesh_file(const std::string& path) {
  MeshFile file{path, read_mesh_content(path), to_lower(std::filesystem::path(path).extension().string()), 0};
  if (!file.format.empty()) file.format.erase(0, 1);
  if (file.format == "stl") {
    file.facets = check_stl(path, file.content);
  } else if (file.format == "obj") {
    file.facets = check_obj(path, file.content);
  } else if (file.format == "ply") {
    file.facets = check_ply(path, file.content);
  } else {
    refuse_mesh_file(path, "unknown kind of file \"" + file.format + "\", expected .stl, .obj or .ply");
  }
  return file;
}

}  // namespace hydroscope
