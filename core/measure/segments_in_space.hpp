// Segments in space are the segments of curves by number, and lead back to the curves.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/nearest_segment.hpp"

namespace talweg {

/// Numbers the segments of all curves consecutively. The curves must outlive the object. O(n log n)
/// for n points. Throws Error(kBadCurve) if there is no curve.
class SegmentsInSpace {
 public:
  SegmentsInSpace(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves)
      : curves_(curves), tree_(all_of(mesh, curves, first_)) {}

  [[nodiscard]] const NearestSegment& tree() const { return tree_; }
  [[nodiscard]] const Segment& segment(std::uint32_t number) const {
    return tree_.segments()[number];
  }
  [[nodiscard]] std::uint32_t curve_of(std::uint32_t segment) const {
    const auto next = std::upper_bound(first_.begin(), first_.end(), segment);
    return static_cast<std::uint32_t>(next - first_.begin() - 1);
  }
  /// The two ends of a segment, as numbers of points of its curve.
  [[nodiscard]] std::array<std::uint32_t, 2> ends(std::uint32_t segment) const {
    const std::uint32_t curve = curve_of(segment), i = segment - first_[curve];
    return {i, (i + 1) % static_cast<std::uint32_t>(curves_[curve].points.size())};
  }
  /// Segments, given ascending, as curves; consecutive segments of a curve are joined.
  [[nodiscard]] std::vector<SurfaceCurve> as_curves(std::span<const std::uint32_t> segments) const {
    std::vector<SurfaceCurve> parts;
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const auto& points = curves_[curve_of(segments[k])].points;
      const auto [from, to] = ends(segments[k]);
      const bool joined = k > 0 && from > 0 && segments[k - 1] + 1 == segments[k];
      if (!joined) parts.push_back({false, {points[from]}});
      if (from != to) parts.back().points.push_back(points[to]);
    }
    return parts;
  }

 private:
  static std::vector<Segment> all_of(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                     std::vector<std::uint32_t>& first) {
    std::vector<Segment> segments;
    for (const SurfaceCurve& curve : curves) {
      first.push_back(static_cast<std::uint32_t>(segments.size()));
      const auto own = segments_of(positions_of(mesh, curve), curve.closed);
      segments.insert(segments.end(), own.begin(), own.end());
    }
    return segments;
  }

  std::span<const SurfaceCurve> curves_;
  std::vector<std::uint32_t> first_;  // per curve, the number of its first segment
  NearestSegment tree_;
};

}  // namespace talweg
