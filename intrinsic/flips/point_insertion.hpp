// Point insertion adds points on edges and in faces as vertices, and the segments between points as
// edges.
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "talweg/intrinsic/flips/flat_flips.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Inserts points of the surface into a triangulation without pending flips. New lengths are
/// measured in the surface's own metric, inside one face each, so insertion never accumulates
/// errors. Points closer than 1e-10 of a face to a vertex or edge are moved onto it.
class PointInsertion {
 public:
  /// The triangulation must outlive this object and have no inserted vertices yet.
  explicit PointInsertion(SignpostTriangulation& triangulation)
      : triangulation_(&triangulation),
        flips_(triangulation, [this](HalfedgeId h) { before_flip(h); }) {}
  PointInsertion(const PointInsertion&) = delete;
  PointInsertion& operator=(const PointInsertion&) = delete;

  /// The vertex at the point; inserts one if there is none. The vertex lies in every face that
  /// contains the point. O(pieces of the face). A face of more than 64 pieces keeps them Delaunay,
  /// and a point near the previous one then costs only a few pieces.
  VertexId insert(const SurfacePoint& point);

  /// Appends to `path` the halfedges of the straight segment between two vertices that lie in a
  /// common face of the surface. A vertex is inserted where the segment crosses an edge inside the
  /// face. In a face of more than 64 pieces, the crossed edge is flipped instead, unless another
  /// segment runs along it. If rounding prevents both (in slivers among many points), the path
  /// follows the shortest way along the edges inside the face. Throws Error(kBadCurve) when the
  /// vertices have no face in common.
  void connect(VertexId from, VertexId to, std::vector<HalfedgeId>& path);

  /// The number of edges split so far.
  [[nodiscard]] std::size_t split_count() const { return split_count_; }
  /// Updates a path that was connected when split_count() was `since`: every edge that was split
  /// later is replaced by its two halves.
  [[nodiscard]] std::vector<HalfedgeId> with_splits(std::span<const HalfedgeId> path,
                                                    std::size_t since) const;

 private:
  /// A face with more pieces keeps them Delaunay, because needles cost most where many meet. In
  /// faces with fewer pieces no edge is flipped.
  static constexpr std::size_t kMostUnflippedPieces = 64;

  struct Place {
    HalfedgeId side;  ///< of the piece that contains the point
    std::array<double, 3> weight{};
  };

  std::vector<HalfedgeId>& pieces(FaceId face);
  std::array<double, 3> barycentric(VertexId v, FaceId face) const;
  [[nodiscard]] Place place_in(HalfedgeId side, FaceId face,
                               const std::array<double, 3>& point) const;
  Place walk(FaceId face, const std::array<double, 3>& point);
  Place locate(FaceId face, const std::array<double, 3>& point);
  VertexId nearest_vertex(FaceId face, const std::array<double, 3>& point);
  double distance(VertexId v, FaceId face, const std::array<double, 3>& point) const;
  VertexId insert_on_edge(const SurfacePoint& point);
  VertexId insert_on_side(HalfedgeId side, double t, const SurfacePoint* exact = nullptr);
  void replace_pieces(FaceId face, HalfedgeId old, std::span<const HalfedgeId> fresh);
  VertexId insert_new(const SurfacePoint& point);
  void improve_around(VertexId v);
  void before_flip(HalfedgeId h);
  HalfedgeId clear_segment(HalfedgeId h, VertexId to, FaceId face);
  HalfedgeId step(VertexId from, VertexId to, FaceId face, bool may_flip = true);
  void go_along_edges(VertexId from, VertexId to, FaceId face, std::vector<HalfedgeId>& path);
  void append_with_splits(HalfedgeId h, std::size_t since, std::vector<HalfedgeId>& path) const;

  SignpostTriangulation* triangulation_;
  struct Split {  // the two halves of the edge, in the direction of `first`
    std::size_t number = 0;
    HalfedgeId first, second;
  };
  // These maps are only looked up, never iterated. A piece is identified by one of its sides, and
  // by that side's place in the list of its face.
  std::unordered_map<FaceId, std::vector<HalfedgeId>> pieces_;
  std::unordered_map<HalfedgeId, std::size_t> slot_;
  std::unordered_map<EdgeId, std::vector<Split>> splits_;
  std::size_t split_count_ = 0;
  std::unordered_set<FaceId> crowded_;
  FlatFlips flips_;
};

}  // namespace talweg
