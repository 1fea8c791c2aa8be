#pragma once

#include <cstddef>

namespace toile {

/// A mesh index, which is a plain int where meshes are stored, as a subscript.
constexpr std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace toile
