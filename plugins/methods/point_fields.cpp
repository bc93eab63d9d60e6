#include "point_fields.hpp"

#include <limits>

#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/exact_distance/marched_distance.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg::plugins {
namespace {

constexpr std::size_t kOfValue = 4;  // units of work

/// Does work with a distance, and asks the host now and then whether to go on.
template <class Work>
void asked(PolylineDistance& distance, const plugin::Services& services, const Work& work) {
  try {
    ProgressPoller poller(
        [&](const char* stage, double done) { return services.go_on(stage, done); }, "distance");
    const ScopedPoller scoped(distance, poller);
    work(poller);
  } catch (const Cancelled&) {
    throw plugin::Services::cancelled();
  }
}

/// All vertices: first those beside the curves, then their neighbours, and so on. In this order
/// each distance follows from the answers before it, so that the progress is steady.
std::vector<VertexId> outwards(const Surface& surface, std::span<const SurfaceCurve> curves) {
  std::vector<VertexId> order;
  std::vector<bool> reached(surface.vertex_count(), false);
  const auto reach = [&](VertexId v) {
    if (reached[v.index()]) return;
    reached[v.index()] = true;
    order.push_back(v);
  };
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      for (const VertexId v : surface.corners(any_face(surface, point))) reach(v);
    }
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const FaceId f : faces_at(surface, SurfacePoint::at_vertex(surface, order[k]))) {
      for (const VertexId v : surface.corners(f)) reach(v);
    }
  }
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) reach(VertexId{v});
  return order;
}

}  // namespace

PointField deviation_field(const SurfaceMesh& mesh, const SurfaceCurve& drawn,
                           const SurfaceCurve& result, const plugin::Services& services) {
  PointField field{"deviation", "mesh units", {}};
  PolylineDistance distance(mesh.surface());
  asked(distance, services, [&](ProgressPoller& poller) {
    distance.set(std::span(&drawn, 1));
    for (const SurfacePoint& point : result.points) {
      field.values.push_back(distance.at(point).distance);
      poller.add_work(kOfValue);
    }
  });
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

std::vector<NearestOnCurve> nearest_field(const Surface& surface,
                                          std::span<const SurfaceCurve> curves,
                                          const plugin::Services& services) {
  PolylineDistance distance(surface);
  const std::size_t n = surface.vertex_count();
  std::vector<NearestOnCurve> nearest(n);
  asked(distance, services, [&](ProgressPoller& poller) {
    distance.set(curves);
    std::size_t known = 0;
    for (const VertexId v : outwards(surface, curves)) {
      poller.set_fraction(static_cast<double>(known++) / static_cast<double>(n));
      poller.add_work(kOfValue);
      nearest[v.index()] = distance.at_vertex(v);
    }
  });
  return nearest;
}

std::vector<double> quick_distance_field(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         const plugin::Services& services) {
  constexpr std::size_t kSmall = 100'000, kExact = 20'000;
  if (surface.vertex_count() <= kSmall) return exact_distance_field(surface, curves, services);
  PolylineDistance distance(surface);
  std::vector<double> values(surface.vertex_count(), std::numeric_limits<double>::infinity());
  asked(distance, services, [&](ProgressPoller& poller) {
    distance.set(curves);
    std::size_t known = 0;
    for (const VertexId v : outwards(surface, curves)) {
      if (known == kExact) break;
      poller.set_fraction(0.5 * static_cast<double>(known++) / static_cast<double>(kExact));
      poller.add_work(kOfValue);
      values[v.index()] = distance.at_vertex(v).distance;
    }
    march_distance(surface, values, poller);
  });
  return values;
}

std::vector<double> exact_distance_field(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         const plugin::Services& services) {
  std::vector<double> values;
  for (const NearestOnCurve& nearest : nearest_field(surface, curves, services)) {
    values.push_back(nearest.distance);
  }
  return values;
}

}  // namespace talweg::plugins
