// Trousers: cloth below a line that runs between the legs.
#pragma once

#include <vector>

#include "runtime/place/hanging_chain.hpp"
#include "runtime/place/rest_mesh.hpp"

namespace toile {

/// Whether a line runs up and down the limb more than around it, as the crotch-waist lines do: seen along the axis it
/// is much shorter than it is. Layers at one distance from such a line are not level.
bool runs_along_axis(const BodyLine& line);

/// A chain worn at such a line shares vertices with chains worn at others: the ends of the crotch seam lie on the
/// waist. They stay where the other line has them, and what lies between is spread evenly along the body's line, the
/// way round that is more nearly as long.
void run_between_other_lines(std::vector<HungLine>& hung);

/// The chains of all lines cut the cloth into parts; a part that such a line bounds goes along the leg on its side,
/// other parts keep to their lines. Positions of chains are known.
void assign_legs(const RestMesh& rest, const std::vector<int>& members, const std::vector<HungLine>& hung,
                 std::vector<int>& line_of);

/// Fills the positions of the cloth about one leg, hung[leg]'s. A vertex's level agrees with the body's along the
/// chains and grows by the lengths on the cloth at rest from there to the hem; its place around is the harmonic angle
/// about the leg's middle. Cloth of two legs is kept apart by the plane between them.
void place_leg(const RestMesh& rest, const std::vector<HungLine>& hung, int leg, const std::vector<int>& line_of,
               const Body& body, double clearance, std::vector<Vec3>& positions);

}  // namespace toile
