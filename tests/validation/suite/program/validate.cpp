// `./dev validate`: the whole suite, its figures into docs/validation.md. With names of cases only their chapters are
// written anew. One case after the other: OpenBLAS's serial build is not to be called by two threads at a time.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/validation/suite/report.hpp"

namespace toile::validation {
namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

int run(const std::vector<std::string>& arguments) {
  const bool quick = std::ranges::find(arguments, "--quick") != arguments.end();
  std::vector<std::string> wanted;
  std::filesystem::path folder;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--into" && i + 1 < arguments.size()) {
      folder = arguments[++i];
    } else if (arguments[i] != "--quick") {
      wanted.push_back(arguments[i]);
    }
  }
  std::vector<Chapter> chapters;
  for (const Case& each : cases()) {
    if (!wanted.empty() && std::ranges::find(wanted, each.name) == wanted.end()) continue;
    fmt::print(stderr, "{} …\n", each.name);
    chapters.push_back(each.run(quick ? Effort::Quick : Effort::Full));
    if (quick) chapters.back().remarks.emplace_back("At the sizes of `./dev test`.");
  }
  std::string before;
  if (std::ifstream in(folder / "validation.md"); in) before = {std::istreambuf_iterator<char>(in), {}};
  const std::string text = page(before, chapters);
  if (folder.empty()) {
    fmt::print("{}", text);
    return 0;
  }
  write(folder / "validation.md", text);
  for (const Chapter& chapter : chapters) {
    for (const Picture& picture : chapter.pictures) {
      write(folder / "validation" / (picture.name + ".svg"), plot_svg(picture.panels));
    }
  }
  return 0;
}

}  // namespace
}  // namespace toile::validation

int main(int argc, char** argv) {
  return toile::validation::run({argv + 1, argv + argc});
}
