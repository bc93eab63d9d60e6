// A signpost triangulation is an intrinsic triangulation with flips: edges have lengths and
// signposts, and an undo log keeps the flips.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"
#include "talweg/intrinsic/surface/zeroed_memory.hpp"

namespace talweg {

/// An intrinsic triangulation of a surface (Sharp, Soliman & Crane 2019): a Δ-complex on the
/// surface's vertices and inserted ones, in which each edge has a length and each halfedge a
/// direction at its tail.
///
/// Arrays are allocated once, in O(mesh); every later operation costs only the elements that it
/// touches. Lengths are taken from the metric, and directions around a vertex are computed, when
/// first needed. A flip first computes the directions at all four corners of its diamond, so a lazy
/// run and a run that has prepared everything agree bit for bit. Flips are logged and can be
/// undone.
///
/// Not thread safe: one triangulation per thread. The surface must outlive the triangulation.
class SignpostTriangulation {
 public:
  explicit SignpostTriangulation(const Surface& surface);

  /// The length of an edge between two vertices, from its length on the surface.
  using Metric = std::function<double(VertexId tail, VertexId head, double surface_length)>;
  /// Forgets all lengths and signposts and uses `metric` from now on (the surface's own lengths if
  /// `metric` is empty). O(1). No flip may be pending.
  void set_metric(Metric metric);
  /// Computes all lengths and directions at once; results stay the same. O(mesh).
  void prepare_all();

  [[nodiscard]] const Surface& surface() const { return *surface_; }
  [[nodiscard]] std::size_t vertex_count() const { return vertex_halfedge_.size(); }
  [[nodiscard]] std::size_t edge_count() const { return halfedges_.size() / 2; }

  // Connectivity, as in Surface.
  [[nodiscard]] HalfedgeId next(HalfedgeId h) const { return halfedges_[h.index()].next; }
  [[nodiscard]] HalfedgeId prev(HalfedgeId h) const { return next(next(h)); }
  [[nodiscard]] VertexId tail(HalfedgeId h) const { return halfedges_[h.index()].tail; }
  [[nodiscard]] VertexId head(HalfedgeId h) const { return tail(twin(h)); }
  [[nodiscard]] bool has_face(HalfedgeId h) const { return next(h).valid(); }
  [[nodiscard]] bool on_boundary(EdgeId e) const {
    return !has_face(halfedge_of(e)) || !has_face(twin(halfedge_of(e)));
  }
  [[nodiscard]] bool on_boundary(VertexId v) const {
    return vertex_halfedge_[v.index()].valid() && !has_face(twin(vertex_halfedge_[v.index()]));
  }
  [[nodiscard]] HalfedgeId halfedge(VertexId v) const { return vertex_halfedge_[v.index()]; }
  [[nodiscard]] HalfedgeId turn_ccw(HalfedgeId h) const { return twin(prev(h)); }
  [[nodiscard]] HalfedgeId turn_cw(HalfedgeId h) const { return next(twin(h)); }
  /// A halfedge from a to b; invalid if there is none. O(degree of a).
  [[nodiscard]] HalfedgeId find_halfedge(VertexId a, VertexId b) const;

  double length(EdgeId e);
  double length(HalfedgeId h) { return length(edge_of(h)); }
  /// The angle at the tail of h inside the face of h (h must have one).
  double corner_angle(HalfedgeId h);
  /// The angle swept counterclockwise about the common tail from one outgoing halfedge to another,
  /// in [0, cone angle]; +infinity if the sweep would leave the surface; 0 if they are the same.
  double angle_ccw(HalfedgeId from, HalfedgeId to);
  /// The sum of the corner angles at a vertex.
  double cone_angle(VertexId v);

