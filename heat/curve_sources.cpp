#include "talweg/heat/curve_sources.hpp"

#include <algorithm>
#include <string>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Sources = std::vector<WeightedVertex>;

void add(Sources& sources, const Surface& surface, const FaceCoordinates& point, double weight) {
  const auto corners = surface.corners(point.face);
  for (std::size_t k = 0; k < 3; ++k) {
    sources.push_back({corners[k], weight * point.barycentric[k]});
  }
}

/// Adds ∫ λ ds over a segment inside one face. λ is linear there, so the integral is the mean of λ
/// at the two ends times the length.
void add_segment(Sources& sources, const Surface& surface, const SurfaceCurve& curve,
                 std::size_t from, std::size_t to) {
  const SurfacePoint &p = curve.points[from], &q = curve.points[to];
  if (p == q) return;
  const FaceId face = common_face(surface, p, q);
  if (!face.valid()) {
    throw Error(ErrorCode::kBadCurve, "Points " + std::to_string(from) + " and " +
                                          std::to_string(to) +
                                          " of the curve have no face in common.");
  }
  const FaceCoordinates in_p = coordinates_in(surface, p, face);
  const FaceCoordinates in_q = coordinates_in(surface, q, face);
  const double half = distance_in_face(surface, in_p, in_q) / 2;
  add(sources, surface, in_p, half);
  add(sources, surface, in_q, half);
}

void add_point(Sources& sources, const Surface& surface, const SurfacePoint& point) {
  if (const auto* at = std::get_if<AtVertex>(&point.where())) {
    sources.push_back({at->vertex, 1.0});
    return;
  }
  const FaceId face = any_face(surface, point);
  add(sources, surface, coordinates_in(surface, point, face), 1.0);
}

/// One entry per vertex, in the order of vertices; zero weights dropped.
Sources merged(Sources sources) {
  std::stable_sort(sources.begin(), sources.end(),
                   [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
  Sources result;
  for (const WeightedVertex& source : sources) {
    if (!(source.weight > 0)) continue;
    if (!result.empty() && result.back().vertex == source.vertex) {
      result.back().weight += source.weight;
    } else {
      result.push_back(source);
    }
  }
  return result;
}

}  // namespace

std::vector<WeightedVertex> curve_sources(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t count = curve.points.size();
  if (count == 0) throw Error(ErrorCode::kBadCurve, "The curve has no points.");
  Sources sources;
  for (std::size_t i = 0; i + 1 < count; ++i) add_segment(sources, surface, curve, i, i + 1);
  if (curve.closed && count > 2) add_segment(sources, surface, curve, count - 1, 0);
  sources = merged(std::move(sources));
  if (!sources.empty()) return sources;
  for (const SurfacePoint& point : curve.points) add_point(sources, surface, point);
  return merged(std::move(sources));
}

}  // namespace talweg
