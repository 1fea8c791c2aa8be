#include "compiler/evaluate/details.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/evaluate/curves.hpp"
#include "compiler/evaluate/detail_properties.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/repetition.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

std::optional<Press> press_of(const syntax::Flag& flag) {
  const auto direction = flag.direction();
  if (!direction) return std::nullopt;
  switch (direction->kind()) {
    case syntax::Kind::KwLeft:
      return Press::Left;
    case syntax::Kind::KwRight:
      return Press::Right;
    case syntax::Kind::KwUp:
      return Press::Up;
    case syntax::Kind::KwOpen:
      return Press::Open;
    default:
      return Press::Down;
  }
}

const Curve& curve_of(const DraftPiece& draft, const std::string& edge) {
  return drafted_edge(draft, edge)->curve;
}

class DetailReader {
 public:
  DetailReader(Session& session, const PieceInstance& piece, DraftPiece& draft)
      : session_(session), piece_(piece), draft_(draft) {}

  bool read() {
    for (const Repeated& detail : piece_.plan.details) {
      const Scope& around = piece_.scope_of(detail.written);
      module_ = &around.module();
      if (!detail.each) {
        read_one(detail.written, around);
        continue;
      }
      const auto known = for_each_value(session_, around, *detail.each, [&](const Scope& inner) {
        ++turn_;
        read_one(detail.written, inner);
      });
      turn_ = 0;
      if (!known) fail();
    }
    return good_;
  }

 private:
  void fail() { good_ = false; }

  void read_one(const syntax::View& written, const Scope& scope) {
    if (const auto dart = syntax::as<syntax::Dart>(written)) read_dart(*dart, scope);
    if (const auto notch = syntax::as<syntax::Notch>(written)) read_notch(*notch, scope);
    if (const auto pivot = syntax::as<syntax::Pivot>(written)) read_pivot(*pivot, scope);
    if (const auto spread = syntax::as<syntax::Spread>(written)) read_spread(*spread, scope);
    if (const auto pleat = syntax::as<syntax::Pleat>(written)) read_pleat(*pleat, scope);
    if (!read_mark(session_, scope, written, draft_)) fail();
  }

  std::optional<DraftPlace> place(const std::optional<syntax::Position>& position, const Scope& scope) {
    if (!position) {
      fail();
      return std::nullopt;
    }
    const Wanted wanted{session_, scope};
    const auto where_expr = position->where();
    const Value where = evaluate(session_, scope, where_expr);
    const auto line = named_edge(session_, piece_, scope, draft_, *position);
    if (!line || where.unknown()) {
      fail();
      return std::nullopt;
    }
    const auto* quantity = where.as<Quantity>();
    const bool measured =
        quantity != nullptr && (quantity->dimension.plain() || quantity->dimension == dimension::length);
    const bool shown = where.as<Point>() != nullptr || where.as<PlaneCurve>() != nullptr;
    if (!measured && !shown) {
      wanted.wrong(*where_expr, where, "a place on an edge", "a length or a fraction");
      fail();
      return std::nullopt;
    }
    if (!wanted.there(*where_expr, where, "a place on an edge")) {
      fail();
      return std::nullopt;
    }
    constexpr double no_length = 1e-5;  // [m] that the edge has none is told with the outline
    if (curve_of(draft_, *line).length() < no_length) return DraftPlace{*line, 0};
    const auto s = arc_length_at(session_, curve_of(draft_, *line), where, module_->at(*where_expr),
                                 "the end of edge `" + *line + "`");
    if (!s) fail();
    return s ? std::optional(DraftPlace{*line, *s}) : std::nullopt;
  }

  /// tuck1, tuck2 under a `for`; dart1, dart2 where the script gives no name.
  std::string name_of(const std::optional<syntax::Token>& token, const char* kind, std::size_t before) const {
    const std::string name = session_.name_of(*module_, token);
    if (name.empty()) return fmt::format("{}{}", kind, before + 1);
    return turn_ > 0 ? fmt::format("{}{}", name, turn_) : name;
  }