  /// Replaces the edge by the other diagonal of its two faces. Returns false and changes nothing if
  /// there are no two different faces or their diamond is not strictly convex. The new length has a
  /// relative error of a few ulp of the diamond's perimeter.
  bool flip(EdgeId e);
  [[nodiscard]] std::size_t flip_count() const { return log_.size(); }
  /// The edge of the newest flip that has not been undone.
  [[nodiscard]] EdgeId last_flipped() const { return log_.back().edge; }
  /// Restores connectivity, length and directions, bit for bit.
  void undo_flip();
  /// Switches signposts and log off, for flips that are neither undone nor traced.
  void flip_without_trace() { keep_trace_ = false; }

  // Inserted vertices (point_insertion.hpp places them). No flip may be pending. Lengths and
  // directions computed so far are forgotten.
  /// Splits the edge of h (which must have a face) at distance `from_tail` from its tail; `to_left`
  /// and `to_right` are the distances to the opposite corners. Returns the new vertex, which
  /// becomes the head of h.
  struct EdgeSplit {
    double from_tail = 0, to_head = 0, to_left = 0, to_right = 0;
  };
  VertexId split_edge(HalfedgeId h, const EdgeSplit& lengths, const SurfacePoint& location);
  /// Splits the face of h; the distances go to the tails of h, next(h) and prev(h).
  VertexId split_face(HalfedgeId h, const std::array<double, 3>& lengths,
                      const SurfacePoint& location);
  /// Replaces an edge inside a face of the surface by the other diagonal of its two faces, which
  /// must be convex, until remove_inserted(). The change is not logged, so it is neither undone nor
  /// traced.
  void flip_unlogged(EdgeId e, double length);
  /// Removes every inserted vertex; the metric is then the surface's own again. O(inserted).
  void remove_inserted();
  [[nodiscard]] std::size_t inserted_count() const {
    return vertex_count() - surface_->vertex_count();
  }
  /// The point of the surface where a vertex lies.
  [[nodiscard]] SurfacePoint location(VertexId v) const;
  /// The face of the surface that contains a face of the triangulation without flips.
  [[nodiscard]] FaceId surface_face(HalfedgeId h) const { return halfedges_[h.index()].face; }
  /// The length of an edge of the triangulation without flips, in the surface's own metric.
  [[nodiscard]] double surface_length(EdgeId e) const { return surface_length_[e.index()]; }

  /// Vertices whose directions have been computed since set_metric().
  [[nodiscard]] std::span<const VertexId> touched() const { return touched_; }

 private:
  struct Flip {
    EdgeId edge;
    double length = 0;
    double direction[2] = {0, 0};
    bool represented[2] = {false, false};  // at tail and head: was the halfedge halfedge(v)?
  };

  void forget();
  void touch(VertexId v);
  double swept(HalfedgeId from, HalfedgeId to);
  double wrapped(double angle, VertexId v) const;
  void rotate_ccw(HalfedgeId h);
  void rotate_cw(HalfedgeId h);
  HalfedgeId new_edge(VertexId tail, VertexId head, double length);
  VertexId new_vertex(const SurfacePoint& location);
  void make_face(HalfedgeId a, HalfedgeId b, HalfedgeId c, FaceId surface_face);
  void note_change(HalfedgeId h) { changed_.push_back(h); }

  const Surface* surface_;
  std::vector<Surface::Halfedge> halfedges_;
  std::vector<HalfedgeId> vertex_halfedge_;
  std::vector<double> surface_length_;
  Metric metric_;

  std::uint32_t epoch_ = 1;  // an entry is valid if its epoch equals the current one
  ZeroedVector<std::uint32_t> edge_epoch_;
  ZeroedVector<std::uint32_t> vertex_epoch_;
  ZeroedVector<double> length_;
  ZeroedVector<double> direction_;
  ZeroedVector<double> cone_;
  std::vector<VertexId> touched_;

  bool keep_trace_ = true;
  std::vector<Flip> log_;
  std::vector<SurfacePoint> inserted_;
  std::vector<HalfedgeId> changed_;  // halfedges of the surface that insertion changed
};

}  // namespace talweg
