// A way's origin is the point of a curve where the shortest way begins, and the side to which the
// way leaves the curve.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct WayOrigin {
  enum class Kind {
    kLeft,     ///< left of a segment, at a right angle to the segment
    kRight,    ///< right of a segment, likewise
    kEnd,      ///< an end of an open curve, off the boundary of the mesh
    kUnknown,  ///< any other: a vertex of a curve, or a way that bends at a vertex of the mesh
  };
  Kind kind = Kind::kUnknown;
  std::uint32_t curve = 0;
  double arc = 0;       ///< arc length on that curve
  double distance = 0;  ///< length of the way
};

/// Finds the origins of the shortest ways of a distance. The distance must outlive the object.
class WayOrigins {
 public:
  /// `distance` must be set to `curves`. No point passed to of() may be farther than `limit`.
  WayOrigins(const Surface& surface, std::span<const SurfaceCurve> curves,
             PolylineDistance& distance, double limit);

  /// The origin of the shortest way to a point, given in a face. O(ways into the face).
  [[nodiscard]] WayOrigin of(const FaceCoordinates& at) const;

 private:
  struct Ends {
    bool first = false, last = false;  ///< whether an end of an open curve lies off the boundary
  };
  PolylineDistance* distance_;
  double limit_;
  std::vector<Ends> ends_;  // per curve
};

}  // namespace talweg
