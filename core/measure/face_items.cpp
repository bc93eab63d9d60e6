#include "talweg/core/measure/face_items.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "talweg/core/space/box_tree.hpp"

namespace talweg {
namespace {

using Ends = std::array<std::array<double, 3>, 2>;

/// The ends of a piece, in an order that does not depend on its direction.
Ends ends_of(const FaceItem& item) {
  Ends ends = {item.piece->from, item.piece->to};
  std::sort(ends.begin(), ends.end());
  return ends;
}

class ItemPairs {
 public:
  using Visit = std::function<void(std::uint32_t, std::uint32_t)>;
  using Numbers = std::vector<std::uint32_t>;

  ItemPairs(std::span<const FaceItem> items, double same, const Visit& visit)
      : items_(items), visit_(&visit) {
    const Point margin(same, same, 0);
    for (const FaceItem& item : items) {
      const Point a(item.a.x, item.a.y, 0), b(item.b.x, item.b.y, 0);
      boxes_.push_back({a.cwiseMin(b) - margin, a.cwiseMax(b) + margin});
    }
  }

  void visit_all() {
    split(pair_equals());
    meet_each_other(free_);
    for (std::size_t c = 0; c < 3; ++c) {
      pair_neighbours(fans_[c], c);
      meet(free_, fans_[c]);
      for (std::size_t other = 0; other < c; ++other) meet(fans_[other], fans_[c]);
    }
  }

 private:
  void pair(std::uint32_t i, std::uint32_t k) const { (*visit_)(std::min(i, k), std::max(i, k)); }

  /// Pairs equal items with each other, and returns one of each group of equal items, ascending.
  Numbers pair_equals() const {
    std::vector<std::pair<Ends, std::uint32_t>> sorted;
    for (std::uint32_t i = 0; i < items_.size(); ++i) sorted.emplace_back(ends_of(items_[i]), i);
    std::sort(sorted.begin(), sorted.end());
    Numbers kinds;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i > 0 && sorted[i].first == sorted[i - 1].first) {
        pair(sorted[i - 1].second, sorted[i].second);
      } else {
        kinds.push_back(sorted[i].second);
      }
    }
    std::sort(kinds.begin(), kinds.end());
    return kinds;
  }

  /// Items with one end at a corner of the face belong to the corner's fan; all others, sides of
  /// the face and points among them, are free.
  void split(const Numbers& kinds) {
    for (const std::uint32_t i : kinds) {
      const PolylinePiece& piece = *items_[i].piece;
      std::size_t ends = 0, corner = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        if (!(piece.from[c] == 1 || piece.to[c] == 1)) continue;
        ++ends;
        corner = c;
      }
      (ends == 1 && items_[i].length > 0 ? fans_[corner] : free_).push_back(i);
    }
  }

  [[nodiscard]] BoxTree::BoxOf boxes_of(const Numbers& numbers) const {
    return [this, &numbers](std::uint32_t i) { return boxes_[numbers[i]]; };
  }

  void meet_each_other(const Numbers& numbers) const {
    const BoxTree::BoxOf box_of = boxes_of(numbers);
    BoxTree(numbers.size(), box_of).visit_pairs(box_of, [&](std::uint32_t i, std::uint32_t k) {
      pair(numbers[i], numbers[k]);
    });
  }

  void meet(const Numbers& some, const Numbers& others) const {
    if (some.empty() || others.empty()) return;
    const BoxTree::BoxOf box_of = boxes_of(some);
    const BoxTree tree(some.size(), box_of);
    for (const std::uint32_t other : others) {
      tree.visit(boxes_[other], box_of, [&](std::uint32_t i) { pair(some[i], other); });
    }
  }

  /// The direction from the corner to the item's other end, radians.
  [[nodiscard]] double angle_from(std::size_t corner, std::uint32_t i) const {
    const FaceItem& item = items_[i];
    const bool forwards = item.piece->from[corner] == 1;
    const PlanePoint at = forwards ? item.a : item.b, to = forwards ? item.b : item.a;
    return std::atan2(to.y - at.y, to.x - at.x);
  }

  /// Sorts a fan by angle, and pairs each item with the nearest longer item on either side.
  void pair_neighbours(const Numbers& fan, std::size_t corner) const {
    std::vector<std::pair<double, std::uint32_t>> sorted;
    for (const std::uint32_t i : fan) sorted.emplace_back(angle_from(corner, i), i);
    // The angles span less than half a turn, but may lie on both sides of ±π.
    if (!sorted.empty()) {
      const double first = sorted.front().first;
      for (auto& [angle, i] : sorted) angle = std::remainder(angle - first, 2 * std::numbers::pi);
    }
    std::sort(sorted.begin(), sorted.end());
    Numbers longer;  // previous items, in descending order of length
    for (const auto& [angle, i] : sorted) {
      while (!longer.empty() && items_[longer.back()].length < items_[i].length) {
        pair(longer.back(), i);
        longer.pop_back();
      }
      if (!longer.empty()) pair(longer.back(), i);
      longer.push_back(i);
    }
  }

  std::span<const FaceItem> items_;
  const Visit* visit_;
  std::vector<SpaceBox> boxes_;
  Numbers free_;
  std::array<Numbers, 3> fans_;
};

}  // namespace

void visit_item_pairs(std::span<const FaceItem> items, double same,
                      const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  ItemPairs(items, same, visit).visit_all();
}

}  // namespace talweg
