// Any bytes at all: what parses is the same script when it is laid out, and laid out again it does not change.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "grammar/format/format.hpp"

namespace {

[[noreturn]] void broken(const char* what, const toile::Source& text) {
  std::fprintf(stderr, "%s\n%s", what, std::string(text.text()).c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  const Source source("fuzz.toile", std::string(reinterpret_cast<const char*>(data), size));
  const syntax::Parsed parsed = syntax::parse(source);
  if (!parsed.errors.empty()) return 0;
  const Source laid_out("fuzz.toile", syntax::format(parsed, source));
  const syntax::Parsed reparsed = syntax::parse(laid_out);
  if (!reparsed.errors.empty()) broken("no script any more", laid_out);
  if (!syntax::same_script(parsed, source, reparsed, laid_out)) broken("another script", laid_out);
  if (syntax::format(reparsed, laid_out) != laid_out.text()) broken("not idempotent", laid_out);
  return 0;
}
