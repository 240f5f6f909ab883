// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cstdint>
#include <random>

#include "solver/import/tool_mesh.h"
#include "tests/import/test_files.h"

namespace hydroscope {
namespace {

using test::catch_input_error;
using test::Folder;
using testing::AllOf;
using testing::HasSubstr;

std::string read_and_catch(const std::string& file) {
  return catch_input_error([&] { read_tool_mesh(file, 1.0); });
}

/// Reads `content` under `name` and expects an InputError with the file's name and `reason`.
void expect_refused(const std::string& name, const std::string& content, const std::string& reason) {
  const Folder folder;
  const std::string file = folder.write(name, content);
  EXPECT_THAT(read_and_catch(file), AllOf(HasSubstr(file), HasSubstr(reason)));
}

std::string make_stl() { return make_binary_stl(test::make_tetrahedron(), "test"); }
std::string make_stl_text() { return make_text_stl(test::make_tetrahedron(), "test"); }

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, what.size(), with);
}

TEST(BadMeshFile, Missing) {
  EXPECT_THAT(read_and_catch("/nowhere/die.stl"), HasSubstr("/nowhere/die.stl: no such file"));
}

TEST(BadMeshFile, Directory) {
  const Folder folder;
  std::filesystem::create_directories(folder.path() + "/die.stl");
  EXPECT_THAT(read_and_catch(folder.path() + "/die.stl"), HasSubstr("is a directory"));
}

TEST(BadMeshFile, Empty) { expect_refused("die.stl", "", "the file is empty"); }

TEST(BadMeshFile, UnknownKind) {
  expect_refused("die.step", "ISO-10303-21;", "unknown kind of file \"step\", expected .stl, .obj or .ply");
  expect_refused("die", "solid", "expected .stl, .obj or .ply");
}

TEST(BadMeshFile, BinaryStlCutShort) {
  const std::string whole = make_stl();
  expect_refused("die.stl", whole.substr(0, whole.size() - 1),
                 "truncated STL: its header announces 4 facets, the file holds 3");
  expect_refused("die.stl", whole.substr(0, 84), "announces 4 facets, the file holds 0");
  expect_refused("die.stl", whole.substr(0, 83), "truncated STL: shorter than the header");
}

TEST(BadMeshFile, BinaryStlWithBytesTooMany) {
  expect_refused("die.stl", make_stl() + std::string(50, '\0'), "announces 4 facets, the file holds 5");
}

TEST(BadMeshFile, BinaryStlWithoutFacets) {
  TriangleMesh none;
  expect_refused("die.stl", make_binary_stl(none, "none"), "no facets");
}

TEST(BadMeshFile, BinaryStlWithNaN) {
  std::string content = make_stl();
  const std::uint32_t nan = 0x7FC00000;
  std::memcpy(content.data() + 84 + 2 * 50 + 12 + 8, &nan, 4);
  expect_refused("die.stl", content, "facet 3: coordinate is not a finite number");
}

TEST(BadMeshFile, TextStlCutShort) {
  const std::string whole = make_stl_text();
  expect_refused("die.stl", whole.substr(0, whole.find("endsolid")), "\"endsolid\" is missing");
  expect_refused("die.stl", whole.substr(0, whole.rfind("endloop")), "the last facet is not complete");
  expect_refused("die.stl", "solid nothing\nendsolid nothing\n", "text STL without a facet");
}

TEST(BadMeshFile, TextStlWithOddFacets) {
  const std::string whole = make_stl_text();
  const std::size_t first = whole.find("    vertex");
  const std::size_t second = whole.find("    vertex", first + 1);
  expect_refused("die.stl", whole.substr(0, first) + whole.substr(second),
                 "line 7: a facet with 2 vertices, expected 3");
  expect_refused("die.stl", replaced(whole, "endfacet", ""), "facet inside a facet");
  expect_refused("die.stl", replaced(whole, "facet normal", "fact normal"), "vertex outside a facet");
  expect_refused("die.stl", replaced(whole, "facet normal 0", "facet normal"),
                 "expected \"facet normal\" and three");
  expect_refused("die.stl", replaced(whole, "vertex 0 0 0", "vertex 0 0"),
                 "line 4: a vertex needs three coordinates");
}

TEST(BadMeshFile, TextStlWithBadNumbers) {
  expect_refused("die.stl", replaced(make_stl_text(), "vertex 0 0 0", "vertex 0 nan 0"),
                 "line 4: coordinate is nan");
  expect_refused("die.stl", replaced(make_stl_text(), "vertex 0 0 0", "vertex -inf 0 0"),
                 "coordinate is -inf");
  expect_refused("die.stl", replaced(make_stl_text(), "vertex 0 0 0", "vertex 0,5 0 0"),
                 "\"0,5\" is not a number");
}

TEST(BadMeshFile, TextThatIsNoMesh) {
  expect_refused("die.stl", "Dear colleague,\nplease find the die attached.\n", "text that is no mesh");
  expect_refused("die.obj", "Dear colleague,\nplease find the die attached.\n", "text that is no mesh");
  expect_refused("die.ply", "Dear colleague,\nplease find the die attached.\n", "no mesh");
}

TEST(BadMeshFile, ObjDefects) {
  const std::string whole = test::make_obj(test::make_tetrahedron());
  expect_refused("die.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no facets");
  expect_refused("die.obj", whole + "f 1 2 9\n", "line 9: face with point \"9\", there are 4");
  expect_refused("die.obj", whole + "f 0 1 2\n", "face with point \"0\"");
  expect_refused("die.obj", whole + "f -9 1 2\n", "face with point \"-9\"");
  expect_refused("die.obj", whole + "f 1/1 2/1 3/1\n", "face with point \"1/1\"");
  expect_refused("die.obj", whole + "f 1 2\n", "a face needs at least three points");
  expect_refused("die.obj", "v 0 nan 0\n" + whole, "line 1: coordinate is nan");
  expect_refused("die.obj", "v 0 1\n" + whole, "line 1: a point needs three coordinates");
  expect_refused("die.obj", whole + std::string(1, '\0'), "binary data");
}

