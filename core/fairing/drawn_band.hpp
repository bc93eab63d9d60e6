// The drawn band is where a fair curve may run: near its drawing, between two walls.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "talweg/core/fairing/drawn_line.hpp"
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
  double begin = 0;       ///< where it begins on the drawn line, mesh units
  bool reversed = false;  ///< it runs against the drawn line, towards that place
};

/// Where a point of the band lies; mesh units.
struct BandPlace {
  double distance = 0;    ///< δ, to the drawing
  double slope = 0;       ///< of δ along the direction that was asked for; 1 on the drawing itself
  double slack = 0;       ///< ε at the nearest point of the drawing
  double wall = 0;        ///< the distance of the walls there
  double wall_slope = 0;  ///< of that along the direction
  double middle = 1;      ///< BandWidth::middle
  double arc = NAN;       ///< of the nearest point on the drawn line; no number at other curves
};

/// The band of a curve that a PolylineDistance is set to, or of several that are joined: of these
/// it is as wide as that of the nearest one. Refers to the distance.
/// The line is the drawing of all of them in space; it may be null, and then every place is
/// anybody's own, as wide as the narrowest.
/// Cost of at(): the drawing's segments in the face and the windows on its sides that are near.
/// Worse: thousands of points in one face.
class DrawnBand {
 public:
  DrawnBand(PolylineDistance& distance, std::size_t curve, const BandWidth& width)
      : DrawnBand(distance, std::vector<BandCurve>{{curve, width}}) {}
  DrawnBand(PolylineDistance& distance, const std::vector<BandCurve>& curves,
            const DrawnLine* line = nullptr);

  [[nodiscard]] BandPlace at(const FaceCoordinates& point, PlanePoint direction) const;
  [[nodiscard]] BandPlace at(const SurfacePoint& point) const;
  /// Whether a place is in the part of the band that belongs to this place on the line: what is
  /// drawn from there to the nearest point stays within the distance of a wall. Else another strand
  /// is nearer.
  [[nodiscard]] bool is_own(const BandPlace& place, double drawn) const;
  /// Whether a straight line from one place on the line to another cuts something off that is
  /// farther from it than nearly the walls are.
  [[nodiscard]] bool cuts_off(double from, double to) const;
  /// The least slack anywhere along the curve, and the largest.
  [[nodiscard]] double least_slack() const;
  [[nodiscard]] double largest_slack() const;
  /// The least slack between two places on the line, of which the second lies ahead.
  [[nodiscard]] double slack_between(double from, double to) const;

 private:
  struct Width {
    std::size_t curve = 0;
    BandWidth width;
    double begin = 0, length = 0;  // on the line, mesh units
    bool reversed = false;
    std::vector<double> arcs, slacks;  // of slack_at, all around a closed curve

    [[nodiscard]] double on_line(double arc) const {
      return begin + (reversed ? length - arc : arc);
    }
    /// And how it changes along the curve.
    [[nodiscard]] std::pair<double, double> slack_at(double arc) const;
    [[nodiscard]] double least_between(double from, double to) const;
    [[nodiscard]] double wall_for(double slack) const {
      return std::min(width.walls * slack, width.most);
    }
  };
  void add(const BandCurve& curve);
  [[nodiscard]] const Width* width_of(std::uint32_t curve) const;
  void set_width(BandPlace& place, std::uint32_t curve, double arc, double arc_slope) const;
  template <class Value>
  [[nodiscard]] double least_along(double from, double to, const Value& value) const;

  PolylineDistance* distance_;
  const DrawnLine* line_;
  std::vector<Width> widths_;  // ascending by curve
  std::size_t narrowest_ = 0;
};

}  // namespace talweg
