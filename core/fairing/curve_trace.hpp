// A curve trace is a curve as straight pieces of faces, and the halfedges crossed between them.
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
  double arc = 0;             ///< mesh units along the curve, where the piece begins
  std::uint32_t crossed = 0;  ///< where its crossings begin: those between it and the next piece
};

struct CurveTrace {
  bool closed = false;
  double length = 0;  ///< mesh units
  std::vector<TracePiece> pieces;
  FaceStrip crossed;
  std::vector<std::size_t> fixed;  ///< pieces, ascending, that begin at points that must stay
  std::vector<SurfacePoint> fixed_points;  ///< these points; the first and the last are the ends
  std::vector<bool> corners;  ///< of these, whether it may turn freely there; empty if nowhere
  /// Unless empty: the place on the drawing (DrawnLine) of each piece's start, not decreasing, and
  /// of the end.
  std::vector<double> drawn;

  /// Appends a piece, with no crossings before it since the last.
  void add(const CurveSegment& segment);
  /// Lets the curve turn freely at those of its fixed points that are among these.
  void set_corners(std::span<const SurfacePoint> points);
  /// Says that it is the drawing itself.
  void set_drawn();
  /// The place on the drawing of a point of a piece; mesh units. Only where `drawn` is given.
  [[nodiscard]] double drawn_at(std::size_t piece, double arc) const;
  /// Of the stretches between points that must stay, mesh units; for a loop the last one leads to
  /// the first of these. One without such points is one stretch.
  [[nodiscard]] std::vector<double> stretch_lengths() const;
  /// The number of the piece at this arc length.
  [[nodiscard]] std::size_t piece_at(double arc) const;
  [[nodiscard]] FaceCoordinates point(std::size_t piece, double arc) const;
};

/// At a vertex the curve passes over the fewer edges. Points of `fixed` that it passes must stay;
/// ends of open curves do anyway. Throws Error(kBadCurve) where two neighbours have no common face.
/// O(points).
CurveTrace trace_of(const Surface& surface, const SurfaceCurve& curve,
                    std::span<const SurfacePoint> fixed = {});

/// The same for the points with these indices, ascending. The ends of open curves may be among
/// them.
CurveTrace trace_through(const Surface& surface, const SurfaceCurve& curve,
                         std::span<const std::size_t> fixed);

/// The halfedge of the face whose tail is the vertex, which is a corner of the face.
HalfedgeId outgoing(const Surface& surface, FaceId face, VertexId v);

/// Around a vertex from one face to another, counterclockwise (left) or clockwise; empty where they
/// are one, or the boundary is in the way.
FaceStrip faces_around(const Surface& surface, FaceId from, FaceId to, VertexId v, bool left);

/// Appends what is crossed on the way from one face to another at a point that both contain.
void cross_at(const Surface& surface, const SurfacePoint& point, FaceId from, FaceId to,
              FaceStrip& crossed);

}  // namespace talweg
