// A drape kept for later: what it takes to start the next one, of a changed pattern, from there.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/pattern/pattern.hpp"
#include "compiler/smesh/smesh.hpp"
#include "runtime/mesh/vec3.hpp"

namespace toile {

struct KeptDrape {
  std::vector<std::string> pieces;             // their names
  std::vector<Vec2> points;                    // [m] of the P-mesh
  std::vector<std::array<int, 3>> triangles;   // into points
  std::vector<int> piece_of_triangle;          // into pieces
  std::vector<std::array<int, 3>> s_vertices;  // the same triangles, into positions
  std::vector<Vec3> positions;                 // [m]
};

KeptDrape keep(const Garment& garment, const SewnMesh& mesh, const std::vector<Vec3>& positions);

/// Where the vertices of `mesh` start, through the pieces' own coordinates: what lies beyond the kept piece goes on as
/// its last triangle does. nullopt when a piece is not among the kept ones.
std::optional<std::vector<Vec3>> start_from(const KeptDrape& kept, const Garment& garment, const SewnMesh& mesh);

/// FNV-1a.
std::uint64_t checksum(std::string_view bytes);

/// As bytes with their checksum, and back; nullopt for bytes that are not a whole kept drape.
std::string to_bytes(const KeptDrape& kept);
std::optional<KeptDrape> from_bytes(std::string_view bytes);

}  // namespace toile
