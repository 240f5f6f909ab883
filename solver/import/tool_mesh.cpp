// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/tool_mesh.h"

#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>

#include "solver/base/error.h"
#include "solver/import/mesh_cleaning.h"
#include "solver/import/mesh_file.h"

namespace hydroscope {

namespace {

/// All meshes of the file in one; materials, normals, colours and animations are left.
PolygonSoup collect_polygons(const aiScene& scene, double unit_scale) {
  PolygonSoup soup;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    const int offset = static_cast<int>(soup.points.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& v = part.mVertices[i];
      soup.points.push_back(unit_scale * Vec3(v.x, v.y, v.z));
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices < 3) continue;  // points and lines
      std::vector<int>& polygon = soup.polygons.emplace_back();
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        require(face.mIndices[k] < part.mNumVertices, "a mesh reader gave a point that does not exist");
        polygon.push_back(offset + static_cast<int>(face.mIndices[k]));
      }
    }
  }
  return soup;
}

PolygonSoup read_polygons(const MeshFile& file, double unit_scale) {
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFileFromMemory(file.content.data(), file.content.size(), 0, file.format.c_str());
  if (scene == nullptr)
    refuse_mesh_file(file.path, std::string("cannot be read: ") + importer.GetErrorString());
  return collect_polygons(*scene, unit_scale);
}

}  // namespace

ImportedMesh read_tool_mesh(const std::string& file, double unit_scale) {
  if (!(unit_scale > 0.0) || !std::isfinite(unit_scale)) {
    throw InputError(file + ": unit_scale = " + std::to_string(unit_scale) + ", expected > 0");
  }
  const PolygonSoup soup = read_polygons(read_mesh_file(file), unit_scale);
  for (const Vec3& point : soup.points) {
    if (!point.allFinite()) refuse_mesh_file(file, "a coordinate is not a finite number");
  }
  if (soup.polygons.empty()) refuse_mesh_file(file, "no facets in the file");
  CleanedMesh cleaned = clean_mesh(soup);
  if (cleaned.mesh.triangles.empty()) {
    refuse_mesh_file(file, "all " + std::to_string(cleaned.degenerate_dropped) + " facets are without area");
  }
  ImportedMesh imported;
  imported.points_read = static_cast<int>(soup.points.size());
  imported.points_welded = cleaned.points_welded;
  imported.degenerate_dropped = cleaned.degenerate_dropped;
  imported.duplicates_dropped = cleaned.duplicates_dropped;
  imported.quads_split = cleaned.polygons_split;
  imported.mesh = std::move(cleaned.mesh);
  imported.quads = std::move(cleaned.quads);
  return imported;
}

}  // namespace hydroscope
