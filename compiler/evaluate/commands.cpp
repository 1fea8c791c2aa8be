#include "compiler/evaluate/commands.hpp"

#include <fmt/format.h>

#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/garments.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/want.hpp"
#include "compiler/units/format.hpp"

namespace toile {

void Commands::define_results() {
  Scope& names = *session_.modules.front()->scope;
  for (const syntax::View& command : module().commands) {
    planned_.push_back({command, nullptr, std::nullopt});
    const auto drape = syntax::as<syntax::Drape>(command);
    const auto develop = syntax::as<syntax::Develop>(command);
    if (!drape && !develop) continue;
    const auto name = drape ? drape->name() : develop->name();
    DrapeRecord& record = session_.drapes.emplace_back();
    record.name = session_.name_of(module(), name);
    record.written = name ? module().at(*name) : module().at(command);
    record.develops = develop.has_value();
    if (drape && drape->garment()) record.developed = development_called(session_.text(module(), *drape->garment()));
    planned_.back().drape = &record;
    if (name) define(session_, names, name, [&record]() -> Value { return ResultValue{&record, ""}; });
  }
}

const DrapeRecord* Commands::development_called(std::string_view name) const {
  for (const DrapeRecord& record : session_.drapes) {
    if (record.develops && record.name == name) return &record;
  }
  return nullptr;
}

void Commands::check() {
  const Holding<bool> in_commands(session_.in_commands, true);
  for (Planned& planned : planned_) {
    if (const auto drape = syntax::as<syntax::Drape>(planned.written)) check_drape(planned, *drape);
    if (const auto develop = syntax::as<syntax::Develop>(planned.written)) check_develop(planned, *develop);
    if (const auto render = syntax::as<syntax::Render>(planned.written)) check_render(planned, *render);
    if (const auto output = syntax::as<syntax::Export>(planned.written)) check_export(planned, *output);
    if (const auto print = syntax::as<syntax::Print>(planned.written)) check_print(*print);
    if (const auto expect = syntax::as<syntax::Expect>(planned.written)) check_expect(*expect);
  }
}

void Commands::check_drape(Planned& planned, const syntax::Drape& drape) {
  planned.drape->reached = true;
  DrapeCommand made;
  made.written = module().at(drape);
  made.name = planned.drape->name;
  bool sound = true;
  if (put_the_wrong_way_round(drape)) return;
  const auto garment_expr = drape.garment();
  const bool of_development = planned.drape->developed != nullptr;
  std::shared_ptr<BodyInstance> body;
  if (const auto body_expr = drape.body()) {
    body = as_body(session_, evaluate(session_, scope(), body_expr), module().at(*body_expr));
    sound = body != nullptr;
  }
  if (const auto accuracy_expr = drape.accuracy()) {
    made.accuracy = Wanted{session_, scope()}.positive(accuracy_expr, dimension::number, "the accuracy of a drape");
    sound = sound && made.accuracy.has_value();
    if (made.accuracy && *made.accuracy > 0.1) {
      sound = false;
      session_.report.add(Problem("E0209", "the accuracy of a drape is the relative residual, 0.1 at most")
                              .at(module().at(*accuracy_expr))
                              .help("drape skirt on form as worn to 1e-6"));
    }
  }
  if (of_development && sound) return check_drape_of_development(planned, drape, std::move(made));
  if (!garment_expr || of_development) return;
  std::vector<syntax::Expr> garments = drape.over();
  garments.insert(garments.begin(), *garment_expr);
  std::vector<int> outside_in;
  for (const syntax::Expr& expr : garments) {
    const GarmentInstance* garment = draped_garment(expr);
    if (garment == nullptr) return;
    if (sound && !module().broken(drape.span())) check_bodies(drape, *garment, body.get());
    if (garment->index >= 0) outside_in.push_back(garment->index);
  }
  if (!sound || outside_in.size() < garments.size()) return;
  made.garment = outside_in.front();
  made.over.assign(outside_in.begin() + 1, outside_in.end());
  made.body = body == nullptr ? -1 : index_of(session_, *body);
  planned.command = made;
}

const GarmentInstance* Commands::draped_garment(const syntax::Expr& expr) {
  const GarmentInstance* garment = as_garment(session_, evaluate(session_, scope(), expr), module().at(expr));
  if (garment == nullptr) return nullptr;
  if (!garment->has_fabric) {
    session_.report.add(
        Problem("E0409", fmt::format("garment `{}` is draped, but not told what it is made of", garment->draft.name))
            .at(module().at(expr), "draped here")
            .also(garment->draft.written, "no fabric here")
            .help(fmt::format("garment {} in fabrics.wool_serge {{ ... }}", garment->draft.name)));
    return nullptr;
  }
  if (garment->drawn_on != nullptr) {
    session_.report.add(
        Problem("E0511", fmt::format("garment `{}` is drawn on `{}`: it has no flat pattern yet that could be draped",
                                     garment->draft.name, garment->drawn_on->spec.name))
            .at(module().at(expr), "draped here")
            .also(garment->draft.written, "drawn on the body")
            .help(fmt::format("develop {} as flat", garment->draft.name)));
    return nullptr;
  }
  return garment;
}

bool Commands::put_the_wrong_way_round(const syntax::Drape& drape) {
  const auto garment = drape.garment(), body = drape.body();
  if (!garment || !body) return false;
  const Value first = evaluate(session_, scope(), garment), second = evaluate(session_, scope(), body);
  const bool swapped = first.as<BodyValue>() != nullptr &&
                       (second.as<GarmentRef>() != nullptr || second.as<GarmentTemplateRef>() != nullptr);
  if (!swapped) return false;
  session_.report.add(
      Problem("E0202", "a garment is draped on a body, and here a body on a garment")
          .at(module().at(*garment), describe(first))
          .also(module().at(*body), describe(second))
          .help(fmt::format("drape {} on {}", session_.text(module(), *body), session_.text(module(), *garment))));
  return true;
}

void Commands::check_bodies(const syntax::Drape& drape, const GarmentInstance& garment, const BodyInstance* body) {
  for (std::size_t i = 0; i < garment.worn_on.size(); ++i) {
    const BodyInstance& worn_on = *garment.worn_on[i];
    if (&worn_on == body) continue;
    const std::string& line = garment.draft.wears[i].line;
    const std::string put = body == nullptr ? "no body" : fmt::format("`{}`", body->spec.name);
    session_.report.add(Problem("E0505", fmt::format("garment `{}` is worn at `{}.{}`, but draped on {}",
                                                     garment.draft.name, worn_on.spec.name, line, put))
                            .at(module().at(drape), "draped here")
                            .also(garment.draft.wears[i].written, "worn here")
                            .help(fmt::format("drape {} on {}", garment.draft.name, worn_on.spec.name)));
    return;
  }
}

void Commands::check_print(const syntax::Print& print) {
  for (const syntax::Expr& value : print.values()) evaluate(session_, scope(), value);
}

void Commands::check_expect(const syntax::Expect& expect) {
  const auto condition = expect.condition();
  const Value value = evaluate(session_, scope(), condition);
  if (value.unknown() || value.as<Truth>() != nullptr || module().broken(expect.span())) return;
  session_.report.add(Problem("E0202", "`expect` needs true or false, and this is " + describe(value))
                          .at(module().at(*condition), describe(value))
                          .help("compare it with something: expect a < b"));
}

std::optional<Command> Commands::next() {
  if (session_.report.has_errors() || next_ >= planned_.size()) return std::nullopt;
  const Holding<bool> in_commands(session_.in_commands, true);
  const Planned& planned = planned_[next_++];
  running_ = planned.drape;
  if (const auto print_command = syntax::as<syntax::Print>(planned.written)) return print(*print_command);
  if (const auto expect_command = syntax::as<syntax::Expect>(planned.written)) return expect(*expect_command);
  return planned.command;
}

void Commands::give(const Result& result) {
  if (running_ != nullptr) running_->result = result;
}

std::set<int> Commands::garments() const {
  std::set<int> found;
  for (const Planned& planned : planned_) {
    if (!planned.command) continue;
    if (const auto* drape = std::get_if<DrapeCommand>(&*planned.command)) {
      found.insert(drape->garment);
      found.insert(drape->over.begin(), drape->over.end());
    }
    if (const auto* develop = std::get_if<DevelopCommand>(&*planned.command)) found.insert(develop->garment);
    if (const auto* flat = std::get_if<ExportCommand>(&*planned.command); flat != nullptr && flat->garment) {
      found.insert(*flat->garment);
    }
  }
  return found;
}

std::optional<Command> Commands::print(const syntax::Print& print) {
  PrintCommand made;
  made.written = module().at(print);
  for (const syntax::Expr& expr : print.values()) {
    const Value value = evaluate(session_, scope(), expr);
    if (session_.report.has_errors()) return std::nullopt;
    made.text += (made.text.empty() ? "" : " ") + format(value);
  }
  return made;
}

namespace {

/// "worn.folds is 7; worn.area is 0.9 m^2" for all comparisons in a condition.
void describe_sides(Session& session, const Scope& scope, const syntax::Expr& expr, std::string& found) {
  const auto add = [&](const syntax::Expr& side) {
    const Value value = evaluate(session, scope, side);
    if (!value.known()) return;
    const std::string written(session.text(scope.module(), side));
    const std::string text = format(value);
    if (text == written) return;
    if (side.kind() == syntax::Kind::Number) return;  // says itself what it is
    found += (found.empty() ? "" : "; ") + written + " is " + text;
  };
  if (const auto unary = syntax::as<syntax::Unary>(expr); unary && unary->operand()) {
    return describe_sides(session, scope, *unary->operand(), found);
  }
  const auto binary = syntax::as<syntax::Binary>(expr);
  if (!binary) {
    if (const auto tuple = syntax::as<syntax::Tuple>(expr); tuple && tuple->parts().size() == 1) {
      describe_sides(session, scope, tuple->parts().front(), found);
    } else {
      add(expr);
    }
    return;
  }
  const auto op = binary->op();
  const bool logical = op && (op->kind() == syntax::Kind::KwAnd || op->kind() == syntax::Kind::KwOr);
  for (const auto& side : {binary->left(), binary->right()}) {
    if (!side) continue;
    if (logical) {
      describe_sides(session, scope, *side, found);
    } else {
      add(*side);
    }
  }
}

}  // namespace

std::optional<Command> Commands::expect(const syntax::Expect& expect) {
  ExpectCommand made;
  made.written = module().at(expect);
  const auto condition = expect.condition();
  const Value value = evaluate(session_, scope(), condition);
  if (session_.report.has_errors()) return std::nullopt;
  const auto* truth = value.as<Truth>();
  made.holds = truth != nullptr && value.known() && truth->value;
  made.text = std::string(session_.text(module(), *condition));
  describe_sides(session_, scope(), *condition, made.found);
  return made;
}

}  // namespace toile
