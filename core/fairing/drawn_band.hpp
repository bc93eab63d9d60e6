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
  double middle = 1;                 ///< how much the middle draws, against other curves
};

/// A curve that is faired, by its number among those of the distance.
struct BandCurve {
  std::size_t curve = 0;
  BandWidth width;
};

/// Where a point of the band lies; mesh units.
struct BandPlace {
  double distance = 0;    ///< δ, to the drawing
  double slope = 0;       ///< of δ along the direction that was asked for
  double slack = 0;       ///< ε at the nearest point of the drawing
  double wall = 0;        ///< the distance of the walls there
  double wall_slope = 0;  ///< of that along the direction
  double middle = 1;      ///< BandWidth::middle
};

/// The band of a curve that a PolylineDistance is set to, or of several that are joined: of these
/// it is as wide as that of the nearest one. Refers to the distance.
/// Cost of at(): the drawing's segments in the face and the windows on its sides that are near.
/// Worse: thousands of points in one face.
class DrawnBand {
 public:
  DrawnBand(PolylineDistance& distance, std::size_t curve, const BandWidth& width)
      : DrawnBand(distance, std::vector<BandCurve>{{curve, width}}) {}
  DrawnBand(PolylineDistance& distance, const std::vector<BandCurve>& curves);

  [[nodiscard]] BandPlace at(const FaceCoordinates& point, PlanePoint direction) const;
  [[nodiscard]] BandPlace at(const SurfacePoint& point) const;
  /// The least slack anywhere along the curve.
  [[nodiscard]] double least_slack() const;

 private:
  struct Width {
    std::size_t curve = 0;
    BandWidth width;
    std::vector<double> arcs, slacks;  // of slack_at, all around a closed curve
  };
  void add(const BandCurve& curve);
  [[nodiscard]] const Width& width_at(std::uint32_t curve) const;
  void set_width(BandPlace& place, std::uint32_t curve, double arc, double arc_slope) const;

  PolylineDistance* distance_;
  std::vector<Width> widths_;  // ascending by curve
  std::size_t narrowest_ = 0;
};

}  // namespace talweg
