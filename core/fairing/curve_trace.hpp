// A curve trace is a curve as straight pieces in faces, and the halfedges crossed between the
// pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/intrinsic/lines/strip_line.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

struct TracePiece : CurveSegment {
  double arc = 0;             ///< arc length at the start of the piece, mesh units
  std::uint32_t crossed = 0;  ///< index of the first crossing after the piece
};

struct CurveTrace {
  bool closed = false;
  double length = 0;  ///< mesh units
  std::vector<TracePiece> pieces;
  FaceStrip crossed;
  std::vector<std::size_t> fixed;  ///< pieces, ascending, that begin at points that must stay
  std::vector<SurfacePoint> fixed_points;  ///< these points, and both ends of an open curve
  std::vector<bool> corners;  ///< per fixed point: whether its turn is free; empty for none
  /// Unless empty: the place on the drawing (DrawnLine) of each piece's start, not decreasing, and
  /// of the end.
  std::vector<double> drawn;

  /// Appends a piece. Halfedges that are later appended to `crossed` lie between this piece and the
  /// next.
  void add(const CurveSegment& segment);
  /// Lets the curve turn freely at its fixed points that are among `points`.
  void set_corners(std::span<const SurfacePoint> points);
  /// Sets `drawn` for a curve that is the drawing itself.
  void set_drawn();
  /// The place on the drawing of a point of a piece; mesh units. `drawn` must not be empty.
  [[nodiscard]] double drawn_at(std::size_t piece, double arc) const;
  /// The lengths of the stretches between fixed points, mesh units. The last stretch of a loop
  /// leads to its first fixed point. A loop without fixed points is one stretch.
  [[nodiscard]] std::vector<double> stretch_lengths() const;
  /// The number of the piece at this arc length.
  [[nodiscard]] std::size_t piece_at(double arc) const;
  [[nodiscard]] FaceCoordinates point(std::size_t piece, double arc) const;
};

/// The trace of a curve. At a vertex the trace passes on the side with fewer edges. Points of the
/// curve that are among `fixed` must stay; the ends of open curves stay anyway. Throws
/// Error(kBadCurve) where two neighbours have no common face. O(points).
CurveTrace trace_of(const Surface& surface, const SurfaceCurve& curve,
                    std::span<const SurfacePoint> fixed = {});

/// The same with the indices of the fixed points, ascending. The ends of open curves may be among
/// these.
CurveTrace trace_through(const Surface& surface, const SurfaceCurve& curve,
                         std::span<const std::size_t> fixed);

/// The halfedge of the face whose tail is the vertex, which is a corner of the face.
HalfedgeId outgoing(const Surface& surface, FaceId face, VertexId v);

/// The strip around a vertex from one face to another, counterclockwise (left) or clockwise; empty
/// if both faces are the same or the boundary is in between.
FaceStrip faces_around(const Surface& surface, FaceId from, FaceId to, VertexId v, bool left);

/// Appends the halfedges that are crossed from one face to another at a point of both faces.
void cross_at(const Surface& surface, const SurfacePoint& point, FaceId from, FaceId to,
              FaceStrip& crossed);

}  // namespace talweg
