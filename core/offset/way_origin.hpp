// A way's origin is where on a curve the shortest way to a point begins, and on which side.
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
    kLeft,     ///< of a segment, at a right angle to it
    kRight,    ///< the same
    kEnd,      ///< an end of an open curve inside the surface
    kUnknown,  ///< another point, around which the way may turn
  };
  Kind kind = Kind::kUnknown;
  std::uint32_t curve = 0;
  double arc = 0;       ///< arc length on that curve
  double distance = 0;  ///< length of the way
};

/// Tells the origins of ways that a distance finds, which must outlive the object.
class WayOrigins {
 public:
  /// `distance` is set to `curves`; no point will be farther than `limit`.
  WayOrigins(const Surface& surface, std::span<const SurfaceCurve> curves,
             PolylineDistance& distance, double limit);

  /// Of the shortest way to a point that lies in that face. O(ways into the face).
  [[nodiscard]] WayOrigin of(const FaceCoordinates& at) const;

 private:
  struct Ends {
    bool first = false, last = false;  ///< whether they are inside the surface
  };
  PolylineDistance* distance_;
  double limit_;
  std::vector<Ends> ends_;  // per curve
};

}  // namespace talweg
