#include "compiler/evaluate/body_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/want.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

/// One part of a body and its properties by name.
class PartReader {
 public:
  PartReader(Session& session, const Scope& scope, const syntax::BodyPart& part, BodyInstance& body)
      : session_(session), wanted_{session, scope}, module_(scope.module()), part_(part), body_(body) {}

  void read() {
    const auto role = part_.role();
    if (!role) return;
    name_ = session_.name_of(module_, part_.name());
    switch (role->kind()) {
      case syntax::Kind::KwSection:
        return read_section();
      case syntax::Kind::KwLimb:
        return read_limb();
      case syntax::Kind::KwLine:
        return read_line();
      default:
        break;
    }
    if (session_.text(module_, *role) == "surface") return read_surface();
    report_unknown(session_, module_, *role, fmt::format("a body has no part `{}`", session_.text(module_, *role)),
                   {"section", "limb", "line", "surface"}, "E0103");
    body_.sound = false;
  }

 private:
  std::string described(const std::string& role) const { return role + (name_.empty() ? "" : " `" + name_ + "`"); }

  /// Reports properties that the part does not have, and those given twice.
  void check_names(const std::vector<std::string>& known, const std::string& role) {
    std::vector<std::string> seen;
    for (const syntax::Property& property : part_.properties()) {
      const auto token = property.name();
      if (!token) continue;
      const std::string name = session_.name_of(module_, token);
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        report_unknown(session_, module_, *token, fmt::format("a {} has no `{}`", role, name), known, "E0103");
        body_.sound = false;
      } else if (std::find(seen.begin(), seen.end(), name) != seen.end()) {
        session_.report.add(Problem("E0102", "`" + name + "` is given twice").at(module_.at(*token)));
        body_.sound = false;
      }
      seen.push_back(name);
    }
  }

  std::optional<syntax::Expr> property(const std::string& name) const {
    for (const syntax::Property& each : part_.properties()) {
      if (session_.name_of(module_, each.name()) == name) return each.value();
    }
    return std::nullopt;
  }

  bool given(const std::string& name) const {
    for (const syntax::Property& each : part_.properties()) {
      if (session_.name_of(module_, each.name()) == name) return true;
    }
    return false;
  }

  /// A property that may be left out: then `place` keeps its value.
  void read_into(double& place, const std::string& name, Dimension dim, const std::string& role, bool positive) {
    if (!given(name)) return;
    const std::string what = "the " + name + " of a " + role;
    const auto value =
        positive ? wanted_.positive(property(name), dim, what) : wanted_.quantity(property(name), dim, what);
    if (value) {
      place = *value;
    } else {
      body_.sound = false;
    }
  }

  void read_required(double& place, const std::string& name, Dimension dim, const std::string& role) {
    if (given(name)) return read_into(place, name, dim, role, true);
    if (place > 0) return;  // a variation keeps what its body has
    body_.sound = false;
    if (module_.broken(part_.span())) return;
    session_.report.add(Problem("E0408", fmt::format("{} needs `{}`", described(role), name)).at(module_.at(part_)));
  }

  FormSpec* form(const std::string& role) {
    if (auto* spec = std::get_if<FormSpec>(&body_.spec.shape)) return spec;
    session_.report.add(Problem("E0408", "only a dress form has a " + role + ", and this body is made otherwise")
                            .at(module_.at(part_)));
    body_.sound = false;
    return nullptr;
  }

  void read_section() {
    check_names({"girth", "ratio", "forward", "squareness"}, "section");
    FormSpec* spec = form("section");
    if (spec == nullptr) return;
    BodySection section;
    const auto earlier = std::find_if(spec->sections.begin(), spec->sections.end(),
                                      [&](const BodySection& other) { return !name_.empty() && other.name == name_; });
    if (earlier != spec->sections.end()) section = *earlier;
    section.name = name_;
    section.written = module_.at(part_);
    if (const auto at = part_.at()) {
      const auto level = wanted_.not_negative(at, dimension::length, "the level of a section");
      if (level) section.level = *level;
      if (!level) body_.sound = false;
    } else if (earlier == spec->sections.end()) {
      body_.sound = false;
      if (!module_.broken(part_.span())) {
        session_.report.add(Problem("E0408", described("section") + " does not say at what level it lies")
                                .at(module_.at(part_))
                                .help("section waist at 104cm { girth 68cm }"));
      }
    }
    read_required(section.girth, "girth", dimension::length, "section");
    read_into(section.width_to_depth, "ratio", dimension::number, "section", true);
    read_into(section.forward, "forward", dimension::length, "section", false);
    read_into(section.squareness, "squareness", dimension::number, "section", true);
    if (earlier != spec->sections.end()) {
      *earlier = section;
    } else {
      spec->sections.push_back(section);
    }
  }

  void read_limb() {
    check_names({"root", "tip", "length", "angle"}, "limb");
    FormSpec* spec = form("limb");
    if (spec == nullptr) return;
    if (name_ != "arm" && name_ != "leg") {
      const auto token = part_.name();
      session_.report.add(Problem("E0408", "a limb is an arm or a leg")
                              .at(token ? module_.at(*token) : module_.at(part_))
                              .help("limb arm { root 34cm, tip 28cm, length 15cm, angle 40deg }"));
      body_.sound = false;
      return;
    }
    BodyLimb limb;
    limb.kind = name_ == "arm" ? BodyLimb::Kind::Arm : BodyLimb::Kind::Leg;
    const auto earlier = std::find_if(spec->limbs.begin(), spec->limbs.end(),
                                      [&](const BodyLimb& other) { return other.kind == limb.kind; });
    if (earlier != spec->limbs.end()) limb = *earlier;
    read_required(limb.girth_root, "root", dimension::length, "limb");
    read_required(limb.girth_tip, "tip", dimension::length, "limb");
    read_required(limb.length, "length", dimension::length, "limb");
    read_into(limb.angle, "angle", dimension::angle, "limb", false);
    if (earlier != spec->limbs.end()) {
      *earlier = limb;
    } else {
      spec->limbs.push_back(limb);
    }
  }

  std::optional<std::array<double, 3>> vector(const std::string& name, bool direction) {
    const auto expr = property(name);
    const Value value = evaluate(session_, wanted_.scope, expr);
    if (value.unknown()) {
      body_.sound = false;
      if (given(name) || module_.broken(part_.span())) return std::nullopt;
      session_.report.add(Problem("E0408", fmt::format("{} needs `{}`", described("line"), name))
                              .at(module_.at(part_))
                              .help("line waist { through (0cm, 0cm, 105cm), normal (0, 0, 1) }"));
      return std::nullopt;
    }
    const auto* point = value.as<Point3>();
    const bool fits =
        point != nullptr && (point->dimension == dimension::length || (direction && point->dimension.plain()));
    if (!fits) {
      wanted_.wrong(*expr, value, "`" + name + "` of a line", "a point in space");
    } else if (direction && std::hypot(point->at[0], point->at[1], point->at[2]) == 0) {
      session_.report.add(Problem("E0208", "a direction cannot be zero").at(module_.at(*expr)));
    } else if (wanted_.there(*expr, value, "a body")) {
      return point->at;
    }
    body_.sound = false;
    return std::nullopt;
  }

  void read_line() {
    check_names({"through", "normal"}, "line");
    auto* spec = std::get_if<MeshSpec>(&body_.spec.shape);
    if (spec == nullptr) {
      session_.report.add(
          Problem("E0408", "lines are cut out of imported bodies; this body has its own").at(module_.at(part_)));
      body_.sound = false;
      return;
    }
    const auto through = vector("through", false);
    const auto normal = vector("normal", true);
    if (!through || !normal) return;
    const bool taken = std::any_of(spec->lines.begin(), spec->lines.end(),
                                   [&](const MeshSpec::Line& line) { return line.name == name_; });
    if (taken) {
      session_.report.add(Problem("E0102", described("line") + " is defined twice").at(module_.at(part_)));
      body_.sound = false;
      return;
    }
    const double size = std::hypot((*normal)[0], (*normal)[1], (*normal)[2]);
    spec->lines.push_back({name_, (*through)[0], (*through)[1], (*through)[2], (*normal)[0] / size, (*normal)[1] / size,
                           (*normal)[2] / size});
  }

  void read_surface() {
    check_names({"softness", "friction"}, "surface");
    read_into(body_.spec.softness, "softness", dimension::softness, "surface", true);
    if (!given("friction")) return;
    const auto friction = wanted_.not_negative(property("friction"), dimension::number, "the friction of a surface");
    if (friction) body_.spec.friction = *friction;
    if (!friction) body_.sound = false;
  }

  Session& session_;
  Wanted wanted_;
  const Module& module_;
  const syntax::BodyPart& part_;
  BodyInstance& body_;
  std::string name_;
};

