// `./dev validate`: the whole suite, its figures into docs/validation.md. With names of cases only those, printed.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>
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
  std::vector<std::future<Chapter>> running;  // no case knows of another
  for (const Case& each : cases()) {
    if (!wanted.empty() && std::ranges::find(wanted, each.name) == wanted.end()) continue;
    running.push_back(std::async(std::launch::async, [&each, quick] {
      Chapter chapter = each.run(quick ? Effort::Quick : Effort::Full);
      fmt::print(stderr, "{}: done\n", each.name);
      return chapter;
    }));
  }
  std::vector<Chapter> chapters;
  for (std::future<Chapter>& each : running) chapters.push_back(each.get());
  const std::string text = page(chapters);
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
