// Files that other programs open. Every function returns the bytes of the file; writing them is the driver's.
#pragma once

#include <string>
#include <vector>

#include "compiler/pattern/pattern.hpp"
#include "compiler/smesh/smesh.hpp"
#include "runtime/drape/drape.hpp"
#include "runtime/mesh/cloth.hpp"

namespace toile {

/// A draped cloth with what is needed to picture it elsewhere.
struct DrapedGarment {
  const Garment* garment = nullptr;
  const SewnMesh* mesh = nullptr;
  const Cloth* cloth = nullptr;
  const Drape* drape = nullptr;
};

/// Metres, z up; vt are (u, v) in metres; a group a piece.
std::string obj(const DrapedGarment& draped);
/// Binary little-endian; positions, uv, strains and pressure as vertex properties.
std::string ply(const DrapedGarment& draped);
/// VTK's XML format in ASCII; strains and stresses of each triangle, uv and pressure of each point.
std::string vtu(const DrapedGarment& draped);
/// glTF 2.0 binary, y up as its convention has it; the textile's repeat as an embedded PNG texture.
std::string glb(const DrapedGarment& draped);
/// Both meshes as JSON: points_m, triangles, warp, sewn vertices, edges, topology.
std::string mesh_json(const Garment& garment, const SewnMesh& mesh);

/// The flat pattern at true scale in millimetres: outlines, seam allowances, names, grain, folds, notches, darts and
/// which edge is sewn to which.
std::string pattern_svg(const Garment& garment);
std::string pattern_json(const Garment& garment);
/// The pattern in one of its sizes.
struct SizedGarment {
  std::string size;
  Garment garment;
};
/// All sizes nested: every piece once, its sizes drawn over each other about the origin of its drawing.
std::string nested_svg(const std::vector<SizedGarment>& sizes);
/// The same for cutters and pattern programs: DXF in millimetres, a block a piece, layers as the apparel standards have
/// them.
std::string pattern_dxf(const Garment& garment);

/// The order of sewing, step by step, with lengths, allowances, notches and directions of pressing.
std::string sewing_text(const Garment& garment);
std::string sewing_json(const Garment& garment);

}  // namespace toile
