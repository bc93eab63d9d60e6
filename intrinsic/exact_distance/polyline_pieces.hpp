// Polyline pieces are the points and segments of curves, sorted by the faces that contain them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

/// A face laid out with side k on the x axis, corner k at (0, 0) and the face above.
struct SideFrame {
  HalfedgeId side;
  double length = 0;
  PlanePoint apex;  ///< corner k + 2

  /// The point with these barycentrics (in the order of Surface::corners()). Points of the side
  /// itself have y == 0 exactly.
  [[nodiscard]] PlanePoint at(const std::array<double, 3>& barycentric, std::size_t k) const {
    const double b = barycentric[(k + 1) % 3], c = barycentric[(k + 2) % 3];
    return {b * length + c * apex.x, c * apex.y};
  }
  /// The derivatives of the barycentrics along a direction of this frame, which must be the frame
  /// of side 0. Not finite in a face without area.
  [[nodiscard]] std::array<double, 3> rates(PlanePoint direction) const {
    const double c = direction.y / apex.y, b = (direction.x - c * apex.x) / length;
    return {-b - c, b, c};
  }
};
/// The frame of side k of a face, k in {0, 1, 2}.
SideFrame side_frame(const Surface& surface, FaceId face, std::size_t k);

/// A curve's segment, or one of its points (from == to), in a face.
struct PolylinePiece {
  FaceId face;  ///< invalid for an isolated vertex
  std::uint32_t curve = 0;
  std::array<double, 3> from{};  ///< barycentrics
  std::array<double, 3> to{};
  double arc = 0;   ///< arc length at `from`
  VertexId vertex;  ///< for a point at a vertex
};

struct PolylinePieces {
  std::vector<PolylinePiece> segments;    ///< by face; a segment along an edge is in both faces
  std::vector<PolylinePiece> points;      ///< in the order of the curves; each vertex once
  std::vector<double> lengths;            ///< of the curves
  std::vector<std::vector<double>> arcs;  ///< arc length at every point of every curve

  [[nodiscard]] std::span<const PolylinePiece> segments_in(FaceId face) const;
};

/// Splits curves into pieces. O(points). A point on an edge is in `points` once for each of the
/// edge's faces. Throws Error(kBadCurve) naming curve and point when a curve has no points, a point
/// is not on the surface, or two neighbours have no common face.
PolylinePieces pieces_of(const Surface& surface, std::span<const SurfaceCurve> curves);

}  // namespace talweg
