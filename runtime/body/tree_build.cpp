#include "runtime/body/tree_build.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr int leaf_size = 3;
constexpr int greatest_depth = 24;  // of nodes of four; beyond it leaves may be larger
constexpr int bins = 12;

double component(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

struct Range {
  int begin = 0, end = 0;
  int size() const { return end - begin; }
};

BoundingBox box_of(const std::vector<TreeItem>& items, Range range) {
  BoundingBox box;
  for (int i = range.begin; i < range.end; ++i) box.include(items[i].box);
  return box;
}

// The bin before which the surface area heuristic (Wald 2007) splits, 0 for none.
int best_split(const std::array<BoundingBox, bins>& box, const std::array<int, bins>& count) {
  std::array<double, bins> cost_above{};
  BoundingBox above;
  for (int b = bins - 1, n = 0; b > 0; --b) {
    if (count[b] > 0) above.include(box[b]);
    n += count[b];
    cost_above[b] = n * above.half_area();
  }
  int best = 0;
  double best_cost = std::numeric_limits<double>::infinity();
  BoundingBox below;
  int n = 0;
  for (int b = 1; b < bins; ++b) {
    if (count[b - 1] > 0) below.include(box[b - 1]);
    n += count[b - 1];
    const double cost = n * below.half_area() + cost_above[b];
    if (n == 0 || cost_above[b] == 0 || cost >= best_cost) continue;
    best = b;
    best_cost = cost;
  }
  return best;
}

// Splits a range in two, neither empty; the items are sorted accordingly.
int split(std::vector<TreeItem>& items, Range range) {
  BoundingBox centres;
  for (int i = range.begin; i < range.end; ++i) centres.include(items[i].centre);
  const Vec3 size = centres.high - centres.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const double low = component(centres.low, axis), extent = component(size, axis);
  const auto bin_of = [&](const TreeItem& item) {
    const double t = extent > 0 ? (component(item.centre, axis) - low) / extent : 0;
    return std::min(bins - 1, static_cast<int>(t * bins));
  };
  std::array<BoundingBox, bins> box;
  std::array<int, bins> count{};
  for (int i = range.begin; i < range.end; ++i) {
    const int b = bin_of(items[i]);
    box[b].include(items[i].box);
    ++count[b];
  }
  const int best = best_split(box, count);
  const int middle = static_cast<int>(std::stable_partition(items.begin() + range.begin, items.begin() + range.end,
                                                            [&](const TreeItem& i) { return bin_of(i) < best; }) -
                                      items.begin());
  const bool is_proper = best > 0 && middle > range.begin && middle < range.end;
  return is_proper ? middle : range.begin + range.size() / 2;
}

class Builder {
 public:
  explicit Builder(std::vector<TreeItem>& items) : items_(items) {
    const BoundingBox box = box_of(items, {0, static_cast<int>(items.size())});
    const Vec3 p = box.low, q = box.high;
    widening_ = 4e-7 * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x), std::abs(q.y),
                                 std::abs(q.z), 1.0});
  }

  int add(Range range, int depth) {
    const int index = static_cast<int>(nodes.size());
    nodes.emplace_back();
    std::array<Range, TriangleTree::width> children{range};
    int n = 1;
    while (n < TriangleTree::width) {
      const auto largest = std::max_element(children.begin(), children.begin() + n,
                                            [](Range a, Range b) { return a.size() < b.size(); });
      if (largest->size() <= leaf_size) break;
      const int middle = split(items_, *largest);
      children[n++] = {middle, largest->end};
      largest->end = middle;
    }
    for (int c = 0; c < TriangleTree::width; ++c) {
      if (c >= n) {
        set(index, c, BoundingBox{{1e30, 1e30, 1e30}, {1e30, 1e30, 1e30}}, 0, -1);
      } else if (children[c].size() <= leaf_size || depth >= greatest_depth) {
        set(index, c, box_of(items_, children[c]), children[c].begin, children[c].size());
      } else {
        const BoundingBox box = box_of(items_, children[c]);
        set(index, c, box, add(children[c], depth + 1), 0);
      }
    }
    return index;
  }

  std::vector<TriangleTree::Node> nodes;

 private:
  void set(int node, int c, const BoundingBox& box, int child, int count) {
    const double low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
    for (int k = 0; k < 3; ++k) {
      nodes[node].low[k][c] = static_cast<float>(low[k] - widening_);
      nodes[node].high[k][c] = static_cast<float>(high[k] + widening_);
    }
    nodes[node].child[c] = child;
    nodes[node].count[c] = count;
  }

  std::vector<TreeItem>& items_;
  double widening_ = 0;  // [m] more than single precision can err
};

}  // namespace

std::vector<TriangleTree::Node> build_tree(std::vector<TreeItem>& items) {
  Builder builder(items);
  builder.add({0, static_cast<int>(items.size())}, 0);
  return std::move(builder.nodes);
}

}  // namespace toile
