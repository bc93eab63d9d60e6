#include "talweg/core/space/box_tree.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kLeaf = 8;
constexpr std::size_t kFew = 1U << 15;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const SpaceBox kEmpty{Point::Constant(kInfinity), Point::Constant(-kInfinity)};

/// Spreads the low 21 bits to every third bit.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1F00000000FFFFULL;
  x = (x | x << 16) & 0x1F0000FF0000FFULL;
  x = (x | x << 8) & 0x100F00F00F00F00FULL;
  x = (x | x << 4) & 0x10C30C30C30C30C3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

struct Key {
  std::uint64_t code;
  std::uint32_t index;
};

/// Stable radix sort by code.
void sort_keys(std::vector<Key>& keys) {
  constexpr int kBits = 11;
  constexpr std::size_t kBuckets = std::size_t{1} << kBits;
  std::vector<Key> other(keys.size());
  for (int shift = 0; shift < 63; shift += kBits) {
    std::array<std::size_t, kBuckets + 1> start{};
    for (const Key& key : keys) ++start[(key.code >> shift & (kBuckets - 1)) + 1];
    for (std::size_t k = 0; k < kBuckets; ++k) start[k + 1] += start[k];
    for (const Key& key : keys) other[start[key.code >> shift & (kBuckets - 1)]++] = key;
    keys.swap(other);
  }
}

/// The objects in the order of the centers of their boxes along the Morton curve.
std::vector<std::uint32_t> order_of(std::size_t count, const BoxTree::BoxOf& box_of) {
  constexpr double kCells = 1 << 21;
  SpaceBox all = kEmpty;
  for (std::uint32_t i = 0; i < count; ++i) all = all.with(box_of(i));
  const double extent = count > 0 ? (all.high - all.low).maxCoeff() : 0;
  const double scale = extent > 0 ? (kCells - 1) / extent : 0.0;
  std::vector<Key> keys(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const SpaceBox box = box_of(i);
    std::uint64_t code = 0;
    for (int k = 0; k < 3; ++k) {
      const double middle = ((box.low[k] - all.low[k]) + (box.high[k] - all.low[k])) / 2;
      const double cell = std::clamp(middle * scale, 0.0, kCells - 1);
      code |= spread(static_cast<std::uint64_t>(cell)) << k;
    }
    keys[i] = {code, i};
  }
  sort_keys(keys);
  std::vector<std::uint32_t> order;
  order.reserve(count);
  for (const Key& key : keys) order.push_back(key.index);
  return order;
}

}  // namespace

BoxTree::BoxTree(std::size_t count, const BoxOf& box_of, Halving halving) {
  if (count == 0) return;
  const auto size = static_cast<std::uint32_t>(count);
  if (halving == Halving::kFast && count > kFew) {
    order_ = order_of(count, box_of);
    build_in_order(0, size, box_of);
    return;
  }
  std::vector<SpaceBox> boxes;
  boxes.reserve(count);
  for (std::uint32_t i = 0; i < size; ++i) {
    boxes.push_back(box_of(i));
    order_.push_back(i);
  }
  build(0, size, boxes);
}

/// Halves a range at the median of the boxes' centers along the longest side.
std::uint32_t BoxTree::build(std::uint32_t begin, std::uint32_t end,
                             std::span<const SpaceBox> boxes) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  SpaceBox box = boxes[order_[begin]];
  for (std::uint32_t i = begin + 1; i < end; ++i) box = box.with(boxes[order_[i]]);
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= kLeaf) return id;
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const auto middle = [&](std::uint32_t i) { return boxes[i].low[axis] + boxes[i].high[axis]; };
  const std::uint32_t half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](std::uint32_t i, std::uint32_t k) {
                     return middle(i) != middle(k) ? middle(i) < middle(k) : i < k;
                   });
  build(begin, half, boxes);
  const std::uint32_t right = build(half, end, boxes);
  nodes_[id].right = right;
  return id;
}

std::uint32_t BoxTree::build_in_order(std::uint32_t begin, std::uint32_t end, const BoxOf& box_of) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({kEmpty, begin, end, 0});
  SpaceBox box = kEmpty;
  if (end - begin <= kLeaf) {
    for (std::uint32_t i = begin; i < end; ++i) box = box.with(box_of(order_[i]));
  } else {
    const std::uint32_t half = begin + (end - begin) / 2;
    build_in_order(begin, half, box_of);
    const std::uint32_t right = build_in_order(half, end, box_of);
    nodes_[id].right = right;
    box = nodes_[id + 1].box.with(nodes_[right].box);
  }
  nodes_[id].box = box;
  return id;
}

}  // namespace talweg
