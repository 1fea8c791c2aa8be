// A text and places in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// A half-open range of bytes of one file. Nodes carry spans only; the file is known by the tree they stand in.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend constexpr bool operator==(Span, Span) = default;
};

/// The index of a source in the session's table of sources (see compiler/diag/sources.hpp).
using FileId = std::uint32_t;

/// A place in a text that can be shown to a person: provenance of pieces, edges, seams and triangles.
struct Location {
  FileId file = 0;
  Span span;

  friend constexpr bool operator==(Location, Location) = default;
};

struct LineColumn {
  int line = 1;    // from 1
  int column = 1;  // from 1, counted in Unicode code points
};

class Source {
 public:
  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  std::string_view slice(Span span) const { return text().substr(span.begin, span.end - span.begin); }
  LineColumn position(std::uint32_t offset) const;
  /// The text of a line without its end; lines count from 1.
  std::string_view line(int number) const;
  int line_count() const { return static_cast<int>(line_starts_.size()); }

 private:
  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
};

}  // namespace toile
