// A split history remembers how a triangulation grew, and so finds the triangle at a place quickly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace talweg {

/// The triangles that there ever were, each with those that took its place. Finding a place takes
/// the depth of this graph: log n as a rule where points came in a mixed order (L. Guibas, D.
/// Knuth, M. Sharir, "Randomized incremental construction of Delaunay and Voronoi diagrams", 1992).
/// About 32 bytes for a triangle that was.
class SplitHistory {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  /// Begins with triangle 0.
  explicit SplitHistory(const Corners& corners) : ever_{{corners, 0, {}, 0}}, now_{0} {}

  /// The triangle with this number is divided; one of its two or three parts takes its number.
  void divide(std::uint32_t triangle,
              std::initializer_list<std::pair<std::uint32_t, Corners>> parts) {
    const std::uint32_t whole = now_[triangle];
    for (const auto& [number, corners] : parts) {
      Ever& divided = ever_[whole];
      const auto part = static_cast<std::uint32_t>(ever_.size());
      divided.parts[divided.count++] = part;
      ever_.push_back({corners, number, {}, 0});
      if (number >= now_.size()) now_.resize(number + std::size_t{1});
      now_[number] = part;
    }
  }

  /// Two triangles take the place of two: the edge between them is flipped.
  void flip(const std::pair<std::uint32_t, Corners>& left,
            const std::pair<std::uint32_t, Corners>& right) {
    const std::array<std::uint32_t, 2> before = {now_[left.first], now_[right.first]};
    divide(left.first, {left, right});
    ever_[before[1]].parts = ever_[before[0]].parts;
    ever_[before[1]].count = 2;
  }

  /// Gives up its memory; nothing can be found any more.
  void forget() { *this = SplitHistory({0, 0, 0}); }

  /// A triangle with a place: holds(Corners) tells whether one has it. Every place is in one.
  template <class Holds>
  [[nodiscard]] std::uint32_t at(const Holds& holds) const {
    std::uint32_t i = 0;
    while (ever_[i].count > 0) {
      const Ever& divided = ever_[i];
      std::size_t k = 0;
      while (k + 1 < divided.count && !holds(ever_[divided.parts[k]].corners)) ++k;
      i = divided.parts[k];
    }
    return ever_[i].triangle;
  }

 private:
  struct Ever {
    Corners corners;
    std::uint32_t triangle;              // its number, or that of one of its parts
    std::array<std::uint32_t, 3> parts;  // indices here
    std::uint32_t count;                 // of parts; 0: it is there
  };
  std::vector<Ever> ever_;
  std::vector<std::uint32_t> now_;  // of each triangle that is there its index in ever_
};

}  // namespace talweg
