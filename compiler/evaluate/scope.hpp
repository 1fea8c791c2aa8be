// Names and what they stand for. Definitions are lazy: each is evaluated when it is first asked for, so they may stand
// in any order; a definition that needs itself is noticed on the way.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/evaluate/value.hpp"
#include "grammar/source.hpp"

namespace toile {

struct Definition {
  std::string name;
  Location at;  // of the name
  std::function<Value()> compute;
  enum class State { Fresh, Running, Done } state = State::Fresh;
  Value value;
  /// While `solve` looks for it: the value that is tried, and how many definitions ran outside of that solve.
  struct Tried {
    Value value;
    std::size_t depth = 0;
  };
  std::optional<Tried> tried;
  /// Made from values that were tried by solves at this depth or deeper: good for the try of that number alone.
  std::optional<std::size_t> depends_on_try;
  long made_in_try = 0;
  bool is_let = false;            // of a piece
  bool used = false;              // by what was evaluated or checked so far
  bool yields = false;            // an edge: a value of that name outside of its piece comes before it
  std::optional<Value> supposed;  // as a branch that is not taken sees it (definitions within a call)
};

class Scope {
 public:
  /// `signature`: the kinds of a call's arguments, for what is remembered of checks; empty outside of calls.
  Scope(Module& module, const Scope* parent, bool is_call = false, std::string signature = "")
      : module_(&module), parent_(parent), is_call_(is_call), signature_(std::move(signature)) {}
  /// Sees what is defined in `names`, as far as one of `models` has that name, too: where what is written about one
  /// piece is read again for a variation of it.
  Scope(Module& module, const Scope* parent, const Scope& names, std::vector<const Scope*> models)
      : module_(&module), parent_(parent), is_call_(false), names_(&names), models_(std::move(models)) {}
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;
  Scope(Scope&&) = default;
  Scope& operator=(Scope&&) = default;
  ~Scope() = default;

  Module& module() const { return *module_; }
  /// Definitions in a call's scope, or in one inside of it, are gone when the call ends.
  bool is_call() const { return is_call_; }
  std::string signature() const { return parent_ == nullptr ? signature_ : parent_->signature() + "|" + signature_; }

  /// The definition of that name in this block alone, or null.
  Definition* own(std::string_view name) const;
  /// The innermost definition seen from here, or null; `where` tells the scope it stands in. A definition that yields
  /// is found only where there is no other, or when it is preferred.
  Definition* find(std::string_view name, const Scope** where = nullptr, bool prefer_edges = false) const;
  /// Null when the name is taken already; an unknown name may then be the one that was meant.
  Definition* define(std::string name, Location at, std::function<Value()> compute);
  void define_value(std::string name, Location at, Value value);

  /// In the order in which they were defined.
  const std::vector<std::unique_ptr<Definition>>& definitions() const { return definitions_; }
  /// All names seen from here, for suggestions.
  std::vector<std::string> visible_names() const;
  std::vector<std::string> own_names() const;
  /// Whether a name was defined twice here, or in a scope around.
  bool is_doubled() const { return doubled_ || (parent_ != nullptr && parent_->is_doubled()); }

 private:
  Module* module_;
  const Scope* parent_;
  bool is_call_;
  bool doubled_ = false;
  const Scope* names_ = nullptr;
  std::vector<const Scope*> models_;
  std::string signature_;
  std::vector<std::unique_ptr<Definition>> definitions_;
  std::map<std::string, Definition*, std::less<>> by_name_;
};

}  // namespace toile
