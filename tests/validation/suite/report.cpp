#include "tests/validation/suite/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace toile::validation {
namespace {

std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

std::string section(const Chapter& chapter) {
  std::string out = fmt::format("\n## {}\n\n{}\n\n", chapter.title, chapter.reference);
  out += "| case | quantity | reference | found | difference | held to | holds |\n|---|---|---|---|---|---|---|\n";
  for (const Figure& figure : chapter.figures) {
    const double off = figure.found - figure.reference;
    const std::string difference = figure.held_to.ends_with('%')
                                       ? fmt::format("{:+.3f} %", 100 * off / figure.reference)
                                       : fmt::format("{:+.2g}", off);
    out +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", figure.subject, figure.quantity, number(figure.reference),
                    number(figure.found), difference, figure.held_to, figure.holds() ? "yes" : "**no**");
  }
  for (const Picture& picture : chapter.pictures) {
    out += fmt::format("\n![{0}](validation/{1}.svg)\n\n{0}\n", picture.caption, picture.name);
  }
  if (!chapter.remarks.empty()) out += "\n";
  for (const std::string& remark : chapter.remarks) out += fmt::format("- {}\n", remark);
  return out;
}

}  // namespace

std::string page(const std::vector<Chapter>& chapters) {
  std::string out =
      "# Validation\n\nWhat the mechanics finds, beside what it should. This page and its plots are written by `./dev "
      "validate`; `./dev test`\nchecks the same cases at smaller sizes. A line that does not hold says so. What the "
      "terms are: [mechanics.md](mechanics.md).\n\n| chapter | lines | hold |\n|---|---|---|\n";
  for (const Chapter& chapter : chapters) {
    out += fmt::format("| {} | {} | {} |\n", chapter.title, chapter.figures.size(),
                       std::count_if(chapter.figures.begin(), chapter.figures.end(),
                                     [](const Figure& figure) { return figure.holds(); }));
  }
  for (const Chapter& chapter : chapters) out += section(chapter);
  return out;
}

}  // namespace toile::validation
