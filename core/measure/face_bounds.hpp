// Face bounds are upper bounds of the distance from a piece of a curve to other curves, found
// within the piece's face.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"

namespace talweg {

/// A point of a segment, and its distance to the other curves.
struct SegmentSample {
  double t = 0;         ///< on the segment, in [0, 1]
  double distance = 0;  ///< mesh units
};

/// Upper bounds of the distance between two samples, tighter than the bound from slope 1. Every
/// bound is a convex function along the segment, so its values at the two samples bound the
/// distance between. by_pieces() is O(pieces of the other curves in the face), so n segments and n
/// pieces in one face cost O(n²); less_by_sides() makes one query of the distance per side.
class FaceBounds {
 public:
  /// `pieces` are the pieces of the curves that `to` is set to.
  FaceBounds(const Surface& surface, PolylineDistance& to, const PolylinePieces& pieces)
      : surface_(&surface), to_(&to), pieces_(&pieces) {}

  /// The bound by distances to the pieces of the other curves in the same face.
  [[nodiscard]] double by_pieces(const CurveSegment& s, const SegmentSample& a,
                                 const SegmentSample& b) const {
    const SideFrame frame = side_frame(*surface_, s.face, 0);
    const PlanePoint p = frame.at(s.at(a.t), 0), q = frame.at(s.at(b.t), 0);
    double best = std::numeric_limits<double>::infinity();
    for (const PolylinePiece& piece : pieces_->segments_in(s.face)) {
      const PlanePoint from = frame.at(piece.from, 0), to = frame.at(piece.to, 0);
      best = std::min(best, std::max(to_segment(p, from, to), to_segment(q, from, to)));
    }
    return best;
  }

