#include "compiler/evaluate/garments.hpp"

#include <fmt/format.h>

#include <map>

#include "compiler/evaluate/arranging.hpp"
#include "compiler/evaluate/definitions.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/free_pieces.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/pieces.hpp"
#include "compiler/evaluate/repetition.hpp"
#include "compiler/evaluate/sewing.hpp"
#include "compiler/evaluate/solve.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

/// Builds one garment: names first, then pieces, then what joins them.
class GarmentBuilder {
 public:
  GarmentBuilder(Session& session, const Scope& scope, const syntax::Garment& written, const std::string& name)
      : session_(session), garment_(*session.garment_instances.emplace_back(std::make_unique<GarmentInstance>())) {
    garment_.written = written;
    garment_.draft.name = name;
    const auto token = written.name();
    garment_.draft.written = token ? scope.module().at(*token) : scope.module().at(written);
    outer_ = &scope;
  }

  GarmentInstance& build(const std::vector<std::optional<Given>>& arguments) {
    std::string kinds;
    for (const auto& argument : arguments) kinds += argument ? signature(argument->value) : "-";
    garment_.scope = std::make_unique<Scope>(outer_->module(), outer_, false, kinds);
    define_names(arguments);
    for (const auto& definition : garment_.scope->definitions()) force(session_, *definition);
    for (const auto& turn : garment_.turns) {
      for (const auto& definition : turn->definitions()) force(session_, *definition);
    }
    read_cloth();
    draft_pieces();
    join_pieces(garment_.written, *garment_.scope);
    if (garment_.sound) make();
    return garment_;
  }

 private:
  void define_names(const std::vector<std::optional<Given>>& arguments) {
    Scope& scope = *garment_.scope;
    if (const auto parameters = garment_.written.parameters()) {
      define_parameters(session_, scope, *parameters, arguments);
    }
    for (const syntax::View item : syntax::items(garment_.written)) {
      if (const auto let = syntax::as<syntax::Let>(item)) define_let(session_, scope, *let);
      if (const auto solve = syntax::as<syntax::Solve>(item)) define_solve(session_, scope, *solve);
      if (const auto fn = syntax::as<syntax::Fn>(item)) define_function(session_, scope, *fn);
      if (const auto param = syntax::as<syntax::Param>(item)) {
        define_param(session_, scope, *param, garment_.draft.name + ".");
      }
      if (const auto piece = syntax::as<syntax::Piece>(item)) define_piece(*piece, scope, "");
    }
    for (const syntax::View item : syntax::items(garment_.written)) {
      if (const auto repeat = syntax::as<syntax::Repeat>(item)) define_repeated(*repeat, scope);
    }
    for (const auto& [name, all] : repeated_) {
      if (all.empty()) continue;  // all their names were taken
      define(session_, scope, all.front()->written.name(), [&session = session_, &scope, pieces = all] {
        std::vector<Value> values;
        for (const PieceInstance* piece : pieces) values.push_back(force(session, *scope.own(piece->name)));
        return list_value(std::move(values));
      });
    }
    PiecePlanner(session_, garment_).plan_all();
    for (const auto& piece : garment_.pieces) {
      if (piece->late) continue;
      define_piece_names(session_, *piece);
    }
  }

  /// Lets and pieces of a `for`, which are called panel1, panel2, …
  void define_repeated(const syntax::Repeat& repeat, const Scope& around) {
    const auto values = repeat.values();
    if (!values) return;
    for (const syntax::View item : syntax::items(repeat)) {
      const auto piece = syntax::as<syntax::Piece>(item);
      if (piece && piece->name()) garment_.repeated.try_emplace(session_.name_of(around.module(), piece->name()), 0);
    }
    const auto known = for_each_value(session_, around, *values, garment_.turns, [&](const Scope&) {
      Scope& turn = *garment_.turns.back();
      for (const syntax::View item : syntax::items(repeat)) {
        if (const auto let = syntax::as<syntax::Let>(item)) define_let(session_, turn, *let);
        const auto piece = syntax::as<syntax::Piece>(item);
        if (piece && piece->name() && piece->parameters()) {
          session_.report.add(
              Problem("E0202", "a piece with parameters is drawn where it is called, not once for each value")
                  .at(turn.module().at(*piece->name()))
                  .help("define it outside of the `for`, and take it here: piece panel = gore(i)"));
          garment_.sound = false;
        } else if (piece && piece->name()) {
          const std::string name = session_.name_of(turn.module(), piece->name());
          define_piece(*piece, turn, fmt::format("{}", repeated_[name].size() + 1));
          garment_.repeated[name] = repeated_[name].size();
        }
        if (const auto inner = syntax::as<syntax::Repeat>(item)) define_repeated(*inner, turn);
      }
    });
    if (known) return;
    garment_.sound = false;
    garment_.doubled = true;  // what it was to make is not there
  }

