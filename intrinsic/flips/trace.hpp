// Tracing leads from intrinsic edges back to points on the surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct TraceResult {
  std::vector<SurfaceCurve> curves;  ///< one per path, in their order
  /// Crossings whose straight line missed their edge by rounding; they were put at the edge's end.
  std::size_t clamped = 0;
};

/// Traces paths by undoing the pending flips, newest first.
///
/// At first a path runs along edges. When the flip of an edge is undone, a passage that ran along
/// the edge crosses the restored edge. For other passages through the diamond, the sides of entry
/// and exit decide whether they cross the restored edge. The sequence of edges that a path crosses
/// is therefore found without arithmetic and cannot be wrong, at little cost, as the flips must be
/// undone anyway. Positions are computed by unfolding the crossed triangles into the plane.
///
/// Memory for the edges is allocated once per object; a call costs O(flips + crossings).
class Tracer {
 public:
  explicit Tracer(SignpostTriangulation& triangulation) : triangulation_(&triangulation) {}

  /// Undoes every pending flip. Each point of a curve and the next lie in one face of the surface;
  /// inserted vertices of a path keep the point they were inserted for. Throws Cancelled when
  /// `progress` (stage "trace") returns false, and any exception of the metric; flips may then
  /// still be pending.
  TraceResult trace_and_undo(std::span<const EdgePath> paths, const Progress& progress = {});

 private:
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xFFFFFFFFU;

  struct Crossing {  // the strand leaves the face of `through` by this halfedge
    HalfedgeId through;
    Index strand = kNone;
    Index prev = kNone, next = kNone;  // along the strand
    Index next_on_edge = kNone;
  };
  struct Strand {  // one segment of a path
    VertexId from, to;
    HalfedgeId along;  // valid while the strand runs along an edge
    Index first = kNone, last = kNone;
    Index next_along = kNone;
  };
  enum class Place : std::uint8_t { kA, kB, kC, kD };  // corner or half of a diamond
  struct Visit {
    Index strand;
    Index before, after;  // the crossings before and after the visit; kNone at an end
    Place from, to;
  };

  void collect(EdgeId e, std::vector<Visit>& visits);
  void collect_entering(HalfedgeId side, Place half, Place opposite, HalfedgeId diagonal,
                        std::vector<Visit>& visits);
  Index insert(Index strand, Index before, Index after, HalfedgeId through);
  void undo_one();
  TraceResult trace(std::span<const EdgePath> paths, const Progress& progress);
  void forget();
  void emit(const Strand& strand, SurfaceCurve& curve, std::size_t& clamped);
  SurfacePoint point_on(HalfedgeId h, double t) const;

  SignpostTriangulation* triangulation_;
  std::vector<Index> crossings_on_;  // heads of lists, by edge
  std::vector<Index> strands_on_;
  std::vector<Crossing> crossings_;
  std::vector<Strand> strands_;
  std::vector<Visit> visits_;
};

}  // namespace talweg
