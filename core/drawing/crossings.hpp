// Crossings are places where curves pass through themselves or each other.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// How paths along the edges of one triangulation cross themselves and each other.
struct PathContacts {
  /// Per path: how often it crosses itself or a later path.
  std::vector<std::size_t> crossings;
  /// Per path: whether it passes a vertex twice or crosses another path.
  std::vector<bool> tangled;
};

/// A stretch of edges that two paths have in common counts as one crossing or none. A path that
/// ends on another path does not cross it. O(n) for n passages of all vertices, times the number of
/// different ways in which one vertex is passed. Passages that share an edge after the vertex, but
/// not the edge before it, are compared pair by pair.
PathContacts path_contacts(const SignpostTriangulation& triangulation,
                           std::span<const EdgePath> paths);

/// The curves (ascending indices) of which two segments, of the same or of different curves, cross
/// inside a face. Touching does not count. O(segments log segments); more only where many long
/// segments share one face. Throws Error(kBadCurve) when a segment lies in no face.
std::vector<std::size_t> crossing_curves(const Surface& surface,
                                         std::span<const SurfaceCurve> curves);

/// A segment of a curve in a face.
struct FaceSegment {
  std::size_t curve = 0, number = 0;
  std::array<double, 3> from{}, to{};  ///< barycentrics
};

/// The segments of curves, listed by face, for finding the crossings of one curve while curves
/// change. The surface must outlive the object.
class CurvesByFace {
 public:
  /// O(segments). Throws Error(kBadCurve) when a segment lies in no face, as all methods do.
  CurvesByFace(const Surface& surface, std::span<const SurfaceCurve> curves);

  /// Puts a curve in the place of curve `number`. O(segments of both curves, and all segments in
  /// the faces of the replaced curve).
  void replace(std::size_t number, const SurfaceCurve& curve);
  /// The points of `curve` at which a segment begins that crosses another segment of `curve`, or a
  /// segment of a listed curve other than `number`. Crossing is meant as in crossing_curves().
  /// O(segments of the curve, and all segments in their faces).
  [[nodiscard]] std::vector<SurfacePoint> crossed_points(std::size_t number,
                                                         const SurfaceCurve& curve) const;

 private:
  using Faces = std::unordered_map<FaceId, std::vector<FaceSegment>>;
  [[nodiscard]] Faces faces_of(std::size_t number, const SurfaceCurve& curve) const;
  void add(std::size_t number, const SurfaceCurve& curve);

  const Surface* surface_;
  Faces faces_;
  std::vector<std::vector<FaceId>> passed_;  // per curve
};

}  // namespace talweg
