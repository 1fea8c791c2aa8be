#include "runtime/driver/outputs.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "runtime/develop/grain_study.hpp"
#include "runtime/export/pattern_text.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/report/report.hpp"

namespace toile {
namespace {

bool ends_with(const std::filesystem::path& path, std::string_view ending) {
  const std::string name = path.filename().string();
  return name.size() > ending.size() && std::string_view(name).substr(name.size() - ending.size()) == ending;
}

using DrapeWriter = std::string (*)(const Draped&, const std::string& script);
/// The first ending that fits counts: the report before plain JSON.
constexpr std::array<std::pair<std::string_view, DrapeWriter>, 6> drape_writers{{
    {".obj", [](const Draped& d, const std::string&) { return obj(d.view()); }},
    {".ply", [](const Draped& d, const std::string&) { return ply(d.view()); }},
    {".vtu", [](const Draped& d, const std::string&) { return vtu(d.view()); }},
    {".glb", [](const Draped& d, const std::string&) { return glb(d.view()); }},
    {".report.json", [](const Draped& d, const std::string& script) { return report_json(script, d.view()); }},
    {".json", [](const Draped& d, const std::string&) { return mesh_json(d.made->garment, d.made->mesh); }},
}};

using PatternWriter = std::string (*)(const Garment&);
constexpr std::array<std::pair<std::string_view, PatternWriter>, 3> pattern_writers{{
    {".svg", pattern_svg},
    {".dxf", pattern_dxf},
    {".json", pattern_json},
}};

constexpr std::array<std::pair<std::string_view, PatternWriter>, 2> sewing_writers{{
    {".txt", sewing_text},
    {".json", sewing_json},
}};

template <class Writers>
auto writer_for(const Writers& writers, const std::filesystem::path& path) -> decltype(writers.front().second) {
  for (const auto& [ending, writer] : writers) {
    if (ends_with(path, ending)) return writer;
  }
  return nullptr;
}

template <class Writers>
std::string listed(const Writers& writers) {
  std::string text;
  for (const auto& [ending, writer] : writers) {
    if (!text.empty()) text += ", ";
    text += ending;
  }
  return text;
}

constexpr std::array<std::pair<const char*, View>, 6> views{{{"front", View::Front},
                                                             {"back", View::Back},
                                                             {"left", View::Left},
                                                             {"right", View::Right},
                                                             {"above", View::Above},
                                                             {"three_quarter", View::ThreeQuarter}}};

}  // namespace

std::optional<std::string> drape_file(const std::filesystem::path& path, const Draped& draped,
                                      const std::string& script) {
  const DrapeWriter writer = writer_for(drape_writers, path);
  return writer == nullptr ? std::nullopt : std::optional(writer(draped, script));
}

std::string development_report(const Developed& developed, const std::string& script) {
  const MadeGarment& drawn = *developed.drawn;
  const int triangles =
      static_cast<int>(drawn.mesh.p.triangles.size() / std::max<std::size_t>(1, drawn.garment.pieces.size()));
  return report_json(
      script, developed.on_form.view(), developed.development, developed.redrawn,
      {developed.proposed, developed.tried, without_each_dart(developed.draft, *developed.on_form.body, triangles, {})},
      study_grain(drawn.mesh, make_law(drawn.garment.fabric), developed.development, {}));
}

std::optional<std::string> development_file(const std::filesystem::path& path, const Developed& developed,
                                            const std::string& script) {
  if (ends_with(path, ".toile")) {
    std::vector<std::string> notes;
    for (const ProposedDart& dart : developed.proposed) {
      notes.push_back("Proposed where " + dart.piece + " is drawn on the body: " + slit_text(dart.dart));
    }
    for (const TriedDart& dart : developed.tried) {
      notes.push_back("Only tried where " + dart.piece + " is drawn on the body: " + slit_text(dart.dart));
    }
    return pattern_text(developed.redrawn, std::filesystem::path(script).filename().string(), notes);
  }
  if (ends_with(path, ".report.json")) return development_report(developed, script);
  if (auto pattern = pattern_file(path, developed.pattern)) return pattern;
  return drape_file(path, developed.on_form, script);
}

std::optional<std::string> pattern_file(const std::filesystem::path& path, const Garment& garment) {
  const PatternWriter writer = writer_for(pattern_writers, path);
  return writer == nullptr ? std::nullopt : std::optional(writer(garment));
}

std::optional<std::string> sewing_file(const std::filesystem::path& path, const Garment& garment) {
  const PatternWriter writer = writer_for(sewing_writers, path);
  return writer == nullptr ? std::nullopt : std::optional(writer(garment));
}

std::string sewing_endings() {
  return listed(sewing_writers);
}

bool is_development_file(const std::filesystem::path& path) {
  return ends_with(path, ".toile") || is_pattern_file(path) || is_drape_file(path);
}

std::string drape_endings() {
  return listed(drape_writers);
}
std::string pattern_endings() {
  return listed(pattern_writers);
}
bool is_drape_file(const std::filesystem::path& path) {
  return writer_for(drape_writers, path) != nullptr;
}
bool is_pattern_file(const std::filesystem::path& path) {
  return writer_for(pattern_writers, path) != nullptr;
}

std::optional<View> view_named(const std::string& name) {
  if (name.empty()) return View::ThreeQuarter;
  for (const auto& [known, view] : views) {
    if (name == known) return view;
  }
  return std::nullopt;
}

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& [name, view] : views) list.emplace_back(name);
    return list;
  }();
  return names;
}

std::string picture(const Draped& draped, const PictureRequest& request) {
  const Garment& garment = draped.made->garment;
  std::vector<DressedCloth> dressed;
  const DressedCloth all{&draped.made->cloth, &draped.drape.positions, garment.textile, std::nullopt};
  if (!request.field.empty()) {
    dressed.push_back(all);
    dressed.back().shown = field(request.field, draped.made->cloth, draped.drape);
  }
  for (std::size_t layer = 0; request.field.empty() && layer < garment.layers.size(); ++layer) {
    dressed.push_back(all);
    dressed.back().textile = garment.layers[layer].textile;
    dressed.back().only = static_cast<int>(layer);
  }
  if (dressed.empty()) dressed.push_back(all);
  RenderOptions options;
  options.width = request.width;
  options.height = request.height;
  options.view = request.view;
  return png(render(dressed, draped.body.get(), options));
}

}  // namespace toile
