// A split history records all triangles of a growing triangulation, to find the triangle at a place
// quickly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace talweg {

/// A directed graph of all triangles of the past and present; a replaced triangle points to the
/// triangles that replaced it. Finding a place takes the depth of the graph: log n expected for
/// points in mixed order (L. Guibas, D. Knuth, M. Sharir, "Randomized incremental construction of
/// Delaunay and Voronoi diagrams", 1992). About 32 bytes per triangle of the graph.
class SplitHistory {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  /// The history of triangle 0 with the given corners.
  explicit SplitHistory(const Corners& corners) : triangles_{{corners, 0, {}, 0}}, present_{0} {}

  /// Records the division of a triangle into two or three parts, one of which keeps its number.
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

  /// Records a flip: the two triangles at an edge are replaced by two others with the same numbers.
  void flip(const std::pair<std::uint32_t, Corners>& left,
            const std::pair<std::uint32_t, Corners>& right) {
    const std::array<std::uint32_t, 2> before = {present_[left.first], present_[right.first]};
    divide(left.first, {left, right});
    triangles_[before[1]].parts = triangles_[before[0]].parts;
    triangles_[before[1]].count = 2;
  }

  /// Frees the memory; at() must not be called afterwards.
  void forget() { *this = SplitHistory({0, 0, 0}); }

  /// The triangle at a place. holds(Corners) tells whether a triangle contains the place; the place
  /// must lie in the first triangle.
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
    std::uint32_t number;                // in the triangulation
    std::array<std::uint32_t, 3> parts;  // indices in triangles_
    std::uint32_t count;                 // of parts; 0 if the triangle exists
  };
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> present_;  // per existing triangle, its index in triangles_
};

}  // namespace talweg
