#include "compiler/evaluate/sewing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compiler/curve/places.hpp"
#include "compiler/evaluate/curves.hpp"
#include "compiler/evaluate/details.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/repetition.hpp"
#include "compiler/evaluate/want.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

class SewingReader {
 public:
  SewingReader(Session& session, GarmentInstance& garment, const Scope& scope)
      : session_(session), garment_(garment), scope_(scope), module_(scope.module()), wanted_{session, scope} {}

  void read(const syntax::Sew& sew) {
    DraftSeam seam;
    seam.written = module_.at(sew);
    const bool first = read_chain(sew.first(), seam.first);
    const bool second = read_chain(sew.second(), seam.second);
    bool sound = first && second;
    const std::vector<syntax::Chain> chains = sew.chains();
    for (std::size_t i = 2; i < chains.size(); ++i) {
      sound = read_chain(chains[i], seam.layers.emplace_back()) && sound;
    }
    sound = says_once(sew) && sound;
    for (const syntax::SewOption& option : sew.options()) sound = read_option(option, seam) && sound;
    if (!sound) return fail();
    garment_.draft.seams.push_back(std::move(seam));
  }

  void read(const syntax::Wear& wear) {
    DraftWear made;
    made.written = module_.at(wear);
    bool sound = read_chain(wear.chain(), made.chain);
    const std::shared_ptr<BodyInstance> body = read_line(wear, made.line);
    for (const syntax::WearOption& option : wear.options()) sound = read_option(option, made) && sound;
    if (!sound || body == nullptr) return fail();
    garment_.draft.wears.push_back(std::move(made));
    garment_.worn_on.push_back(body);
  }

 private:
  void fail() { garment_.sound = false; }

  bool read_chain(const std::optional<syntax::Chain>& chain, std::vector<DraftEdgeRef>& into) {
    if (!chain) return false;
    bool sound = true;
    for (const syntax::EdgeRef& reference : chain->edges()) {
      std::vector<DraftEdgeRef> edges = read_edge(reference);
      for (DraftEdgeRef& edge : edges) sound = sound && read_part(reference, edges.size(), edge);
      sound = sound && !edges.empty();
      into.insert(into.end(), edges.begin(), edges.end());
    }
    return sound && !into.empty();
  }

  /// One edge, or all of a hole or a line whose name stands alone; none after a mistake.
  std::vector<DraftEdgeRef> read_edge(const syntax::EdgeRef& reference) {
    const std::vector<syntax::Token> path = reference.path();
    const std::optional<std::vector<std::string>> called = path_of(session_, scope_, reference);
    if (path.size() < 2 || !called || called->size() != path.size()) return {};
    DraftEdgeRef made;
    made.written = module_.at(reference);
    made.piece = called->at(0);
    const PieceInstance* piece = garment_.piece(made.piece);
    if (piece == nullptr) {
      if (!garment_.doubled) report_no_piece(path[0], made.piece);
      return {};
    }
    if (piece->late && piece->taken == nullptr) return {};           // told where it is taken
    if (!piece->plan.outline && piece->taken == nullptr) return {};  // that it has none is told where it is drawn
    made.edge = called->at(1);
    if (const InnerInstance* inner = piece->inner_called(made.edge)) {
      return read_inner(path, *inner, made);
    }
    // An edge of a hole without the hole's name, or of a line: make_garment() tells how it is written.
    std::vector<std::string> known = piece->edge_names();
    for (const auto& inner : piece->inner) {
      if (!inner->name.empty()) known.push_back(inner->name);
      for (const PlannedEdge& edge : inner->edges) known.push_back(edge.name);
    }
    if (std::find(known.begin(), known.end(), made.edge) == known.end()) {
      if (piece->doubled) return {};
      report_unknown(session_, module_, path[1], fmt::format("piece `{}` has no edge `{}`", made.piece, made.edge),
                     known, "E0308");
      return {};
    }
    if (!read_side(path, 2, made)) return {};
    return {made};
  }

