// Joined curves are curves of a set whose ends meet, and are faired as one curve.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Curves of a set, each of which begins where the previous curve ends; or one curve alone.
struct JoinedCurves {
  struct Part {
    std::size_t curve = 0;
    bool reversed = false;

    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts;
  bool is_ring = false;  ///< the last part also ends where the first part begins

  bool operator==(const JoinedCurves&) const = default;
  [[nodiscard]] bool is_joined() const { return is_ring || parts.size() > 1; }
};

/// All curves, joined at points where exactly two ends of open curves meet. No other curve of the
/// set may pass such a point, the point may be neither at the boundary nor among `corners`, and
/// `may_join` must accept both curves. O(n log n) for n points.
std::vector<JoinedCurves> joined_curves(
    const Surface& surface, std::span<const SurfaceCurve> curves,
    std::span<const SurfacePoint> corners,
    const std::function<bool(std::size_t, std::size_t)>& may_join);

/// Joins the curves of the parts, in order, to one curve. The curve of a ring is closed, and begins
/// where the first part begins.
SurfaceCurve joined_parts(const JoinedCurves& joined, std::vector<SurfaceCurve> parts);
/// The same with all curves of the set.
SurfaceCurve joined(const JoinedCurves& joined, std::span<const SurfaceCurve> curves);
/// The points where parts meet: after each part but the last; for a ring, before each part.
std::vector<SurfacePoint> junctions(const JoinedCurves& joined,
                                    std::span<const SurfaceCurve> curves);
/// Splits a curve that passes the junctions in order into its parts, each in the direction of its
/// own curve; a curve alone stays whole.
std::vector<SurfaceCurve> split_at_junctions(const JoinedCurves& joined,
                                             std::span<const SurfacePoint> junctions,
                                             SurfaceCurve curve);

}  // namespace talweg
