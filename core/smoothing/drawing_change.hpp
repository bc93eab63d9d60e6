// A drawing change tells which points of a curve stay when a part of it is redrawn.
#pragma once

#include <cstddef>

#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Two drawings of one curve, side by side: the first `kept_before` points are the same in both,
/// and so are the last `kept_after`; what lies between has changed. Closed curves are turned so
/// that the points that are kept lie half before and half after the change.
struct DrawingChange {
  SurfaceCurve before;
  SurfaceCurve after;
  std::size_t kept_before = 0;
  std::size_t kept_after = 0;

  /// Whether the two are the same.
  [[nodiscard]] bool is_none() const {
    return kept_before + kept_after == before.points.size() &&
           kept_before + kept_after == after.points.size();
  }
  /// Points of `after` that are new.
  [[nodiscard]] std::size_t new_points() const {
    return after.points.size() - kept_before - kept_after;
  }
};

/// Finds the longest common stretch, of closed curves around their seam, too, as far as it holds
/// one of four points spread over `before`. A curve that was closed or opened has changed
/// everywhere. O(points).
DrawingChange change_between(const SurfaceCurve& before, const SurfaceCurve& after);

}  // namespace talweg
