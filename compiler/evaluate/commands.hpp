// A script's commands: checked all together before anything runs, then evaluated one by one.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/evaluate/program.hpp"
#include "compiler/evaluate/session.hpp"

namespace toile {

class Commands {
 public:
  explicit Commands(Session& session) : session_(session) {}

  /// Defines the names of results (`drape … as worn`).
  void define_results();
  /// Checks every command with results of which only the dimensions are known.
  void check();
  /// The next command with its values, or nothing at the end or after an error.
  std::optional<Command> next();
  void give(const Result& result);
  /// Those that the commands drape or export: indices among the garments.
  std::set<int> garments() const;

 private:
  /// What checking a command has found out once and for all.
  struct Planned {
    syntax::View written;
    DrapeRecord* drape = nullptr;
    std::optional<Command> command;  // complete, but for what depends on results
  };

  void check_drape(Planned& planned, const syntax::Drape& drape);
  /// The garment that is draped, or over which another one is; null where it has no cloth yet, which is reported.
  const GarmentInstance* draped_garment(const syntax::Expr& expr);
  void check_bodies(const syntax::Drape& drape, const GarmentInstance& garment, const BodyInstance* body);
  /// `drape form on skirt`: reported.
  bool put_the_wrong_way_round(const syntax::Drape& drape);
  void check_develop(Planned& planned, const syntax::Develop& develop);
  void check_render(Planned& planned, const syntax::Render& render);
  void check_export(Planned& planned, const syntax::Export& output);
  void check_print(const syntax::Print& print);
  void check_expect(const syntax::Expect& expect);

  std::optional<Command> print(const syntax::Print& print);
  std::optional<Command> expect(const syntax::Expect& expect);

  /// A checked output path with one of these extensions, or nothing.
  std::optional<std::string> output_path(const std::optional<syntax::Expr>& path, const std::string& what,
                                         const std::vector<std::string>& extensions);
  /// The development of that name among the commands above.
  const DrapeRecord* development_called(std::string_view name) const;
  void check_drape_of_development(Planned& planned, const syntax::Drape& drape, DrapeCommand made);
  /// The drape whose result an expression names.
  const DrapeRecord* result(const syntax::Expr& expr, const Value& value);

  const Scope& scope() const { return *session_.modules.front()->scope; }
  const Module& module() const { return *session_.modules.front(); }

  Session& session_;
  std::vector<Planned> planned_;
  std::map<std::string, Location> outputs_;
  std::size_t next_ = 0;
  DrapeRecord* running_ = nullptr;
};

}  // namespace toile