/// Files are numbered from the script on, so what is imported has the higher number, and was there before.
bool written_before(const Location& a, const Location& b) {
  return std::pair(b.file, a.span.begin) < std::pair(a.file, b.span.begin);
}

/// Sections may be written in any order; no two lie at one level.
void order_sections(Session& session, FormSpec& form, BodyInstance& body) {
  auto& sections = form.sections;
  std::stable_sort(sections.begin(), sections.end(),
                   [](const BodySection& a, const BodySection& b) { return a.level < b.level; });
  for (std::size_t i = 1; i < sections.size() && body.sound; ++i) {
    if (sections[i].level > sections[i - 1].level) continue;
    body.sound = false;
    // The later one in the text is at fault.
    const auto [first, second] = std::minmax(sections[i - 1].written, sections[i].written, written_before);
    session.report.add(Problem("E0408", fmt::format("two sections of `{}` lie at the same level of {}", body.spec.name,
                                                    format_quantity(sections[i].level, dimension::length)))
                           .at(second, "at this level")
                           .also(first, "lies here already"));
  }
}

/// One block says each part once: a section of that name again would silently replace the one above.
bool said_once(Session& session, const Module& module, const std::vector<syntax::BodyPart>& parts) {
  std::map<std::string, Location> said;
  bool once = true;
  for (const syntax::BodyPart& part : parts) {
    if (!part.role() || !part.name()) continue;
    const std::string name = session.name_of(module, part.role()) + " `" + session.name_of(module, part.name()) + "`";
    const auto [earlier, is_new] = said.try_emplace(name, module.at(*part.name()));
    if (is_new) continue;
    once = false;
    session.report.add(Problem("E0102", name + " is defined twice")
                           .at(module.at(*part.name()), "defined again here")
                           .also(earlier->second, "first defined here"));
  }
  return once;
}

}  // namespace

void apply_parts(Session& session, const Scope& scope, const std::vector<syntax::BodyPart>& parts, BodyInstance& body) {
  if (!said_once(session, scope.module(), parts)) {
    body.sound = false;
    return;
  }
  for (const syntax::BodyPart& part : parts) PartReader(session, scope, part, body).read();
  if (auto* form = std::get_if<FormSpec>(&body.spec.shape)) order_sections(session, *form, body);
}

}  // namespace toile
