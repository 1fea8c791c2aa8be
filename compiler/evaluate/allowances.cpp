#include "compiler/evaluate/allowances.hpp"

#include <fmt/format.h>

#include "compiler/diag/codes.hpp"
#include "compiler/evaluate/names.hpp"

namespace toile {
namespace {

void allow(Session& session, const Module& module, const syntax::Allow& written, Location block) {
  for (const syntax::Token& token : written.codes()) {
    const std::string code = session.name_of(module, token);
    if (find_code(code) == nullptr) {
      std::vector<std::string> known;
      for (const CodeEntry& entry : code_registry()) {
        if (entry.code.starts_with('W')) known.emplace_back(entry.code);
      }
      report_unknown(session, module, token, fmt::format("there is no warning `{}`", code), known);
    } else if (!code.starts_with('W')) {
      session.report.add(Problem("E0121", fmt::format("{} is an error, and only warnings can be allowed", code))
                             .at(module.at(token))
                             .help("toile explain " + code));
    } else {
      session.report.allow(code, block);
    }
  }
}

void read_block(Session& session, const Module& module, const syntax::View& owner, Location block) {
  for (const syntax::View item : syntax::items(owner)) {
    if (const auto written = syntax::as<syntax::Allow>(item)) allow(session, module, *written, block);
    const bool holds = item.kind() == syntax::Kind::Garment || item.kind() == syntax::Kind::Piece;
    if (holds) read_block(session, module, item, module.at(item));
  }
}

}  // namespace

void read_allowances(Session& session, const Module& module) {
  const auto size = static_cast<std::uint32_t>(session.sources[module.file].text().size());
  read_block(session, module, syntax::root(module.parsed.tree), {module.file, {0, size}});
}

}  // namespace toile
