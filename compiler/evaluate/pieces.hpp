// Pieces: which statements make one up once variations are applied, its edges walked by the pen, and what else it says.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Puts together what a piece consists of: its own statements, or those of the piece that it varies with its own in
/// their place. `earlier` are the garment's pieces by name, written in any order.
class PiecePlanner {
 public:
  PiecePlanner(Session& session, GarmentInstance& garment) : session_(session), garment_(garment) {}

  /// The plans of all pieces of the garment but those that are taken from elsewhere or vary what is, which are late; a
  /// variation of itself is an error.
  void plan_all();
  /// The plan of a piece that varies one from elsewhere.
  void vary(PieceInstance& piece, const PieceInstance& model);

 private:
  bool is_late(const PieceInstance& piece) const;
  void plan(PieceInstance& piece);
  /// The piece that it varies; null for none, and with an error for an unknown one.
  PieceInstance* base_of(PieceInstance& piece);
  void apply(PieceInstance& piece);
  /// False for what the piece has said before: that is reported.
  bool say_once(PieceInstance& piece, std::map<std::string, Location>& said, const syntax::View& item,
                const char* what);
  void vary_outline(PieceInstance& piece, const syntax::Outline& outline);
  void take_edge(PieceInstance& piece, const syntax::Edge& edge);
  /// Reports a name that the same piece has defined before.
  void take_name(const Module& module, std::map<std::string, Location>& own, const syntax::Token& name);

  Session& session_;
  GarmentInstance& garment_;
  enum class State { Running, Done };
  std::map<const PieceInstance*, State> states_;
};

/// Defines the lets, edges and holes of a planned piece in its scope. Edges are curves; each begins where the one
/// before ends.
void define_piece_names(Session& session, PieceInstance& piece);

/// The piece as drafted. Sets `piece.sound` to false after a mistake.
DraftPiece draft_piece(Session& session, PieceInstance& piece);

}  // namespace toile
