// How a call ended, as its exit code tells it.
#pragma once

namespace toile {

struct Outcome {
  bool interrupted = false;    // Ctrl-C
  bool wrong_usage = false;    // a garment, body, view or file type named on the command line does not exist
  bool file_failed = false;    // an input or output file
  bool script_failed = false;  // an error in the script, or an expectation that does not hold
  bool unsettled = false;      // a solve did not reach equilibrium; its outputs are written all the same

  /// 130 interrupted, 2 wrong usage, then 4 (files) before 1 (script) before 3 (solve), 0 all well.
  int exit_code() const {
    if (interrupted) return 130;
    if (wrong_usage) return 2;
    if (file_failed) return 4;
    if (script_failed) return 1;
    return unsettled ? 3 : 0;
  }

  /// Several calls together.
  void add(const Outcome& other) {
    interrupted |= other.interrupted;
    wrong_usage |= other.wrong_usage;
    file_failed |= other.file_failed;
    script_failed |= other.script_failed;
    unsettled |= other.unsettled;
  }
};

}  // namespace toile
