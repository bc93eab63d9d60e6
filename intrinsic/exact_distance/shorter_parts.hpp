// The shorter parts of a new window are the parts where its distances are below all known ones.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "talweg/intrinsic/exact_distance/polyline_window.hpp"

namespace talweg {

/// At first there is one part, the whole window or a part of it. Each older window of the edge then
/// removes the parts where it is at least as short, and is cut where the new window is shorter.
/// Borders are accurate to kBorder. Adjacent windows overlap by a few times kBorder, so that no
/// point of the edge falls between two windows.
class ShorterParts {
 public:
  using Part = std::array<double, 2>;  // from, to

  /// `length` is the length of the edge. The new window, which must outlive the object, counts as
  /// shorter where its distance is less by more than `same`. `whole`: the part where the window can
  /// be shorter at all.
  ShorterParts(const EdgeWindow& window, double length, double same, const Part& whole)
      : window_(&window), length_(length), same_(same), size_(size_of(window, length)) {
    parts_.add(whole[0], whole[1]);
  }
  ShorterParts(const EdgeWindow& window, double length, double same)
      : ShorterParts(window, length, same, {window.begin, window.end}) {}

  void compare_with(EdgeWindow& other);

  [[nodiscard]] bool empty() const { return parts_.count == 0; }
  /// Disjoint, sorted. Gaps are closed when there would be too many parts, which only costs time.
  [[nodiscard]] std::span<const Part> parts() const { return {parts_.at.data(), parts_.count}; }

  /// Accuracy of borders, relative to the edge's length or to the source's distance from the
  /// window, whichever is smaller. A source can be far nearer than the edge is long and reach all
  /// of the edge.
  static constexpr double kBorder = 1e-10;
  /// Parts and windows narrower than kNarrow times the accuracy are dropped.
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
