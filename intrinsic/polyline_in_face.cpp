// PolylineDistance: inside faces.
#include <algorithm>
#include <cmath>
#include <limits>

#include "talweg/intrinsic/polyline_distance.hpp"

namespace talweg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How far along the segment from p to q the point nearest to x is, in [0, 1].
double nearest_part(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double dx = q.x - p.x, dy = q.y - p.y, length = std::hypot(dx, dy);
  if (!(length > 0)) return 0;
  return std::clamp(((x.x - p.x) * (dx / length) + (x.y - p.y) * (dy / length)) / length, 0.0, 1.0);
}

/// How a shortest way arrives at a point in the plane.
struct Arrival {
  PlanePoint direction;      // of the way there, of length 1; 0 at the source
  double bend = 0;           // 1 / distance to the point that it comes from; 0: from a segment
  PlanePoint arc_direction;  // gradient of the arc length
};

Arrival from_point(double dx, double dy) {
  const double r = std::hypot(dx, dy);
  if (!(r > 0)) return {};
  return {{dx / r, dy / r}, 1 / r, {}};
}

/// In the frame of the window's edge turned so that the face is above.
Arrival from_window(const EdgeWindow& w, double x, double rise, bool own) {
  const double turn = own ? 1 : -1;
  double bend = 0;
  if (w.bends_towards(x, rise, bend)) return from_point(turn * (x - bend), rise);
  if (w.from_point()) return from_point(turn * (x - w.px), rise + std::abs(w.py));
  return {{turn * w.px, turn * w.py}, 0, {turn * w.sense * w.py, -turn * w.sense * w.px}};
}

Arrival from_piece(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double part = nearest_part(x, p, q);
  const PlanePoint foot{p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
  Arrival arrival = from_point(x.x - foot.x, x.y - foot.y);
  if (part > 0 && part < 1) {
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    arrival.bend = 0;
    arrival.arc_direction = {(q.x - p.x) / length, (q.y - p.y) / length};
  }
  return arrival;
}

double dot(PlanePoint a, PlanePoint b) { return a.x * b.x + a.y * b.y; }

}  // namespace

/// Through the windows of one side.
void PolylineDistance::offer_windows(FaceId face, const Barycentric& b, std::size_t side,
                                     HalfedgeId h, FaceHit& best) const {
  const EdgeId edge = edge_of(h);
  const bool own = h == halfedge_of(edge);
  PlanePoint p{0, -1};
  for (std::uint32_t i = first_window_[edge.index()]; i != kNone; i = windows_[i].next) {
    const EdgeWindow& w = windows_[i];
    if (w.into != h) continue;
    if (p.y < 0) {  // not laid out yet; most sides have no window that leads in
      const SideFrame frame = side_frame(*surface_, face, side);
      p = frame.at(b, side);
      if (!own) p.x = frame.length - p.x;
    }
    Nearest nearest{0, w.curve, 0};
    nearest.distance = w.value_beyond(p.x, own ? p.y : -p.y, nearest.arc_length);
    if (is_nearer(nearest, best.nearest)) best = {nearest, side, &w};
  }
}

PolylineDistance::FaceHit PolylineDistance::hit_in_face(FaceId face, const Barycentric& b) const {
  FaceHit best{{kInfinity, 0, 0}};
  double longest = 0;
  HalfedgeId h = surface_->halfedge(face);
  for (std::size_t k = 0; k < 3; ++k, h = surface_->next(h)) {
    longest = std::max(longest, surface_->length(edge_of(h)));
    offer_windows(face, b, k, h, best);
  }
  for (std::size_t k = 0; k < 3; ++k, h = surface_->next(h)) {
    const Nearest& corner = vertex_[surface_->tail(h).index()];
    if (corner.distance > best.nearest.distance) continue;
    const PlanePoint p = side_frame(*surface_, face, k).at(b, k);
    const Nearest nearest = farther(corner, std::sqrt(p.x * p.x + p.y * p.y));
    if (is_nearer(nearest, best.nearest)) best = {nearest, k};
  }
  const auto pieces = pieces_.segments_in(face);
  if (pieces.empty()) {
    if (best.nearest.distance <= kRounding * longest) best.nearest.distance = 0;
    return best;
  }
  const SideFrame frame = side_frame(*surface_, face, 0);
  for (const PolylinePiece& piece : pieces) {
    const PlanePoint x = frame.at(b, 0), p = frame.at(piece.from, 0), q = frame.at(piece.to, 0);
    const double part = nearest_part(x, p, q), dx = q.x - p.x, dy = q.y - p.y;
    const Nearest nearest{std::hypot(x.x - (p.x + part * dx), x.y - (p.y + part * dy)), piece.curve,
                          piece.arc + part * std::hypot(dx, dy)};
    if (is_nearer(nearest, best.nearest)) best = {nearest, 0, nullptr, &piece};
  }
  if (best.nearest.distance <= kRounding * longest) best.nearest.distance = 0;
  return best;
}

PolylineDistance::FaceHit PolylineDistance::final_hit(FaceId face, const Barycentric& b) {
  const VertexId corner = surface_->tail(surface_->halfedge(face));
  for (;;) {
    const FaceHit hit = hit_in_face(face, b);
    if (is_final(hit.nearest.distance) || marches_in_vain(corner)) return hit;
    march();
  }
}

PolylineDistance::FaceValue PolylineDistance::at_face(FaceId face, const Barycentric& b,
                                                      const std::array<Barycentric, 2>& d) {
  const FaceHit hit = final_hit(face, b);
  const Nearest nearest = finish(hit.nearest);
  FaceValue result{nearest.distance, {}, {}, nearest.curve, nearest.arc_length, {}};
  if (std::isinf(nearest.distance)) return result;
  const SideFrame frame = side_frame(*surface_, face, hit.side);
  const PlanePoint p = frame.at(b, hit.side);
  const bool own = frame.side == halfedge_of(edge_of(frame.side));
  const Arrival way = hit.window != nullptr
                          ? from_window(*hit.window, own ? p.x : frame.length - p.x, p.y, own)
                      : hit.piece != nullptr
                          ? from_piece(p, frame.at(hit.piece->from, 0), frame.at(hit.piece->to, 0))
                          : from_point(p.x, p.y);
  const std::array<PlanePoint, 2> step{frame.at(d[0], hit.side), frame.at(d[1], hit.side)};
  for (std::size_t i = 0; i < 2; ++i) {
    result.first[i] = dot(way.direction, step[i]);
    result.arc_first[i] = dot(way.arc_direction, step[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i / 2, k = (i + 1) / 2;
    result.second[i] = way.bend * (dot(step[j], step[k]) - result.first[j] * result.first[k]);
  }
  return result;
}

}  // namespace talweg
