#include "runtime/library/late_library.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace toile {

LateLibrary::LateLibrary(const char* name) : handle_(dlopen(name, RTLD_LAZY | RTLD_LOCAL)), name_(name) {
  if (handle_ == nullptr) throw std::runtime_error(std::string("the library cannot be opened: ") + dlerror());
}

void* LateLibrary::address(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) throw std::runtime_error(std::string(name_) + " has no function " + name);
  return found;
}

}  // namespace toile