  /// Darts and pleats of one piece are told apart by their names.
  void take_name(const std::string& name, Location written) {
    const auto [earlier, is_new] = names_.try_emplace(name, written);
    if (is_new) return;
    session_.report.add(Problem("E0102", fmt::format("`{}` is there twice in piece `{}`", name, piece_.name))
                            .at(written, "again here")
                            .also(earlier->second, "first here")
                            .help("choose another name for one of them"));
    fail();
  }

  void read_dart(const syntax::Dart& dart, const Scope& scope) {
    const Wanted wanted{session_, scope};
    DraftDart made;
    made.written = module_->at(dart);
    made.name = name_of(dart.name(), "dart", draft_.darts.size() + draft_.tried.size());
    bool placed = true;
    if (dart.inside()) {
      const auto from = wanted.point(dart.from(), "one end of a dart"), to = wanted.point(dart.to(), "its other end");
      placed = from && to;
      if (placed) made.inside = {*from, *to};
    } else if (const auto where = place(dart.position(), scope)) {
      made.edge = where->edge;
      made.at = where->at;
    } else {
      placed = false;
    }
    DetailProperties sizes(
        session_, *module_, "dart",
        dart.inside() ? std::vector<std::string>{"width", "widest"}
                      : std::vector<std::string>{"width", "depth", "tip", "short"},
        dart.inside() ? std::vector<std::string>{"pressed"} : std::vector<std::string>{"trued", "tried", "pressed"});
    for (const syntax::Property& property : dart.properties()) {
      const auto name = sizes.name(property);
      if (!name) continue;
      if (*name == "tip") {
        made.tip = wanted.point(property.value(), "the tip of a dart");
        sizes.set(*name, made.tip ? std::optional(0.0) : std::nullopt);
      } else if (*name == "widest") {
        sizes.set(*name, widest(property, made, scope));
      } else {
        sizes.set(*name, wanted.positive(property.value(), dimension::length, "the " + *name + " of a dart"));
      }
    }
    for (const syntax::Flag& flag : dart.flags()) read_flag(flag, dart.inside(), made);
    const bool tried = has_word(dart, syntax::Kind::KwTried);
    if (piece_.plan.on) return read_slit(std::move(made), placed, sizes, dart.span(), tried);
    if (tried) {
      session_.report.add(Problem("E0103",
                                  "only a dart that is drawn on a body can be `tried`: what it gains is known "
                                  "once its piece is developed")
                              .at(made.written));
      return fail();
    }
    if (sizes.has("tip") && sizes.has("depth")) {
      session_.report.add(Problem("E0102", "a dart has a `depth` or a `tip`").at(made.written));
      return fail();
    }
    const bool deep = !dart.inside() && !sizes.has("tip");
    const std::string help = dart.inside() ? "dart from (10cm, 9cm) to (10cm, -12cm) { width 2.5cm }"
                                           : "dart at 50% of waist { width 2.5cm, depth 9cm }";
    const bool told =
        deep ? sizes.complete({"width", "depth"}, dart.span(), help) : sizes.complete({"width"}, dart.span(), help);
    if (!told || !placed) return fail();
    made.width = sizes.size("width");
    made.depth = sizes.size("depth");
    made.short_of_tip = sizes.size("short");
    made.widest = sizes.has("widest") ? sizes.size("widest") : distance(made.inside.from, made.inside.to) / 2;
    take_name(made.name, made.written);
    draft_.darts.push_back(std::move(made));
  }

  /// A dart of a piece that is drawn on a body is a slit there: how wide it opens comes out of the development.
  void read_slit(DraftDart made, bool placed, DetailProperties& sizes, Span span, bool tried) {
    const bool sized = sizes.has("width");
    if (sized || made.edge.empty() || sizes.has("tip") == sizes.has("depth")) {
      session_.report.add(Problem("E0310", sized ? "the width of a dart drawn on a body comes out of the development"
                                                 : "a dart drawn on a body has either its depth or its tip")
                              .at(made.written)
                              .help("dart at 50% of waist { depth 9cm }, or { tip (8cm, 115cm) }"));
      return fail();
    }
    if (!sizes.complete({}, span, "") || !placed) return fail();
    made.depth = made.tip ? distance(curve_of(draft_, made.edge).at(made.at), *made.tip) : sizes.size("depth");
    made.width = slit_width(made.depth);
    take_name(made.name, made.written);
    (tried ? draft_.tried : draft_.darts).push_back(std::move(made));
  }

