// PolylineDistance: inside faces.
#include <algorithm>
#include <cmath>
#include <limits>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

double length_of(double dx, double dy) { return std::sqrt(dx * dx + dy * dy); }

/// The fraction of the segment from p to q at its point nearest to x, in [0, 1].
double nearest_part(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double dx = q.x - p.x, dy = q.y - p.y, length = length_of(dx, dy);
  if (!(length > 0)) return 0;
  return std::clamp(((x.x - p.x) * (dx / length) + (x.y - p.y) * (dy / length)) / length, 0.0, 1.0);
}

/// How a shortest way arrives at a point in the plane.
struct Arrival {
  PlanePoint direction;      // unit direction of the way there; 0 at the source
  PlanePoint arc_direction;  // gradient of the arc length
};

Arrival from_point(double dx, double dy) {
  const double r = length_of(dx, dy);
  if (!(r > 0)) return {};
  return {{dx / r, dy / r}, {}};
}

/// Uses the frame of the window's edge, turned so that the face is above.
Arrival from_window(const EdgeWindow& w, double x, double rise, bool own) {
  const double turn = own ? 1 : -1;
  double bend = 0;
  if (w.bends_towards(x, rise, bend)) return from_point(turn * (x - bend), rise);
  if (w.from_point()) return from_point(turn * (x - w.px), rise + std::abs(w.py));
  return {{turn * w.px, turn * w.py}, {turn * w.sense * w.py, -turn * w.sense * w.px}};
}

Arrival from_piece(PlanePoint x, PlanePoint p, PlanePoint q) {
  const double part = nearest_part(x, p, q);
  const PlanePoint foot{p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
  Arrival arrival = from_point(x.x - foot.x, x.y - foot.y);
  if (part > 0 && part < 1) {
    const double length = length_of(q.x - p.x, q.y - p.y);
    arrival.arc_direction = {(q.x - p.x) / length, (q.y - p.y) / length};
  }
  return arrival;
}

}  // namespace

/// Offers ways through the windows of the sides, which are at least as long as at the windows'
/// lowest point.
void PolylineDistance::offer_windows(const FaceCopy& copy, const Corners& at, FaceHit& best) const {
  const LedIn* const first = led_in_.data() + copy.first;
  for (const LedIn& in : std::span(first, copy.count)) {
    if (in.lowest > best.nearest.distance) continue;
    const PlanePoint p = at[in.side];
    Nearest nearest{0, in.window.curve, 0};
    nearest.distance = in.own ? in.window.value_beyond(p.x, p.y, nearest.arc_length)
                              : in.window.value_beyond(copy.frames[in.side].length - p.x, -p.y,
                                                       nearest.arc_length);
    if (is_nearer(nearest, best.nearest)) best = {nearest, in.side, &in};
  }
}

/// Offers ways from the curves' segments in the face itself, in the frame of side 0.
void PolylineDistance::offer_pieces(const FaceCopy& copy, PlanePoint at, FaceHit& best) const {
  const SideFrame& frame = copy.frames[0];
  for (const PolylinePiece& piece : copy.pieces) {
    const PlanePoint p = frame.at(piece.from, 0), q = frame.at(piece.to, 0);
    const double part = nearest_part(at, p, q), dx = q.x - p.x, dy = q.y - p.y;
    const Nearest nearest{length_of(at.x - (p.x + part * dx), at.y - (p.y + part * dy)),
                          piece.curve, piece.arc + part * length_of(dx, dy)};
    if (is_nearer(nearest, best.nearest)) best = {nearest, 0, nullptr, &piece};
  }
}

