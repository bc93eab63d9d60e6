// The corridor potential: flat as wide as the drawing is uncertain, steep beyond.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "talweg/core/polish.hpp"
#include "talweg/core/surface_mesh.hpp"
#include "talweg/intrinsic/polyline_distance.hpp"
#include "talweg/intrinsic/surface_point.hpp"

namespace talweg {

/// How exact the drawing is: the mean length of its segments, collinear neighbours (turning by less
/// than 0.1 rad) merged; for a closed curve at most 1/24 of its length. Mesh units.
double default_slack(const Surface& surface, std::span<const SurfaceCurve> drawn);

/// The size of what is drawn: the largest distance of its points from their centre of mass (along
/// the curve); for several curves the largest of them. Follows the drawing, not the mesh; a small
/// loop has a small one. Mesh units.
double drawing_radius(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn);

/// φ = L (a τ max(0, δ − ε) / L)², a = 10, with the exact distance δ to the drawing. For closed
/// curves a vector, φ (cos θ, sin θ), where θ runs from 0 to 2πk along the drawn loop and is taken
/// from its nearest point: a loop that slides along a level set of δ has to walk around a circle
/// of radius φ, so it does not slide inwards for nothing. ε may vary along the drawing; then that
/// of the nearest point of the drawing counts.
class Corridor {
 public:
  struct Options {
    double tau = 1;
    double slack = 0;   ///< ε, mesh units, >= 0
    double length = 1;  ///< L, mesh units, > 0
    int turns = 1;      ///< k, >= 0; 0 switches the phase off
    /// Unless empty, ε instead of `slack`: per curve one value per point, mesh units, >= 0; linear
    /// in the arc length between points, also from the last to the first of a closed curve.
    std::vector<std::vector<double>> slack_at;
  };
  /// `distance` has the curves set, `closed` tells which of them are closed.
  /// Throws Error(kBadUsage) naming the curve and the point when slack_at does not fit the curves
  /// or has a value that is negative or not finite.
  Corridor(PolylineDistance& distance, std::vector<bool> closed, const Options& options);

  std::array<double, 2> at(const SurfacePoint& point) const;
  std::array<double, 2> at_vertex(VertexId v) const;
  PotentialOnEdge on_edge(EdgeId e, double t) const;

 private:
  /// ε along one curve.
  struct Field {
    std::vector<double> arcs, values;
  };
  /// A value and its derivative by arc length.
  struct Varying {
    double value = 0;
    double slope = 0;
  };
  void set_field(const std::vector<std::vector<double>>& slack_at);
  [[nodiscard]] Varying slack(std::uint32_t curve, double arc) const;
  [[nodiscard]] double phase_per_arc(std::uint32_t curve) const;
  [[nodiscard]] std::array<double, 2> lifted(const PolylineDistance::Nearest& nearest) const;

  PolylineDistance* distance_;
  std::vector<bool> closed_;
  double slack_;
  std::vector<Field> field_;  // per curve; empty: slack_ everywhere
  double steepness_;          // (a τ)² / L
  int turns_;
};

}  // namespace talweg
