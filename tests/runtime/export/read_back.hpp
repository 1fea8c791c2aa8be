// Files read back by another library.
#pragma once

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <string>
#include <vector>

#include "runtime/mesh/vec3.hpp"

namespace toile {

using Corners = std::array<Vec3, 3>;

inline const aiScene* read_back(Assimp::Importer& importer, const std::string& bytes, const char* format) {
  return importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_ValidateDataStructure, format);
}

/// The corners of all triangles, in the order of the file.
inline std::vector<Corners> triangles_of(const aiScene& scene) {
  std::vector<Corners> triangles;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      Corners corners;
      for (unsigned c = 0; c < 3; ++c) {
        const aiVector3D& p = mesh.mVertices[mesh.mFaces[f].mIndices[c]];
        corners[c] = {p.x, p.y, p.z};
      }
      triangles.push_back(corners);
    }
  }
  return triangles;
}

/// The largest distance between corresponding corners.
inline double largest_difference(const std::vector<Corners>& a, const std::vector<Corners>& b) {
  double largest = 0;
  for (std::size_t t = 0; t < std::min(a.size(), b.size()); ++t) {
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, distance(a[t][c], b[t][c]));
  }
  return largest;
}

inline std::vector<Corners> triangles_of(const std::vector<std::array<int, 3>>& triangles,
                                         const std::vector<Vec3>& positions) {
  std::vector<Corners> all;
  for (const auto& [a, b, c] : triangles) {
    all.push_back({positions[static_cast<std::size_t>(a)], positions[static_cast<std::size_t>(b)],
                   positions[static_cast<std::size_t>(c)]});
  }
  return all;
}

}  // namespace toile
