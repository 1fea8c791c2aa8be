#include "tests/validation/suite/library.hpp"

#include "runtime/driver/workroom.hpp"

namespace toile::validation {
namespace {

class Nobody final : public Listener {
 public:
  void diagnosed(const Diagnostic&, const Sources&) override {}
  void printed(const std::string&) override {}
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string&, const std::string&) override {}
};

}  // namespace

FabricSheet fabric_called(const std::string& name) {
  Nobody nobody;
  Workroom workroom({}, nobody, {});
  workroom.load("validation", "import fabrics\n");
  return workroom.fabric_called("fabrics." + name).value();
}

}  // namespace toile::validation