  /// Once for each name, and once for all that a `for` did not make.
  void report_no_piece(const syntax::Token& at, const std::string& name) {
    const std::string stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
    const auto repeated = garment_.repeated.find(stem);
    if (!garment_.told.insert(repeated == garment_.repeated.end() ? name : stem).second) return;
    const std::string message = fmt::format("garment `{}` has no piece `{}`", garment_.draft.name, name);
    if (repeated == garment_.repeated.end()) {
      std::vector<std::string> names;
      for (const auto& each : garment_.pieces) names.push_back(each->name);
      return report_unknown(session_, module_, at, message, names, "E0309");
    }
    const std::size_t count = repeated->second;
    session_.report.add(Problem("E0309", message)
                            .at(module_.at(at))
                            .help(count == 0 ? fmt::format("its `for` has no turns, so that there is no `{}`", stem)
                                             : fmt::format("its `for` makes `{0}1` to `{0}{1}`", stem, count)));
  }

  /// `piece.hole.edge`, `piece.line.edge`, or without an edge all of them.
  std::vector<DraftEdgeRef> read_inner(const std::vector<syntax::Token>& path, const InnerInstance& inner,
                                       const DraftEdgeRef& made) {
    std::vector<std::string> known;
    for (const PlannedEdge& edge : inner.edges) known.push_back(edge.name);
    const std::string named = path.size() > 2 ? session_.name_of(module_, path[2]) : "";
    const bool one = std::find(known.begin(), known.end(), named) != known.end();
    const bool all = path.size() == 2 || (path.size() == 3 && (named == "drawn" || named == "mirrored"));
    if (!one && !all) {
      report_unknown(session_, module_, path[2],
                     fmt::format("{} `{}` has no edge `{}`", inner.kind(), inner.name, named), known, "E0308");
      return {};
    }
    std::vector<DraftEdgeRef> edges;
    for (const std::string& name : one ? std::vector{named} : known) {
      edges.push_back(made);
      edges.back().edge = inner.name + "." + name;
      if (!read_side(path, one ? 3 : 2, edges.back())) return {};
    }
    return edges;
  }

  /// `in 0cm..18cm`: places on the edge as drawn.
  bool read_part(const syntax::EdgeRef& reference, std::size_t edges, DraftEdgeRef& edge) {
    const auto range = reference.range();
    if (!range) return true;
    if (module_.broken(reference.span())) return false;
    if (edges > 1) {
      session_.report.add(Problem("E0308", "a part is told of a single edge").at(module_.at(reference)));
      return false;
    }
    const DraftEdge* drafted = nullptr;
    for (const DraftPiece& piece : garment_.draft.pieces) {
      if (piece.name == edge.piece) drafted = drafted_edge(piece, edge.edge);
    }
    if (drafted == nullptr) return false;
    const auto from = place_on(drafted->curve, range->low(), edge.edge),
               to = place_on(drafted->curve, range->high(), edge.edge);
    if (!from || !to) return false;
    if (*to - *from < 1e-3) {
      session_.report.add(
          Problem("E0112", "a part of an edge runs from its lower to its higher place").at(module_.at(*range)));
      return false;
    }
    edge.part = DrawnSpan{*from, *to};
    return true;
  }

  std::optional<double> place_on(const Curve& curve, const std::optional<syntax::Expr>& expr, const std::string& name) {
    const Value where = evaluate(session_, scope_, expr);
    if (where.unknown()) return std::nullopt;
    const auto* quantity = where.as<Quantity>();
    const bool measured =
        quantity != nullptr && (quantity->dimension.plain() || quantity->dimension == dimension::length);
    if (!measured) {
      wanted_.wrong(*expr, where, "a place on an edge", "a length or a fraction");
      return std::nullopt;
    }
    if (!wanted_.there(*expr, where, "a place on an edge")) return std::nullopt;
    return arc_length_at(session_, curve, where, module_.at(*expr), "the end of edge `" + name + "`");
  }

