// A point lookup finds a surface point among many.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <variant>

#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// An index of points with exact comparison of coordinates. O(1) per lookup and O(n) to construct;
/// a search through the list would cost n² for n way-points of one drawing.
class PointLookup {
 public:
  PointLookup() = default;
  explicit PointLookup(std::span<const SurfacePoint> points) { add_all(points); }
  /// Points are numbered from 0 in the order of addition; repeated points count, too.
  void add(const SurfacePoint& point) { first_.try_emplace(point, count_++); }
  void add_all(std::span<const SurfacePoint> points) {
    for (const SurfacePoint& point : points) add(point);
  }

  [[nodiscard]] bool contains(const SurfacePoint& point) const { return first_.contains(point); }
  /// The number of the first equal point.
  [[nodiscard]] std::optional<std::size_t> find(const SurfacePoint& point) const {
    const auto found = first_.find(point);
    return found == first_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  struct Hash {
    std::size_t operator()(const SurfacePoint& point) const {
      if (const auto* v = std::get_if<AtVertex>(&point.where())) return v->vertex.index();
      // The odd factors (from the golden ratio and xxHash) spread consecutive indices and evenly
      // spaced coordinates.
      if (const auto* e = std::get_if<OnEdge>(&point.where())) {
        return e->edge.index() * 0x9E3779B1U ^ std::hash<double>{}(e->t);
      }
      const InFace& in = std::get<InFace>(point.where());
      return in.face.index() * 0x9E3779B1U ^ std::hash<double>{}(in.barycentric[0]) ^
             std::hash<double>{}(in.barycentric[1]) * 0xC2B2AE3DU;
    }
  };
  std::unordered_map<SurfacePoint, std::size_t, Hash> first_;  // never iterated
  std::size_t count_ = 0;
};

}  // namespace talweg
