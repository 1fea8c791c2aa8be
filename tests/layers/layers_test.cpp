// The written architecture held to: who may include whom, where heavy libraries are seen, how long a file may grow.
// The tables here are the architecture; ARCHITECTURE.md explains them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A folder may include itself and what stands here; nothing else of the tree.
const std::map<std::string, std::set<std::string>> allowed{
    {"grammar", {}},
    {"grammar/format", {"grammar"}},
    {"grammar/reference", {"grammar"}},
    // the front end: text to pattern; no meshes, no files, no threads
    {"compiler/diag", {"grammar"}},
    {"compiler/units", {"grammar", "compiler/diag"}},
    {"compiler/solve", {}},
    {"compiler/curve", {"compiler/solve"}},
    {"compiler/pattern", {"grammar", "compiler/diag", "compiler/curve"}},
    {"compiler/evaluate",
     {"grammar", "compiler/diag", "compiler/units", "compiler/solve", "compiler/curve", "compiler/pattern"}},
    // pattern to meshes
    {"compiler/pmesh", {"grammar", "compiler/curve", "compiler/pattern"}},
    {"compiler/smesh", {"grammar", "compiler/curve", "compiler/pattern", "compiler/pmesh"}},
    // the runtime: meshes to equilibrium, pictures and files; no text, no syntax, no evaluation
    {"runtime/library", {}},
    {"runtime/mesh", {"compiler/curve", "compiler/pmesh", "compiler/smesh"}},
    {"runtime/fabric", {"compiler/pattern"}},
    {"runtime/body", {"compiler/curve", "compiler/pattern", "runtime/mesh"}},
    {"runtime/solve", {"runtime/library", "runtime/mesh"}},
    {"runtime/energy", {"compiler/curve", "compiler/smesh", "runtime/mesh", "runtime/fabric", "runtime/solve"}},
    {"runtime/contact",
     {"compiler/curve", "compiler/smesh", "runtime/mesh", "runtime/body", "runtime/energy", "runtime/solve"}},
    {"runtime/place",
     {"compiler/curve", "compiler/pmesh", "compiler/smesh", "runtime/mesh", "runtime/body", "runtime/contact",
      "runtime/solve"}},
    {"runtime/drape",
     {"compiler/curve", "compiler/pattern", "compiler/smesh", "runtime/mesh", "runtime/fabric", "runtime/body",
      "runtime/energy", "runtime/contact", "runtime/solve", "runtime/place"}},
    {"runtime/develop",
     {"compiler/curve", "compiler/pattern", "compiler/pmesh", "compiler/smesh", "runtime/mesh", "runtime/fabric",
      "runtime/body", "runtime/energy", "runtime/place", "runtime/drape", "runtime/solve"}},
    {"runtime/field", {"compiler/curve", "runtime/mesh", "runtime/drape"}},
    {"runtime/laboratory",
     {"compiler/curve", "compiler/pattern", "runtime/mesh", "runtime/fabric", "runtime/energy", "runtime/solve"}},
    {"runtime/png", {}},
    {"runtime/render",
     {"compiler/curve", "compiler/pattern", "runtime/library", "runtime/mesh", "runtime/body", "runtime/drape",
      "runtime/field", "runtime/png"}},
    {"runtime/export",
     {"compiler/curve", "compiler/pattern", "compiler/pmesh", "compiler/smesh", "runtime/mesh", "runtime/body",
      "runtime/drape", "runtime/develop", "runtime/field", "runtime/png"}},
    {"runtime/report",
     {"compiler/curve", "compiler/pattern", "compiler/pmesh", "compiler/smesh", "runtime/mesh", "runtime/body",
      "runtime/contact", "runtime/drape", "runtime/develop", "runtime/field", "runtime/export"}},
    // other programs' patterns: files to plain structs to the text of a script
    {"runtime/import", {"grammar", "compiler/curve", "compiler/pattern"}},
    {"stdlib", {}},
    // the one place that sees both sides, and the command line above it
    {"runtime/driver",
     {"grammar",           "grammar/format",   "grammar/reference", "stdlib",         "compiler/diag",
      "compiler/evaluate", "compiler/pattern", "compiler/pmesh",    "compiler/smesh", "runtime/mesh",
      "runtime/body",      "runtime/place",    "runtime/drape",     "runtime/field",  "runtime/solve",
      "runtime/render",    "runtime/png",      "runtime/export",    "runtime/report", "runtime/import",
      "runtime/develop",   "runtime/fabric",   "runtime/laboratory"}},
    {"runtime/cli",
     {"compiler/diag", "compiler/evaluate", "runtime/drape", "runtime/solve", "runtime/report", "runtime/driver"}},
};

/// Headers that cost seconds a file: the start of the include, and the folders that may have it. A header that has it
/// is private: only its own folder includes it.
const std::map<std::string, std::set<std::string>> heavy{
    {"tao/pegtl", {"grammar"}},
    {"CGAL/", {"compiler/pmesh", "runtime/contact"}},
    {"CLI/", {"runtime/cli"}},
    {"nlohmann/", {"runtime/export", "runtime/report", "runtime/import", "runtime/cli"}},
    {"embree", {"runtime/render"}},
    {"tbb/", {"runtime/solve", "runtime/render", "runtime/cli"}},
    {"cholmod", {"runtime/solve"}},
    {"Eigen/", {"runtime/body", "runtime/mesh", "runtime/place", "runtime/develop"}},
    {"png.h", {"runtime/png"}},
    {"regex", {}},
};
/// Eigen's dense types, which the mechanics share through one light header, are not heavy.
const std::set<std::string> not_heavy{"Eigen/Core", "Eigen/Geometry"};