  /// A point, as that of a notch, on the line named first.
  std::optional<DraftSeamPlace> seam_place(Vec2 point, Location at, const DraftSeam& seam) {
    constexpr double on = 1e-6;  // [m]
    for (const DraftEdgeRef& reference : seam.first) {
      for (const DraftPiece& piece : garment_.draft.pieces) {
        const DraftEdge* edge = piece.name == reference.piece ? drafted_edge(piece, reference.edge) : nullptr;
        if (edge == nullptr) continue;
        const double s = nearest_place(edge->curve, point);
        if (distance(edge->curve.at(s), point) < on) return DraftSeamPlace{s, false, reference.piece, reference.edge};
      }
    }
    session_.report.add(Problem("E0213", "this point does not lie on the line that the seam names first")
                            .at(at)
                            .also(seam.first.empty() ? seam.written : seam.first.front().written, "the line"));
    return std::nullopt;
  }

  /// A place on a seam, whose length is not known yet.
  std::optional<DraftSeamPlace> seam_place(const std::optional<syntax::Expr>& expr, const DraftSeam& seam) {
    const Value where = evaluate(session_, scope_, expr);
    if (where.unknown()) return std::nullopt;
    const auto* point = where.as<Point>();
    if (point != nullptr && point->dimension == dimension::length && where.known()) {
      return seam_place(point->at, module_.at(*expr), seam);
    }
    const auto* quantity = where.as<Quantity>();
    if (quantity == nullptr || !(quantity->dimension.plain() || quantity->dimension == dimension::length)) {
      wanted_.wrong(*expr, where, "a place on a seam", "a length or a fraction");
      return std::nullopt;
    }
    if (!wanted_.there(*expr, where, "a place on a seam")) return std::nullopt;
    return DraftSeamPlace{quantity->si, quantity->dimension.plain(), {}, {}};
  }

  /// What stands behind the edge's name, if anything.
  bool read_side(const std::vector<syntax::Token>& path, std::size_t at, DraftEdgeRef& edge) {
    if (path.size() == at) return true;
    const std::string side = session_.name_of(module_, path[at]);
    if (side == "drawn") edge.side = Side::Drawn;
    if (side == "mirrored") edge.side = Side::Mirrored;
    if (edge.side && path.size() == at + 1) return true;
    const syntax::Token& wrong = edge.side ? path[at + 1] : path[at];
    report_unknown(
        session_, module_, wrong,
        fmt::format("edge `{}` has a drawn and a mirrored side, no `{}`", edge.edge, session_.name_of(module_, wrong)),
        {"drawn", "mirrored"}, "E0103");
    return false;
  }

  /// A seam is eased or gathered, zipped or buttoned, and has one step.
  bool says_once(const syntax::Sew& sew) {
    const auto family = [](syntax::Kind word) {
      if (word == syntax::Kind::KwGather || word == syntax::Kind::KwStretch) return syntax::Kind::KwEase;
      return word == syntax::Kind::KwButtoned ? syntax::Kind::KwZipped : word;
    };
    std::map<syntax::Kind, syntax::Token> said;
    bool sound = true;
    for (const syntax::SewOption& option : sew.options()) {
      const auto word = option.word();
      if (!word || word->kind() == syntax::Kind::KwNotch) continue;
      const auto [before, fresh] = said.try_emplace(family(word->kind()), *word);
      if (fresh) continue;
      sound = false;
      session_.report.add(
          Problem("E0102", fmt::format("`{}` after `{}`: one of them is too many", session_.text(module_, *word),
                                       session_.text(module_, before->second)))
              .at(module_.at(*word))
              .also(module_.at(before->second), "said here"));
    }
    return sound;
  }

