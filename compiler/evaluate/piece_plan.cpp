// Which statements make up a piece.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/pieces.hpp"

namespace toile {
namespace {

std::string name_of(const Session& session, const PiecePlan& plan, const syntax::Inner& inner) {
  return session.name_of(plan.module_of(inner), inner.name());
}

bool is_among(const Session& session, const PiecePlan& plan, const std::vector<syntax::Inner>& all,
              const syntax::Inner& inner) {
  const std::string name = name_of(session, plan, inner);
  return !name.empty() && std::any_of(all.begin(), all.end(), [&](const syntax::Inner& other) {
    return name_of(session, plan, other) == name;
  });
}

/// The names that a `solve` defines.
std::set<std::string> names_of(const Session& session, const PiecePlan& plan, const syntax::Solve& solve) {
  const Module& module = plan.module_of(solve);
  std::set<std::string> names;
  for (const syntax::Sought& sought : solve.unknowns()) names.insert(session.name_of(module, sought.name()));
  return names;
}

std::string name_of(const Session& session, const PiecePlan& plan, const syntax::Let& let) {
  return session.name_of(plan.module_of(let), let.name());
}

/// Replaces what defined that name, or adds it.
void take_let(const Session& session, PiecePlan& plan, const syntax::Let& let) {
  const std::string name = name_of(session, plan, let);
  std::erase_if(plan.solves, [&](const syntax::Solve& solve) { return names_of(session, plan, solve).contains(name); });
  const auto same = std::find_if(plan.lets.begin(), plan.lets.end(),
                                 [&](const syntax::Let& other) { return name_of(session, plan, other) == name; });
  if (same != plan.lets.end()) {
    *same = let;
  } else {
    plan.lets.push_back(let);
  }
}

/// Replaces what defined any of its unknowns, or adds it.
void take_solve(const Session& session, PiecePlan& plan, const syntax::Solve& solve) {
  const std::set<std::string> names = names_of(session, plan, solve);
  std::erase_if(plan.lets, [&](const syntax::Let& let) { return names.contains(name_of(session, plan, let)); });
  std::erase_if(plan.solves, [&](const syntax::Solve& other) {
    const std::set<std::string> others = names_of(session, plan, other);
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return others.contains(name); });
  });
  plan.solves.push_back(solve);
}

/// Darts, notches, pleats, marks: the first of a kind that a piece has of its own puts those of its model away.
class OwnDetails {
 public:
  explicit OwnDetails(PiecePlan& plan) : plan_(plan) {}

  void take(const syntax::View& item, const std::optional<syntax::For>& each) {
    const syntax::Kind kind = family(item);
    if (seen_.insert(kind).second) {
      std::erase_if(plan_.details, [&](const Repeated& detail) { return family(detail.written) == kind; });
    }
    plan_.details.push_back({item, each});
  }

 private:
  /// A dart goes with the pivots that move it.
  static syntax::Kind family(const syntax::View& item) {
    return item.kind() == syntax::Kind::Pivot ? syntax::Kind::Dart : item.kind();
  }

  PiecePlan& plan_;
  std::set<syntax::Kind> seen_;
};

}  // namespace

void PiecePlanner::plan_all() {
  for (const auto& piece : garment_.pieces) piece->late = is_late(*piece);
  for (const auto& piece : garment_.pieces) {
    if (!piece->late) plan(*piece);
  }
}

bool PiecePlanner::is_late(const PieceInstance& piece) const {
  const PieceInstance* next = &piece;
  for (std::size_t steps = 0; steps <= garment_.pieces.size(); ++steps) {
    if (next->written.taken()) return true;
    if (!next->written.base()) return false;
    const std::string name = session_.name_of(next->outer->module(), next->written.base());
    const PieceInstance* base = garment_.piece(name);
    if (base == nullptr) return next->outer->find(name) != nullptr;
    next = base;
  }
  return false;  // round in a circle, which is told
}

void PiecePlanner::vary(PieceInstance& piece, const PieceInstance& model) {
  piece.plan = model.plan;
  piece.sound = piece.sound && model.sound;
  piece.doubled = model.doubled;
  apply(piece);
}

