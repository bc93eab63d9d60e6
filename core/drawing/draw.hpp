// Drawing by clicks makes a curve and the way-points that a result passes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "talweg/core/drawing/way_point.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A curve and which of its points are meant exactly, ready for CurveSmoother::set_curve().
struct Drawing {
  SurfaceCurve curve;
  std::vector<WayPoint> way_points;
};

struct DrawOptions {
  bool closed = false;  ///< leads back to the first click
  /// Straight over the faces, or along edges where all clicks are vertices. By default straight
  /// between way-points, which say nothing of the way, and along edges in a stroke.
  std::optional<bool> straight;
  /// Mesh units, >= 0: how far from each click a result may pass. Without a value the clicks are no
  /// way-points, and the whole path is a stroke.
  std::optional<double> tolerance = 0;
};

/// Draws through clicked points in their order: straight over the faces, where legs may cross, or
/// along edges, where it never passes itself. Clicks are settled first (straight_lines.hpp).
/// Throws Error(kBadCurve) for less than two points, or where the next cannot be reached,
/// Error(kBadUsage) for a negative tolerance, and Cancelled. O(vertices) for memory, and a way of
/// EdgeDijkstra or StraightLines to each click.
Drawing draw(const Surface& surface, std::span<const SurfacePoint> clicks,
             const DrawOptions& options = {}, const Progress& progress = {});
Drawing draw(const Surface& surface, std::span<const VertexId> clicks,
             const DrawOptions& options = {}, const Progress& progress = {});

}  // namespace talweg
