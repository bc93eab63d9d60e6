#include "talweg/core/drawing/curve_through.hpp"

#include "talweg/core/drawing/curve_embedding.hpp"

namespace talweg {

SurfaceCurve curve_through(const Surface& surface, std::span<const VertexId> vertices) {
  SurfaceCurve curve;
  curve.closed = vertices.size() > 1 && vertices.front() == vertices.back();
  if (curve.closed) vertices = vertices.first(vertices.size() - 1);
  for (const VertexId v : vertices) curve.points.push_back(SurfacePoint::at_vertex(surface, v));
  check_drawn(surface, curve);
  return curve;
}

}  // namespace talweg
