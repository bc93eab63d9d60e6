// The shorter parts of a new window are where its ways are shorter than all that are known.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "talweg/intrinsic/exact_distance/polyline_window.hpp"

namespace talweg {

/// At first one part, the whole window or a part of it. Each older window of the edge then takes
/// away what it reaches by a way at least as short, and is cut where the new window is shorter.
/// Borders are found to kBorder; there neighbouring windows overlap by a few times that, so that no
/// point of the edge falls between two.
class ShorterParts {
 public:
  using Part = std::array<double, 2>;  // from, to

  /// `length` is that of the edge. The new window counts as shorter where it is so by more than
  /// `same`. It must outlive the object. `whole`: where it can be shorter at all.
  ShorterParts(const EdgeWindow& window, double length, double same, const Part& whole)
      : window_(&window), length_(length), same_(same), size_(size_of(window, length)) {
    parts_.add(whole[0], whole[1]);
  }
  ShorterParts(const EdgeWindow& window, double length, double same)
      : ShorterParts(window, length, same, {window.begin, window.end}) {}

  void compare_with(EdgeWindow& other);

  [[nodiscard]] bool empty() const { return parts_.count == 0; }
  /// Disjoint, in order. When there would be too many, gaps are closed, which only costs time.
  [[nodiscard]] std::span<const Part> parts() const { return {parts_.at.data(), parts_.count}; }

  /// Accuracy of borders, relative to the edge or to the distance of the source; the latter can be
  /// far shorter than the edge although its ways lead everywhere.
  static constexpr double kBorder = 1e-10;
  /// Parts and windows narrower than this times the accuracy are dropped.
  static constexpr double kNarrow = 8;

 private:
  struct Parts {
    std::size_t count = 0;
    std::array<Part, 12> at;

    void add(double from, double to) {
      if (count > 0 && (from <= at[count - 1][1] || count == at.size())) {
        at[count - 1][1] = to;
      } else {
        at[count++] = {from, to};
      }
    }
    void take(const Parts& other) {
      count = other.count;
      std::copy_n(other.at.begin(), count, at.begin());
    }
  };

  /// The smaller of the edge's length and the source's distance from the window.
  static double size_of(const EdgeWindow& w, double length) {
    if (!w.from_point() || w.py == 0) return length;
    return std::min(length, std::abs(w.py) + std::max({w.begin - w.px, w.px - w.end, 0.0}));
  }

  const EdgeWindow* window_;
  double length_, same_, size_;
  Parts parts_;
};

}  // namespace talweg
