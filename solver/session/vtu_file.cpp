// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/vtu_file.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw InputError(file + ": " + why);
}

std::string read_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(file, "no such file, or it cannot be read");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Value of an attribute inside a tag, empty when it is not there.
std::string find_attribute(const std::string& tag, const std::string& name) {
  const auto at = tag.find(name + "=\"");
  if (at == std::string::npos) return {};
  const auto from = at + name.size() + 2;
  return tag.substr(from, tag.find('"', from) - from);
}

struct DataArray {
  std::string tag, body;
};

/// The data array called `name`, or the first one after `section`.
DataArray find_array(const std::string& file, const std::string& text, const std::string& section,
                     const std::string& name) {
  std::size_t at = text.find("<" + section);
  while (at != std::string::npos) {
    at = text.find("<DataArray", at);
    if (at == std::string::npos) break;
    const auto end = text.find('>', at), close = text.find("</DataArray>", end);
    if (end == std::string::npos || close == std::string::npos) break;
    const std::string tag = text.substr(at, end - at);
    if (name.empty() || find_attribute(tag, "Name") == name)
      return {tag, text.substr(end + 1, close - end - 1)};
    at = close;
  }
  refuse(file, "no data array " + (name.empty() ? section : name) +
                   " in it; expected a VTK unstructured grid (.vtu)");
}

std::string decode_base64(const std::string& text) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t buffer = 0;
  int bits = 0;
  for (const char c : text) {
    const auto digit = kDigits.find(c);
    if (digit == std::string::npos) continue;  // white space, padding
    buffer = (buffer << 6U) | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>((buffer >> static_cast<unsigned>(bits)) & 0xffU));
  }
  return bytes;
}

template <typename Value>
void append(const std::string& bytes, std::size_t from, std::vector<double>& values) {
  for (; from + sizeof(Value) <= bytes.size(); from += sizeof(Value)) {
    Value value;
    std::memcpy(&value, bytes.data() + from, sizeof value);
    values.push_back(static_cast<double>(value));
  }
}

std::vector<double> read_binary(const std::string& file, const std::string& text, const DataArray& array) {
  const std::size_t header = text.find("header_type=\"UInt64\"") != std::string::npos ? 8 : 4;
  const std::string bytes = decode_base64(array.body), type = find_attribute(array.tag, "type");
  std::vector<double> values;
  if (type == "Float64")
    append<double>(bytes, header, values);
  else if (type == "Float32")
    append<float>(bytes, header, values);
  else if (type == "Int64")
    append<std::int64_t>(bytes, header, values);
  else if (type == "Int32")
    append<std::int32_t>(bytes, header, values);
  else if (type == "UInt8")
    append<std::uint8_t>(bytes, header, values);
  else
    refuse(file, "data of type " + type + " is not read; expected Float32, Float64, Int32, Int64 or UInt8");
  return values;
}

std::vector<double> read_values(const std::string& file, const std::string& text, const DataArray& array) {
  const std::string format = find_attribute(array.tag, "format");
  if (format == "binary") return read_binary(file, text, array);
  if (format != "ascii") {
    refuse(file,
           "data in the form '" + format + "' is not read; save it as ascii, or binary without compression");
  }
  std::istringstream in(array.body);
  return {std::istream_iterator<double>(in), std::istream_iterator<double>()};
}

}  // namespace

QuadMesh read_vtu_quads(const std::string& file) {
  const std::string text = read_text(file);
  if (text.find("UnstructuredGrid") == std::string::npos)
    refuse(file, "expected a VTK unstructured grid (.vtu)");
  if (text.find("compressor=") != std::string::npos)
    refuse(file, "compressed data is not read; save without it");
  const auto read = [&](const char* section, const char* name) {
    return read_values(file, text, find_array(file, text, section, name));
  };
  const std::vector<double> x = read("Points", ""), nodes = read("Cells", "connectivity"),
                            types = read("Cells", "types");
  constexpr double kQuad = 9.0;  // VTK_QUAD
  for (const double type : types) {
    if (type != kQuad)
      refuse(file,
             "cell type " + std::to_string(static_cast<int>(type)) + "; expected quadrilaterals (9) only");
  }
  if (types.empty() || nodes.size() != 4 * types.size() || x.size() % 3 != 0) {
    refuse(file, "points or cells are missing or cut short");
  }
  QuadMesh mesh;
  for (std::size_t i = 0; i + 2 < x.size(); i += 3) {
    const Vec3 point(x[i], x[i + 1], x[i + 2]);
    if (!point.allFinite())
      refuse(file, "point " + std::to_string(i / 3) + " has a coordinate that is no number");
    mesh.points.push_back(point);
  }
  for (std::size_t e = 0; e < types.size(); ++e) {
    std::array<int, 4> quad{};
    for (std::size_t a = 0; a < 4; ++a) {
      quad[a] = static_cast<int>(nodes[4 * e + a]);
      if (quad[a] < 0 || quad[a] >= static_cast<int>(mesh.points.size())) {
        refuse(file, "cell " + std::to_string(e) + " names a point that is not there");
      }
    }
    mesh.quads.push_back(quad);
  }
  return mesh;
}

}  // namespace hydroscope
