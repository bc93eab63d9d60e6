// Joined curves continue each other where two ends of a set meet, and are faired as one curve.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Curves of a set, each of which begins where the one before ends; or one curve alone.
struct JoinedCurves {
  struct Part {
    std::size_t curve = 0;
    bool reversed = false;

    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts;
  bool is_ring = false;  ///< the last part also ends where the first one begins

  bool operator==(const JoinedCurves&) const = default;
  [[nodiscard]] bool is_joined() const { return is_ring || parts.size() > 1; }
};

/// All curves, joined where exactly two ends of open curves lie at one point, nothing else of the
/// set passes it, it is neither at the boundary nor among `corners`, and `may_join` both curves.
/// O(n log n) for n points.
std::vector<JoinedCurves> joined_curves(
    const Surface& surface, std::span<const SurfaceCurve> curves,
    std::span<const SurfacePoint> corners,
    const std::function<bool(std::size_t, std::size_t)>& may_join);

/// The curves of the parts, in their order, as one. A ring is closed, and begins where its first
/// part does.
SurfaceCurve joined_parts(const JoinedCurves& joined, std::vector<SurfaceCurve> parts);
/// The same, of all curves of the set.
SurfaceCurve joined(const JoinedCurves& joined, std::span<const SurfaceCurve> curves);
/// Where parts meet: after each part but the last; of a ring, before each.
std::vector<SurfacePoint> junctions(const JoinedCurves& joined,
                                    std::span<const SurfaceCurve> curves);
/// The parts of a curve that passes the junctions in their order, in the directions of the curves;
/// the curve itself where it is one alone.
std::vector<SurfaceCurve> parted(const JoinedCurves& joined,
                                 std::span<const SurfacePoint> junctions, SurfaceCurve curve);

}  // namespace talweg