  static bool has_word(const syntax::Dart& dart, syntax::Kind kind) {
    const std::vector<syntax::Flag> flags = dart.flags();
    return std::any_of(flags.begin(), flags.end(),
                       [&](const syntax::Flag& flag) { return flag.word() && flag.word()->kind() == kind; });
  }

  /// A length from the first end, or a fraction of the way.
  std::optional<double> widest(const syntax::Property& property, const DraftDart& dart, const Scope& scope) {
    const Wanted wanted{session_, scope};
    const auto expr = property.value();
    const Value value = evaluate(session_, scope, expr);
    if (value.unknown() || dart.inside.from == dart.inside.to) return std::nullopt;
    if (value.as<Quantity>() == nullptr) {
      wanted.wrong(*expr, value, "where a dart is widest", "a length or a fraction");
      return std::nullopt;
    }
    if (!wanted.there(*expr, value, "where a dart is widest")) return std::nullopt;
    return arc_length_at(session_, line(dart.inside.from, dart.inside.to), value, module_->at(*expr), "the dart's end");
  }

  void read_flag(const syntax::Flag& flag, bool inside, DraftDart& dart) {
    const auto word = flag.word();
    if (!word) return fail();
    if (word->kind() == syntax::Kind::KwTrued && !inside) {
      dart.trued = true;
    } else if (word->kind() == syntax::Kind::KwTried && !inside) {
      return;  // where it goes is known once all of it is read
    } else if (word->kind() == syntax::Kind::KwPressed) {
      dart.pressed = press_of(flag);
    } else {
      refuse(*word, inside ? "a dart inside a piece" : "a dart");
    }
  }

  void refuse(const syntax::Token& word, const std::string& owner) {
    session_.report.add(
        Problem("E0103", fmt::format("{} is not `{}`", owner, session_.text(*module_, word))).at(module_->at(word)));
    fail();
  }

  void read_notch(const syntax::Notch& notch, const Scope& scope) {
    if (const auto where = place(notch.position(), scope)) {
      draft_.notches.push_back({where->edge, where->at, module_->at(notch)});
    }
  }

  void read_pivot(const syntax::Pivot& pivot, const Scope& scope) {
    const Wanted wanted{session_, scope};
    DraftPivot made;
    made.written = module_->at(pivot);
    made.dart = session_.name_of(*module_, pivot.dart());
    const auto where = place(pivot.target(), scope);
    if (const auto share = pivot.share()) {
      const auto part = wanted.positive(share, dimension::number, "the share of a dart");
      if (!part) return fail();
      if (*part > 1) {
        session_.report.add(Problem("E0209", "the share of a dart lies between 0 % and 100 %").at(module_->at(*share)));
        return fail();
      }
      made.share = *part;
    }
    if (!where || made.dart.empty()) return fail();
    made.edge = where->edge;
    made.at = where->at;
    made.name = session_.name_of(*module_, pivot.alias());
    if (made.name.empty()) made.name = made.share < 1 ? made.dart + "_2" : made.dart;
    draft_.pivots.push_back(std::move(made));
  }

  void read_spread(const syntax::Spread& spread, const Scope& scope) {
    const Wanted wanted{session_, scope};
    const auto by = wanted.positive(spread.amount(), dimension::length, "what a slash is opened by");
    const auto other_by = spread.other_amount() ? wanted.not_negative(spread.other_amount(), dimension::length,
                                                                      "what a slash is opened by")
                                                : std::optional(0.0);
    const auto opened = place(spread.opened(), scope), other = place(spread.other(), scope);
    if (!by || !other_by || !opened || !other) return fail();
    draft_.spreads.push_back({*opened, *other, *by, *other_by, module_->at(spread)});
  }

