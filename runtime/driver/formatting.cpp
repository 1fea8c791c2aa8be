#include "runtime/driver/formatting.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <iterator>
#include <optional>

#include "compiler/evaluate/syntax_errors.hpp"
#include "grammar/format/format.hpp"
#include "runtime/driver/files.hpp"

namespace toile {
namespace {

namespace fs = std::filesystem;

class Formatter {
 public:
  Formatter(bool check, Listener& listener) : check_(check), listener_(listener) {}

  void file(const std::string& name) {
    std::string error;
    const std::optional<std::string> text = read_file(name, error);
    if (!text) return fail(error);
    const std::optional<std::string> laid_out = lay_out(name, *text);
    if (laid_out && *laid_out != *text) settle(name, *laid_out);
  }

  void standard_input() {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    std::optional<std::string> laid_out = lay_out("<standard input>", text);
    if (!laid_out) return;
    if (check_ && *laid_out != text) return differs("<standard input>");
    if (laid_out->empty() || check_) return;
    laid_out->pop_back();  // the line's end comes with printing
    listener_.printed(*laid_out);
  }

  const Outcome& outcome() const { return outcome_; }

 private:
  std::optional<std::string> lay_out(const std::string& name, const std::string& text) {
    Sources sources;
    const FileId id = sources.add(Source(name, text));
    const syntax::Parsed parsed = syntax::parse(sources[id]);
    for (const syntax::SyntaxError& error : parsed.errors) {
      listener_.diagnosed(syntax_diagnostic(error, sources[id], id), sources);
      outcome_.script_failed = true;
    }
    if (!parsed.errors.empty()) return std::nullopt;
    return syntax::format(parsed, sources[id]);
  }

  void settle(const std::string& name, const std::string& text) {
    if (check_) return differs(name);
    // What a link points to is rewritten, not the link, and who may read it stays as it was.
    std::error_code ignored;
    const fs::path target = fs::canonical(name, ignored);
    const fs::perms allowed = fs::status(target, ignored).permissions();
    std::string error;
    if (!write_file(target, text, error)) return fail(error);
    fs::permissions(target, allowed, ignored);
    listener_.wrote(name);
  }

  void differs(const std::string& name) {
    outcome_.script_failed = true;
    listener_.failed(fmt::format("{} is not in the layout", name), fmt::format("toile fmt {} rewrites it", name));
  }

  void fail(const std::string& error) {
    outcome_.file_failed = true;
    listener_.failed(error, "");
  }

  bool check_;
  Listener& listener_;
  Outcome outcome_;
};

}  // namespace

Outcome format_files(const std::vector<std::string>& files, bool check, Listener& listener) {
  Formatter formatter(check, listener);
  for (const std::string& name : files) {
    if (name == "-") {
      formatter.standard_input();
    } else {
      formatter.file(name);
    }
  }
  return formatter.outcome();
}

}  // namespace toile