  /// Whether a bound through a side of the face is at most `enough`: for each sample, its height
  /// over the side plus the distance from its foot on the side to a piece in the face beyond. By
  /// rounding, the points of a stroke along an edge lie on both sides of the edge, so two curves
  /// along one edge may have no common face.
  [[nodiscard]] bool less_across_a_side(const CurveSegment& s, const SegmentSample& a,
                                        const SegmentSample& b, double enough) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const SideFrame frame = side_frame(*surface_, s.face, k);
      const PlanePoint p = frame.at(s.at(a.t), k), q = frame.at(s.at(b.t), k);
      const auto is_beside = [&](PlanePoint x) {
        return x.y < enough && x.x >= 0 && x.x <= frame.length;
      };
      if (is_beside(p) && is_beside(q) && less_across(frame, p, q, enough)) return true;
    }
    return false;
  }

  /// Whether the bound through a point on a side of the face is less than `enough`. One point to
  /// the left and one to the right of the segment are tried: the points where the shortest way
  /// probably enters the face. The slope of the distance gives the angle at which this way meets
  /// the segment. Distances beyond `enough` are not computed, because the sides of large faces may
  /// be far away.
  bool less_by_sides(const CurveSegment& s, const SegmentSample& a, const SegmentSample& b,
                     double enough) {
    if (less_by_sides_in(s, a, b, enough)) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (s.from[k] == 0 && s.to[k] == 0 && less_by_other_face(s, k, a, b, enough)) return true;
    }
    return false;
  }

 private:
  /// The distance of a point is at most its height over the side plus the distance of its foot to a
  /// piece in the face across the side; both are convex along the segment.
  [[nodiscard]] bool less_across(const SideFrame& frame, PlanePoint p, PlanePoint q,
                                 double enough) const {
    if (!surface_->has_face(twin(frame.side))) return false;
    const FaceId face = surface_->face(twin(frame.side));
    std::size_t k = 0;
    SideFrame across = side_frame(*surface_, face, k);
    while (across.side != twin(frame.side)) across = side_frame(*surface_, face, ++k);
    const PlanePoint p_foot{frame.length - p.x, 0}, q_foot{frame.length - q.x, 0};
    const auto pieces = pieces_->segments_in(face);
    return std::any_of(pieces.begin(), pieces.end(), [&](const PolylinePiece& piece) {
      const PlanePoint from = across.at(piece.from, k), to = across.at(piece.to, k);
      return std::max(p.y + to_segment(p_foot, from, to), q.y + to_segment(q_foot, from, to)) <=
             enough;
    });
  }

  /// less_by_sides() in the face across the side opposite to corner k, for a segment on this side.
  bool less_by_other_face(const CurveSegment& s, std::size_t k, const SegmentSample& a,
                          const SegmentSample& b, double enough) {
    const HalfedgeId side = side_frame(*surface_, s.face, (k + 1) % 3).side;
    if (!surface_->has_face(twin(side))) return false;
    const FaceId face = surface_->face(twin(side));
    return less_by_sides_in(
        segment_between(*surface_, s.point(*surface_, 0), s.point(*surface_, 1), face), a, b,
        enough);
  }

  bool less_by_sides_in(const CurveSegment& s, const SegmentSample& a, const SegmentSample& b,
                        double enough) {
    const SideFrame frame = side_frame(*surface_, s.face, 0);
    if (!(frame.length > 0 && frame.apex.y > 0)) return false;
    const PlanePoint p = frame.at(s.at(a.t), 0), q = frame.at(s.at(b.t), 0);
    const double length = distance_of(p, q);
    if (!(length > 0)) return false;
    const double slope = std::clamp((b.distance - a.distance) / length, -1.0, 1.0);
    const double across = std::sqrt(1 - slope * slope);
    const double ex = (q.x - p.x) / length, ey = (q.y - p.y) / length;
    for (const double side : {-across, across}) {
      const PlanePoint back{-slope * ex - side * ey, -slope * ey + side * ex};
      std::array<double, 3> c = s.at((a.t + b.t) / 2);
      // A point that is near compared with the interval gives no better bound than slope 1.
      if (!(walk_to_side(frame, back, c) > length / 4)) continue;
      const PlanePoint corner = frame.at(c, 0);
      const double limit = enough - std::max(distance_of(p, corner), distance_of(q, corner));
      if (!(limit > 0)) continue;
      const SurfacePoint on_side = SurfacePoint::from_barycentric(*surface_, s.face, c);
      if (std::isfinite(to_->below(limit, on_side))) return true;
    }
    return false;
  }

  /// Moves c in a direction to the boundary of the face; returns the distance moved, mesh units.
  static double walk_to_side(const SideFrame& frame, PlanePoint direction,
                             std::array<double, 3>& c) {
    const double up = direction.y / frame.apex.y;
    const double along = (direction.x - up * frame.apex.x) / frame.length;
    const std::array<double, 3> change{-along - up, along, up};
    double way = std::numeric_limits<double>::infinity();
    std::size_t reached = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(change[k] < 0) || c[k] / -change[k] >= way) continue;
      way = c[k] / -change[k];
      reached = k;
    }
    if (!std::isfinite(way)) return 0;
    for (std::size_t k = 0; k < 3; ++k) c[k] = std::max(0.0, c[k] + way * change[k]);
    c[reached] = 0;
    const double sum = c[0] + c[1] + c[2];
    for (double& x : c) x /= sum;
    return way;
  }

  const Surface* surface_;
  static double distance_of(PlanePoint p, PlanePoint q) { return std::hypot(q.x - p.x, q.y - p.y); }

  static double to_segment(PlanePoint x, PlanePoint p, PlanePoint q) {
    const double dx = q.x - p.x, dy = q.y - p.y, squared = dx * dx + dy * dy;
    const double t = squared > 0 ? ((x.x - p.x) * dx + (x.y - p.y) * dy) / squared : 0;
    const double clamped = std::clamp(t, 0.0, 1.0);
    return distance_of(x, {p.x + clamped * dx, p.y + clamped * dy});
  }

  PolylineDistance* to_;
  const PolylinePieces* pieces_;
};

}  // namespace talweg
