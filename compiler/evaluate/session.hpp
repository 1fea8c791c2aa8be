// What all of the evaluation shares, and the bounds that it keeps.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "compiler/diag/diagnostic.hpp"
#include "compiler/evaluate/instances.hpp"
#include "compiler/evaluate/reporter.hpp"

namespace toile {

struct Session {
  explicit Session(World& the_world) : world(the_world) {}

  World& world;
  Sources sources;
  Reporter report;
  std::vector<std::unique_ptr<Module>> modules;  // the first is the script
  /// `--set flare=20cm`, each a little text of its own.
  struct GivenSetting {
    std::string name;
    Module* module = nullptr;
    bool taken = false;
  };
  std::vector<GivenSetting> settings;
  std::vector<std::string> param_names;               // as settings may call them
  std::string size;                                   // `--size`, or empty
  std::vector<std::vector<std::string>> size_tables;  // the names of their sizes

  // Referred to by values, so they never move.
  std::deque<UserFunction> functions;
  std::deque<BodyTemplate> body_templates;
  std::deque<GarmentTemplate> garment_templates;
  std::deque<PieceTemplate> piece_templates;
  std::deque<std::unique_ptr<GarmentInstance>> garment_instances;
  std::deque<DrapeRecord> drapes;

  std::vector<Garment> garments;
  std::vector<DraftGarment> drafts;  // of which they were made
  std::vector<BodySpec> bodies;

  /// > 0 while something is checked that may never be computed: a branch that is not taken, a function that nothing
  /// calls. Names then stand for values without magnitude.
  int supposing = 0;
  /// While commands are checked and run a result must come from a drape above; before that it is only not known yet.
  bool in_commands = false;

  // Bounds.
  int depth = 0;
  std::intptr_t stack_base = 0;
  int call_depth = 0;
  long steps = 0;
  bool exhausted = false;  // a bound was met: unwind in silence
  std::vector<Definition*> running;
  long tries = 0;  // values tried by `solve`, so far; a change makes what depends on the last one stale

  /// What was found for calls and branches that were only supposed, by place and kinds of arguments.
  std::map<std::pair<const UserFunction*, std::string>, Value> supposed_calls;
  std::map<std::tuple<FileId, syntax::NodeId, std::string>, Value> supposed_branches;

  std::string_view text(const Module& module, const syntax::View& view) const {
    return sources[module.file].slice(view.span());
  }
  std::string name_of(const Module& module, const std::optional<syntax::Token>& token) const {
    return token ? std::string(text(module, *token)) : std::string();
  }
};

/// Sets a value for as long as a block runs.
template <typename T>
class Holding {
 public:
  Holding(T& place, T value) : place_(place), before_(place) { place = std::move(value); }
  ~Holding() { place_ = std::move(before_); }
  Holding(const Holding&) = delete;
  Holding& operator=(const Holding&) = delete;

 private:
  T& place_;
  T before_;
};

}  // namespace toile
