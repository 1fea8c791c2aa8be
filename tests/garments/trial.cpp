#include "tests/garments/trial.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>
#include <variant>

#include "runtime/driver/workroom.hpp"

namespace toile::test {
namespace {

struct Heard final : Listener {
  std::string text;
  bool said_unsettled = false, said_crossing = false;
  void diagnosed(const Diagnostic& diagnostic, const Sources&) override {
    text += std::string(diagnostic.code) + " " + diagnostic.message + " ";
    said_unsettled |= std::string(diagnostic.code) == "W0509";
    said_crossing |= std::string(diagnostic.code) == "W0516";
  }
  void printed(const std::string&) override {}
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string& message, const std::string& help) override { text += message + " " + help + " "; }
};

std::optional<Draped> first_drape(Workroom& workroom) {
  while (const std::optional<Command> command = workroom.next()) {
    if (const auto* drape = std::get_if<DrapeCommand>(&*command)) return workroom.drape(*drape);
  }
  return std::nullopt;
}

bool is_finite(const Drape& drape) {
  for (const Vec3& p : drape.positions) {
    if (!std::isfinite(p.x + p.y + p.z)) return false;
  }
  return std::isfinite(drape.residual_relative + drape.energy.total() + drape.contact.pressure_Pa.max);
}

Trial run(const std::string& script, int triangles) {
  Heard heard;
  WorkroomOptions options;
  options.triangles = triangles;
  options.threads = 1;
  options.out = std::filesystem::temp_directory_path();
  Workroom workroom(options, heard, {});
  Trial trial;
  const bool loaded = workroom.load("random.toile", script);
  const std::optional<Draped> draped = loaded ? first_drape(workroom) : std::nullopt;
  trial.said = heard.text;
  if (!draped) {
    trial.end = trial.said.empty() ? End::Silent : End::Refused;
    return trial;
  }
  const Drape& drape = draped->drape;
  trial.triangles = static_cast<int>(draped->made->cloth.triangles.size());
  trial.iterations = drape.iterations;
  trial.crossing_pairs = drape.crossing_pairs;
  trial.residual = drape.residual_relative;
  trial.penetration = drape.contact.max_penetration_m;
  trial.pressure = drape.contact.pressure_Pa.max;
  trial.end = !is_finite(drape)          ? End::NotFinite
              : drape.crossing_pairs > 0 ? End::Crossing
              : drape.converged          ? End::Rest
              : heard.said_unsettled     ? End::Reported
                                         : End::Silent;
  return trial;
}

std::string written(const Trial& trial) {
  std::ostringstream out;
  out.precision(17);
  out << static_cast<int>(trial.end) << ' ' << trial.triangles << ' ' << trial.iterations << ' ' << trial.crossing_pairs
      << ' ' << (std::isfinite(trial.residual) ? trial.residual : -1) << ' ' << trial.penetration << ' '
      << trial.pressure << '\n'
      << trial.said;
  return out.str();
}

Trial read(const std::string& text) {
  Trial trial;
  std::istringstream in(text);
  int end = 0;
  in >> end >> trial.triangles >> trial.iterations >> trial.crossing_pairs >> trial.residual >> trial.penetration >>
      trial.pressure;
  if (!in) return {};
  trial.end = static_cast<End>(end);
  in.ignore();
  std::getline(in, trial.said, '\0');
  return trial;
}

[[noreturn]] void child(int out, const std::string& script, int triangles, int most_seconds) {
  const auto seconds = static_cast<rlim_t>(most_seconds);
  const rlimit limit{seconds, seconds + 2};
  setrlimit(RLIMIT_CPU, &limit);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const std::string text = written(run(script, triangles));
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = write(out, text.data() + done, text.size() - done);
    if (wrote <= 0) break;
    done += static_cast<std::size_t>(wrote);
  }
  _exit(0);
}

}  // namespace

const char* name(End end) {
  switch (end) {
    case End::Rest:
      return "rest";
    case End::Reported:
      return "reported";
    case End::Refused:
      return "refused";
    case End::Crossing:
      return "crossing";
    case End::NotFinite:
      return "not finite";
    case End::Silent:
      return "silent";
    case End::Crash:
      return "crash";
    case End::Hang:
      return "hang";
  }
  return "";
}

Trial try_script(const std::string& script, int triangles, int most_seconds) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    child(ends[1], script, triangles, most_seconds);
  }
  close(ends[1]);
  if (process < 0) {
    close(ends[0]);
    return {};
  }
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(got));
  }
  close(ends[0]);
  int status = 0;
  rusage used{};
  wait4(process, &status, 0, &used);
  Trial trial;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    trial = read(text);
  } else if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    trial.end = signal == SIGXCPU || signal == SIGKILL ? End::Hang : End::Crash;
    trial.said = "signal " + std::to_string(signal);
  }
  trial.seconds = static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec) +
                  static_cast<double>(used.ru_stime.tv_sec) + 1e-6 * static_cast<double>(used.ru_stime.tv_usec);
  return trial;
}

}  // namespace toile::test
