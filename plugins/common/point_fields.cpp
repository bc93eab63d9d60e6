#include "point_fields.hpp"

#include "talweg/core/measures.hpp"
#include "talweg/intrinsic/polyline_distance.hpp"

namespace talweg::plugins {

PointField deviation_field(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                           const SurfaceCurve& result) {
  PolylineDistance distance(mesh.surface());
  distance.set(std::span(&drawn, 1));
  PointField field{"deviation", "mesh units", {}};
  for (const SurfacePoint& point : result.points) {
    field.values.push_back(distance.at(point).distance);
  }
  return field;
}

PointField curvature_field(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  PointField field{"curvature", "radians", std::vector<double>(n, 0.0)};
  for (std::size_t k = 0; k < n; ++k) {
    if (!curve.closed && (k == 0 || k + 1 == n)) continue;
    field.values[k] = turning_angle(mesh.surface(), curve.points[(k + n - 1) % n], curve.points[k],
                                    curve.points[(k + 1) % n]);
  }
  return field;
}

std::vector<double> exact_distance_field(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         const plugin::Services& services) {
  constexpr std::size_t kEvery = 1024;
  PolylineDistance distance(surface);
  distance.set(curves);
  const std::size_t n = surface.vertex_count();
  std::vector<double> values;
  values.reserve(n);
  for (std::size_t v = 0; v < n; ++v) {
    if (v % kEvery == 0 &&
        !services.go_on("distance", static_cast<double>(v) / static_cast<double>(n))) {
      throw plugin::Services::cancelled();
    }
    values.push_back(distance.at_vertex(VertexId{v}).distance);
  }
  return values;
}

}  // namespace talweg::plugins
