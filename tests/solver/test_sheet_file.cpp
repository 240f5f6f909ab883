// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "solver/base/error.h"
#include "solver/geometry/sheet_mesh.h"
#include "solver/session/sheet_file.h"

namespace hydroscope {
namespace {

/// A quarter of a half tube, radius 30, as a VTU in text; written inside out when asked.
std::string make_vtu(bool is_inside_out) {
  constexpr int kAround = 6, kAlong = 3;
  std::ostringstream points, cells, offsets, types;
  for (int j = 0; j <= kAlong; ++j) {
    for (int i = 0; i <= kAround; ++i) {
      const double a = std::acos(0.0) * i / kAround;
      points << 30 * std::cos(a) << ' ' << 30 * std::sin(a) << ' ' << 5.0 * j << '\n';
    }
  }
  int count = 0;
  for (int j = 0; j < kAlong; ++j) {
    for (int i = 0; i < kAround; ++i) {
      const int a = j * (kAround + 1) + i, b = a + 1, c = b + kAround + 1, d = a + kAround + 1;
      cells << a << ' ' << (is_inside_out ? d : b) << ' ' << c << ' ' << (is_inside_out ? b : d) << '\n';
      offsets << 4 * ++count << ' ';
      types << "9 ";
    }
  }
  std::ostringstream text;
  text << "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece><Points><DataArray type=\"Float64\" "
          "NumberOfComponents=\"3\" format=\"ascii\">\n"
       << points.str() << "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">"
       << cells.str() << "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" << offsets.str()
       << "</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" << types.str()
       << "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n";
  return text.str();
}

class SheetFile : public ::testing::Test {
 protected:
  SheetFile() : folder_(std::filesystem::temp_directory_path() / "hydroscope_sheet_file_test") {
    std::filesystem::create_directories(folder_);
    scene_.directory = folder_.string();
    scene_.mesh.file = "tube.vtu";
    scene_.mesh.thickness = 1.5;
  }
  ~SheetFile() override { std::filesystem::remove_all(folder_); }

  SheetMesh read(const std::string& text) {
    std::ofstream(folder_ / "tube.vtu") << text;
    return read_sheet_mesh(scene_);
  }

  std::filesystem::path folder_;
  Scene scene_;
};

TEST_F(SheetFile, QuarterTubeComesWithItsSymmetryPlanesAndEnd) {
  for (const bool is_inside_out : {false, true}) {
    const SheetMesh m = read(make_vtu(is_inside_out));
    EXPECT_EQ(m.mesh.quads.size(), 18U);
    ASSERT_EQ(m.symmetry.size(), 3U);
    EXPECT_EQ(m.symmetry[0].nodes.size(), 4U);  // x = 0
    EXPECT_EQ(m.symmetry[2].nodes.size(), 7U);  // z = 0
    EXPECT_EQ(m.end_nodes.size(), 7U);
    EXPECT_TRUE(m.start_nodes.empty());
    for (std::size_t i = 0; i < m.directors.size(); ++i) {
      EXPECT_GT(m.directors[i].dot(m.mesh.points[i].normalized()), 0.8) << "towards the outside";
    }
    const auto& q = m.mesh.quads[0];
    const auto point = [&](int k) { return m.mesh.points[static_cast<std::size_t>(q[static_cast<std::size_t>(k)])]; };
    EXPECT_GT((point(1) - point(0)).cross(point(3) - point(0)).dot(m.directors[static_cast<std::size_t>(q[0])]), 0.0);
  }
}

TEST_F(SheetFile, BadFilesAreRefused) {
  EXPECT_THROW(read("no xml at all"), InputError);
  std::string triangle = make_vtu(false);
  triangle.replace(triangle.rfind("9 "), 1, "5");
  EXPECT_THROW(read(triangle), InputError);
  std::string nan = make_vtu(false);
  nan.replace(nan.find("30 0 0"), 2, "xx");
  EXPECT_THROW(read(nan), InputError);
  scene_.mesh.file = "missing.vtu";
  EXPECT_THROW(read_sheet_mesh(scene_), InputError);
}

}  // namespace
}  // namespace hydroscope
