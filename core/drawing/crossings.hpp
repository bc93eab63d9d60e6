// Crossings are where curves pass through themselves or each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// How paths along the edges of one triangulation meet themselves and each other.
struct PathContacts {
  /// Per path: how often it crosses itself or a later path.
  std::vector<std::size_t> crossings;
  /// Per path: whether it passes a vertex twice or crosses another path.
  std::vector<bool> tangled;
};

/// Where two paths run along the same edges for a while, that counts as one crossing or none. A
/// path that ends on another does not cross it. O(n) for n passages of all vertices, times the ways
/// in which one vertex is passed; passages that have an edge in common, but not the one before, are
/// compared pair by pair.
PathContacts path_contacts(const SignpostTriangulation& triangulation,
                           std::span<const EdgePath> paths);

/// The curves (ascending indices) of which two segments, of the same or of different curves, cross
/// inside a face. Touching does not count. O(segments log segments); more only where many long
/// segments share one face. Throws Error(kBadCurve) when a segment lies in no face.
std::vector<std::size_t> crossing_curves(const Surface& surface,
                                         std::span<const SurfaceCurve> curves);

/// The points of one of these curves at which a segment begins that crosses another segment, of the
/// same or of another curve, as for crossing_curves().
std::vector<SurfacePoint> crossed_points(const Surface& surface,
                                         std::span<const SurfaceCurve> curves, std::size_t curve);

}  // namespace talweg
