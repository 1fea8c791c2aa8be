#include "grammar/build.hpp"

#include "grammar/scan.hpp"

namespace toile::syntax {
namespace {

/// A node after all its descendants; `size` counts it and them.
struct Closed {
  Kind kind;
  Span span;
  std::uint32_t size;
};

std::vector<Closed> with_trivia(std::string_view text, const std::vector<Event>& events) {
  std::vector<Closed> closed;
  closed.reserve(events.size() + events.size() / 2 + 16);
  const auto count = [&] { return static_cast<std::uint32_t>(closed.size()); };
  std::uint32_t at = 0;
  const auto fill = [&](std::uint32_t to) {
    while (at < to) {
      Trivia trivia = trivia_at(text, at);
      if (trivia.span.end == at || trivia.span.end > to) trivia = {Kind::Error, {at, to}};
      at = trivia.span.end;
      closed.push_back({trivia.kind, trivia.span, 1});
    }
  };
  std::vector<std::uint32_t> place(events.size());  // of every token in `closed`
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event& event = events[i];
    if (event.first == i) {
      fill(event.span.begin);
      place[i] = count();
      at = event.span.end;
      closed.push_back({event.kind, event.span, 1});
    } else {
      closed.push_back({event.kind, event.span, count() - place[event.first] + 1});
    }
  }
  const auto end = static_cast<std::uint32_t>(text.size());
  fill(end);
  closed.push_back({Kind::File, {0, end}, count() + 1});
  return closed;
}

/// Renumbers so that parents come before their children and all stand in the order of the text.
std::vector<Node> parents_first(const std::vector<Closed>& closed) {
  struct Open {
    NodeId id;
    NodeId unfilled;  // one past the children still to come, which come last to first
    NodeId end;
  };
  std::vector<Node> nodes(closed.size());
  std::vector<Open> open;
  for (std::size_t i = closed.size(); i-- > 0;) {
    const Closed& from = closed[i];
    while (!open.empty() && open.back().unfilled == open.back().id + 1) open.pop_back();
    NodeId id = Tree::root();
    Node node{from.kind, from.span, no_node, no_node, no_node};
    if (!open.empty()) {
      Open& parent = open.back();
      id = parent.unfilled - from.size;
      node.parent = parent.id;
      if (parent.unfilled != parent.end) node.next_sibling = parent.unfilled;
      parent.unfilled = id;
    }
    if (from.size > 1) {
      node.first_child = id + 1;
      open.push_back({id, id + from.size, id + from.size});
    }
    nodes[id] = node;
  }
  return nodes;
}

}  // namespace

Tree build_tree(std::string_view text, const std::vector<Event>& events) {
  return Tree(parents_first(with_trivia(text, events)));
}

}  // namespace toile::syntax
