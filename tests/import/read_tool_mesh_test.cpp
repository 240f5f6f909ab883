// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scenes/generators/die_meshes.h"
#include "solver/geometry/mesh_topology.h"
#include "solver/import/tool_mesh.h"
#include "tests/import/test_files.h"

namespace hydroscope {
namespace {

using test::Folder;

double calc_volume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.points[static_cast<std::size_t>(t[0])];
    volume += a.dot(mesh.points[static_cast<std::size_t>(t[1])].cross(
                  mesh.points[static_cast<std::size_t>(t[2])])) /
              6;
  }
  return volume;
}

TEST(ReadToolMesh, EveryFormatGivesTheSameTetrahedron) {
  const Folder folder;
  const TriangleMesh mesh = test::make_tetrahedron();
  const std::vector<std::string> files = {folder.write("binary.stl", make_binary_stl(mesh, "t")),
                                          folder.write("text.stl", make_text_stl(mesh, "t")),
                                          folder.write("upper.STL", make_binary_stl(mesh, "t")),
                                          folder.write("points.obj", test::make_obj(mesh)),
                                          folder.write("text.ply", test::make_ply(mesh, false)),
                                          folder.write("binary.ply", test::make_ply(mesh, true))};
  for (const std::string& file : files) {
    const ImportedMesh imported = read_tool_mesh(file, 1.0);
    EXPECT_EQ(imported.mesh.points.size(), 4u) << file;
    EXPECT_EQ(imported.mesh.triangles.size(), 4u) << file;
    EXPECT_EQ(make_topology(imported.mesh).open_edges, 0) << file;
    EXPECT_NEAR(calc_volume(imported.mesh), 1.0 / 6, 1e-7) << file;  // and so oriented as written
    EXPECT_EQ(imported.degenerate_dropped, 0) << file;
  }
}

TEST(ReadToolMesh, CountsWeldedPoints) {
  const Folder folder;
  const ImportedMesh imported =
      read_tool_mesh(folder.write("t.stl", make_binary_stl(test::make_tetrahedron(), "t")), 1.0);
  EXPECT_EQ(imported.points_read, 12);  // an STL file repeats its points
  EXPECT_EQ(imported.points_welded, 8);
}

TEST(ReadToolMesh, ScalesUnits) {
  const Folder folder;
  const std::string file = folder.write("t.stl", make_binary_stl(test::make_tetrahedron(), "t"));
  EXPECT_NEAR(calc_volume(read_tool_mesh(file, 25.4).mesh), 25.4 * 25.4 * 25.4 / 6, 1e-6 * 2731);
}

TEST(ReadToolMesh, SplitsQuadsAtTheShorterDiagonal) {
  const Folder folder;
  const ImportedMesh imported =
      read_tool_mesh(folder.write("q.obj", "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 1 0\nf 1 2 3 4\n"), 1.0);
  EXPECT_EQ(imported.quads_split, 1);
  ASSERT_EQ(imported.mesh.triangles.size(), 2u);
  EXPECT_EQ(imported.quads, (std::vector<std::array<int, 2>>{{0, 1}}));
  for (const auto& t : imported.mesh.triangles) {
    int on_short = 0;  // both halves hold the points (2, 0) and (1, 1)
    for (int p : t) {
      const Vec3& x = imported.mesh.points[static_cast<std::size_t>(p)];
      on_short += (x - Vec3(2, 0, 0)).norm() < 1e-6 || (x - Vec3(1, 1, 0)).norm() < 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(on_short, 2);
  }
  for (const Vec3& n : calc_facet_normals(imported.mesh)) EXPECT_GT(n.z(), 0.99);
}

TEST(ReadToolMesh, ReadsObjAsOthersWriteIt) {
  const Folder folder;
  const std::string content =
      "# a comment\nmtllib none.mtl\no die\nvn 0 0 1\nvt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0 1.0\nusemtl "
      "steel\n"
      "s off\nf 1/1/1 2/1/1 3/1/1\nf -3//1 -1//1 -2//1\n";
  const ImportedMesh imported = read_tool_mesh(folder.write("d.obj", content), 1.0);
  EXPECT_EQ(imported.mesh.triangles.size(), 2u);
  EXPECT_EQ(imported.mesh.points.size(), 4u);
}

TEST(ReadToolMesh, JoinsTheSolidsOfATextStl) {
  const Folder folder;
  TriangleMesh other = test::make_tetrahedron();
  for (Vec3& p : other.points) p += Vec3(5, 0, 0);
  const std::string content = make_text_stl(test::make_tetrahedron(), "a") + make_text_stl(other, "b");
  EXPECT_EQ(read_tool_mesh(folder.write("two.stl", content), 1.0).mesh.triangles.size(), 8u);
}

TEST(ReadToolMesh, DoesNotMindTheNormalsOfAnStl) {
  const Folder folder;
  std::string content = make_text_stl(test::make_tetrahedron(), "t");
  for (const char* odd : {"-nan(ind)", "1.#QNAN", "inf"}) {
    const std::size_t at = content.find("facet normal") + 13;
    content.replace(at, content.find(' ', at) - at, odd);
    EXPECT_EQ(read_tool_mesh(folder.write("t.stl", content), 1.0).mesh.triangles.size(), 4u) << odd;
  }
}

TEST(ReadToolMesh, DropsDegenerateAndDoubleFacets) {
  const Folder folder;
  TriangleMesh mesh = test::make_tetrahedron();
  mesh.points.push_back({0.5, 0, 0});
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.push_back({0, 4, 1});
  mesh.triangles.push_back({1, 0, 2});  // the first one again, from behind
  const ImportedMesh imported = read_tool_mesh(folder.write("d.obj", test::make_obj(mesh)), 1.0);
  EXPECT_EQ(imported.mesh.triangles.size(), 4u);
  EXPECT_EQ(imported.mesh.points.size(), 4u);
  EXPECT_EQ(imported.degenerate_dropped, 2);
  EXPECT_EQ(imported.duplicates_dropped, 1);
}

TEST(ReadToolMesh, BringsTheDiesBack) {
  const Folder folder;
  for (const TriangleMesh& die : {make_square_die({}), make_square_bulge_die({}), make_punch({}),
                                  make_square_die({20.5, 6.0, 90.0, 14, 16})}) {
    for (bool is_text : {false, true}) {
      const std::string content = is_text ? make_text_stl(die, "die") : make_binary_stl(die, "die");
      const ImportedMesh imported = read_tool_mesh(folder.write("die.stl", content), 1.0);
      ASSERT_EQ(imported.mesh.triangles.size(), die.triangles.size());
      EXPECT_EQ(imported.mesh.points.size(), die.points.size());
      EXPECT_EQ(imported.degenerate_dropped, 0);
      EXPECT_EQ(make_topology(imported.mesh).open_edges, make_topology(die).open_edges);
      double worst = 0.0;
      for (std::size_t f = 0; f < die.triangles.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
          worst =
              std::max(worst, (imported.mesh.points[static_cast<std::size_t>(imported.mesh.triangles[f][k])] -
                               die.points[static_cast<std::size_t>(die.triangles[f][k])])
                                  .norm());
        }
      }
      EXPECT_LT(worst, 1e-5);  // single precision at 100 mm: 4e-6 mm
    }
  }
}

}  // namespace
}  // namespace hydroscope
