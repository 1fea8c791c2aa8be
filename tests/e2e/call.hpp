// Calls the `toile` binary in a folder of its own and tells what came of it.
#pragma once

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/runtime/driver/scratch.hpp"

namespace toile {

struct Called {
  int exit_code = -1;
  std::string out, err;
};

class CommandLine {
 public:
  /// `toile ARGUMENTS` as typed in a shell in the scratch folder; `before` may hold a wrapper such as `timeout`,
  /// `input` names the file that is its standard input.
  Called toile(const std::string& arguments, const std::string& before = "",
               const std::string& input = "/dev/null") const {
    const std::string line = fmt::format("cd '{}' && {} '{}' {} >.out 2>.err <{}", scratch.path().string(), before,
                                         TOILE_BINARY, arguments, input);
    const int status = std::system(line.c_str());
    Called called{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), scratch.read(".out"),
                  scratch.read(".err")};
    std::filesystem::remove(scratch / ".out");
    std::filesystem::remove(scratch / ".err");
    return called;
  }

  Scratch scratch{"e2e"};
};

}  // namespace toile
