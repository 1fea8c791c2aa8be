// The world outside a script: modules of the standard library, files beside the script, bodies that can be measured.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/evaluate/program.hpp"
#include "runtime/body/body.hpp"
#include "runtime/develop/chart.hpp"

namespace toile {

class FileWorld final : public World {
 public:
  /// Scripts go by names that are paths seen from `base`; what a script names is found from the folder it stands in.
  FileWorld(std::filesystem::path base, std::filesystem::path script)
      : base_(std::move(base)), script_(std::move(script)) {}

  std::optional<std::string> read(const std::string& path, const std::string& from) override;
  std::optional<std::string> module(const std::string& name) override;
  std::vector<std::string> module_names() override;
  std::variant<std::vector<BodyLineFacts>, std::string> measure(const BodySpec& spec) override;
  std::variant<ChartAnswer, std::string> charted(const BodySpec& spec, const ChartSpec& chart,
                                                 const ChartQuestion& question) override;

  /// The body's surface, made once for equal specifications; null with the reason in `error`.
  std::shared_ptr<const Body> body(const BodySpec& spec, std::string& error);

  /// Whether a file that a script names could not be read.
  bool missed_a_file() const { return missed_a_file_; }

 private:
  struct Made {
    std::shared_ptr<const Body> body;
    std::string error;
  };
  std::filesystem::path beside(const std::filesystem::path& script, const std::string& path) const {
    return base_ / script.parent_path() / path;
  }

  std::filesystem::path base_;
  std::filesystem::path script_;
  bool missed_a_file_ = false;
  std::map<std::string, Made> bodies_;
  std::map<std::string, std::unique_ptr<BodyChart>> charts_;  // that were asked
};

/// Text that is the same for two specifications exactly when they describe the same body.
std::string identity(const BodySpec& spec);
std::string identity(const ChartSpec& chart);

}  // namespace toile
