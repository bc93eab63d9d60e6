#include "talweg/core/drawing/draw.hpp"

#include <algorithm>
#include <cmath>

#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

SurfaceCurve along_edges(const Surface& surface, std::span<const SurfacePoint> clicks, bool closed,
                         const Progress& progress) {
  std::vector<VertexId> through;
  for (const SurfacePoint& click : clicks) {
    through.push_back(std::get<AtVertex>(click.where()).vertex);
  }
  SurfaceCurve curve{closed, {}};
  EdgeDijkstra dijkstra(surface);
  for (const VertexId v : dijkstra.draw(through, closed, progress)) {
    curve.points.push_back(SurfacePoint::at_vertex(surface, v));
  }
  return curve;
}

}  // namespace

Drawing draw(const Surface& surface, std::span<const SurfacePoint> given,
             const DrawOptions& options, const Progress& progress) {
  std::vector<SurfacePoint> clicks;
  clicks.reserve(given.size());
  for (const SurfacePoint& click : given) clicks.push_back(settled(surface, click));
  if (clicks.size() < 2) throw Error(ErrorCode::kBadCurve, "A curve needs at least two points.");
  if (options.tolerance && !(*options.tolerance >= 0 && std::isfinite(*options.tolerance))) {
    throw Error(ErrorCode::kBadUsage, "tolerance must be finite and >= 0.");
  }
  const bool straight = options.straight.value_or(options.tolerance.has_value());
  const bool edges = !straight && std::all_of(clicks.begin(), clicks.end(),
                                              [](const auto& p) { return p.is_vertex(); });
  Drawing drawing;
  drawing.curve = edges ? along_edges(surface, clicks, options.closed, progress)
                        : StraightLines(surface).join(clicks, options.closed, progress);
  if (!options.tolerance) return drawing;
  PointLookup known;
  for (const SurfacePoint& click : clicks) {
    if (known.contains(click)) continue;
    known.add(click);
    drawing.way_points.push_back({click, *options.tolerance});
  }
  return drawing;
}

Drawing draw(const Surface& surface, std::span<const VertexId> clicks, const DrawOptions& options,
             const Progress& progress) {
  std::vector<SurfacePoint> points;
  points.reserve(clicks.size());
  for (const VertexId v : clicks) points.push_back(SurfacePoint::at_vertex(surface, v));
  return draw(surface, points, options, progress);
}

}  // namespace talweg
