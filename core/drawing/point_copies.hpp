// Point copies map points of a drawing to the same points on another surface.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/point_lookup.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A map from a point to its copies. O(1) for a point and each copy.
class PointCopies {
 public:
  void add(const SurfacePoint& point, const SurfacePoint& copy) {
    points_.add(point);
    const auto number = static_cast<std::uint32_t>(copies_.size());
    const auto first = static_cast<std::uint32_t>(*points_.find(point));
    copies_.push_back(copy);
    next_.push_back(kNone);
    last_.push_back(number);
    if (first == number) return;
    next_[last_[first]] = number;
    last_[first] = number;
  }

  /// All copies of these points, in the order in which they were added.
  [[nodiscard]] std::vector<SurfacePoint> of(std::span<const SurfacePoint> points) const {
    std::vector<std::uint32_t> numbers;
    for (const SurfacePoint& point : points) {
      const auto first = points_.find(point);
      if (!first) continue;
      for (auto k = static_cast<std::uint32_t>(*first); k != kNone; k = next_[k])
        numbers.push_back(k);
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<SurfacePoint> copies;
    copies.reserve(numbers.size());
    for (const std::uint32_t k : numbers) copies.push_back(copies_[k]);
    return copies;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  PointLookup points_;
  std::vector<SurfacePoint> copies_;
  std::vector<std::uint32_t> next_;  // per copy: the next one of the same point
  std::vector<std::uint32_t> last_;  // per first copy: the last one of the same point
};

}  // namespace talweg
