#include "talweg/core/measure/coarse_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "talweg/intrinsic/surface/plane_point.hpp"
#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

double apart(PlanePoint p, PlanePoint q) { return std::hypot(q.x - p.x, q.y - p.y); }

double to_piece(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double dx = q.x - p.x, dy = q.y - p.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? ((x.x - p.x) * dx + (x.y - p.y) * dy) / squared : 0;
  const double clamped = std::clamp(t, 0.0, 1.0);
  return apart(x, {p.x + clamped * dx, p.y + clamped * dy});
}

/// The corners of a face in the plane of its frame.
std::array<PlanePoint, 3> corners_of(const SideFrame& frame) {
  return {PlanePoint{0, 0}, PlanePoint{frame.length, 0}, frame.apex};
}

}  // namespace

CoarseDistance::CoarseDistance(const Surface& surface, std::span<const SurfaceCurve> curves)
    : surface_(&surface),
      pieces_(pieces_of(surface, curves)),
      ways_(surface.vertex_count(), HUGE_VAL) {
  for (const PolylinePiece& piece : pieces_.segments) start_at(piece);
  for (const PolylinePiece& piece : pieces_.points) start_at(piece);
}

void CoarseDistance::start_at(const PolylinePiece& piece) {
  if (piece.vertex.valid()) reach(piece.vertex, 0);
  if (!piece.face.valid()) return;
  const SideFrame frame = side_frame(*surface_, piece.face, 0);
  const PlanePoint from = frame.at(piece.from, 0), to = frame.at(piece.to, 0);
  const auto vertices = surface_->corners(piece.face);
  const auto places = corners_of(frame);
  for (std::size_t k = 0; k < 3; ++k) reach(vertices[k], to_piece(places[k], from, to));
}

void CoarseDistance::reach(VertexId vertex, double way) {
  double& known = ways_[vertex.index()];
  if (!(way < known)) return;
  known = way;
  queue_.push({way, vertex});
}

double CoarseDistance::at_vertex(VertexId vertex) {
  const double& known = ways_[vertex.index()];
  while (!queue_.empty() && queue_.top().first < known) {
    const auto [way, at] = queue_.top();
    queue_.pop();
    if (way > ways_[at.index()]) continue;  // a shorter way is known
    for_each_spoke(*surface_, at, [&, before = way](HalfedgeId h) {
      reach(surface_->head(h), before + surface_->length(edge_of(h)));
    });
  }
  return known;
}

CoarseDistance::OnSegment CoarseDistance::on(const CurveSegment& segment) {
  const SideFrame frame = side_frame(*surface_, segment.face, 0);
  const PlanePoint p = frame.at(segment.from, 0), q = frame.at(segment.to, 0);
  OnSegment bound{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  // The length of the way through a fixed place is convex along the segment, so its values at the
  // ends bound it.
  const auto add = [&](double at_first, double at_last) {
    bound.first = std::min(bound.first, at_first);
    bound.last = std::min(bound.last, at_last);
    bound.most = std::min(bound.most, std::max(at_first, at_last));
  };
  const auto vertices = surface_->corners(segment.face);
  const auto places = corners_of(frame);
  for (std::size_t k = 0; k < 3; ++k) {
    const double way = at_vertex(vertices[k]);
    add(way + apart(p, places[k]), way + apart(q, places[k]));
  }
  for (const PolylinePiece& piece : pieces_.segments_in(segment.face)) {
    const PlanePoint from = frame.at(piece.from, 0), to = frame.at(piece.to, 0);
    add(to_piece(p, from, to), to_piece(q, from, to));
  }
  bound.most = std::min(bound.most, (bound.first + bound.last + segment.length) / 2);
  return bound;
}

}  // namespace talweg