constexpr int most_lines = 400;
constexpr int most_files_with_one_heavy_library = 6;

struct Include {
  std::string path;
  int line = 0;
};

struct SourceFile {
  std::string path;    // from the root of the tree
  std::string folder;  // "compiler/curve"
  bool is_header = false;
  int lines = 0;
  std::vector<Include> includes;
};

SourceFile read(const fs::path& root, const fs::path& path) {
  SourceFile file;
  file.path = fs::relative(path, root).generic_string();
  file.folder = fs::path(file.path).parent_path().generic_string();
  file.is_header = path.extension() == ".hpp";
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    ++file.lines;
    if (line.rfind("#include", 0) != 0) continue;
    const std::size_t begin = line.find_first_of("\"<");
    const std::size_t end = line.find_first_of("\">", begin + 1);
    if (end != std::string::npos) file.includes.push_back({line.substr(begin + 1, end - begin - 1), file.lines});
  }
  return file;
}

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> files = [] {
    const fs::path root = TOILE_SOURCE_DIR;
    std::vector<SourceFile> found;
    for (const char* top : {"grammar", "compiler", "runtime", "stdlib", "tests"}) {
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
        const fs::path extension = entry.path().extension();
        if (extension == ".cpp" || extension == ".hpp") found.push_back(read(root, entry.path()));
      }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return found;
  }();
  return files;
}

bool is_test(const SourceFile& file) {
  return file.folder.rfind("tests", 0) == 0;
}

bool is_ours(const std::string& include) {
  const std::string top = include.substr(0, include.find('/'));
  return top == "grammar" || top == "compiler" || top == "runtime" || top == "stdlib" || top == "tests";
}

std::string at(const SourceFile& file, const Include& include) {
  return file.path + ":" + std::to_string(include.line) + " includes " + include.path;
}

TEST(Layers, HaveEveryFolderInTheTable) {
  for (const SourceFile& file : sources()) {
    if (is_test(file)) continue;
    EXPECT_TRUE(allowed.count(file.folder)) << file.path << " stands in a folder without a layer";
  }
}

TEST(Layers, LinkOnlyDownwards) {
  for (const SourceFile& file : sources()) {
    const auto layer = allowed.find(file.folder);
    if (layer == allowed.end()) continue;
    for (const Include& include : file.includes) {
      if (!is_ours(include.path)) continue;
      const std::string folder = fs::path(include.path).parent_path().generic_string();
      EXPECT_TRUE(folder == file.folder || layer->second.count(folder)) << at(file, include);
    }
  }
}

TEST(Layers, HaveNoCircle) {
  // Removes, again and again, what needs nothing that is left; a circle stays behind.
  std::map<std::string, std::set<std::string>> left = allowed;
  for (bool removed = true; removed;) {
    removed = false;
    for (auto layer = left.begin(); layer != left.end();) {
      const bool is_free = std::none_of(layer->second.begin(), layer->second.end(),
                                        [&left](const std::string& below) { return left.count(below) > 0; });
      removed |= is_free;
      layer = is_free ? left.erase(layer) : std::next(layer);
    }
  }
  EXPECT_THAT(left, testing::IsEmpty());
}

/// The heavy library that an include belongs to, or nothing.
std::string heavy_library(const Include& include) {
  if (not_heavy.count(include.path)) return "";
  for (const auto& [library, folders] : heavy) {
    if (include.path.rfind(library, 0) == 0) return library;
  }
  return "";
}

TEST(HeavyLibraries, AreSeenInTheirFoldersOnly) {
  std::set<std::string> private_headers;
  for (const SourceFile& file : sources()) {
    if (is_test(file)) continue;
    for (const Include& include : file.includes) {
      const std::string library = heavy_library(include);
      if (library.empty()) continue;
      EXPECT_TRUE(heavy.at(library).count(file.folder)) << at(file, include);
      if (file.is_header) private_headers.insert(file.path);
    }
  }
  for (const SourceFile& file : sources()) {
    for (const Include& include : file.includes) {
      if (!private_headers.count(include.path)) continue;
      EXPECT_EQ(fs::path(include.path).parent_path().generic_string(), file.folder) << at(file, include);
    }
  }
}

TEST(HeavyLibraries, AreSeenInFewFiles) {
  std::map<std::string, std::set<std::string>> seen_in;
  for (const SourceFile& file : sources()) {
    if (is_test(file)) continue;
    for (const Include& include : file.includes) {
      if (const std::string library = heavy_library(include); !library.empty()) seen_in[library].insert(file.path);
    }
  }
  for (const auto& [library, files] : seen_in) {
    EXPECT_LE(files.size(), static_cast<std::size_t>(most_files_with_one_heavy_library))
        << library << " in " << testing::PrintToString(files);
  }
}

TEST(Files, StayShort) {
  for (const SourceFile& file : sources()) {
    EXPECT_LE(file.lines, most_lines) << file.path;
  }
}

TEST(Headers, IncludeFromTheRoot) {
  for (const SourceFile& file : sources()) {
    for (const Include& include : file.includes) {
      EXPECT_NE(include.path.rfind("..", 0), 0u) << at(file, include);
    }
  }
}

}  // namespace
