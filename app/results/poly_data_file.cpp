// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/poly_data_file.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

constexpr const char* kStart = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
)";
constexpr std::string_view kAppended = "<AppendedData encoding=\"raw\">\n_";

const char* type_name(const DataArray::Values& values) {
  constexpr const char* kNames[] = {"Float64", "Int32", "UInt8"};
  return kNames[values.index()];
}

size_t count(const DataArray::Values& values) {
  return std::visit([](const auto& list) { return list.size(); }, values);
}

/// Builds the XML part and the binary part side by side.
class FileMaker {
 public:
  void add(const DataArray& array, bool is_field, const std::string& indent) {
    xml += indent + "<DataArray type=\"" + type_name(array.values) + "\" Name=\"" + array.name + "\"";
    const size_t tuples = count(array.values) / static_cast<size_t>(array.components);
    if (is_field) xml += " NumberOfTuples=\"" + std::to_string(tuples) + "\"";
    if (array.components != 1) xml += " NumberOfComponents=\"" + std::to_string(array.components) + "\"";
    xml += " format=\"appended\" offset=\"" + std::to_string(raw.size()) + "\"/>\n";
    std::visit([this](const auto& list) { append(list.data(), list.size() * sizeof(list[0])); },
               array.values);
  }

  std::string xml;
  std::string raw;

 private:
  void append(const void* values, size_t bytes) {
    const auto header = static_cast<std::uint64_t>(bytes);
    raw.append(reinterpret_cast<const char*>(&header), sizeof header);
    if (bytes > 0) raw.append(static_cast<const char*>(values), bytes);
  }
};

/// Reads one tag after the other of the XML part.
class TagScanner {
 public:
  TagScanner(std::string_view xml, const std::string& file) : xml_(xml), file_(file) {}

  bool next() {
    const size_t open = xml_.find('<', at_);
    if (open == std::string_view::npos) return false;
    const size_t close = xml_.find('>', open);
    if (close == std::string_view::npos) fail("a tag is cut off");
    tag_ = xml_.substr(open + 1, close - open - 1);
    at_ = close + 1;
    return true;
  }

  std::string_view name() const { return tag_.substr(0, tag_.find_first_of(" /", 1)); }

  std::string text(std::string_view attribute, const char* standard = nullptr) const {
    const std::string start = " " + std::string(attribute) + "=\"";
    const size_t from = tag_.find(start);
    if (from == std::string_view::npos) {
      if (standard != nullptr) return standard;
      fail("attribute " + std::string(attribute) + " is missing");
    }
    const size_t first = from + start.size(), last = tag_.find('"', first);
    if (last == std::string_view::npos) fail("a tag is cut off");
    return std::string(tag_.substr(first, last - first));
  }

  size_t number(std::string_view attribute, const char* standard = nullptr) const {
    const std::string digits = text(attribute, standard);
    size_t value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || stop != digits.data() + digits.size()) fail("'" + digits + "' is no number");
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ": damaged state file: " + what);
  }

 private:
  std::string_view xml_;
  const std::string& file_;
  size_t at_ = 0;
  std::string_view tag_;
};

template <class Value>
std::vector<Value> copy_values(std::string_view block, const TagScanner& tags) {
  if (block.size() % sizeof(Value) != 0) tags.fail("an array has a broken length");
  std::vector<Value> values(block.size() / sizeof(Value));
  if (!block.empty()) std::memcpy(values.data(), block.data(), block.size());
  return values;
}

DataArray read_array(const TagScanner& tags, std::string_view raw) {
  const size_t offset = tags.number("offset");
  std::uint64_t bytes = 0;
  if (offset > raw.size() || raw.size() - offset < sizeof bytes) tags.fail("an array is cut off");
  std::memcpy(&bytes, raw.data() + offset, sizeof bytes);
  if (bytes > raw.size() - offset - sizeof bytes) tags.fail("an array is cut off");
  const std::string_view block = raw.substr(offset + sizeof bytes, bytes);
  DataArray array{tags.text("Name"), static_cast<int>(tags.number("NumberOfComponents", "1")), {}};
  const std::string type = tags.text("type");
  if (type == "Float64")
    array.values = copy_values<double>(block, tags);
  else if (type == "Int32")
    array.values = copy_values<std::int32_t>(block, tags);
  else if (type == "UInt8")
    array.values = copy_values<std::uint8_t>(block, tags);
  else
    tags.fail("type '" + type + "' is not ours");
  return array;
}