  void read_pleat(const syntax::Pleat& pleat, const Scope& scope) {
    const Wanted wanted{session_, scope};
    DraftPleat made;
    made.written = module_->at(pleat);
    made.name = name_of(pleat.name(), "pleat", draft_.pleats.size());
    const auto where = place(pleat.position(), scope);
    if (pleat.other_end()) {
      made.other_end = place(pleat.other_end(), scope);
      if (!made.other_end) return fail();
    }
    DetailProperties sizes(session_, *module_, "pleat", {"depth", "width", "stitched"},
                           {"knife", "box", "inverted", "pressed"});
    for (const syntax::Property& property : pleat.properties()) {
      if (const auto name = sizes.name(property)) {
        sizes.set(*name, wanted.positive(property.value(), dimension::length, "the " + *name + " of a pleat"));
      }
    }
    for (const syntax::Flag& flag : pleat.flags()) read_flag(flag, made);
    check_words(pleat, made);
    const bool box = made.style == PleatStyle::Box;
    const bool told =
        box ? sizes.complete({"depth", "width"}, pleat.span(), "pleat at 50% of waist { box, depth 2cm, width 4cm }")
            : sizes.complete({"depth"}, pleat.span(), "pleat at 50% of waist { depth 2cm }");
    if (!told || !where) return fail();
    if (!box && sizes.has("width")) {
      session_.report.add(Problem("E0103", "only a box pleat has a `width`").at(made.written));
      return fail();
    }
    made.place = *where;
    made.depth = sizes.size("depth");
    made.width = sizes.size("width");
    made.stitched = sizes.size("stitched");
    take_name(made.name, made.written);
    draft_.pleats.push_back(std::move(made));
  }

  /// One kind, and a direction only where there is one to choose.
  void check_words(const syntax::Pleat& pleat, const DraftPleat& made) {
    int kinds = 0;
    for (const syntax::Flag& flag : pleat.flags())
      kinds += flag.word() && flag.word()->kind() != syntax::Kind::KwPressed;
    if (kinds > 1) {
      session_.report.add(Problem("E0102", "a pleat is `knife`, `box` or `inverted`").at(made.written));
      fail();
    }
    if (made.style != PleatStyle::Knife && made.pressed) {
      session_.report.add(Problem("E0103", "only a knife pleat is pressed to a side").at(made.written));
      fail();
    }
  }

  void read_flag(const syntax::Flag& flag, DraftPleat& pleat) {
    const auto word = flag.word();
    if (!word) return fail();
    switch (word->kind()) {
      case syntax::Kind::KwKnife:
        pleat.style = PleatStyle::Knife;
        return;
      case syntax::Kind::KwBox:
        pleat.style = PleatStyle::Box;
        return;
      case syntax::Kind::KwInverted:
        pleat.style = PleatStyle::Inverted;
        return;
      case syntax::Kind::KwPressed:
        pleat.pressed = press_of(flag);
        if (pleat.pressed != Press::Open) return;
        [[fallthrough]];
      default:
        refuse(*word, "a pleat");
    }
  }

  Session& session_;
  const PieceInstance& piece_;
  const Module* module_ = nullptr;  // in which the statement that is read is written
  DraftPiece& draft_;
  bool good_ = true;
  std::map<std::string, Location> names_;  // of darts and pleats
  int turn_ = 0;                           // of the `for` around what is read, from 1 on; 0 outside
};

}  // namespace

std::optional<std::string> named_edge(Session& session, const PieceInstance& piece, const Scope& scope,
                                      const DraftPiece& draft, const syntax::View& reference) {
  const std::optional<std::vector<std::string>> path = path_of(session, scope, reference);
  if (!path || path->empty() || !piece.plan.outline) return std::nullopt;
  const std::string name = fmt::format("{}", fmt::join(*path, "."));
  if (drafted_edge(draft, name) != nullptr) return name;
  std::vector<std::string> known = piece.edge_names();
  for (const auto& inner : piece.inner) {
    for (const PlannedEdge& rim : inner->edges) known.push_back(inner->name + "." + rim.name);
  }
  if (piece.doubled || std::find(known.begin(), known.end(), name) != known.end()) return std::nullopt;
  const auto first = syntax::token(reference, syntax::Kind::Name);
  report_unknown(session, scope.module(), *first, fmt::format("piece `{}` has no edge `{}`", piece.name, name), known,
                 "E0308");
  return std::nullopt;
}

bool read_details(Session& session, const PieceInstance& piece, DraftPiece& draft) {
  return DetailReader(session, piece, draft).read();
}

}  // namespace toile
