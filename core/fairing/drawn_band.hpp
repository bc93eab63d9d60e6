// The drawn band is where a fair curve may run: near its drawing, between two walls.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/plane_point.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// How wide the band of a curve is; mesh units.
struct BandWidth {
  double slack = 0;                  ///< ε
  std::span<const double> slack_at;  ///< unless empty, replaces it: at each point of the curve
  double least_slack = 0;            ///< > 0; less counts as this
  double walls = 1.2;                ///< W: their distance from the drawing, in slacks
  double most = HUGE_VAL;            ///< they are never farther away than this
};

/// Where a point of the band lies; mesh units.
struct BandPlace {
  double distance = 0;    ///< δ, to the drawing
  double slope = 0;       ///< of δ along the direction that was asked for
  double slack = 0;       ///< ε at the nearest point of the drawing
  double wall = 0;        ///< the distance of the walls there
  double wall_slope = 0;  ///< of that along the direction
};

/// The band of one of the curves that a PolylineDistance is set to. Refers to the distance.
class DrawnBand {
 public:
  DrawnBand(PolylineDistance& distance, std::size_t curve, const BandWidth& width);

  [[nodiscard]] BandPlace at(const FaceCoordinates& point, PlanePoint direction) const;
  [[nodiscard]] BandPlace at(const SurfacePoint& point) const;
  /// The least slack anywhere along the curve.
  [[nodiscard]] double least_slack() const;

 private:
  void set_width(BandPlace& place, std::uint32_t curve, double arc, double arc_slope) const;

  PolylineDistance* distance_;
  std::size_t curve_;
  BandWidth width_;
  std::vector<double> arcs_, slacks_;  // of slack_at, all around a closed curve
};

}  // namespace talweg
