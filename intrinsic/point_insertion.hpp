// Making vertices of points on edges and in faces, and edges of the straight segments between them.
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "talweg/intrinsic/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface_point.hpp"

namespace talweg {

/// Inserts points of the surface into a triangulation without pending flips. New lengths are
/// measured in the surface's own metric, inside one face each, so insertion never accumulates
/// errors. Points closer than 1e-10 of a face to a vertex or edge fall on it.
class PointInsertion {
 public:
  /// The triangulation must outlive this object and have no inserted vertices yet.
  explicit PointInsertion(SignpostTriangulation& triangulation) : triangulation_(&triangulation) {}

  /// The vertex at the point; inserts it if there is none. O(pieces of the face).
  VertexId insert(const SurfacePoint& point);

  /// Appends to `path` the halfedges of the straight segment between two vertices which lie in a
  /// common face of the surface; where it crosses an edge inside the face, a vertex is inserted.
  /// Throws Error(kBadCurve) when the vertices have no face in common.
  void connect(VertexId from, VertexId to, std::vector<HalfedgeId>& path);

 private:
  struct Place {
    HalfedgeId side;  ///< of the piece that contains the point
    std::array<double, 3> weight{};
  };

  std::vector<HalfedgeId>& pieces(FaceId face);
  std::array<double, 3> barycentric(VertexId v, FaceId face) const;
  Place locate(FaceId face, const std::array<double, 3>& point);
  double distance(VertexId v, FaceId face, const std::array<double, 3>& point) const;
  VertexId insert_on_side(HalfedgeId side, double t, const SurfacePoint* exact = nullptr);
  void replace_pieces(FaceId face, HalfedgeId old, std::span<const HalfedgeId> fresh);
  HalfedgeId step(VertexId from, VertexId to, FaceId face);

  SignpostTriangulation* triangulation_;
  std::unordered_map<FaceId, std::vector<HalfedgeId>> pieces_;  // looked up only, never iterated
};

}  // namespace talweg
