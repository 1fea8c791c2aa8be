// What the command line says, and where: what a script prints on standard output, all the rest on standard error.
#pragma once

#include <mutex>

#include "runtime/cli/arguments.hpp"
#include "runtime/cli/json_messages.hpp"
#include "runtime/driver/listener.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

class Console final : public Listener {
 public:
  explicit Console(const Arguments& arguments);
  ~Console() override;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void diagnosed(const Diagnostic& diagnostic, const Sources& sources) override;
  void printed(const std::string& line) override;
  void noted(const std::string& line) override;
  void wrote(const std::string& path) override;
  void failed(const std::string& message, const std::string& help) override;

  /// The progress of a long job: a bar that is redrawn on a terminal, a line for each tenth elsewhere.
  void progressed(const Progress& progress);
  bool shows_progress() const { return shows_progress_; }
  bool in_colour() const { return in_colour_; }

 private:
  void clear_bar();
  void say(const std::string& text);
  void say_line(const std::string& text, const std::string& json);

  MessageFormat format_;
  bool quiet_;
  bool is_terminal_;
  bool in_colour_;
  bool shows_progress_;
  bool bar_is_drawn_ = false;
  int tenths_told_ = -1;
  std::string phase_;
  SarifLog sarif_;
  std::mutex mutex_;  // progress may come from a solver's thread
};

}  // namespace toile
