// render and export: what is written where.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/commands.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/garments.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

const std::vector<std::string> views{"front", "back", "left", "right", "above", "three_quarter"};

/// Fields of the drape that can be shown as colours (runtime/field).
const std::vector<std::string> shown_fields{"strain.warp",     "strain.weft",     "strain.shear",   "stress.warp",
                                            "stress.weft",     "stress.shear",    "curvature.warp", "curvature.weft",
                                            "curvature.twist", "contact.pressure"};

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

/// The path without "." parts and doubled slashes, or nothing when it leaves the output folder.
std::optional<std::string> inside_folder(const std::string& path) {
  if (path.empty() || path.front() == '/' || path.back() == '/' || path.find('\\') != std::string::npos) return {};
  if (path.size() > 1 && path[1] == ':') return {};
  std::string clean;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string part = path.substr(begin, end - begin);
    if (part == "..") return {};
    if (!part.empty() && part != ".") clean += (clean.empty() ? "" : "/") + part;
    begin = end + 1;
  }
  if (clean.empty()) return {};
  return clean;
}

std::string extension(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const std::size_t slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  return path.substr(dot + 1);
}

std::string listed(const std::vector<std::string>& extensions) {
  std::string text;
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    if (i > 0) text += i + 1 == extensions.size() ? " or " : ", ";
    text += "." + extensions[i];
  }
  return text;
}

}  // namespace

std::optional<std::string> Commands::output_path(const std::optional<syntax::Expr>& path, const std::string& what,
                                                 const std::vector<std::string>& extensions) {
  const auto text = Wanted{session_, scope()}.text(path, "an output's path");
  if (!text) return std::nullopt;
  const Location at = module().at(*path);
  auto clean = inside_folder(*text);
  if (!clean) {
    session_.report.add(Problem("E0501", fmt::format("\"{}\" is no path inside the output folder", *text))
                            .at(at)
                            .help("outputs have relative paths without `..`: \"pictures/skirt.png\""));
    return std::nullopt;
  }
  if (!contains(extensions, extension(*clean))) {
    session_.report.add(Problem("E0503", fmt::format("{} is written as {}", what, listed(extensions)))
                            .at(at)
                            .help(extension(*clean).empty() ? "the path's ending tells the kind of file" : ""));
    return std::nullopt;
  }
  const auto [earlier, is_new] = outputs_.try_emplace(*clean, at);
  if (is_new) return clean;
  session_.report.add(Problem("E0502", fmt::format("two outputs are called \"{}\"", *clean))
                          .at(at, "overwrites the first")
                          .also(earlier->second, "first written here"));
  return std::nullopt;
}

const DrapeRecord* Commands::result(const syntax::Expr& expr, const Value& value) {
  const auto* found = value.as<ResultValue>();
  if (found != nullptr && found->prefix.empty()) {
    if (found->drape->reached) return found->drape;
    const std::string made = found->drape->develops ? "developed" : "draped";
    session_.report.add(Problem("E0506", "`" + found->drape->name + "` is used before it is " + made)
                            .at(module().at(expr), "used here")
                            .also(found->drape->written, made + " only here"));
    return nullptr;
  }
  if (value.unknown()) return nullptr;
  const bool is_garment = value.as<GarmentRef>() != nullptr || value.as<GarmentTemplateRef>() != nullptr;
  session_.report.add(Problem("E0506", "a drape's result is wanted here, and this is " + describe(value))
                          .at(module().at(expr), describe(value))
                          .help(is_garment ? "drape it and give the result a name: drape skirt on form as worn" : ""));
  return nullptr;
}

void Commands::check_render(Planned& planned, const syntax::Render& render) {
  RenderCommand made;
  made.written = module().at(render);
  const auto subject = render.subject();
  const Value value = evaluate(session_, scope(), subject);
  const DrapeRecord* drape = subject ? result(*subject, value) : nullptr;
  const auto path = output_path(render.path(), "a picture", {"png"});
  bool sound = drape != nullptr && path.has_value();
  for (const syntax::RenderOption& option : render.options()) {
    const auto word = option.word();
    if (!word) continue;
    if (word->kind() == syntax::Kind::KwPixels) {
      const Wanted wanted{session_, scope()};
      const std::vector<syntax::Expr> sizes = option.sizes();
      if (sizes.empty()) continue;
      const auto width = wanted.count(sizes.front(), "the width of a picture in pixels", 8192);
      const auto height = wanted.count(sizes.back(), "the height of a picture in pixels", 8192);
      sound = sound && width && height;
      if (width) made.width = *width;
      if (height) made.height = *height;
      continue;
    }
    std::string name;
    for (const syntax::Token& part : option.names()) {
      name += (name.empty() ? "" : ".") + session_.name_of(module(), part);
    }
    if (name.empty()) continue;
    const bool is_view = word->kind() == syntax::Kind::KwFrom;
    if (!contains(is_view ? views : shown_fields, name)) {
      session_.report.add(
          Problem("E0504", fmt::format("there is no {} `{}`", is_view ? "view" : "field", name))
              .at({module().file, {option.names().front().span().begin, option.names().back().span().end}})
              .help(suggestion(name, is_view ? views : shown_fields)));
      sound = false;
    }
    (is_view ? made.view : made.field) = name;
  }
  if (!sound) return;
  made.result = drape->name;
  made.path = *path;
  planned.command = made;
}

void Commands::check_export(Planned& planned, const syntax::Export& output) {
  ExportCommand made;
  made.written = module().at(output);
  const auto subject = output.subject();
  const Value value = evaluate(session_, scope(), subject);
  if (!subject || value.unknown()) return;
  const bool is_garment = value.as<GarmentRef>() != nullptr || value.as<GarmentTemplateRef>() != nullptr;
  if (is_garment) {
    const GarmentInstance* garment = as_garment(session_, value, module().at(*subject));
    const auto path = output_path(output.path(), "a flat pattern", {"svg", "dxf", "json"});
    if (garment == nullptr || garment->index < 0 || !path) return;
    made.garment = garment->index;
    made.path = *path;
  } else {
    const DrapeRecord* drape = result(*subject, value);
    if (value.as<ResultValue>() == nullptr) return;  // how that would be written nobody knows
    const bool develops = drape != nullptr && drape->develops;
    const auto path = develops ? output_path(output.path(), "a development",
                                             {"toile", "svg", "dxf", "json", "obj", "ply", "vtu", "glb"})
                               : output_path(output.path(), "a drape", {"obj", "ply", "vtu", "glb", "json"});
    if (drape == nullptr || !path) return;
    made.result = drape->name;
    made.path = *path;
  }
  planned.command = made;
}

}  // namespace toile
