// Drawing straight over the surface from point to point.
#pragma once

#include <memory>
#include <span>

#include "talweg/core/drawing.hpp"
#include "talweg/intrinsic/flip_out.hpp"
#include "talweg/intrinsic/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface_point.hpp"
#include "talweg/intrinsic/trace.hpp"

namespace talweg {

/// Joins surface points by straight lines (geodesics). Memory is made once per object, when points
/// that share no face first ask for it; a call costs what its lines touch. The surface must outlive
/// the object. One thread at a time.
class StraightLines {
 public:
  explicit StraightLines(const Surface& surface);

  /// A curve through the points, in order. Two points of a common face are joined inside it; others
  /// by the geodesic that FlipOut finds from a shortest edge path between them, which is locally,
  /// not always globally, shortest. Points that fall together are taken once.
  /// Throws Error(kBadCurve) when two points lie on different components, or fewer than two (three
  /// if closed) different ones are left.
  SurfaceCurve join(std::span<const SurfacePoint> points, bool closed);

 private:
  void append_leg(const SurfacePoint& from, const SurfacePoint& to,
                  std::vector<SurfacePoint>& points);
  [[nodiscard]] VertexId nearest_corner(const SurfacePoint& point) const;

  /// O(mesh), and needed only where two points share no face.
  struct Workshop {
    explicit Workshop(const Surface& surface);
    SignpostTriangulation triangulation;
    FlipOut flip_out;
    Tracer tracer;
    EdgeDijkstra dijkstra;
  };

  const Surface* surface_;
  std::unique_ptr<Workshop> workshop_;
};

}  // namespace talweg
