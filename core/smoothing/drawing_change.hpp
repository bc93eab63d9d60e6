// A drawing change records the points of a curve that stay when a part of it is redrawn.
#pragma once

#include <cstddef>

#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Two drawings of one curve. The first `kept_before` points are equal in both, and the last
/// `kept_after`; the points between have changed. Closed curves are rotated so that half of the
/// common points lie before the change and half after it.
struct DrawingChange {
  SurfaceCurve before;
  SurfaceCurve after;
  std::size_t kept_before = 0;
  std::size_t kept_after = 0;

  /// Whether the two drawings are equal.
  [[nodiscard]] bool is_none() const {
    return kept_before + kept_after == before.points.size() &&
           kept_before + kept_after == after.points.size();
  }
  /// The number of new points of `after`.
  [[nodiscard]] std::size_t new_points() const {
    return after.points.size() - kept_before - kept_after;
  }
};

/// Finds the longest common stretch, which may cross the seam of a closed curve. The stretch is
/// found if it contains one of four points spread over `before`. A curve that was closed or opened
/// counts as changed everywhere. O(points).
DrawingChange change_between(const SurfaceCurve& before, const SurfaceCurve& after);

}  // namespace talweg
