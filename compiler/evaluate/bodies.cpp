#include "compiler/evaluate/bodies.hpp"

#include <fmt/format.h>

#include "compiler/evaluate/body_parts.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/measurements.hpp"
#include "compiler/evaluate/names.hpp"

namespace toile {
namespace {

std::vector<syntax::BodyPart> parts_of(const syntax::Body& written) {
  std::vector<syntax::BodyPart> parts;
  for (const syntax::View item : syntax::items(written)) {
    if (const auto part = syntax::as<syntax::BodyPart>(item)) parts.push_back(*part);
  }
  return parts;
}

void define_lets(Session& session, Scope& inside, const syntax::Body& written) {
  for (const syntax::View item : syntax::items(written)) {
    const auto let = syntax::as<syntax::Let>(item);
    if (!let) continue;
    define(session, inside, let->name(),
           [&session, &inside, expr = let->value()] { return evaluate(session, inside, expr); });
  }
}

/// Asks about measurements, the default ones among them, that are hardly those of one figure; false for impossible
/// ones.
bool check_figure(Session& session, const Scope& inside, const std::string& name,
                  const std::vector<std::optional<Given>>& arguments) {
  std::vector<Measured> measured;
  for (std::size_t i = 0; i < inside.definitions().size(); ++i) {
    Definition& parameter = *inside.definitions()[i];
    const bool given = i < arguments.size() && arguments[i].has_value();
    measured.push_back({parameter.name, force(session, parameter), given ? arguments[i]->at : parameter.at, given});
  }
  return check_measurements(session, fmt::format("body `{}`", name), measured);
}

/// A form of the sections and limbs in its braces.
Value form_of(Session& session, const Scope& scope, const syntax::Body& written, const std::string& name,
              const std::vector<std::optional<Given>>& arguments) {
  auto body = std::make_shared<BodyInstance>();
  body->spec.name = name;
  body->spec.written = scope.module().at(written);
  body->spec.shape = FormSpec{};
  Scope inside(scope.module(), &scope, true);
  if (const auto parameters = written.parameters()) {
    define_parameters(session, inside, *parameters, arguments);
    if (!check_figure(session, inside, name, arguments)) return Unknown{};
  }
  define_lets(session, inside, written);
  apply_parts(session, inside, parts_of(written), *body);
  for (const auto& definition : inside.definitions()) force(session, *definition);
  const auto& form = std::get<FormSpec>(body->spec.shape);
  if (body->sound && form.sections.size() < 2 && !scope.module().broken(written.span())) {
    session.report.add(
        Problem("E0408", fmt::format("body `{}` needs two sections or more", name)).at(scope.module().at(written)));
    body->sound = false;
  }
  return body->sound ? Value{BodyValue{body}} : Value{};
}

/// A copy of another body under a new name, with changes.
Value variation(Session& session, const Scope& scope, const syntax::Body& written, const std::string& name) {
  const auto base_expr = written.base();
  const Value base = evaluate(session, scope, base_expr);
  if (base.unknown()) return Unknown{};
  const std::shared_ptr<BodyInstance> original = as_body(session, base, scope.module().at(*base_expr));
  if (original == nullptr) return Unknown{};
  auto body = std::make_shared<BodyInstance>();
  body->spec = original->spec;
  body->spec.name = name;
  body->spec.written = scope.module().at(written);
  apply_parts(session, scope, parts_of(written), *body);
  return body->sound ? Value{BodyValue{body}} : Value{};
}

}  // namespace

void define_body(Session& session, Scope& scope, const syntax::Body& written) {
  const std::string name = session.name_of(scope.module(), written.name());
  if (written.parameters()) {
    session.body_templates.push_back({written, &scope, name});
    define(session, scope, written.name(),
           [body = BodyTemplateRef{&session.body_templates.back()}]() -> Value { return body; });
    return;
  }
  define(session, scope, written.name(), [&session, &scope, written, name]() -> Value {
    return written.base() ? variation(session, scope, written, name) : form_of(session, scope, written, name, {});
  });
}

Value instantiate(Session& session, const BodyTemplate& body, const std::vector<std::optional<Given>>& arguments) {
  const Holding<int> for_real(session.supposing, 0);
  for (const auto& argument : arguments) {
    if (argument && !argument->value.known()) return Unknown{};
  }
  return form_of(session, *body.scope, body.written, body.name, arguments);
}

std::shared_ptr<BodyInstance> as_body(Session& session, const Value& value, Location at) {
  if (value.unknown()) return nullptr;
  if (const auto* body = value.as<BodyValue>()) return body->body;
  if (const auto* form = value.as<BodyTemplateRef>()) {
    const auto formals = formals_of(session, (*form)->scope->module(), (*form)->written.parameters());
    for (const Formal& formal : formals) {
      if (formal.optional) continue;
      session.report.add(
          Problem("E0108", fmt::format("body `{}` needs `{}`", (*form)->name, formal.name)).at(at, "not given here"));
      return nullptr;
    }
    const Value made = instantiate(session, **form, {});
    const auto* body = made.as<BodyValue>();
    return body == nullptr ? nullptr : body->body;
  }
  session.report.add(Problem("E0202", "a body is wanted here, and this is " + describe(value)).at(at, describe(value)));
  return nullptr;
}

const std::vector<BodyLineFacts>* body_lines(Session& session, BodyInstance& body, Location at) {
  if (body.lines) return &*body.lines;
  if (!body.sound) return nullptr;
  auto measured = session.world.measure(body.spec);
  if (const auto* trouble = std::get_if<std::string>(&measured)) {
    body.sound = false;
    session.report.add(Problem("E0407", fmt::format("body `{}` cannot be made: {}", body.spec.name, *trouble))
                           .at(body.spec.written, "this body")
                           .also(at, "wanted here"));
    return nullptr;
  }
  body.lines = std::get<std::vector<BodyLineFacts>>(std::move(measured));
  return &*body.lines;
}

std::optional<std::vector<std::string>> line_names(const BodySpec& body) {
  const auto* form = std::get_if<FormSpec>(&body.shape);
  if (form == nullptr) return std::nullopt;
  std::vector<std::string> names;
  bool has_waist = false;
  for (const BodySection& section : form->sections) {
    if (!section.name.empty()) names.push_back(section.name);
    has_waist = has_waist || section.name == "waist";
  }
  const auto add_pair = [&names](const std::string& name) {
    names.push_back("left_" + name);
    names.push_back("right_" + name);
  };
  for (const BodyLimb& limb : form->limbs) {
    if (limb.kind == BodyLimb::Kind::Arm) add_pair("armhole");
    if (limb.kind == BodyLimb::Kind::Leg) add_pair("leg");
    if (limb.kind == BodyLimb::Kind::Leg && has_waist) add_pair("crotch");
  }
  return names;
}

std::optional<BodyLineFacts> stated_line(const BodySpec& body, const std::string& name) {
  const auto* form = std::get_if<FormSpec>(&body.shape);
  if (form == nullptr) return std::nullopt;
  for (const BodySection& section : form->sections) {
    const bool possible = section.girth >= 0.05 && section.girth <= 5;  // else the body's making says what is wrong
    if (section.name == name && possible) return BodyLineFacts{name, section.girth, section.level};
  }
  return std::nullopt;
}

int index_of(Session& session, BodyInstance& body) {
  if (body.index < 0) {
    body.index = static_cast<int>(session.bodies.size());
    session.bodies.push_back(body.spec);
  }
  return body.index;
}

}  // namespace toile
