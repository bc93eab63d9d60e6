// Ridge gates are the places of a drawing that a path along ridges must pass exactly or nearby.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/drawing/way_point.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct RidgeGate {
  std::size_t point = 0;  ///< of the curve
  /// Mesh units, >= 0: how far from the point the way may pass. Where it costs something, only on
  /// a ridge: with little cost it is pulled there as a whole, and not half of the way.
  double radius = 0;
  double cost = 0;   ///< of each mesh unit of that distance
  double faint = 0;  ///< mesh units: what a place costs where nothing attracts
  /// Mesh units: what the point itself costs where a ridge passes the gate. More than the ridge
  /// beside it costs at ends of strokes, for which the way would else leave the ridge.
  double leaves_for = 0;
  bool is_click = false;      ///< its way-point goes along
  bool is_on_border = false;  ///< the way passes the mesh's border there
  /// At ends of open curves the unit direction of the drawing, and how far along it the way may
  /// pass the point, mesh units, which costs as much again: it begins and ends beside what was
  /// drawn, neither before nor after it.
  Point along = Point::Zero();
  double thickness = 0;
};

/// The gates of a curve in its order, including the ends of an open curve, and the widths of the
/// corridors between successive gates; for a closed curve also from the last gate to the first.
struct RidgeGates {
  std::vector<RidgeGate> gates;
  std::vector<double> widths;  ///< mesh units
};

struct RidgeBand {
  double width = 0;      ///< mesh units: of strokes, and around clicks and ends
  double leg_part = 0;   ///< the corridor of a leg is at least this part of its length
  double leg_width = 0;  ///< mesh units: and at most as wide as this, or as the band
  double edge = 0;       ///< mesh units: the length of the mesh's edges there
};

/// Way-points and free ends may move within the band, but no more than a third of the way to the
/// next gate. Points of `fixed` stay. A stroke has gates that are free within the band at least
/// every 16 bands. O(points).
RidgeGates ridge_gates(const SurfaceMesh& mesh, const SurfaceCurve& curve, const PointLookup& fixed,
                       std::span<const WayPoint> way_points, std::span<const SurfacePoint> painted,
                       const RidgeBand& band);

}  // namespace talweg
