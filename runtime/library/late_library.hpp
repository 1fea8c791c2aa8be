// A shared library that is opened when something of it is first needed. Those of the solver and of the renderer take
// longer to load than a script takes to check, and most calls of `toile` need neither.
#pragma once

namespace toile {

/// Stays open to the end of the process.
class LateLibrary {
 public:
  /// `name` as the loader looks for it: "libcholmod.so.3". Throws std::runtime_error when it cannot be opened.
  explicit LateLibrary(const char* name);

  /// A function of the library, or of one that it needs. Throws std::runtime_error when there is none of that name.
  template <typename Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const char* name) const;

  void* handle_;
  const char* name_;
};

}  // namespace toile
