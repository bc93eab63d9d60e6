// The drawn band is the strip along a drawing, between two walls, where a fair curve may run.
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

/// The width of the band of a curve; lengths in mesh units.
struct BandWidth {
  double slack = 0;                  ///< ε
  std::span<const double> slack_at;  ///< unless empty, replaces `slack`: ε at each curve point
  double least_slack = 0;            ///< > 0; lower bound of ε
  double wall_in_slacks = 1.2;       ///< W: distance of the walls from the drawing, in slacks
  double largest_wall = HUGE_VAL;    ///< upper bound of the distance of the walls
  double centering = 1;              ///< factor of FairOptions::centering on this curve
};

/// A curve that is faired, by its number among the curves of the distance.
struct BandCurve {
  std::size_t curve = 0;
  BandWidth width;
  double begin = 0;       ///< first place of the curve on the drawn line, mesh units
  bool reversed = false;  ///< the curve runs against the drawn line and ends at `begin`
};

/// The place of a point in the band; lengths in mesh units.
struct BandPlace {
  double distance = 0;    ///< δ, to the drawing
  double slope = 0;       ///< derivative of δ along the given direction; 1 on the drawing itself
  double slack = 0;       ///< ε at the nearest point of the drawing
  double wall = 0;        ///< distance of the walls from the drawing there
  double wall_slope = 0;  ///< derivative of `wall` along the direction
  double centering = 1;   ///< BandWidth::centering
  double arc = NAN;       ///< place of the nearest point on the drawn line; NaN at other curves
};

/// The band of one curve of a PolylineDistance, or of several joined curves: the width at a point
/// is the width of the nearest of these curves. Where another curve of the distance is nearest, the
/// narrowest width counts. Refers to the distance. `line` is the drawing of all these curves in
/// space. Without a line, is_same_strand() is true everywhere and slack_between() is the least
/// slack. Cost of at(): the drawing's segments in the face and the windows on its sides that are
/// near. The worst case is thousands of points in one face.
class DrawnBand {
 public:
  DrawnBand(PolylineDistance& distance, std::size_t curve, const BandWidth& width)
      : DrawnBand(distance, std::vector<BandCurve>{{curve, width}}) {}
  DrawnBand(PolylineDistance& distance, const std::vector<BandCurve>& curves,
            const DrawnLine* line = nullptr);

  [[nodiscard]] BandPlace at(const FaceCoordinates& point, PlanePoint direction) const;
  [[nodiscard]] BandPlace at(const SurfacePoint& point) const;
  /// Whether a place belongs to the strand of the drawing at `drawn`, a place on the line: the
  /// drawing from `drawn` to the nearest point stays within a wall's distance. Otherwise another
  /// strand is nearer.
  [[nodiscard]] bool is_same_strand(const BandPlace& place, double drawn) const;
  /// Whether a straight line between two places on the line cuts off a part of the drawing that is
  /// farther from the straight line than 0.8 of the walls' distance.
  [[nodiscard]] bool chord_cuts_off(double from, double to) const;
  /// The least slack anywhere along the curve, and the largest.
  [[nodiscard]] double least_slack() const;
  [[nodiscard]] double largest_slack() const;
  /// The least slack between two places on the line, the second ahead of the first.
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
    /// The slack and its derivative by arc length.
    [[nodiscard]] std::pair<double, double> slack_at(double arc) const;
    [[nodiscard]] double least_between(double from, double to) const;
    [[nodiscard]] double wall_for(double slack) const {
      return std::min(width.wall_in_slacks * slack, width.largest_wall);
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
