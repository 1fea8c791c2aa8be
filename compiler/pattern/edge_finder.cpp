#include <fmt/format.h>

#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

// The hole or the line that has an edge of that name, and which of the two it is.
struct Holder {
  const DraftInner* inner = nullptr;
  const char* kind = "";
};

Holder holder_of(const DraftPiece& piece, const std::string& edge) {
  const auto find = [&](const std::vector<DraftInner>& all, const char* kind) {
    for (const DraftInner& inner : all) {
      for (const DraftEdge& own : inner.edges) {
        if (own.name == edge) return Holder{&inner, kind};
      }
    }
    return Holder{};
  };
  const Holder hole = find(piece.holes, "hole");
  return hole.inner != nullptr ? hole : find(piece.lines, "line");
}

void report_unknown_edge(const DraftPiece& piece, const DraftEdgeRef& reference, Findings& findings) {
  std::vector<Label> labels{{reference.written, "unknown edge"}, {piece.written, "the piece"}};
  const Holder holder = holder_of(piece, reference.edge);
  const DraftInner* const inner = holder.inner;
  if (inner == nullptr) {
    std::vector<std::string> names;
    for (const DraftEdge& edge : piece.outline) names.push_back(edge.name);
    for (const auto* all : {&piece.holes, &piece.lines}) {
      for (const DraftInner& other : *all) {
        for (const DraftEdge& own : other.edges) names.push_back(other.name + "." + own.name);
      }
    }
    findings.error("E0308", "piece " + quoted(piece.name) + " has no edge named " + quoted(reference.edge),
                   std::move(labels), suggestion(reference.edge, names));
    return;
  }
  labels.push_back({inner->written, fmt::format("the {}", holder.kind)});
  const std::string owner = inner->name.empty() ? "a hole" : fmt::format("{} {}", holder.kind, quoted(inner->name));
  findings.error(
      "E0308", fmt::format("edge {} of piece {} belongs to {}", quoted(reference.edge), quoted(piece.name), owner),
      std::move(labels),
      inner->name.empty()
          ? fmt::format("give the hole a name, `hole eye from ...`, and write `{}.eye.{}`", piece.name, reference.edge)
          : fmt::format("write `{}.{}.{}`", piece.name, inner->name, reference.edge));
}

}  // namespace

const DraftEdge* drafted_edge(const DraftPiece& piece, const std::string& name) {
  for (const DraftEdge& edge : piece.outline) {
    if (edge.name == name) return &edge;
  }
  for (const auto* all : {&piece.holes, &piece.lines}) {
    for (const DraftInner& inner : *all) {
      for (const DraftEdge& own : inner.edges) {
        if (!inner.name.empty() && inner.name + "." + own.name == name) return &own;
      }
    }
  }
  return nullptr;
}

EdgeFinder::EdgeFinder(const DraftGarment& draft, const std::vector<Piece>& pieces) : draft_(draft), pieces_(pieces) {
  for (const DraftPiece& piece : draft.pieces) drafted_.try_emplace(piece.name, &piece);
  for (std::size_t i = 0; i < pieces.size(); ++i) cut_from_[pieces[i].drawn_name].push_back(static_cast<PieceId>(i));
}

// In the order of the outline, which is that of the index. What a pleat folds under the sewn line passes by.
std::optional<Chain> EdgeFinder::parts_of(const DraftEdgeRef& reference, Side side) const {
  Chain chain;
  const auto pieces = cut_from_.find(reference.piece);
  if (pieces == cut_from_.end()) return std::nullopt;
  for (const PieceId p : pieces->second) {
    for (int e = 0; e < pieces_[p].edge_count(); ++e) {
      const PieceEdge& candidate = pieces_[p].edge(e);
      if (candidate.is_dart_leg || candidate.folded_under) continue;
      if (candidate.name != reference.edge || candidate.side != side) continue;
      constexpr double slack = 1e-5;  // [m]
      const std::optional<DrawnSpan>& part = reference.part;
      if (part && (candidate.drawn.from < part->from - slack || candidate.drawn.to > part->to + slack)) continue;
      chain.push_back({{p, e}, true});
    }
  }
  if (chain.empty()) return std::nullopt;
  return chain;
}

std::optional<FoundEdge> EdgeFinder::find(const DraftEdgeRef& reference, const char* deed, Findings& findings) const {
  const auto known = drafted_.find(reference.piece);
  const DraftPiece* const piece = known == drafted_.end() ? nullptr : known->second;
  if (piece == nullptr) {
    std::vector<std::string> names;
    for (const DraftPiece& p : draft_.pieces) names.push_back(p.name);
    findings.error("E0309",
                   fmt::format("garment {} has no piece named {}", quoted(draft_.name), quoted(reference.piece)),
                   {{reference.written, "unknown piece"}}, suggestion(reference.piece, names));
    return std::nullopt;
  }
  if (piece->fold && reference.edge == *piece->fold) {
    const bool cut =
        std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& each) { return each.drawn_name == piece->name; });
    if (!cut) return std::nullopt;  // what is wrong with the piece, perhaps with its fold, has been told
    findings.error(
        "E0315", fmt::format("the fold {} of piece {} cannot be {}", quoted(reference.edge), quoted(piece->name), deed),
        {{reference.written, "here"}, {piece->fold_written, "the fold is no edge of the unfolded piece"}},
        "leave this out, or leave out the fold to have a seam there");
    return std::nullopt;
  }
  if (drafted_edge(*piece, reference.edge) == nullptr) {
    report_unknown_edge(*piece, reference, findings);
    return std::nullopt;
  }
  FoundEdge found{&reference, piece->fold || piece->mirrored, {}};
  if (reference.side == Side::Mirrored && !found.copied) {
    findings.error("E0322", fmt::format("piece {} has no mirrored copy", quoted(piece->name)),
                   {{reference.written, "there is one copy of this edge"}, {piece->written, "the piece"}},
                   "a piece has copies when it lies on the fold or is cut mirrored");
    return std::nullopt;
  }
  for (const Side side : {Side::Drawn, Side::Mirrored}) {
    found.copies[static_cast<std::size_t>(side)] = parts_of(reference, side);
  }
  return found;
}

std::optional<std::vector<FoundEdge>> EdgeFinder::find(const std::vector<DraftEdgeRef>& references, const char* deed,
                                                       Findings& findings) const {
  std::vector<FoundEdge> found;
  for (const DraftEdgeRef& reference : references) {
    if (const std::optional<FoundEdge> edge = find(reference, deed, findings)) found.push_back(*edge);
  }
  if (found.size() != references.size() || found.empty()) return std::nullopt;
  return found;
}

}  // namespace toile
