// A face triangulation divides one triangle along points and segments in it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "talweg/core/cutting/split_history.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

/// A triangulation of a triangle in which given segments are chains of edges. Points have integer
/// barycentric coordinates, so the side of a line on which a point lies is decided exactly, and two
/// faces of a mesh agree on the points of their common edge. O((n + flips) log n) expected for n
/// points and for segments between neighbours. About n flips are needed, because beyond 1024 points
/// the triangulation is improved around each new point. A segment that crosses many others adds a
/// point per crossing.
class FaceTriangulation {
 public:
  static constexpr std::int64_t kOne = std::int64_t{1} << 40;
  /// Integer barycentric coordinates, each >= 0, with the sum kOne. On side k, from corner k to k +
  /// 1, coordinate k + 2 is 0.
  using Place = std::array<std::int64_t, 3>;
  using Corners = std::array<std::uint32_t, 3>;

  /// The corners (numbers 0, 1, 2) in the plane, counterclockwise. Positions matter for the
  /// Delaunay criterion only.
  explicit FaceTriangulation(const std::array<PlanePoint, 3>& corners);

  /// Adds a point and returns its number, or the number of an existing point at this place. O(log
  /// n) expected, O(n) after the first connect().
  std::uint32_t insert(const Place& place);
  /// Makes the segment between two points a chain of edges. The chain passes through points on the
  /// segment. At a crossing with another segment, a point is added at the nearest place of the
  /// lattice. Returns the number of the segment. Throws Error(kNumerical) on failure (never seen).
  std::size_t connect(std::uint32_t a, std::uint32_t b);
  /// Flips edges that do not belong to segments until the triangulation is constrained Delaunay up
  /// to rounding.
  void improve();

  /// The points along a segment, in order, ends included.
  [[nodiscard]] std::vector<std::uint32_t> chain(std::size_t segment) const;
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  /// The triangles, counterclockwise, each with a positive area.
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }

 private:
  using Key = std::uint64_t;
  static Key directed(std::uint32_t a, std::uint32_t b) { return (Key{a} << 32U) | b; }
  static Key undirected(std::uint32_t a, std::uint32_t b) {
    return a < b ? directed(a, b) : directed(b, a);
  }
  /// The sign of the triangle's area on the lattice: 1 if a, b, c turn left.
  [[nodiscard]] int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] bool has_edge(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool is_fixed(std::uint32_t a, std::uint32_t b) const {
    return fixed_.count(undirected(a, b)) > 0;
  }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t a, std::uint32_t b) const;
  void set(std::uint32_t triangle, const Corners& corners);
  void add(const Corners& corners);
  [[nodiscard]] std::uint32_t find(const Place& place) const;
  void remember(const Place& place);
  [[nodiscard]] std::array<int, 3> sides(const Corners& c, std::uint32_t p) const;
  [[nodiscard]] std::uint32_t triangle_at(std::uint32_t p) const;
  void split_inside(std::uint32_t triangle, std::uint32_t p);
  void split_edge(std::uint32_t a, std::uint32_t b, std::uint32_t p);
  void flip(std::uint32_t a, std::uint32_t b);
  void improve_around(std::uint32_t p);
  [[nodiscard]] bool can_flip(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::array<std::uint32_t, 2> leaving(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t step(std::uint32_t a, std::uint32_t b);
  std::uint32_t cross(std::uint32_t a, std::uint32_t b, std::uint32_t u, std::uint32_t v);
  using Edges = std::vector<std::array<std::uint32_t, 2>>;
  void clear_way(std::uint32_t a, std::uint32_t b, const Edges& edges);
  void refill(std::uint32_t a, std::uint32_t b, const Edges& edges);
  void fill(const std::vector<std::uint32_t>& chain, bool on_left, std::vector<std::uint32_t>& free,
            Edges& made);
  void improve(Edges open);
  [[nodiscard]] Corners neighbours(std::uint32_t triangle) const;
  [[nodiscard]] bool should_flip(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] PlanePoint plane(std::uint32_t p) const;

  std::array<PlanePoint, 3> corners_;
  std::vector<Place> places_;
  struct PlaceHash {
    std::size_t operator()(const Place& p) const {
      // Multiplication by odd numbers (of the golden ratio, and of xxHash) spreads places on
      // lattice lines.
      const std::uint64_t x = static_cast<std::uint64_t>(p[1]) * 0x9E3779B97F4A7C15U ^
                              static_cast<std::uint64_t>(p[2]) * 0xC2B2AE3D27D4EB4FU;
      return static_cast<std::size_t>(x ^ (x >> 32U));
    }
  };
  std::unordered_map<Place, std::uint32_t, PlaceHash> number_of_;  // for more than kFew points
  std::vector<Corners> triangles_;
  std::unordered_map<Key, std::uint32_t> triangle_of_;  // by directed edge
  std::vector<std::uint32_t> corner_of_;                // per point, one of its triangles
  SplitHistory history_{{0, 1, 2}};
  bool has_history_ = true;
  struct Fixed {
    bool is_split = false;
    std::uint32_t at = 0;
  };
  std::unordered_map<Key, Fixed> fixed_;  // edges of segments, including split ones
  std::vector<std::vector<std::uint32_t>> segments_;
};

}  // namespace talweg