  bool read_option(const syntax::SewOption& option, DraftSeam& seam) {
    const auto word = option.word();
    if (!word) return false;
    switch (word->kind()) {
      case syntax::Kind::KwReversed:
        seam.reversed = true;
        return true;
      case syntax::Kind::KwOpen:
        seam.open = true;
        return true;
      case syntax::Kind::KwZipped:
        seam.closure = Seam::Closure::Zipped;
        return true;
      case syntax::Kind::KwButtoned:
        seam.closure = Seam::Closure::Buttoned;
        return true;
      case syntax::Kind::KwStep:
        seam.step = wanted_.count(option.amount(), "the step of a seam");
        return seam.step.has_value();
      case syntax::Kind::KwFolded: {
        const auto angle = wanted_.quantity(option.amount(), dimension::angle, "the angle of a folded seam");
        if (angle) seam.angle = *angle;
        return angle && check_fold(session_, *angle, module_.at(*option.amount()));
      }
      case syntax::Kind::KwNotch:
        return read_notches(option, seam);
      default:
        return read_fullness(*word, option, seam);
    }
  }

  bool read_notches(const syntax::SewOption& option, DraftSeam& seam) {
    bool sound = true;
    for (const syntax::Expr& expr : option.places()) {
      const auto place = seam_place(expr, seam);
      if (place) seam.notches.push_back(*place);
      sound = sound && place;
    }
    return sound;
  }

  bool read_fullness(const syntax::Token& word, const syntax::SewOption& option, DraftSeam& seam) {
    if (const auto range = option.range()) {
      const auto from = seam_place(range->low(), seam), to = seam_place(range->high(), seam);
      if (!from || !to) return false;
      seam.taken = {*from, *to};
    }
    seam.fullness = word.kind() == syntax::Kind::KwEase     ? Seam::Fullness::Ease
                    : word.kind() == syntax::Kind::KwGather ? Seam::Fullness::Gather
                                                            : Seam::Fullness::Stretch;
    const auto amount = option.amount();
    if (!amount) return true;
    seam.stated = wanted_.not_negative(amount, dimension::length,
                                       fmt::format("the amount of `{}`", session_.text(module_, word)));
    return seam.stated.has_value();
  }

  /// The body's line after `at`.
  std::shared_ptr<BodyInstance> read_line(const syntax::Wear& wear, std::string& line) {
    const auto expr = wear.line();
    const Value value = evaluate(session_, scope_, expr);
    if (value.unknown()) return nullptr;
    if (const auto* body = value.as<BodyValue>(); body != nullptr && garment_.drawn_on == body->body) {
      line.clear();  // held where it is drawn
      return body->body;
    }
    const auto* found = value.as<BodyLineValue>();
    // Where the map of a piece was not understood the body may be the one that it is drawn on.
    const bool unmapped = std::any_of(garment_.pieces.begin(), garment_.pieces.end(),
                                      [](const auto& piece) { return piece->plan.on && !piece->sound; });
    if (value.as<BodyValue>() != nullptr && unmapped) return nullptr;
    if (found == nullptr) {
      wanted_.wrong(*expr, value, "what a garment is worn at", "a line of a body");
      return nullptr;
    }
    line = found->line;
    return found->body;
  }

  bool read_option(const syntax::WearOption& option, DraftWear& wear) {
    const auto word = option.word();
    if (!word) return false;
    if (word->kind() != syntax::Kind::KwFrom) {
      wear.held = word->kind() == syntax::Kind::KwHeld;
      return true;
    }
    const auto expr = option.origin();
    const auto from = wanted_.quantity(expr, dimension::number, "the place after `from`");
    if (!from) return false;
    if (*from < -1 || *from > 1) {
      session_.report.add(Problem("E0209", "`from` is a fraction of the line's girth, from the front")
                              .at(module_.at(*expr), "this is " + format_number(*from))
                              .help("25% lies at the left side, 50% at the back"));
      return false;
    }
    wear.from = *from;
    return true;
  }

  Session& session_;
  GarmentInstance& garment_;
  const Scope& scope_;
  const Module& module_;
  Wanted wanted_;
};

}  // namespace

void read_seam(Session& session, GarmentInstance& garment, const Scope& scope, const syntax::Sew& sew) {
  SewingReader(session, garment, scope).read(sew);
}

void read_wear(Session& session, GarmentInstance& garment, const Scope& scope, const syntax::Wear& wear) {
  SewingReader(session, garment, scope).read(wear);
}

}  // namespace toile
