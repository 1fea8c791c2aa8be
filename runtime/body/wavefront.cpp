#include "runtime/body/wavefront.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace toile {
namespace {

std::string_view next_word(std::string_view& line) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  const auto end = static_cast<std::size_t>(std::find_if(line.begin(), line.end(), is_blank) - line.begin());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

template <class Number>
std::optional<Number> number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  Number value{};
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string read_vertex(std::string_view line, Body::Surface& surface) {
  double xyz[3];
  for (double& coordinate : xyz) {
    const std::string_view word = next_word(line);
    const auto value = number<double>(word);
    if (!value || !(std::abs(*value) < 1e4)) return fmt::format("a vertex needs three coordinates, found '{}'", word);
    coordinate = *value;
  }
  surface.points.push_back({xyz[0], xyz[1], xyz[2]});
  return {};
}

std::string read_face(std::string_view line, Body::Surface& surface) {
  const int count = static_cast<int>(surface.points.size());
  std::vector<int> corners;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    if (word.front() == '#') break;
    const auto index = number<int>(word.substr(0, word.find('/')));
    if (!index || *index == 0) return fmt::format("'{}' is no vertex of a face", word);
    const int vertex = *index > 0 ? *index - 1 : count + *index;
    if (vertex < 0 || vertex >= count) return fmt::format("there is no vertex {} yet", *index);
    if (corners.empty() || corners.back() != vertex) corners.push_back(vertex);
  }
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() < 3) return "a face needs three different vertices";
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    surface.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
  return {};
}

void drop_unused_points(Body::Surface& surface) {
  std::vector<int> renumbered(surface.points.size(), -1);
  for (const auto& t : surface.triangles) {
    for (const int v : t) renumbered[v] = 0;
  }
  int count = 0;
  for (std::size_t i = 0; i < renumbered.size(); ++i) {
    if (renumbered[i] < 0) continue;
    renumbered[i] = count;
    surface.points[count++] = surface.points[i];
  }
  surface.points.resize(static_cast<std::size_t>(count));
  for (auto& t : surface.triangles) {
    for (int& v : t) v = renumbered[v];
  }
}

}  // namespace

bool read_obj(std::string_view text, Body::Surface* surface, std::string* error) {
  *surface = {};
  int number_of_line = 0;
  while (!text.empty()) {
    ++number_of_line;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view keyword = next_word(line);
    std::string fault;
    if (keyword == "v") fault = read_vertex(line, *surface);
    if (keyword == "f") fault = read_face(line, *surface);
    if (!fault.empty()) {
      *error = fmt::format("line {}: {}", number_of_line, fault);
      return false;
    }
  }
  drop_unused_points(*surface);
  return true;
}

}  // namespace toile
