// PolylineDistance: what the curves themselves send to the sides of their faces.
#include <algorithm>
#include <cmath>
#include <limits>

#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg {
namespace {

constexpr double kUpright = 1e-8;  // rad, whose square is below the rounding of a double

}  // namespace

PolylineDistance::PolylineDistance(const Surface& surface)
    : surface_(&surface),
      bends_(surface.vertex_count(), 0),
      vertex_(surface.vertex_count(), Nearest{std::numeric_limits<double>::infinity(), 0, 0}),
      face_copy_of_(surface.face_count(), kNone),
      windows_(surface.edge_count()) {}

void PolylineDistance::forget() {
  for (const VertexId v : touched_vertices_) {
    vertex_[v.index()].distance = std::numeric_limits<double>::infinity();
  }
  for (const FaceCopy& copy : face_copies_) face_copy_of_[copy.face.index()] = kNone;
  face_copies_.clear();
  led_in_.clear();
  touched_vertices_.clear();
  windows_.clear();
  with_curve_.clear();
  edge_ways_from_ = -1;
}

void PolylineDistance::set(std::span<const SurfaceCurve> curves) {
  PolylinePieces pieces = pieces_of(*surface_, curves);
  forget();
  pieces_ = std::move(pieces);
  queue_.reset(step_width());
  try {
    send_pieces();
  } catch (...) {
    forget();
    pieces_ = {};
    queue_.reset(1);
    throw;
  }
}

void PolylineDistance::send_pieces() {
  // Segments go first, because they hide most of the windows that points would send.
  constexpr std::size_t kOfPiece = 8;  // units of work
  const auto begin_piece = [&] {
    tell_work();
    work_ += kOfPiece;
  };
  for (const PolylinePiece& piece : pieces_.segments) {
    begin_piece();
    send_segment(piece);
  }
  for (const PolylinePiece& piece : pieces_.points) {
    begin_piece();
    if (piece.vertex.valid()) {
      send_vertex(piece);
    } else {
      send_point(piece);
    }
  }
}

/// An eighth of the mean side of the curves' faces. The step affects only the amount of superfluous
/// work, not the result.
double PolylineDistance::step_width() const {
  double sum = 0;
  std::size_t count = 0;
  const auto add = [&](HalfedgeId h) {
    sum += surface_->length(edge_of(h));
    ++count;
  };
  const auto add_face = [&](const PolylinePiece& piece) {
    if (piece.face.valid()) {
      const HalfedgeId h = surface_->halfedge(piece.face);
      for (const HalfedgeId side : {h, surface_->next(h), surface_->prev(h)}) add(side);
    } else if (const HalfedgeId h = surface_->halfedge(piece.vertex); h.valid()) {
      add(h);
    }
  };
  for (const PolylinePiece& piece : pieces_.segments) add_face(piece);
  for (const PolylinePiece& piece : pieces_.points) add_face(piece);
  if (sum > 0) return sum / static_cast<double>(count) / 8;
  const auto lengths = surface_->lengths();
  const auto longest = std::max_element(lengths.begin(), lengths.end());
  return longest != lengths.end() && *longest > 0 ? *longest : 1.0;
}

void PolylineDistance::send_vertex(const PolylinePiece& piece) {
  lower(piece.vertex, 0, piece.curve, piece.arc);
  queue_.push({0, static_cast<std::uint32_t>(piece.vertex.index()), kVertexItem});
}

void PolylineDistance::send(HalfedgeId side, EdgeWindow window) {
  window.into = twin(side);
  const EdgeId edge = edge_of(side);
  const EdgeWindow turned = window.turned(surface_->length(edge));
  insert(side == halfedge_of(edge) ? window : turned);
  if (window.from_point()) pass_on(turned);
}

void PolylineDistance::send_point(const PolylinePiece& piece) {
  for (std::size_t k = 0; k < 3; ++k) {
    const SideFrame frame = side_frame(*surface_, piece.face, k);
    const PlanePoint p = frame.at(piece.from, k);
    EdgeWindow window;
    window.end = frame.length;
    window.px = p.x;
    window.py = p.y;
    window.arc = piece.arc;
    window.curve = piece.curve;
    send(frame.side, window);
  }
}

void PolylineDistance::send_segment(const PolylinePiece& piece) {
  for (std::size_t k = 0; k < 3; ++k) {
    const SideFrame frame = side_frame(*surface_, piece.face, k);
    const PlanePoint p = frame.at(piece.from, k), q = frame.at(piece.to, k);
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    const double tx = (q.x - p.x) / length, ty = (q.y - p.y) / length;
    // A segment perpendicular to the side reaches it only from its ends. If it is perpendicular up
    // to kUpright, it is nearer than its ends by less than rounding.
    if (!(std::abs(tx) > kUpright)) continue;
    const double first = p.x + p.y * ty / tx, last = q.x + q.y * ty / tx;
    EdgeWindow window;
    window.begin = std::max(0.0, std::min(first, last));
    window.end = std::min(frame.length, std::max(first, last));
    if (!(window.begin <= window.end)) continue;
    // The direction out of the face, which is downwards.
    window.px = tx > 0 ? ty : -ty;
    window.py = -std::abs(tx);
    window.sense = tx > 0 ? -1 : 1;
    window.offset = -(window.px * p.x + window.py * p.y);
    window.arc = piece.arc - (tx * p.x + ty * p.y);
    window.curve = piece.curve;
    send(frame.side, window);
  }
}

}  // namespace talweg