void PiecePlanner::plan(PieceInstance& piece) {
  // From the piece back to one that varies none or is planned already, then forwards again.
  std::vector<std::pair<PieceInstance*, PieceInstance*>> way;  // each with the piece that it varies
  PieceInstance* next = &piece;
  while (next != nullptr && states_.try_emplace(next, State::Running).second) {
    PieceInstance* base = base_of(*next);
    way.emplace_back(next, base);
    next = base;
  }
  const Module& module = piece.outer->module();
  if (next != nullptr && states_[next] == State::Running) {
    PieceInstance& last = *way.back().first;
    session_.report.add(Problem("E0106", fmt::format("piece `{}` is a variation of itself", last.name))
                            .at(module.at(*last.written.base())));
    last.sound = false;
    way.back().second = nullptr;
  }
  std::reverse(way.begin(), way.end());
  for (const auto& [varied, base] : way) {
    if (base == nullptr) {
      apply(*varied);
    } else {
      vary(*varied, *base);
      for (PieceSource& source : varied->plan.sources) {
        if (source.model == base) source.model = varied;
      }
    }
    states_[varied] = State::Done;
  }
}

PieceInstance* PiecePlanner::base_of(PieceInstance& piece) {
  const auto written = piece.written.base();
  if (!written) return nullptr;
  const Module& module = piece.outer->module();
  const std::string name = session_.name_of(module, written);
  if (PieceInstance* base = garment_.piece(name)) return base;
  std::vector<std::string> names;
  for (const auto& each : garment_.pieces) {
    if (each.get() != &piece) names.push_back(each->name);
  }
  if (!garment_.doubled)
    report_unknown(session_, module, *written, fmt::format("there is no piece `{}` to vary", name), names);
  piece.sound = false;
  return nullptr;
}

void PiecePlanner::take_name(const Module& module, std::map<std::string, Location>& own, const syntax::Token& name) {
  const std::string text = session_.name_of(module, name);
  const auto [earlier, is_new] = own.try_emplace(text, module.at(name));
  if (is_new) return;
  session_.report.add(Problem("E0102", "`" + text + "` is defined twice")
                          .at(module.at(name), "defined again here")
                          .also(earlier->second, "first defined here"));
}

void PiecePlanner::apply(PieceInstance& piece) {
  PiecePlan& plan = piece.plan;
  const Module& module = piece.outer->module();
  plan.sources.push_back({piece.written, &piece});
  OwnDetails own(plan);
  std::vector<syntax::Inner> own_inner;
  std::map<std::string, Location> own_lets;
  std::map<std::string, Location> said;
  const auto once = [&](const syntax::View& item, const char* what) { return say_once(piece, said, item, what); };
  if (const auto on = piece.written.on()) plan.on = on;
  for (const syntax::View item : syntax::items(piece.written)) {
    if (const auto let = syntax::as<syntax::Let>(item)) {
      if (!let->name()) continue;
      take_name(module, own_lets, *let->name());
      take_let(session_, plan, *let);
    } else if (const auto solve = syntax::as<syntax::Solve>(item)) {
      for (const syntax::Sought& sought : solve->unknowns()) {
        if (sought.name()) take_name(module, own_lets, *sought.name());
      }
      take_solve(session_, plan, *solve);
    } else if (const auto outline = syntax::as<syntax::Outline>(item)) {
      if (!outline->origin() || once(item, "outline")) vary_outline(piece, *outline);
    } else if (const auto edge = syntax::as<syntax::Edge>(item)) {
      take_edge(piece, *edge);
    } else if (const auto inner = syntax::as<syntax::Inner>(item)) {
      own_inner.push_back(*inner);
    } else if (const auto fold = syntax::as<syntax::Fold>(item)) {
      if (once(item, "fold")) plan.fold = fold;
    } else if (const auto cut = syntax::as<syntax::Cut>(item)) {
      if (once(item, "cut")) plan.cut = cut;
    } else if (const auto grain = syntax::as<syntax::Grain>(item)) {
      if (once(item, "grain")) plan.grain = grain;
    } else if (const auto repeat = syntax::as<syntax::Repeat>(item)) {
      for (const syntax::View detail : syntax::items(*repeat)) own.take(detail, repeat->values());
    } else if (const auto allowance = syntax::as<syntax::Allowance>(item)) {
      if (once(item, "allowance")) plan.allowance = allowance;
    } else if (const auto label = syntax::as<syntax::Label>(item)) {
      if (once(item, "label")) plan.label = label;
    } else if (item.kind() != syntax::Kind::Allow) {
      own.take(item, std::nullopt);
    }
  }
  // On the fold and cut in pairs are two ways to have both halves: a variation's own word replaces the other one.
  const bool own_fold = said.contains("fold"), own_cut = said.contains("cut");
  if (own_cut && !own_fold && plan.cut->mirrored()) plan.fold.reset();
  if (own_fold && !own_cut && plan.cut && plan.cut->mirrored()) plan.cut.reset();
  // Two holes or lines of one name in one block stay two, for the definition of names to notice.
  std::erase_if(plan.inner, [&](const syntax::Inner& each) { return is_among(session_, plan, own_inner, each); });
  plan.inner.insert(plan.inner.end(), own_inner.begin(), own_inner.end());
}

