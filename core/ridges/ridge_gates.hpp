// Ridge gates are the places of a drawing that a path along ridges must pass, exactly or nearby.
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
  std::size_t point = 0;  ///< index of the curve's point
  /// Mesh units, >= 0: the largest distance from the point at which the path may pass. If `cost` is
  /// above 0, the path may leave the point only for a ridge, so it moves all the way onto the ridge
  /// or stays.
  double radius = 0;
  double cost = 0;   ///< of each mesh unit of distance from the point
  double faint = 0;  ///< mesh units: cost of a place without attraction; less with attraction
  /// Mesh units: the cost of passing the point itself, if a ridge passes the gate. At ends of
  /// strokes, this cost exceeds the cost of the ridge beside the point; otherwise the path would
  /// leave the ridge for the point.
  double leaves_for = 0;
  bool is_click = false;      ///< whether the point is a way-point, which moves with the path
  bool is_on_border = false;  ///< whether the path must pass at the mesh's border
  /// At ends of open curves: the unit direction of the drawing, and the largest distance along this
  /// direction, before or after the point, at which the path may pass (mesh units, which are also
  /// its cost). The result therefore begins and ends beside the drawn ends.
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
  double width = 0;  ///< mesh units: of corridors of strokes, and around clicks and ends
  /// The corridor of a leg is `leg_part` of the leg's length wide, but at least `width`, and at
  /// most `leg_width` (mesh units) if this is more than `width`.
  double leg_part = 0, leg_width = 0;
  double edge = 0;  ///< mesh units: length of the mesh's edges near the drawing
};

/// Way-points and free ends may move within the band, but no more than a third of the way to the
/// next gate. Points of `fixed` stay. A stroke has additional gates at least every 16 bands, at
/// which the path may pass anywhere within the band. O(points).
RidgeGates ridge_gates(const SurfaceMesh& mesh, const SurfaceCurve& curve, const PointLookup& fixed,
                       std::span<const WayPoint> way_points, std::span<const SurfacePoint> painted,
                       const RidgeBand& band);

}  // namespace talweg
