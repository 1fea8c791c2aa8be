#include "runtime/driver/workroom.hpp"

#include <fmt/format.h>

#include "runtime/driver/files.hpp"
#include "runtime/driver/sizes.hpp"
#include "runtime/driver/stopwatch.hpp"

namespace toile {

Diagnostic at_place(Severity severity, const char* code, Location written, std::string message, std::string label,
                    std::string help) {
  return {severity, code, std::move(message), {{written, std::move(label), true}}, std::move(help)};
}

Workroom::Workroom(WorkroomOptions options, Listener& listener, Job job)
    : options_(std::move(options)), listener_(&listener), job_(std::move(job)) {}

bool Workroom::load(const std::filesystem::path& script) {
  std::string error;
  std::optional<std::string> text = read_file(script, error);
  if (!text) {
    file_failed(error);
    return false;
  }
  return load(script.string(), *std::move(text));
}

bool Workroom::load(const std::string& name, std::string text, const std::filesystem::path& base) {
  script_ = name;
  text_ = std::move(text);
  if (options_.out.empty()) options_.out = (base / name).parent_path();
  world_ = std::make_unique<FileWorld>(base, name);
  {
    const Stopwatch watch(profile_.compile_s);
    program_ = toile::load(name, text_, options_.settings, *world_, options_.size);
  }
  if (!options_.patterns_only) program_->check_bodies();
  pass_on_diagnostics();
  if (world_->missed_a_file()) outcome_.file_failed = true;
  return program_->ok() && !interrupted();
}

std::optional<Command> Workroom::next() {
  if (interrupted()) return std::nullopt;
  std::optional<Command> command = program_->next();
  pass_on_diagnostics();
  return command;
}

void Workroom::pass_on_diagnostics() {
  const std::vector<Diagnostic>& all = program_->diagnostics();
  for (; passed_on_ < all.size(); ++passed_on_) diagnose(all[passed_on_]);
}

void Workroom::write(const std::filesystem::path& wanted, const std::string& bytes) {
  if (interrupted()) return;
  const std::filesystem::path path = options_.size_in_names ? name_for_size(wanted, options_.size) : wanted;
  std::string error;
  if (write_file(path, bytes, error)) {
    listener_->wrote(path.string());
  } else {
    file_failed(error);
  }
}

void Workroom::write_below(const std::string& path, const std::string& bytes, Location written) {
  if (const std::optional<std::filesystem::path> target = below(options_.out, path)) {
    write(*target, bytes);
  } else {
    diagnose(at_place(Severity::Error, "E0501", written,
                      fmt::format("\"{}\" lies outside the folder for this script's files", path), "written here",
                      R"(give a path without a leading "/" or "..", and choose the folder with --out)"));
  }
}

void Workroom::diagnose(const Diagnostic& diagnostic) {
  if (diagnostic.severity == Severity::Warning && program_->allows(diagnostic)) return;
  if (diagnostic.severity == Severity::Error) outcome_.script_failed = true;
  listener_->diagnosed(diagnostic, program_->sources());
}

void Workroom::wrong_usage(const std::string& message, const std::string& help) {
  outcome_.wrong_usage = true;
  listener_->failed(message, help);
}

void Workroom::file_failed(const std::string& message) {
  outcome_.file_failed = true;
  listener_->failed(message, "");
}

void Workroom::unsettled(const std::string& message) {
  outcome_.unsettled = true;
  listener_->failed(message, "");
}

bool Workroom::interrupted() {
  if (job_.is_cancelled()) outcome_.interrupted = true;
  return outcome_.interrupted;
}

Profile Workroom::profile() const {
  Profile profile = profile_;
  profile.total_s = profile.compile_s + profile.mesh_s + profile.place_s + profile.solve_s;
  add_process_usage(profile);
  return profile;
}

}  // namespace toile
