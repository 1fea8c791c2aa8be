#include "runtime/driver/golden.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "runtime/driver/diff.hpp"
#include "runtime/driver/files.hpp"
#include "runtime/driver/run.hpp"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// What a script asks of its test.
struct Directives {
  std::vector<std::string> stages;
  WorkroomOptions options;
  bool run = false;
  std::string error;
};

Directives read_directives(const std::string& script) {
  Directives found;
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("//!", 0) != 0) continue;
    std::istringstream words(line.substr(3));
    std::string word;
    words >> word;
    if (word == "run") {
      found.run = true;
    } else if (word == "triangles") {
      if (!(words >> found.options.triangles) || found.options.triangles < 1) found.error = line;
    } else if (word == "emit") {
      for (std::string stage; words >> stage;) {
        if (!stage_named(stage)) found.error = line;
        found.stages.push_back(stage);
      }
    } else if (word == "size") {
      words >> found.options.size;
    } else if (word == "set") {
      std::string name, expression;
      std::getline(words >> std::ws, name, '=');
      std::getline(words, expression);
      found.options.settings.push_back({name, expression});
    } else {
      found.error = line;
    }
  }
  return found;
}

/// Writes down what a workroom says; files are named without their folder.
class Transcript final : public Listener {
 public:
  void diagnosed(const Diagnostic& diagnostic, const Sources& sources) override {
    add(render(diagnostic, sources, false));
  }
  void printed(const std::string& line) override { add(line); }
  void noted(const std::string& line) override { add(line); }
  void wrote(const std::string& path) override { add("wrote " + fs::path(path).filename().string()); }
  void failed(const std::string& message, const std::string& help) override {
    add("error: " + message + (help.empty() ? "" : "\nhelp: " + help));
  }
  const std::string& text() const { return text_; }

 private:
  void add(const std::string& text) {
    text_ += text;
    if (text_.empty() || text_.back() != '\n') text_ += '\n';
  }
  std::string text_;
};

/// A folder for what tested scripts write, gone with this object.
class ScratchFolder {
 public:
  ScratchFolder() : path_(fs::temp_directory_path() / fmt::format("toile-test-{}", ::getpid())) {}
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Golden texts by the ending of their files.
using Goldens = std::map<std::string, std::string>;

Goldens find_out(const fs::path& script, const std::string& text, Directives directives, const fs::path& scratch,
                 const Job& job) {
  Transcript transcript;
  directives.options.out = scratch;
  Workroom workroom(directives.options, transcript, job);
  Goldens found;
  if (workroom.load(script.filename().string(), text, script.parent_path())) {
    if (directives.run) {
      run_commands(workroom);
    } else {
      check_meshes(workroom);
    }
    for (const std::string& stage : directives.stages) {
      if (const auto emitted = emit_stage(workroom, *stage_named(stage), "")) found["." + stage] = *emitted;
    }
  }
  found[".out"] = transcript.text();
  return found;
}

class Tester {
 public:
  Tester(bool update, Listener& listener, const Job& job) : update_(update), listener_(listener), job_(job) {}

  void test(const fs::path& script) {
    std::string error;
    const std::optional<std::string> text = read_file(script, error);
    if (!text) return fail(script, error + "\n");
    const Directives directives = read_directives(*text);
    if (!directives.error.empty()) {
      return fail(script,
                  fmt::format("not understood: {}\nthere are emit, triangles, set and run\n", directives.error));
    }
    const Goldens found = find_out(script, *text, directives, scratch_.path(), job_);
    if (job_.is_cancelled()) return;
    std::string differences;
    for (const auto& [ending, bytes] : found) differences += settle(fs::path(script).replace_extension(ending), bytes);
    if (differences.empty()) {
      ++passed_;
    } else {
      fail(script, differences);
    }
  }

  Outcome close() {
    listener_.printed(fmt::format("{} passed, {} failed", passed_, failed_));
    outcome_.script_failed |= failed_ > 0;
    outcome_.interrupted = job_.is_cancelled();
    return outcome_;
  }

 private:
  /// Compares with the golden file, or makes it one; what is wrong comes back in words.
  std::string settle(const fs::path& golden, const std::string& found) {
    std::string error;
    const std::optional<std::string> expected = read_file(golden, error);
    if (expected == found) return "";
    if (update_) {
      if (!write_file(golden, found, error)) {
        outcome_.file_failed = true;
        return error + "\n";
      }
      listener_.wrote(golden.string());
      return "";
    }
    if (!expected) return fmt::format("{} is not there; `toile test --update` writes it\n", golden.string());
    return fmt::format("{}\n{}", golden.string(), line_diff(*expected, found));
  }

  void fail(const fs::path& script, const std::string& why) {
    ++failed_;
    listener_.printed(fmt::format("FAILED {}\n{}", script.string(), why));
  }

  bool update_;
  Listener& listener_;
  const Job& job_;
  ScratchFolder scratch_;
  int passed_ = 0;
  int failed_ = 0;
  Outcome outcome_;
};

std::vector<fs::path> scripts_below(const fs::path& path, std::string& error) {
  std::error_code code;
  if (fs::is_regular_file(path, code)) return {path};
  std::vector<fs::path> scripts;
  for (auto entry = fs::recursive_directory_iterator(path, code); !code && entry != fs::recursive_directory_iterator();
       entry.increment(code)) {
    if (entry->path().extension() == ".toile" && entry->is_regular_file()) scripts.push_back(entry->path());
  }
  if (code) error = fmt::format("cannot read {}: {}", path.string(), code.message());
  std::sort(scripts.begin(), scripts.end());
  return scripts;
}

}  // namespace

Outcome test_scripts(const std::filesystem::path& path, bool update, Listener& listener, const Job& job) {
  std::string error;
  const std::vector<fs::path> scripts = scripts_below(path, error);
  if (!error.empty()) {
    listener.failed(error, "");
    Outcome outcome;
    outcome.file_failed = true;
    return outcome;
  }
  Tester tester(update, listener, job);
  for (const fs::path& script : scripts) {
    if (!job.is_cancelled()) tester.test(script);
  }
  return tester.close();
}

}  // namespace toile
