#include "tests/validation/suite/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace toile::validation {
namespace {

std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

std::string section(const Chapter& chapter) {
  std::string out = fmt::format("{}\n\n{}\n\n", chapter.title, chapter.reference);
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

constexpr std::string_view heading = "\n## ";

/// What stands behind each heading, titles first.
std::vector<std::string> sections_of(const std::string& text) {
  std::vector<std::string> sections;
  for (std::size_t at = text.find(heading); at != std::string::npos;) {
    const std::size_t begin = at + heading.size();
    at = text.find(heading, begin);
    sections.push_back(text.substr(begin, at == std::string::npos ? at : at - begin));
  }
  return sections;
}

std::string title_of(const std::string& section) {
  return section.substr(0, section.find('\n'));
}

int count(const std::string& text, std::string_view what) {
  int times = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++times;
  return times;
}

}  // namespace

std::string page(const std::string& before, const std::vector<Chapter>& chapters) {
  std::vector<std::string> sections = sections_of(before);
  for (const Chapter& chapter : chapters) {
    const auto stood = std::ranges::find(sections, chapter.title, title_of);
    if (stood == sections.end()) {
      sections.push_back(section(chapter));
    } else {
      *stood = section(chapter);
    }
  }
  std::string out =
      "# Validation\n\nWhat the mechanics finds, beside what it should. This page and its plots are written by `./dev "
      "validate`; `./dev test`\nchecks the same cases at smaller sizes. A line that does not hold says so. What the "
      "terms are: [mechanics.md](mechanics.md).\n\n| chapter | lines | hold |\n|---|---|---|\n";
  for (const std::string& section : sections) {
    const int hold = count(section, "| yes |\n");
    out += fmt::format("| {} | {} | {} |\n", title_of(section), hold + count(section, "| **no** |\n"), hold);
  }
  for (const std::string& section : sections) out += std::string(heading) + section;
  return out;
}

}  // namespace toile::validation
