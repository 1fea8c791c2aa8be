// Pictures of a draped cloth on its body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/pattern/textile.hpp"
#include "runtime/body/body.hpp"
#include "runtime/field/field.hpp"
#include "runtime/mesh/cloth.hpp"
#include "runtime/png/png.hpp"

namespace toile {

enum class View { Front, Back, Left, Right, Above, ThreeQuarter };

struct RenderOptions {
  int width = 800, height = 800;
  View view = View::ThreeQuarter;
  int samples = 16;  // a pixel, stratified and seeded by the pixel: deterministic
};

/// One draped cloth in the scene.
struct DressedCloth {
  const Cloth* cloth = nullptr;
  const std::vector<Vec3>* positions = nullptr;
  Textile textile;
  std::optional<Field> shown;  // false colours with a scale instead of the textile
  std::optional<int> only{};   // the triangles of this fabric; without it all
};

Image render(const std::vector<DressedCloth>& cloths, const Body* body, const RenderOptions& options);

}  // namespace toile
