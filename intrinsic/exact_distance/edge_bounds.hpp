// Edge bounds are upper bounds of the distances at the points of an edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/exact_distance/window_index.hpp"

namespace talweg {

/// On an edge with thousands of windows, a new window is shorter than the known ones in a small
/// part at most. The bounds hold the shortest known distances at places evenly spread over the
/// edge; paths along the edge extend the bounds to all points between two places. A binary tree
/// with the bounds of ever longer parts excludes most of a new window in O(log n) steps. Distances
/// only decrease, so a bound stays valid.
class EdgeBounds {
 public:
  /// `parts`: a power of 2.
  EdgeBounds(double length, std::size_t parts)
      : length_(length),
        parts_(parts),
        at_(parts + 1, std::numeric_limits<double>::infinity()),
        most_(2 * parts, std::numeric_limits<double>::infinity()) {}

  [[nodiscard]] std::size_t parts() const { return parts_; }

  /// Lowers the bounds to the distances of a window that is not empty.
  void add(const EdgeWindow& window) {
    const double size = length_ / static_cast<double>(parts_);
    const auto before = std::min(parts_ - 1, static_cast<std::size_t>(window.begin / size));
    std::size_t last = before;
    for (std::size_t i = before; i <= parts_; last = i++) {
      const double bend = std::clamp(place(i), window.begin, window.end);
      const double way = window.value(bend) + std::abs(place(i) - bend);
      at_[i] = std::min(at_[i], way);
      if (place(i) >= window.end && i > before) break;
    }
    update(before == 0 ? 0 : before - 1, std::min(parts_ - 1, last + 1));
  }

  /// The range of a window without the parts at its ends where known distances are shorter by more
  /// than `same`. Adds the cost of the search to `visited`.
  [[nodiscard]] EdgeRange not_longer(const EdgeWindow& window, double same,
                                     std::size_t& visited) const {
    Asked asked{&window, same};
    const std::size_t first = find(asked, 1, 0, parts_, false);
    const std::size_t last = first == parts_ ? first : find(asked, 1, 0, parts_, true);
    visited += asked.visited;
    if (first == parts_) return {};
    return {std::max(window.begin, place(first)), std::min(window.end, place(last + 1))};
  }

 private:
  struct Asked {
    const EdgeWindow* window;
    double same;
    std::size_t visited = 0;
  };

  [[nodiscard]] double place(std::size_t i) const {
    return i == parts_ ? length_ : length_ / static_cast<double>(parts_) * static_cast<double>(i);
  }

  void update(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) {
      most_[parts_ + i] = (at_[i] + at_[i + 1] + (place(i + 1) - place(i))) / 2;
    }
    for (std::size_t i = (parts_ + first) / 2, k = (parts_ + last) / 2; i > 0; i /= 2, k /= 2) {
      for (std::size_t j = i; j <= k; ++j) most_[j] = std::max(most_[2 * j], most_[2 * j + 1]);
    }
  }

  /// The smallest distance of a window between two places, also beyond the ends of the window.
  static double lowest_between(const EdgeWindow& window, double from, double to) {
    if (!window.from_point()) return std::min(window.value(from), window.value(to));
    return window.value(std::clamp(window.px, from, to));
  }

  /// The first part (the last part if `last` is set) in which the window may be shorter, among the
  /// `count` parts from part `first` on; parts() if there is none.
  [[nodiscard]] std::size_t find(Asked& asked, std::size_t node, std::size_t first,
                                 std::size_t count, bool last) const {
    constexpr std::size_t kVisits = 4;  // the cost of a square root and a cache miss
    asked.visited += kVisits;
    const double from = std::max(asked.window->begin, place(first));
    const double to = std::min(asked.window->end, place(first + count));
    if (to < from) return parts_;
    if (lowest_between(*asked.window, from, to) > most_[node] + asked.same) return parts_;
    if (count == 1) return first;
    const std::size_t half = count / 2;
    for (const bool right : {last, !last}) {
      const std::size_t found =
          find(asked, 2 * node + (right ? 1 : 0), first + (right ? half : 0), half, last);
      if (found != parts_) return found;
    }
    return parts_;
  }

  double length_;
  std::size_t parts_;
  std::vector<double> at_;    // the shortest known distance at each place
  std::vector<double> most_;  // per part, per two parts, ...: a binary tree with root 1
};

}  // namespace talweg
