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
  explicit SplitHistory(const Corners& corners) : triangles_{{corners, 0, {}, 0}}, present_{0} {}

  /// The triangle with this number is divided; one of its two or three parts takes its number.
  void divide(std::uint32_t triangle,
              std::initializer_list<std::pair<std::uint32_t, Corners>> parts) {
    const std::uint32_t whole = present_[triangle];
    for (const auto& [number, corners] : parts) {
      Triangle& divided = triangles_[whole];
      const auto part = static_cast<std::uint32_t>(triangles_.size());
      divided.parts[divided.count++] = part;
      triangles_.push_back({corners, number, {}, 0});
      if (number >= present_.size()) present_.resize(number + std::size_t{1});
      present_[number] = part;
    }
  }

  /// Two triangles take the place of two: the edge between them is flipped.
  void flip(const std::pair<std::uint32_t, Corners>& left,
            const std::pair<std::uint32_t, Corners>& right) {
    const std::array<std::uint32_t, 2> before = {present_[left.first], present_[right.first]};
    divide(left.first, {left, right});
    triangles_[before[1]].parts = triangles_[before[0]].parts;
    triangles_[before[1]].count = 2;
  }

  /// Gives up its memory; nothing can be found any more.
  void forget() { *this = SplitHistory({0, 0, 0}); }

  /// A triangle with a place: holds(Corners) tells whether one has it. Every place is in one.
  template <class Holds>
  [[nodiscard]] std::uint32_t at(const Holds& holds) const {
    std::uint32_t i = 0;
    while (triangles_[i].count > 0) {
      const Triangle& divided = triangles_[i];
      std::size_t k = 0;
      while (k + 1 < divided.count && !holds(triangles_[divided.parts[k]].corners)) ++k;
      i = divided.parts[k];
    }
    return triangles_[i].number;
  }

 private:
  struct Triangle {
    Corners corners;
    std::uint32_t number;                // the number of the triangle, or of one of its parts
    std::array<std::uint32_t, 3> parts;  // indices here
    std::uint32_t count;                 // of parts; 0 for a triangle of the present
  };
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> present_;  // by number: index in triangles_
};

}  // namespace talweg