PolylineDistance::FaceHit PolylineDistance::hit_in(const FaceCopy& copy,
                                                   const Barycentric& b) const {
  FaceHit best{{kUnreached, 0, 0}};
  Corners at;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlanePoint p = at[k] = copy.frames[k].at(b, k);
    const Nearest& corner = copy.corners[k];
    if (corner.distance > best.nearest.distance) continue;
    const Nearest nearest = farther(corner, std::sqrt(p.x * p.x + p.y * p.y));
    if (is_nearer(nearest, best.nearest)) best = {nearest, k};
  }
  offer_windows(copy, at, best);
  offer_pieces(copy, at[0], best);
  if (best.nearest.distance <= kRounding * copy.longest) best.nearest.distance = 0;
  return best;
}

void PolylineDistance::copy_face(FaceId face) {
  std::uint32_t& id = face_copy_of_[face.index()];
  if (id == kNone) {
    id = static_cast<std::uint32_t>(face_copies_.size());
    face_copies_.emplace_back().face = face;
  }
  FaceCopy& copy = face_copies_[id];
  copy.front = queue_.front();
  into_one_face_.clear();
  copy.pieces = pieces_.segments_in(face);
  HalfedgeId h = surface_->halfedge(face);
  for (std::uint32_t k = 0; k < 3; ++k, h = surface_->next(h)) {
    copy.frames[k] = side_frame(*surface_, face, k);
    copy.corners[k] = vertex_[surface_->tail(h).index()];
    copy.longest = std::max(copy.longest, copy.frames[k].length);
    const EdgeId edge = edge_of(h);
    windows_.each(edge, [&](const EdgeWindow& w) {
      if (w.into == h) into_one_face_.push_back({w, w.lowest(), k, h == halfedge_of(edge)});
    });
  }
  store(copy, led_in_, into_one_face_);
}

/// A copy of the face as it is now.
const PolylineDistance::FaceCopy& PolylineDistance::fresh_copy(FaceId face) {
  const std::uint32_t& id = face_copy_of_[face.index()];
  if (id == kNone || face_copies_[id].front != queue_.front()) copy_face(face);
  return face_copies_[id];
}

/// A copy of the face that is final for the answer at b.
const PolylineDistance::FaceCopy& PolylineDistance::final_copy(FaceId face, const Barycentric& b,
                                                               FaceHit& hit) {
  if (face_copy_of_[face.index()] == kNone) copy_face(face);
  for (;;) {
    const FaceCopy& copy = face_copies_[face_copy_of_[face.index()]];
    hit = hit_in(copy, b);
    if (hit.nearest.distance + queue_.step() / 64 < copy.front) return copy;
    if (copy.front == queue_.front()) {
      const VertexId corner = surface_->tail(surface_->halfedge(face));
      if (queue_.empty() || marches_in_vain(corner)) return copy;
      march();
    }
    copy_face(face);
  }
}

PolylineDistance::Nearest PolylineDistance::in_face(FaceId face, const Barycentric& b) {
  FaceHit hit;
  final_copy(face, b, hit);
  return finish(hit.nearest);
}

PolylineDistance::FaceValue PolylineDistance::at_face(FaceId face, const Barycentric& b,
                                                      PlanePoint direction) {
  FaceHit hit;
  const FaceCopy& copy = final_copy(face, b, hit);
  const Nearest nearest = finish(hit.nearest);
  FaceValue result{nearest.distance, 0, nearest.curve, nearest.arc_length, 0};
  if (std::isinf(nearest.distance)) return result;
  const SideFrame& frame = copy.frames[hit.side];
  const PlanePoint p = frame.at(b, hit.side);
  const Arrival way =
      hit.window != nullptr
          ? from_window(hit.window->window, hit.window->own ? p.x : frame.length - p.x, p.y,
                        hit.window->own)
      : hit.piece != nullptr
          ? from_piece(p, frame.at(hit.piece->from, 0), frame.at(hit.piece->to, 0))
          : from_point(p.x, p.y);
  const PlanePoint step = frame.at(copy.frames[0].rates(direction), hit.side);
  result.slope = dot(way.direction, step);
  result.arc_slope = dot(way.arc_direction, step);
  return result;
}

}  // namespace talweg
