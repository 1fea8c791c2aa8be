// What may stand behind a dot: modules and their definitions, bodies and their lines, results and their fields.
#include <algorithm>

#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/measurements.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/sewn_lengths.hpp"
#include "compiler/units/unit.hpp"

namespace toile {
namespace {

struct Access {
  Session& session;
  const Module& module;  // where it is written
  const syntax::Token& name;
  std::string text;

  Value unknown(const std::string& message, const std::vector<std::string>& known,
                const std::string& code = "E0103") const {
    report_unknown(session, module, name, message, known, code);
    return Unknown{};
  }
};

/// A definition inside of a module, garment, piece, hole or line.
Value defined_in(const Access& access, const Scope& scope, const std::string& owner, const std::string& code) {
  if (Definition* definition = scope.own(access.text)) {
    definition->used = true;
    return force(access.session, *definition);
  }
  return access.unknown(owner + " has no `" + access.text + "`", scope.own_names(), code);
}

Value body_line(const Access& access, const BodyValue& object, Location object_at) {
  std::optional<std::vector<std::string>> stated = line_names(object.body->spec);
  std::vector<std::string> names;
  if (stated) {
    names = *std::move(stated);
  } else {
    const std::vector<BodyLineFacts>* lines = body_lines(access.session, *object.body, object_at);
    if (lines == nullptr) return Unknown{};
    for (const BodyLineFacts& line : *lines) names.push_back(line.name);
  }
  if (std::ranges::find(names, access.text) != names.end()) return BodyLineValue{object.body, access.text};
  const std::string message = "body `" + object.body->spec.name + "` has no line `" + access.text + "`";
  for (const std::string& name : names) {  // by the name of the measurement that is taken there
    if (!same_measurement(name, access.text)) continue;
    access.session.report.add(
        Problem("E0103", message).at(access.module.at(access.name)).help("did you mean `" + name + "`?"));
    return Unknown{};
  }
  return access.unknown(message, names);
}

Value fact_of_line(const Access& access, const BodyLineValue& object, Location object_at) {
  if (access.text == "girth" || access.text == "level") {
    std::optional<BodyLineFacts> line = stated_line(object.body->spec, object.line);
    if (!line) {
      const std::vector<BodyLineFacts>* lines = body_lines(access.session, *object.body, object_at);
      if (lines == nullptr) return Unknown{};
      const auto found = std::ranges::find(*lines, object.line, &BodyLineFacts::name);
      if (found == lines->end()) return Unknown{};
      line = *found;
    }
    return metres(access.text == "girth" ? line->girth : line->level);
  }
  return access.unknown("a line of a body has no `" + access.text + "`", {"girth", "level"});
}

const std::vector<std::pair<std::string, std::string>>& schema_of(const DrapeRecord& record) {
  if (record.develops) return development_schema();
  return record.developed != nullptr ? form_drape_schema() : result_schema();
}

/// The next parts of the schema's names after `prefix`.
std::vector<std::string> fields_after(const DrapeRecord& record, const std::string& prefix) {
  std::vector<std::string> names;
  for (const auto& [name, unit] : schema_of(record)) {
    if (!name.starts_with(prefix)) continue;
    const std::string next = name.substr(prefix.size(), name.find('.', prefix.size()) - prefix.size());
    if (names.empty() || names.back() != next) names.push_back(next);
  }
  return names;
}

Value result_field(const Access& access, const ResultValue& object) {
  Session& session = access.session;
  const DrapeRecord& drape = *object.drape;
  if (session.in_commands && !drape.reached) {
    const std::string made = drape.develops ? "developed" : "draped";
    session.report.add(Problem("E0506", "`" + drape.name + "` is used before it is " + made)
                           .at(access.module.at(access.name), "used here")
                           .also(drape.written, made + " only here"));
    return Unknown{};
  }
  const std::string full = object.prefix + access.text;
  for (const auto& [name, unit_name] : schema_of(drape)) {
    if (name.starts_with(full + ".")) return ResultValue{object.drape, full + "."};
    if (name != full) continue;
    const Unit unit = parse_unit(unit_name).value_or(Unit{});
    if (!drape.result) return {Quantity{unit.dimension, 0, unit.percent}, false};
    const auto found = drape.result->find(full);
    if (found != drape.result->end()) return Quantity{unit.dimension, found->second, unit.percent};
    session.report.add(Problem("E0506", "this drape's result has no `" + full + "`").at(access.module.at(access.name)));
    return Unknown{};
  }
  const std::string owner = object.prefix.empty() ? drape.name : drape.name + "." + object.prefix;
  std::string shown = owner;
  if (shown.ends_with('.')) shown.pop_back();
  return access.unknown("`" + shown + "` has no field `" + access.text + "`", fields_after(drape, object.prefix));
}

Value field_of(const Access& access, const RecordValue& record) {
  std::vector<std::string> names;
  for (const RecordValue::Field& field : *record.fields) {
    if (field.name == access.text) return field.value;
    names.push_back(field.name);
  }
  for (const RecordValue::Field& field : *record.fields) {
    if (same_measurement(field.name, access.text)) return field.value;
  }
  return access.unknown("this record has no field `" + access.text + "`", names);
}

Value coordinate(const Value& object, std::string_view name) {
  const bool known = object.known();
  if (const auto* point = object.as<Point>()) {
    if (name == "x") return {Quantity{point->dimension, point->at.x}, known};
    if (name == "y") return {Quantity{point->dimension, point->at.y}, known};
  }
  if (const auto* point = object.as<Point3>()) {
    if (name == "x") return {Quantity{point->dimension, point->at[0]}, known};
    if (name == "y") return {Quantity{point->dimension, point->at[1]}, known};
    if (name == "z") return {Quantity{point->dimension, point->at[2]}, known};
  }
  return Unknown{};
}

Value end_of_curve(const Access& access, const PlaneCurve& object) {
  const bool known = object.curve != nullptr;
  if (access.text == "start") return {Point{dimension::length, known ? object.curve->start() : Vec2{}}, known};
  if (access.text == "end") return {Point{dimension::length, known ? object.curve->end() : Vec2{}}, known};
  return access.unknown("a curve has no field `" + access.text + "`", {"start", "end"});
}

}  // namespace

Value member(Session& session, const Scope& scope, const Value& object, const syntax::Token& name, Location object_at) {
  const Access access{session, scope.module(), name, session.name_of(scope.module(), name)};
  if (object.unknown()) return object;
  if (const auto* module = object.as<ModuleRef>()) {
    return defined_in(access, *(*module)->scope, "module `" + (*module)->name + "`", "E0101");
  }
  if (const auto* garment = object.as<GarmentRef>()) {
    return defined_in(access, *(*garment)->scope, "garment `" + (*garment)->draft.name + "`", "E0103");
  }
  if (const auto* piece = object.as<PieceRef>()) {
    if (access.text == "sewn" && (*piece)->scope->own("sewn") == nullptr) return sewn_lengths(session, **piece);
    const bool whole = !(*piece)->outer->module().broken((*piece)->written.span());
    if (!whole && (*piece)->scope->own(access.text) == nullptr) return Unknown{};  // it may stand in what was not read
    return defined_in(access, *(*piece)->scope, "piece `" + (*piece)->name + "`", "E0103");
  }
  if (const auto* inner = object.as<InnerRef>()) {
    return defined_in(access, *(*inner)->scope, std::string((*inner)->kind()) + " `" + (*inner)->name + "`", "E0103");
  }
  if (const auto* record = object.as<RecordValue>()) return field_of(access, *record);
  if (const auto* body = object.as<BodyValue>()) return body_line(access, *body, object_at);
  if (const auto* line = object.as<BodyLineValue>()) return fact_of_line(access, *line, object_at);
  if (const auto* result = object.as<ResultValue>()) return result_field(access, *result);
  if (const auto* curve = object.as<PlaneCurve>()) return end_of_curve(access, *curve);
  if (object.as<Point>() != nullptr || object.as<Point3>() != nullptr) {
    Value value = coordinate(object, access.text);
    if (!value.unknown()) return value;
    std::vector<std::string> names{"x", "y"};
    if (object.as<Point3>() != nullptr) names.emplace_back("z");
    return access.unknown(describe(object) + " has no field `" + access.text + "`", names);
  }
  session.report.add(Problem("E0103", describe(object) + " has no fields, so no `" + access.text + "`")
                         .at(scope.module().at(name))
                         .also(object_at, describe(object)));
  return Unknown{};
}

}  // namespace toile