TEST(BadMeshFile, PlyDefects) {
  for (bool is_binary : {false, true}) {
    const std::string whole = test::make_ply(test::make_tetrahedron(), is_binary);
    expect_refused("die.ply", whole.substr(0, whole.size() - 4), "truncated PLY");
    expect_refused("die.ply", whole.substr(0, 40), "\"end_header\" is missing");
    expect_refused("die.ply", replaced(whole, "element face 4", "element face 5"), "truncated PLY");
    expect_refused("die.ply", replaced(whole, "element face 4", "element face 0"), "no facets");
    expect_refused("die.ply", replaced(whole, "element vertex 4", "element vertex 0"), "no points");
    expect_refused("die.ply", replaced(whole, "element vertex 4", "element vertex -4"), "truncated PLY");
    expect_refused("die.ply", replaced(whole, "property float x", "property quad x"), "damaged PLY header");
    expect_refused("die.ply", replaced(whole, "element face", "element dust 99999999999\nelement face"),
                   "element without properties");
  }
  const std::string text = test::make_ply(test::make_tetrahedron(), false);
  expect_refused("die.ply", replaced(text, "3 0 2 1", "3 0 2 7"), "face 0: a point that does not exist");
  expect_refused("die.ply", replaced(text, "3 0 2 1", "2 0 2"), "face 0: a facet needs three points");
  expect_refused("die.ply", replaced(text, "0 1 0", "0 nan 0"), "point 2: coordinate is not a finite number");
  expect_refused("die.ply", replaced(text, "ascii", "morse"), "unknown format");
}

TEST(BadMeshFile, MessagesHoldNoControlCodes) {
  const std::string message = [&] {
    const Folder folder;
    return read_and_catch(folder.write("die.obj", "v 0 \x1b[31m\x07 0\nf 1 1 1\n"));
  }();
  EXPECT_THAT(message, HasSubstr("is not a number"));
  for (char c : message) EXPECT_TRUE(c >= ' ' && c <= '~');
}

TEST(BadMeshFile, FacetsWithoutArea) {
  TriangleMesh flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  flat.triangles = {{0, 1, 2}, {1, 2, 3}};
  expect_refused("die.stl", make_binary_stl(flat, "flat"), "all 2 facets are without area");
}

TEST(BadMeshFile, BadUnitScale) {
  const Folder folder;
  const std::string file = folder.write("die.stl", make_stl());
  for (double scale : {0.0, -1.0, std::nan("")}) {
    EXPECT_THAT(catch_input_error([&] { read_tool_mesh(file, scale); }), HasSubstr("unit_scale"));
  }
}

/// Whatever the bytes, the answer is a mesh or an InputError, and it comes.
void read_garbage(const Folder& folder, const std::string& name, const std::string& content) {
  const std::string file = folder.write(name, content);
  try {
    const ImportedMesh imported = read_tool_mesh(file, 1.0);
    EXPECT_FALSE(imported.mesh.triangles.empty());
    for (const Vec3& p : imported.mesh.points) EXPECT_TRUE(p.allFinite());
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file));
  }
}

TEST(BadMeshFile, RandomBytesNeitherCrashNorHang) {
  const Folder folder;
  std::mt19937 dice(1);
  for (int i = 0; i < 300; ++i) {
    std::string content(dice() % 3000, '\0');
    for (char& c : content) c = static_cast<char>(dice() % (i % 2 == 0 ? 256 : 96) + (i % 2 == 0 ? 0 : 32));
    if (i % 5 == 0) content = "solid " + content;
    if (i % 5 == 1) content = "ply\nformat ascii 1.0\n" + content;
    for (const char* name : {"die.stl", "die.obj", "die.ply"}) read_garbage(folder, name, content);
  }
}

TEST(BadMeshFile, EveryPrefixIsRefusedOrRead) {
  const Folder folder;
  const TriangleMesh mesh = test::make_tetrahedron();
  const std::vector<std::pair<const char*, std::string>> files = {{"die.stl", make_stl()},
                                                                  {"die.stl", make_stl_text()},
                                                                  {"die.obj", test::make_obj(mesh)},
                                                                  {"die.ply", test::make_ply(mesh, false)},
                                                                  {"die.ply", test::make_ply(mesh, true)}};
  for (const auto& [name, content] : files) {
    for (std::size_t size = 0; size < content.size(); ++size)
      read_garbage(folder, name, content.substr(0, size));
  }
}

TEST(BadMeshFile, FlippedBytesNeitherCrashNorHang) {
  const Folder folder;
  const TriangleMesh mesh = test::make_tetrahedron();
  std::mt19937 dice(2);
  const std::vector<std::pair<const char*, std::string>> files = {{"die.stl", make_stl()},
                                                                  {"die.stl", make_stl_text()},
                                                                  {"die.obj", test::make_obj(mesh)},
                                                                  {"die.ply", test::make_ply(mesh, false)},
                                                                  {"die.ply", test::make_ply(mesh, true)}};
  for (const auto& [name, content] : files) {
    for (int i = 0; i < 400; ++i) {
      std::string broken = content;
      for (unsigned k = 0; k < 1 + dice() % 4; ++k)
        broken[dice() % broken.size()] = static_cast<char>(dice() % 256);
      read_garbage(folder, name, broken);
    }
  }
}

}  // namespace
}  // namespace hydroscope