template <class Value>
std::vector<Value> take(DataArray& array, const TagScanner& tags) {
  auto* values = std::get_if<std::vector<Value>>(&array.values);
  if (values == nullptr) tags.fail("array '" + array.name + "' has another type");
  return std::move(*values);
}

void check_sizes(const PolyData& data, size_t points, size_t cells, const TagScanner& tags) {
  if (data.points.size() != 3 * points) tags.fail("points are missing");
  if (data.offsets.size() != cells) tags.fail("cells are missing");
  const auto is_point = [points](std::int32_t index) {
    return index >= 0 && static_cast<size_t>(index) < points;
  };
  if (!std::all_of(data.connectivity.begin(), data.connectivity.end(), is_point))
    tags.fail("a cell has no such point");
  std::int32_t last = 0;
  for (const std::int32_t offset : data.offsets) {
    if (offset < last || static_cast<size_t>(offset) > data.connectivity.size())
      tags.fail("cells are broken");
    last = offset;
  }
  for (const DataArray& array : data.point_arrays) {
    if (count(array.values) != points * static_cast<size_t>(array.components))
      tags.fail("array '" + array.name + "' is cut off");
  }
}

}  // namespace

const DataArray& PolyData::find_array(const std::vector<DataArray>& arrays, const std::string& name) {
  const auto found =
      std::find_if(arrays.begin(), arrays.end(), [&](const DataArray& a) { return a.name == name; });
  if (found == arrays.end()) throw InputError("array '" + name + "' is missing");
  return *found;
}

void PolyData::fail_type(const std::string& name) {
  throw InputError("array '" + name + "' has another type");
}

std::string make_poly_data_file(const PolyData& data) {
  FileMaker maker;
  maker.xml = std::string(kStart) + "  <PolyData>\n    <FieldData>\n";
  for (const DataArray& array : data.field_arrays) maker.add(array, true, "      ");
  maker.xml += "    </FieldData>\n    <Piece NumberOfPoints=\"" + std::to_string(data.points.size() / 3) +
               "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
               std::to_string(data.offsets.size()) + "\">\n      <PointData>\n";
  for (const DataArray& array : data.point_arrays) maker.add(array, false, "        ");
  maker.xml += "      </PointData>\n      <Points>\n";
  maker.add({"Points", 3, data.points}, false, "        ");
  maker.xml += "      </Points>\n      <Polys>\n";
  maker.add({"connectivity", 1, data.connectivity}, false, "        ");
  maker.add({"offsets", 1, data.offsets}, false, "        ");
  maker.xml += "      </Polys>\n    </Piece>\n  </PolyData>\n  ";
  return maker.xml + std::string(kAppended) + maker.raw + "\n  </AppendedData>\n</VTKFile>\n";
}

PolyData parse_poly_data_file(const std::string& bytes, const std::string& file) {
  const std::string_view all = bytes;
  const size_t appended = all.find(kAppended);
  TagScanner tags(all.substr(0, appended), file);
  if (!all.starts_with(kStart) || appended == std::string_view::npos)
    tags.fail("not written by this program");
  const std::string_view raw = all.substr(appended + kAppended.size());
  PolyData data;
  std::string_view section;
  size_t points = 0, cells = 0;
  while (tags.next()) {
    if (tags.name() == "Piece") {
      points = tags.number("NumberOfPoints");
      cells = tags.number("NumberOfPolys");
    }
    if (tags.name() != "DataArray") {
      section = tags.name();
      continue;
    }
    DataArray array = read_array(tags, raw);
    if (section == "FieldData")
      data.field_arrays.push_back(std::move(array));
    else if (section == "PointData")
      data.point_arrays.push_back(std::move(array));
    else if (section == "Points")
      data.points = take<double>(array, tags);
    else if (section == "Polys" && array.name == "connectivity")
      data.connectivity = take<std::int32_t>(array, tags);
    else if (section == "Polys" && array.name == "offsets")
      data.offsets = take<std::int32_t>(array, tags);
  }
  check_sizes(data, points, cells, tags);
  return data;
}

}  // namespace hydroscope
