// The corridor is a potential that is 0 within the uncertainty of the drawing, and steep beyond.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// φ = L (a τ max(0, δ − ε) / L)², a = 10, with the exact distance δ to the drawing. For closed
/// curves the potential is the vector φ (cos θ, sin θ). θ runs from 0 to 2πk along the drawn loop
/// and is taken at the nearest point of the loop. A loop that slides along a level set of δ then
/// has to walk around a circle of radius φ, so sliding inwards gains it nothing. ε may vary along
/// the drawing; the value at the nearest point of the drawing counts.
class Corridor {
 public:
  /// The corridor's parameters for one of the curves.
  struct Valley {
    bool closed = false;
    double slack = 0;   ///< ε, mesh units, >= 0
    double length = 1;  ///< L, mesh units, > 0
    int turns = 1;      ///< k, >= 0; 0 switches the phase of a closed curve off
    /// For an open curve that is part of a loop: the loop's length and the arc length on the loop
    /// where the part begins, mesh units. The loop length of other curves is 0.
    double loop_length = 0, arc_start = 0;
    double apart = HUGE_VAL;  ///< half of the gap to the nearest other curve, mesh units
    /// Unless empty, replaces `slack`: ε at each point of the curve, mesh units, >= 0, linear in
    /// the arc length between points, also from the last to the first point of a closed curve.
    std::vector<double> slack_at;
    bool slack_from_options = false;  ///< whether the options set this slack
    double slack_before_gaps = 0;     ///< mesh units: the slack before nearby curves narrowed it

    friend bool operator==(const Valley&, const Valley&) = default;
  };
  /// `distance` has its curves set; there is one valley per curve. tau is in [0, infinity). Throws
  /// Error(kBadUsage) naming the curve and the point when slack_at does not fit its curve or has a
  /// value that is negative or not finite.
  Corridor(PolylineDistance& distance, double tau, const std::vector<Valley>& valleys)
      : Corridor(distance, std::vector<double>(valleys.size(), tau), valleys) {}
  /// The same with a tau for each valley.
  Corridor(PolylineDistance& distance, const std::vector<double>& taus,
           const std::vector<Valley>& valleys);

  /// Checks the slack values of a curve with this number of points; throws as the constructor does.
  static void check_slack(const std::vector<double>& values, std::size_t curve, std::size_t points);

  /// φ at a point of the surface whose nearest point on the curves is `nearest`.
  [[nodiscard]] std::array<double, 2> lifted(const PolylineDistance::Nearest& nearest) const;
  std::array<double, 2> at(const SurfacePoint& point) const;
  std::array<double, 2> at_vertex(VertexId v) const;
  /// Like at_vertex() where δ is at most `exact`. Farther out, δ is replaced by the length of a
  /// path along edges, which is not less. The replacement avoids a wide band of exact distances
  /// around walls that no curve climbs. The value is exact, too, where `exactly` is true for the
  /// nearest curve.
  std::array<double, 2> at_vertex_bounded(VertexId v, double exact,
                                          const std::vector<bool>& exactly) const;
  /// An upper bound on the relative lengthening of any edge of at least this length whose ends are
  /// no farther from the drawing than `distance`. O(curves); asks for no distance.
  [[nodiscard]] double largest_lengthening(double distance, double length) const;

 private:
  /// One curve's valley, with its constants computed.
  struct Profile {
    double slack = 0;
    double steepness = 0;              // (a τ)² / L
    double phase_per_arc = 0;          // 2πk / length of a closed curve
    double phase = 0;                  // θ where the curve begins
    std::vector<double> arcs, slacks;  // if slack_at is given, else empty
  };
  /// A value and its derivative by arc length.
  struct Varying {
    double value = 0;
    double slope = 0;
  };
  void set_field(Profile& profile, const Valley& valley, std::size_t curve) const;
  [[nodiscard]] static Varying slack(const Profile& profile, double arc);

  PolylineDistance* distance_;
  std::vector<Profile> profiles_;  // per curve
  double least_slack_ = HUGE_VAL;
};

}  // namespace talweg
