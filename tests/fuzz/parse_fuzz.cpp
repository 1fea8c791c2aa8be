// Any bytes at all: the parser returns, and its tree is a lossless tree of them.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "grammar/emit.hpp"
#include "tests/grammar/invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  const Source source("fuzz.toile", std::string(reinterpret_cast<const char*>(data), size));
  for (const auto& parsed : {syntax::parse(source), syntax::parse_expression(source)}) {
    const std::string broken = syntax::broken_invariant(parsed, source);
    if (!broken.empty()) {
      std::fprintf(stderr, "%s\n", broken.c_str());
      std::abort();
    }
    (void)syntax::emit(parsed.tree, source);
  }
  return 0;
}
