// The distance to polylines along the surface is exact, and computed only as far out as queries
// need.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/convex_stretch.hpp"
#include "talweg/intrinsic/exact_distance/curve_components.hpp"
#include "talweg/intrinsic/exact_distance/edge_path_distances.hpp"
#include "talweg/intrinsic/exact_distance/face_paths.hpp"
#include "talweg/intrinsic/exact_distance/known_faces.hpp"
#include "talweg/intrinsic/exact_distance/nearest_on_curve.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/exact_distance/window_front.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The length of the shortest path along the surface to the nearest of a set of curves. The
/// distance is exact (up to rounding) on the polyhedral surface and for the curves' straight
/// segments. The method, and alternatives that were tried: docs/development/distance.md.
///
/// Windows (see EdgeWindow) spread from the curve in the order of their distance (WindowFront); a
/// query lets them spread until its answer is final. Answers do not depend on which queries were
/// made before, not even in the last bit. Memory is allocated once per object; set() and queries
/// cost only the elements that they touch. One thread at a time. The surface must outlive the
/// object.
class PolylineDistance {
 public:
  /// O(vertices + edges), memory only.
  explicit PolylineDistance(const Surface& surface);

  /// Sets the curves to measure from. O(points of the curves + elements touched since the last
  /// set()). A curve may be a single point. Throws Error(kBadCurve) naming the curve and the point
  /// when a curve has no points or two neighbours have no common face; then no curves are set.
  void set(std::span<const SurfaceCurve> curves) { set(curves, WindowFront::Room{}); }
  /// Like set(), but with a limited number of windows per curve point and per edge. Once the limit
  /// is reached, distances farther out are only upper bounds: see exact_within().
  void set_with_few_windows(std::span<const SurfaceCurve> curves);

  /// Sets the poller that is called while windows spread; null for none. With a poller, set() and
  /// every query may throw Cancelled. Then set() leaves no curves set, and an interrupted query
  /// leaves the object as if the query had not been made. See ScopedPoller.
  void set_poller(ProgressPoller* poller) { front_.work().set_poller(poller); }

  using Nearest = NearestOnCurve;
  Nearest at_vertex(VertexId v);
  /// Like at_vertex() where the distance is at most `exact` (mesh units, >= 0). Farther out the
  /// result follows the shortest path along edges to a vertex within `exact`: an upper bound that
  /// needs no exact distances beyond `exact`.
  Nearest at_vertex_bounded(VertexId v, double exact);
  Nearest at(const SurfacePoint& point);
  /// t in [0, 1] from the tail to the head of halfedge_of(edge).
  Nearest on_edge(EdgeId edge, double t);

  /// The distance inside a face at b (barycentrics, in the order of Surface::corners()) and its
  /// derivative along a direction of the plane in which corner 0 of the face is the origin, corner
  /// 1 lies on the positive x axis and corner 2 above it (as in FaceFrame).
  struct FaceValue {
    double value = 0;
    double slope = 0;         ///< derivative of the value along the direction
    std::uint32_t curve = 0;  ///< as in Nearest
    double arc_length = 0;    ///< as in Nearest
    double arc_slope = 0;
  };
  using Barycentric = std::array<double, 3>;
  FaceValue at_face(FaceId face, const Barycentric& b, PlanePoint direction);

  /// The distance if it is less than `limit`, otherwise infinite; computes no distances beyond
  /// `limit`.
  double below(double limit, const SurfacePoint& point);

  /// The parts of an edge that are not farther than `limit`: stretches from the tail of
  /// halfedge_of(edge), mesh units, in order. Computes no distances beyond `limit`. O(windows of
  /// the edge).
  std::vector<Stretch> within(EdgeId edge, double limit);
  /// The ways into a face, final for distances up to `limit`; larger distances are upper bounds.
  /// Valid until the next call of any member function.
  const FacePaths& paths_into(FaceId face, double limit);

  /// Computes all distances below `distance`; queries do this by themselves.
  void reach(double distance) {
    while (!front_.is_final(distance)) front_.march();
  }

  /// The length of a curve, mesh units, including the last segment of a closed curve.
  [[nodiscard]] double curve_length(std::size_t curve) const { return pieces_.lengths[curve]; }
  /// Arc length at every point of the curve as it was set, not decreasing.
  [[nodiscard]] std::span<const double> point_arcs(std::size_t curve) const {
    return pieces_.arcs[curve];
  }
  /// The distance below which all distances are already known.
  [[nodiscard]] double front() const { return front_.distance(); }
  /// The limit (mesh units) up to which distances are exact. Larger distances are upper bounds,
  /// lengths of paths along the surface. Infinite unless set_with_few_windows() has reached its
  /// limit of windows.
  [[nodiscard]] double exact_within() const { return front_.exact_within(); }
  /// The number of windows made since set(), which measures the cost.
  [[nodiscard]] std::size_t window_count() const { return front_.windows().size(); }

 private:
  void set(std::span<const SurfaceCurve> curves, const WindowFront::Room& room);
  void forget(double step, const WindowFront::Room& room);
  [[nodiscard]] Nearest finish(Nearest nearest) const;
  [[nodiscard]] bool is_final_at(VertexId beside, double distance);
  [[nodiscard]] VertexId vertex_beside(const SurfacePoint& point) const;
  double known_at(const SurfacePoint& point);
  const FacePaths& final_paths(FaceId face, const Barycentric& b, FacePaths::Hit& hit);

  const Surface* surface_;
  PolylinePieces pieces_;
  WindowFront front_;
  CurveComponents components_;
  KnownFaces faces_;
  EdgePathDistances edge_path_distances_;
};

/// Sets a distance's poller during a scope.
class ScopedPoller {
 public:
  ScopedPoller(PolylineDistance& distance, ProgressPoller& poller) : distance_(distance) {
    distance_.set_poller(&poller);
  }
  ~ScopedPoller() { distance_.set_poller(nullptr); }
  ScopedPoller(const ScopedPoller&) = delete;
  ScopedPoller& operator=(const ScopedPoller&) = delete;

 private:
  PolylineDistance& distance_;
};

}  // namespace talweg
