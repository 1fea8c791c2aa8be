#include "compiler/evaluate/unused.hpp"

#include <map>
#include <string>
#include <vector>

#include "compiler/diag/nearest.hpp"

namespace toile {
namespace {

struct Let {
  std::string name;
  Location at;
  bool used = false;
  const PieceInstance* piece = nullptr;
};

/// Those that variations say themselves. A let is one however often its piece was made.
class Lets {
 public:
  explicit Lets(FileId script) : script_(script) {}

  void add(const PieceInstance& piece) {
    const Span said = piece.written.span();
    for (const auto& definition : piece.scope->definitions()) {
      if (!definition->is_let || definition->at.file != script_) continue;
      if (definition->at.span.begin < said.begin || definition->at.span.end > said.end) continue;
      Let& let = all_[definition->at.span.begin];
      let = {definition->name, definition->at, let.used || definition->used, &piece};
    }
  }

  std::vector<Let> unused() const {
    std::vector<Let> found;
    for (const auto& [at, let] : all_) {
      if (!let.used) found.push_back(let);
    }
    return found;
  }

 private:
  FileId script_;
  std::map<std::uint32_t, Let> all_;
};

/// What the models of a variation define, which a let of it may replace.
std::vector<std::string> replaceable(const PieceInstance& piece) {
  std::vector<std::string> names;
  for (const auto& definition : piece.scope->definitions()) {
    if (definition->is_let) names.push_back(definition->name);
  }
  if (piece.parameters != nullptr) {
    for (const std::string& name : piece.parameters->own_names()) names.push_back(name);
  }
  return names;
}

void report(Session& session, const Let& let) {
  session.report.add(
      Problem("W0120", "nothing uses `" + let.name + "`, so that it changes nothing of the piece that is varied")
          .at(let.at)
          .help(suggestion(let.name, replaceable(*let.piece))));
}

}  // namespace

void report_unused_lets(Session& session) {
  if (session.report.has_errors()) return;  // what uses it may not have been understood
  const Module& script = *session.modules.front();
  Lets lets(script.file);
  for (const auto& garment : session.garment_instances) {
    for (const auto& piece : garment->pieces) {
      if (piece->scope != nullptr && piece->written.varies()) lets.add(*piece);
    }
  }
  for (const Let& let : lets.unused()) report(session, let);
}

}  // namespace toile
