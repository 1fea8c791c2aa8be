// Surfaces from Wavefront OBJ text.
#pragma once

#include <string>
#include <string_view>

#include "runtime/body/body.hpp"

namespace toile {

/// Reads `v` and `f` (polygons of any size as fans; v, v/vt, v//vn, v/vt/vn; negative indices count back) and passes
/// over all else. Vertices that no face uses are dropped. False with `error` ("line 7: …") when the text is not sound.
bool read_obj(std::string_view text, Body::Surface* surface, std::string* error);

}  // namespace toile