bool PiecePlanner::say_once(PieceInstance& piece, std::map<std::string, Location>& said, const syntax::View& item,
                            const char* what) {
  const Location at = piece.outer->module().at(item);
  const auto [earlier, fresh] = said.try_emplace(what, at);
  if (fresh) return true;
  piece.sound = false;
  session_.report.add(Problem("E0102", fmt::format("piece `{}` says its {} twice", piece.name, what))
                          .at(at, "said again here")
                          .also(earlier->second, "first said here")
                          .help("leave one of them out"));
  return false;
}

void PiecePlanner::vary_outline(PieceInstance& piece, const syntax::Outline& outline) {
  PiecePlan& plan = piece.plan;
  const Module& module = piece.outer->module();
  if (!outline.origin()) {
    for (const syntax::View item : syntax::items(outline)) {
      if (const auto edge = syntax::as<syntax::Edge>(item)) take_edge(piece, *edge);
    }
    return;
  }
  plan.outline = outline;
  plan.edges.clear();
  for (const syntax::View item : syntax::items(outline)) {
    if (const auto repeat = syntax::as<syntax::Repeat>(item); repeat && repeat->values()) {
      plan.edges.push_back({"", {}, *repeat});
      continue;
    }
    const auto edge = syntax::as<syntax::Edge>(item);
    if (!edge || !edge->name()) continue;
    const std::string name = session_.name_of(module, edge->name());
    const auto same = std::find_if(plan.edges.begin(), plan.edges.end(),
                                   [&](const PlannedEdge& other) { return other.name == name; });
    if (same == plan.edges.end()) {
      plan.edges.push_back({name, *edge});
      continue;
    }
    session_.report.add(Problem("E0102", fmt::format("edge `{}` is drawn twice", name))
                            .at(module.at(*edge->name()), "drawn again here")
                            .also(module.at(*same->written.name()), "first drawn here")
                            .help("edges of one piece have different names, so that seams can tell them apart"));
    piece.sound = false;
    piece.doubled = true;
  }
}

void PiecePlanner::take_edge(PieceInstance& piece, const syntax::Edge& edge) {
  const Module& module = piece.outer->module();
  if (!edge.name()) return;
  const std::string name = session_.name_of(module, edge.name());
  for (PlannedEdge& planned : piece.plan.edges) {
    if (planned.name != name) continue;
    planned.written = edge;
    return;
  }
  piece.sound = false;
  if (module.broken(piece.written.span())) return;
  if (!piece.written.varies()) {
    session_.report.add(Problem("E0308", fmt::format("edge `{}` stands outside of an outline", name))
                            .at(module.at(*edge.name()))
                            .help("outline from (0cm, 0cm) { ... }"));
    return;
  }
  std::vector<std::string> known;
  for (const PlannedEdge& planned : piece.plan.edges) known.push_back(planned.name);
  const auto base = piece.written.base();
  const std::string varied =
      base ? session_.name_of(module, base) : std::string(session_.text(module, *piece.written.taken()));
  report_unknown(session_, module, *edge.name(), fmt::format("piece `{}` has no edge `{}` to replace", varied, name),
                 known, "E0308");
}

}  // namespace toile
