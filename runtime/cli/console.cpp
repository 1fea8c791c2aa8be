#include "runtime/cli/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace toile {
namespace {

bool wants_colour(WhenColour when, bool is_terminal) {
  if (when == WhenColour::Auto) return is_terminal && std::getenv("NO_COLOR") == nullptr;
  return when == WhenColour::Always;
}

}  // namespace

Console::Console(const Arguments& arguments)
    : format_(arguments.messages),
      quiet_(arguments.quiet),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      in_colour_(wants_colour(arguments.colour, is_terminal_)),
      shows_progress_(arguments.progress || (is_terminal_ && !arguments.quiet && format_ == MessageFormat::Human)) {}

Console::~Console() {
  clear_bar();
  if (format_ == MessageFormat::Sarif) std::fputs(sarif_.text().c_str(), stderr);
}

void Console::say(const std::string& text) {
  const std::lock_guard lock(mutex_);
  clear_bar();
  std::fputs(text.c_str(), stderr);
}

void Console::diagnosed(const Diagnostic& diagnostic, const Sources& sources) {
  if (quiet_ && diagnostic.severity != Severity::Error) return;
  if (format_ == MessageFormat::Sarif) return sarif_.add(diagnostic, sources);
  if (format_ == MessageFormat::Json) return say(json_diagnostic(diagnostic, sources) + "\n");
  std::string text = render(diagnostic, sources, in_colour_);
  if (text.empty() || text.back() != '\n') text += '\n';
  say(text + "\n");
}

void Console::printed(const std::string& line) {
  {
    const std::lock_guard lock(mutex_);
    clear_bar();
  }
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// What is of no use in a log of findings.
void Console::say_line(const std::string& text, const std::string& json) {
  if (quiet_ || format_ == MessageFormat::Sarif) return;
  say((format_ == MessageFormat::Json ? json : text) + "\n");
}

void Console::noted(const std::string& line) {
  say_line(line, json_message("note", "message", line));
}

void Console::wrote(const std::string& path) {
  say_line("wrote " + path, json_message("wrote", "path", path));
}

void Console::failed(const std::string& message, const std::string& help) {
  if (format_ == MessageFormat::Sarif) return sarif_.add_failure(message, help);
  if (format_ == MessageFormat::Json) return say(json_failure(message, help) + "\n");
  const char* const red = in_colour_ ? "\x1b[1;31m" : "";
  const char* const plain = in_colour_ ? "\x1b[0m" : "";
  say(fmt::format("{}error:{} {}\n{}", red, plain, message, help.empty() ? "" : "help: " + help + "\n"));
}

void Console::progressed(const Progress& progress) {
  if (!shows_progress_ || format_ == MessageFormat::Sarif) return;
  const std::lock_guard lock(mutex_);
  const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
  if (format_ == MessageFormat::Human && is_terminal_) {
    constexpr int width = 30;
    const int filled = static_cast<int>(fraction * width);
    fmt::print(stderr, "\r\x1b[K{:<10} [{:#<{}}{:.<{}}] {:3.0f} %  residual {:.1e}", progress.phase, "", filled, "",
               width - filled, 100 * fraction, progress.residual);
    bar_is_drawn_ = true;
    std::fflush(stderr);
    return;
  }
  const int tenths = static_cast<int>(10 * fraction);
  if (progress.phase == phase_ && tenths <= tenths_told_) return;
  phase_ = progress.phase;
  tenths_told_ = tenths;
  if (format_ == MessageFormat::Json) {
    fmt::print(stderr, "{}\n", json_progress(progress));
  } else {
    fmt::print(stderr, "{} {} %\n", progress.phase, 10 * tenths);
  }
}

void Console::clear_bar() {
  if (!bar_is_drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  bar_is_drawn_ = false;
}

}  // namespace toile
