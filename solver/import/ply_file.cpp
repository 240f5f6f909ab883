// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "solver/base/error.h"
#include "solver/import/mesh_file.h"

namespace hydroscope {

namespace {

struct Property {
  std::string name, type, count_type;  // count_type: of a list, else empty
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
  std::size_t end = 0;  // first byte of the data
};

int find_type_size(const std::string& type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "int32" || type == "uint32") return 4;
  if (type == "float" || type == "float32") return 4;
  if (type == "double" || type == "float64") return 8;
  return 0;
}

void read_property(const std::string& path, std::istringstream& words, Header& header) {
  Property property;
  words >> property.type;
  if (property.type == "list") words >> property.count_type >> property.type;
  words >> property.name;
  const bool is_known = find_type_size(property.type) > 0 &&
                        (property.count_type.empty() || find_type_size(property.count_type) > 0);
  if (!words || !is_known || header.elements.empty()) refuse_mesh_file(path, "damaged PLY header: property");
  header.elements.back().properties.push_back(property);
}

Header read_header(const std::string& path, const std::string& content) {
  Header header;
  std::size_t at = 0;
  for (int line = 0;; ++line) {
    const std::size_t end = content.find('\n', at);
    if (end == std::string::npos) refuse_mesh_file(path, "truncated PLY: \"end_header\" is missing");
    std::istringstream words(content.substr(at, std::min<std::size_t>(end - at, 1000)));
    at = end + 1;
    std::string word;
    words >> word;
    if (line == 0 && word != "ply") refuse_mesh_file(path, "no mesh: a PLY file begins with \"ply\"");
    if (word == "format") words >> header.format;
    if (word == "property") read_property(path, words, header);
    if (word == "element") {
      Element element;
      words >> element.name >> element.count;
      if (!words) refuse_mesh_file(path, "damaged PLY header: element");
      header.elements.push_back(element);
    }
    if (word == "end_header") break;
    const bool is_known = word.empty() || word == "ply" || word == "format" || word == "property" ||
                          word == "element" || word == "comment" || word == "obj_info";
    if (!is_known) refuse_mesh_file(path, "damaged PLY header: \"" + word.substr(0, 40) + "\"");
  }
  header.end = at;
  return header;
}

/// The data behind the header as a stream of numbers, text or binary.
class Numbers {
 public:
  Numbers(const std::string& content, const Header& header)
      : content_(content), at_(header.end), is_text_(header.format == "ascii") {
    is_swapped_ = (header.format == "binary_big_endian") == (std::endian::native == std::endian::little);
    if (is_text_) text_.str(content.substr(header.end));
  }

  /// The next number, or nothing at the end of the data.
  std::optional<double> next(const std::string& type) {
    if (is_text_) {
      std::string word;
      if (!(text_ >> word)) return std::nullopt;
      double value = 0.0;
      const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (end != word.data() + word.size()) return std::numeric_limits<double>::quiet_NaN();
      return code == std::errc() ? value : 0.0;  // out of range: judged after reading
    }
    const auto size = static_cast<std::size_t>(find_type_size(type));
    if (content_.size() - at_ < size) return std::nullopt;
    std::array<char, 8> bytes{};
    for (std::size_t i = 0; i < size; ++i) bytes[is_swapped_ ? size - 1 - i : i] = content_[at_ + i];
    at_ += size;
    return convert(bytes, type);
  }

 private:
  template <class T>
  static double as(const std::array<char, 8>& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  }

  static double convert(const std::array<char, 8>& bytes, const std::string& type) {
    if (type == "char" || type == "int8") return as<std::int8_t>(bytes);
    if (type == "uchar" || type == "uint8") return as<std::uint8_t>(bytes);
    if (type == "short" || type == "int16") return as<std::int16_t>(bytes);
    if (type == "ushort" || type == "uint16") return as<std::uint16_t>(bytes);
    if (type == "int" || type == "int32") return as<std::int32_t>(bytes);
    if (type == "uint" || type == "uint32") return as<std::uint32_t>(bytes);
    if (type == "float" || type == "float32") return as<float>(bytes);
    return as<double>(bytes);
  }

  const std::string& content_;
  std::size_t at_;
  bool is_text_;
  bool is_swapped_ = false;
  std::istringstream text_;
};

class PlyCheck {
 public:
  PlyCheck(const std::string& path, const std::string& content)
      : path_(path), header_(read_header(path, content)), numbers_(content, header_) {}

  std::size_t run() {
    const bool is_known = header_.format == "ascii" || header_.format == "binary_little_endian" ||
                          header_.format == "binary_big_endian";
    if (!is_known) refuse_mesh_file(path_, "PLY of unknown format \"" + header_.format + "\"");
    for (const Element& element : header_.elements) {
      // Without a size in bytes, the announced number could not be checked against the file.
      if (element.properties.empty())
        refuse_mesh_file(path_, "damaged PLY header: element without properties");
      if (element.name == "vertex") {
        points_ = element.count;
        int places = 0;
        for (const Property& p : element.properties)
          places += p.name == "x" || p.name == "y" || p.name == "z";
        if (places != 3) refuse_mesh_file(path_, "PLY with points without x, y and z");
      }
      if (element.name != "face") continue;
      if (points_ == 0) refuse_mesh_file(path_, "PLY with no points before its facets");
      faces_ = element.count;
    }
    if (points_ == 0) refuse_mesh_file(path_, "PLY with no points");
    if (faces_ == 0) refuse_mesh_file(path_, "PLY with no facets");
    for (const Element& element : header_.elements) {
      for (std::size_t i = 0; i < element.count; ++i) check_item(element, i);
    }
    return faces_;
  }

 private:
  double next(const std::string& type) {
    const std::optional<double> value = numbers_.next(type);
    if (!value) refuse_mesh_file(path_, "truncated PLY: fewer points or facets than its header announces");
    return *value;
  }

  void check_item(const Element& element, std::size_t i) {
    for (const Property& property : element.properties) {
      if (!property.count_type.empty()) {
        check_list(element, property, i);
        continue;
      }
      const double value = next(property.type);
      const bool is_place = element.name == "vertex" && property.name.size() == 1 &&
                            std::string("xyz").find(property.name) != std::string::npos;
      if (is_place && !std::isfinite(value)) {
        refuse_mesh_file(path_, "point " + std::to_string(i) + ": coordinate is not a finite number");
      }
    }
  }

  void check_list(const Element& element, const Property& property, std::size_t i) {
    const double count = next(property.count_type);
    const bool is_face = element.name == "face" && property.name.rfind("vertex_ind", 0) == 0;
    const std::string where = element.name + " " + std::to_string(i) + ": ";
    if (!(count >= (is_face ? 3 : 0)) || count != std::floor(count)) {
      refuse_mesh_file(path_, where + "a facet needs three points or more");
    }
    for (double k = 0; k < count; ++k) {
      const double index = next(property.type);
      if (is_face && !(index >= 0 && index < static_cast<double>(points_) && index == std::floor(index))) {
        refuse_mesh_file(path_, where + "a point that does not exist");
      }
    }
  }

  const std::string& path_;
  Header header_;
  Numbers numbers_;
  std::size_t points_ = 0;
  std::size_t faces_ = 0;
};

}  // namespace

std::size_t check_ply(const std::string& path, const std::string& content) {
  return PlyCheck(path, content).run();
}

}  // namespace hydroscope