  /// Seams, worn lines and arrangements, those of a `for` in the scope of each of its turns.
  void join_pieces(const syntax::View& owner, const Scope& scope) {
    for (const syntax::View item : syntax::items(owner)) {
      if (const auto sew = syntax::as<syntax::Sew>(item)) read_seam(session_, garment_, scope, *sew);
      if (const auto wear = syntax::as<syntax::Wear>(item)) read_wear(session_, garment_, scope, *wear);
      if (const auto arrange = syntax::as<syntax::Arrange>(item)) {
        read_arrangement(session_, garment_, scope, *arrange);
      }
      const auto repeat = syntax::as<syntax::Repeat>(item);
      if (!repeat || !repeat->values()) continue;
      std::vector<std::unique_ptr<Scope>> turns;
      for_each_value(session_, scope, *repeat->values(), turns, [&](const Scope&) {
        for (const syntax::View inner : syntax::items(*repeat)) {
          if (const auto let = syntax::as<syntax::Let>(inner)) define_let(session_, *turns.back(), *let);
        }
        const Scope& turn = *turns.back();
        join_pieces(*repeat, turn);
      });
    }
  }

  void define_piece(const syntax::Piece& written, const Scope& around, const std::string& number) {
    if (written.parameters()) return define_free_piece(session_, *garment_.scope, written);
    auto piece = std::make_unique<PieceInstance>();
    piece->name = session_.name_of(outer_->module(), written.name()) + number;
    piece->garment = &garment_;
    piece->outer = &around;
    piece->written = written;
    PieceInstance* reference = piece.get();
    const auto name = written.name();
    const auto value = [this_session = &session_, reference] {
      return reference->late ? take(*this_session, *reference) : Value{PieceRef{reference}};
    };
    const Definition* made = number.empty() || !name
                                 ? define(session_, *garment_.scope, name, value)
                                 : garment_.scope->define(piece->name, outer_->module().at(*name), value);
    if (made == nullptr && !number.empty()) report_taken(piece->name, *name);
    if (!number.empty() && made != nullptr) {
      repeated_[session_.name_of(outer_->module(), name)].push_back(reference);
    }
    if (made == nullptr) {
      garment_.sound = false;
      garment_.doubled = true;
      return;
    }
    garment_.add(std::move(piece));
  }

  /// panel2 of a `for`, where there is a panel2 already.
  void report_taken(const std::string& name, const syntax::Token& at) {
    session_.report.add(Problem("E0102", "`" + name + "` is defined twice")
                            .at(outer_->module().at(at), "defined again here, by `for`")
                            .also(garment_.scope->own(name)->at, "first defined here")
                            .help("choose another name for one of them"));
  }

  void read_cloth() {
    if (const auto written = garment_.written.fabric()) {
      const auto fabric = Wanted{session_, *garment_.scope}.fabric(*written);
      garment_.has_fabric = true;
      garment_.sound = garment_.sound && fabric;
      if (fabric) garment_.draft.fabric = *fabric;
    }
    if (const auto textile_expr = garment_.written.textile()) {
      const Value value = evaluate(session_, *garment_.scope, textile_expr);
      if (const auto* textile = value.as<TextileValue>()) {
        garment_.draft.textile = *textile->textile;
      } else if (const auto* colour = value.as<Colour>()) {
        garment_.draft.textile = {"", {{*colour, 0.01}}, {{*colour, 0.01}}};
      } else {
        refuse(value, *textile_expr, "a textile or a colour");
      }
    }
  }

