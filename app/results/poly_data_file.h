// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace hydroscope {

/// One named array of a VTK PolyData file, values of a tuple side by side.
struct DataArray {
  using Values = std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::uint8_t>>;
  std::string name;
  int components = 1;
  Values values;
};

/// A surface as VTK's XML PolyData (.vtp) holds it.
struct PolyData {
  std::vector<double> points;              ///< x, y, z of each [mm]
  std::vector<std::int32_t> connectivity;  ///< points of the cells, one cell after the other
  std::vector<std::int32_t> offsets;       ///< where each cell ends in `connectivity`
  std::vector<DataArray> point_arrays;
  std::vector<DataArray> field_arrays;  ///< of the whole file

  /// Throws InputError when the file has no array of this name and type.
  template <class Value>
  const std::vector<Value>& point_array(const std::string& name) const {
    return find<Value>(point_arrays, name);
  }
  template <class Value>
  const std::vector<Value>& field_array(const std::string& name) const {
    return find<Value>(field_arrays, name);
  }

 private:
  static const DataArray& find_array(const std::vector<DataArray>& arrays, const std::string& name);
  [[noreturn]] static void fail_type(const std::string& name);

  template <class Value>
  static const std::vector<Value>& find(const std::vector<DataArray>& arrays, const std::string& name) {
    const auto* values = std::get_if<std::vector<Value>>(&find_array(arrays, name).values);
    if (values == nullptr) fail_type(name);
    return *values;
  }
};

/// The bytes of a .vtp file: version 1.0, raw appended data, 64-bit headers, this
/// machine's byte order. ParaView and VTK read it; values keep every bit.
std::string make_poly_data_file(const PolyData& data);

/// Reads what make_poly_data_file wrote; throws InputError naming `file` when it
/// is cut off, damaged or of another make.
PolyData parse_poly_data_file(const std::string& bytes, const std::string& file);

}  // namespace hydroscope
