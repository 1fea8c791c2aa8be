#include "grammar/emit.hpp"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "grammar/scan.hpp"

namespace toile::syntax {
namespace {

void write_escaped(std::string& out, std::string_view text) {
  for (std::uint32_t i = 0; i < text.size();) {
    const std::uint32_t length = code_point_length(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == '\n') {
      out += "\\n";
    } else if (length == 0 || byte < 0x20 || byte == 0x7f) {
      fmt::format_to(std::back_inserter(out), "\\x{:02x}", byte);
    } else {
      out += text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
}

}  // namespace

std::string emit(const Tree& tree, const Source& source) {
  std::string out;
  std::vector<std::size_t> depth(tree.size(), 0);
  for (NodeId id = 0; id < tree.size(); ++id) {
    const Node& node = tree[id];
    if (node.parent != no_node) depth[id] = depth[node.parent] + 1;
    if (is_trivia(node.kind)) continue;
    out.append(2 * depth[id], ' ');
    if (!spelling(node.kind).empty()) {
      fmt::format_to(std::back_inserter(out), "'{}'", name(node.kind));
    } else {
      out += name(node.kind);
      if (is_token(node.kind)) {
        out += ' ';
        write_escaped(out, source.slice(node.span));
      }
    }
    out += '\n';
  }
  return out;
}

}  // namespace toile::syntax
