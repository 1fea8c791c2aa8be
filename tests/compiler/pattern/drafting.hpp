// Drafting garments by hand, as the front end would from a script.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "compiler/pattern/draft.hpp"

namespace toile::test {

/// Every place gets a span of its own, so that tests can tell which places a diagnostic shows.
inline Location next_place() {
  static std::uint32_t offset = 0;
  offset += 10;
  return {0, {offset, offset + 5}};
}

inline DraftEdge edge(std::string name, Curve curve) {
  return {std::move(name), std::move(curve), next_place()};
}

/// A polygon of named edges; each starts where the one before ends. `names[i]` runs from corner i to the next.
inline DraftPiece polygon(std::string name, const std::vector<Vec2>& corners, const std::vector<std::string>& names) {
  DraftPiece piece;
  piece.name = std::move(name);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    piece.outline.push_back(edge(names[i], line(corners[i], corners[(i + 1) % corners.size()])));
  }
  piece.written = next_place();
  return piece;
}

/// Drawn counter-clockwise from (0, 0): bottom, right, top, left.
inline DraftPiece rectangle(std::string name, double width, double height) {
  return polygon(std::move(name), {{0, 0}, {width, 0}, {width, height}, {0, height}},
                 {"bottom", "right", "top", "left"});
}

inline DraftPiece folded(DraftPiece piece, std::string fold) {
  piece.fold = std::move(fold);
  piece.fold_written = next_place();
  return piece;
}

inline DraftPiece paired(DraftPiece piece) {
  piece.mirrored = true;
  piece.quantity = 2;
  return piece;
}

inline DraftDart dart(std::string name, std::string edge_name, double at, double width, double depth) {
  return {std::move(name), std::move(edge_name), at, width, depth, next_place(), {}};
}

/// "front.side", "front.side.mirrored", "front.side.drawn", "front.eye.rim" or "front.eye.rim.mirrored".
inline DraftEdgeRef edge_ref(const std::string& text) {
  const auto first = text.find('.'), last = text.rfind('.');
  DraftEdgeRef reference{text.substr(0, first), text.substr(first + 1), {}, next_place()};
  if (text.substr(last) == ".mirrored") reference.side = Side::Mirrored;
  if (text.substr(last) == ".drawn") reference.side = Side::Drawn;
  if (reference.side) reference.edge = text.substr(first + 1, last - first - 1);
  return reference;
}

inline std::vector<DraftEdgeRef> refs(const std::vector<std::string>& texts) {
  std::vector<DraftEdgeRef> references;
  for (const std::string& text : texts) references.push_back(edge_ref(text));
  return references;
}

inline DraftSeam sew(const std::vector<std::string>& first, const std::vector<std::string>& second,
                     bool reversed = false) {
  DraftSeam seam;
  seam.first = refs(first);
  seam.second = refs(second);
  seam.reversed = reversed;
  seam.written = next_place();
  return seam;
}

inline DraftWear wear(const std::vector<std::string>& chain, std::string line_name) {
  return {refs(chain), std::move(line_name), true, 0, next_place()};
}

inline DraftGarment garment(std::vector<DraftPiece> pieces, std::vector<DraftSeam> seams = {},
                            std::vector<DraftWear> wears = {}) {
  DraftGarment draft;
  draft.name = "garment";
  draft.pieces = std::move(pieces);
  draft.seams = std::move(seams);
  draft.wears = std::move(wears);
  draft.written = next_place();
  return draft;
}

struct Made {
  Garment garment;
  std::vector<Diagnostic> diagnostics;
};

inline Made make(const DraftGarment& draft) {
  Made made;
  made.garment = make_garment(draft, made.diagnostics);
  return made;
}

inline std::vector<std::string> codes(const Made& made) {
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : made.diagnostics) found.push_back(diagnostic.code);
  return found;
}

/// For tests that need a sound garment: what was reported, or nothing.
inline std::string complaints(const Made& made) {
  std::string text;
  for (const Diagnostic& diagnostic : made.diagnostics) {
    if (diagnostic.severity == Severity::Error) text += diagnostic.code + " " + diagnostic.message + "\n";
  }
  return text;
}

/// "front.side", "front.waist#1", "-back.side.mirrored" (walked against the outline), joined by spaces.
inline std::string described(const Garment& made, const Chain& chain) {
  std::string text;
  for (const ChainLink& link : chain) {
    const Piece& piece = made.pieces[link.edge.piece];
    const PieceEdge& e = piece.edge(link.edge.edge);
    if (!text.empty()) text += " ";
    text += std::string(link.forward ? "" : "-") + piece.drawn_name + "." + e.name;
    if (e.part > 0) text += "#" + std::to_string(e.part);
    if (e.side == Side::Mirrored) text += ".mirrored";
  }
  return text;
}

inline std::vector<std::string> described_seams(const Garment& made) {
  std::vector<std::string> texts;
  for (const Seam& seam : made.seams) {
    if (!seam.is_dart) texts.push_back(described(made, seam.first) + " | " + described(made, seam.second));
  }
  return texts;
}

/// The half of a flared skirt's panel, drawn clockwise like the first script of the language.
inline DraftPiece flared_panel(std::string name) {
  const double w = 0.20, flare = 0.14, length = 0.60;
  DraftPiece piece;
  piece.name = std::move(name);
  piece.outline = {edge("waist", tangent_curve({0, 0}, 0, {w, 0.012}, 0.1745)),
                   edge("side", line({w, 0.012}, {w + flare, -length})),
                   edge("hem", tangent_curve({w + flare, -length}, 3.3, {0, -length - 0.01}, 3.14159265358979)),
                   edge("centre", line({0, -length - 0.01}, {0, 0}))};
  piece.darts = {dart("dart1", "waist", 0.11, 0.025, 0.09)};
  piece.notches = {{"side", 0.18, next_place()}, {"waist", 0.18, next_place()}};
  piece.allowances = {{"", 0.01, next_place()}, {"hem", 0.04, next_place()}};
  piece.written = next_place();
  return folded(std::move(piece), "centre");
}

inline DraftGarment flared_skirt() {
  return garment({flared_panel("front"), flared_panel("back")}, {sew({"front.side"}, {"back.side"})},
                 {wear({"front.waist", "back.waist"}, "waist")});
}

}  // namespace toile::test
