// Files by the ending of their names, and pictures by the names of views and fields.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/driver/draped.hpp"
#include "runtime/render/render.hpp"

namespace toile {

/// A drape as .obj, .ply, .vtu, .glb, .report.json (the report) or .json (both meshes); nullopt for another ending.
std::optional<std::string> drape_file(const std::filesystem::path& path, const Draped& draped,
                                      const std::string& script);
std::string development_report(const Developed& developed, const std::string& script);
/// A development as .toile (its pattern as text), .report.json, .svg, .dxf or .json (the pattern), .obj, .ply, .vtu or
/// .glb (the cloth on its form); nullopt for another ending.
std::optional<std::string> development_file(const std::filesystem::path& path, const Developed& developed,
                                            const std::string& script);
/// A flat pattern as .svg, .dxf or .json; nullopt for another ending.
std::optional<std::string> pattern_file(const std::filesystem::path& path, const Garment& garment);
/// The order of sewing as .txt or .json; nullopt for another ending.
std::optional<std::string> sewing_file(const std::filesystem::path& path, const Garment& garment);
std::string sewing_endings();
bool is_development_file(const std::filesystem::path& path);
std::string drape_endings();
std::string pattern_endings();
bool is_drape_file(const std::filesystem::path& path);
bool is_pattern_file(const std::filesystem::path& path);

/// "front", "back", "left", "right", "above", "three_quarter"; the empty name is the default view.
std::optional<View> view_named(const std::string& name);
const std::vector<std::string>& view_names();

struct PictureRequest {
  View view = View::ThreeQuarter;
  std::string field;  // one of field_names(), or empty for the cloth's own colours
  int width = 800, height = 800;
};
/// PNG bytes.
std::string picture(const Draped& draped, const PictureRequest& request);

}  // namespace toile
