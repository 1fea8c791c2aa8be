#include "grammar/source.hpp"

#include <algorithm>
#include <functional>

namespace toile {

Source::Source(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)), line_starts_{0} {
  for (std::size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n', end + 1)) {
    line_starts_.push_back(static_cast<std::uint32_t>(end + 1));
  }
}

LineColumn Source::position(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const auto after = std::ranges::upper_bound(line_starts_, offset);
  const std::uint32_t start = *(after - 1);
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80; };
  const auto code_points = std::count_if(text_.begin() + start, text_.begin() + offset, std::not_fn(continues));
  return {static_cast<int>(after - line_starts_.begin()), static_cast<int>(code_points) + 1};
}

std::string_view Source::line(int number) const {
  if (number < 1 || number > line_count()) return {};
  const std::size_t start = line_starts_[static_cast<std::size_t>(number) - 1];
  std::string_view line = text().substr(start);
  line = line.substr(0, line.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace toile