  void refuse(const Value& value, const syntax::Expr& written, const std::string& wanted) {
    garment_.sound = false;
    if (value.unknown()) return;
    session_.report.add(Problem("E0202", fmt::format("{} is wanted here, and this is {}", wanted, describe(value)))
                            .at(outer_->module().at(written), describe(value)));
  }

  void draft_pieces() {
    for (const auto& piece : garment_.pieces) {
      garment_.draft.pieces.push_back(piece->late ? draft_taken(session_, *piece) : draft_piece(session_, *piece));
      garment_.sound = garment_.sound && piece->sound;
    }
  }

  /// Unfolds, cuts darts, pairs seams and checks the geometry.
  void make() {
    if (!outer_->module().parsed.errors.empty()) return;  // parts may be missing
    if (depth_of_try(session_)) return;  // `solve` looks at its curves; it will be made when those hold
    std::vector<Diagnostic> found;
    Garment made = make_garment(garment_.draft, found);
    for (Diagnostic& diagnostic : found) {
      if (diagnostic.severity == Severity::Error) garment_.sound = false;
      session_.report.add(std::move(diagnostic));
    }
    if (garment_.sound) check_tried();
    if (!garment_.sound) return;
    garment_.index = static_cast<int>(session_.garments.size());
    session_.garments.push_back(std::move(made));
    session_.drafts.push_back(garment_.draft);
  }

  /// Darts that are only tried have to fit as if they were cut.
  void check_tried() {
    for (std::size_t p = 0; p < garment_.draft.pieces.size(); ++p) {
      for (const DraftDart& dart : garment_.draft.pieces[p].tried) {
        DraftGarment with = garment_.draft;
        with.pieces[p].darts.push_back(dart);
        std::vector<Diagnostic> found;
        make_garment(with, found);
        for (Diagnostic& diagnostic : found) {
          if (diagnostic.severity != Severity::Error) continue;
          garment_.sound = false;
          session_.report.add(std::move(diagnostic));
        }
      }
    }
  }

  Session& session_;
  GarmentInstance& garment_;
  const Scope* outer_ = nullptr;
  std::map<std::string, std::vector<PieceInstance*>> repeated_;  // by the name that they share
};

}  // namespace

void define_garment(Session& session, Scope& scope, const syntax::Garment& written) {
  const std::string name = session.name_of(scope.module(), written.name());
  if (written.parameters()) {
    session.garment_templates.push_back({written, &scope, name});
    define(session, scope, written.name(),
           [garment = GarmentTemplateRef{&session.garment_templates.back()}]() -> Value { return garment; });
    return;
  }
  define(session, scope, written.name(), [&session, &scope, written, name]() -> Value {
    return GarmentRef{&GarmentBuilder(session, scope, written, name).build({})};
  });
}

Value instantiate(Session& session, const GarmentTemplate& garment,
                  const std::vector<std::optional<Given>>& arguments) {
  if (session.supposing > 0) return Unknown{};  // nothing is cut on supposition
  return GarmentRef{&GarmentBuilder(session, *garment.scope, garment.written, garment.name).build(arguments)};
}

GarmentInstance* as_garment(Session& session, const Value& value, Location at) {
  if (const auto* garment = value.as<GarmentRef>()) return *garment;
  if (value.unknown()) return nullptr;
  if (const auto* form = value.as<GarmentTemplateRef>()) {
    for (const Formal& formal : formals_of(session, (*form)->scope->module(), (*form)->written.parameters())) {
      if (formal.optional) continue;
      session.report.add(Problem("E0108", fmt::format("garment `{}` needs `{}`", (*form)->name, formal.name))
                             .at(at, "not given here"));
      return nullptr;
    }
    const Value made = instantiate(session, **form, {});
    return *made.as<GarmentRef>();
  }
  session.report.add(
      Problem("E0202", "a garment is wanted here, and this is " + describe(value)).at(at, describe(value)));
  return nullptr;
}

}  // namespace toile
