// Drawing through clicks makes a curve, and way-points that its smoothed curve must pass.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "talweg/core/drawing/way_point.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A curve, and those of its points that are meant exactly; ready for CurveSmoother::set_curve().
struct Drawing {
  SurfaceCurve curve;
  std::vector<WayPoint> way_points;
};

struct DrawOptions {
  bool closed = false;  ///< leads back to the first click
  /// True: straight over the faces. False: along edges if all clicks are vertices, else straight.
  /// Default: true if `tolerance` has a value (clicks leave the course between them open).
  std::optional<bool> straight;
  /// Mesh units, >= 0: how far from each click a result may pass. Without a value the clicks are
  /// not way-points, and the whole path is a stroke.
  std::optional<double> tolerance = 0;
};

/// Draws through clicked points in their order: straight over the faces, where legs may cross, or
/// along edges, where the path never crosses itself. Clicks are settled first (straight_lines.hpp).
/// Throws Error(kBadCurve) for fewer than two points, or where the next point cannot be reached;
/// Error(kBadUsage) for a negative tolerance; and Cancelled. O(vertices) memory, and a run of
/// EdgeDijkstra or StraightLines for each click.
Drawing draw(const Surface& surface, std::span<const SurfacePoint> clicks,
             const DrawOptions& options = {}, const Progress& progress = {});
Drawing draw(const Surface& surface, std::span<const VertexId> clicks,
             const DrawOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
