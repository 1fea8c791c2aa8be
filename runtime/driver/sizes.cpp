#include "runtime/driver/sizes.hpp"

namespace toile {
namespace {

/// For a first look: what is said then will be said again.
class Unheard final : public Listener {
 public:
  void diagnosed(const Diagnostic&, const Sources&) override {}
  void printed(const std::string&) override {}
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string&, const std::string&) override {}
};

}  // namespace

std::vector<WorkroomOptions> one_by_size(const std::filesystem::path& script, const WorkroomOptions& options) {
  if (options.size != "all") return {options};
  WorkroomOptions each = options;
  each.size.clear();
  Unheard unheard;
  Workroom workroom(each, unheard, {});
  if (!workroom.load(script)) return {each};
  std::vector<WorkroomOptions> all;
  for (const std::string& size : workroom.program().sizes()) {
    each.size = size;
    each.size_in_names = true;
    all.push_back(each);
  }
  // Without any size, loading the script will say that there is none called `all`.
  return all.empty() ? std::vector{options} : all;
}

std::filesystem::path name_for_size(const std::filesystem::path& path, const std::string& size) {
  const std::string name = path.filename().string();
  // A report is named `skirt.report.json`: its ending has two parts.
  constexpr std::string_view report = ".report.json";
  const std::size_t ending = name.ends_with(report) ? name.size() - report.size() : name.rfind('.');
  const std::size_t at = std::min(ending, name.size());
  return path.parent_path() / (name.substr(0, at) + "-" + size + name.substr(at));
}

}  // namespace toile
