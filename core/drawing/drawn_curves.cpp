#include "talweg/core/drawing/drawn_curves.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "talweg/core/drawing/capping.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

bool along_vertices(const SurfaceCurve& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(),
                     [](const SurfacePoint& p) { return p.is_vertex(); });
}

}  // namespace

SurfaceCurve capped_curve(const Surface& surface, const SurfaceCurve& curve,
                          std::span<const SurfacePoint> pins) {
  if (!along_vertices(curve)) return curve;
  std::vector<VertexId> path, pinned;
  for (const SurfacePoint& p : curve.points) path.push_back(std::get<AtVertex>(p.where()).vertex);
  std::vector<VertexId> sorted = path;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return curve;
  for (const SurfacePoint& p : pins) {
    if (p.is_vertex()) pinned.push_back(std::get<AtVertex>(p.where()).vertex);
  }
  cap_corners(surface, path, curve.closed, pinned);
  SurfaceCurve capped{curve.closed, {}};
  for (const VertexId v : path) capped.points.push_back(SurfacePoint::at_vertex(surface, v));
  return capped;
}

void check_pins(std::span<const SurfaceCurve> curves, std::span<const SurfacePoint> pins,
                std::string_view name) {
  if (pins.empty()) return;
  PointLookup passed;
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) passed.add(point);
  }
  for (std::size_t i = 0; i < pins.size(); ++i) {
    if (passed.contains(pins[i])) continue;
    const auto* v = std::get_if<AtVertex>(&pins[i].where());
    throw Error(ErrorCode::kBadUsage,
                fmt::format("The {} {} is not a point of the curve.", name,
                            v != nullptr ? fmt::format("at vertex {}", v->vertex.index())
                                         : fmt::format("number {}", i + 1)));
  }
}

std::vector<WeightedVertex> sources_of(const Surface& surface,
                                       std::span<const SurfaceCurve> curves) {
  std::vector<WeightedVertex> sources;
  for (const SurfaceCurve& curve : curves) {
    const std::vector<WeightedVertex> more = curve_sources(surface, curve);
    sources.insert(sources.end(), more.begin(), more.end());
  }
  std::stable_sort(sources.begin(), sources.end(),
                   [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
  std::size_t kept = 0;
  for (const WeightedVertex& source : sources) {
    if (kept > 0 && sources[kept - 1].vertex == source.vertex) {
      sources[kept - 1].weight += source.weight;
    } else {
      sources[kept++] = source;
    }
  }
  sources.resize(kept);
  return sources;
}

}  // namespace talweg
