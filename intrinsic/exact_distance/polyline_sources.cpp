#include "talweg/intrinsic/exact_distance/polyline_sources.hpp"

#include <algorithm>
#include <cmath>

#include "talweg/intrinsic/exact_distance/window_front.hpp"

namespace talweg {
namespace {

constexpr double kUpright = 1e-8;  // rad, whose square is below the rounding of a double

}  // namespace

EdgeWindow window_of_point(const PolylinePiece& point, const SideFrame& frame, std::size_t k) {
  const PlanePoint p = frame.at(point.from, k);
  EdgeWindow window;
  window.end = frame.length;
  window.px = p.x;
  window.py = p.y;
  window.arc = point.arc;
  window.curve = point.curve;
  window.into = twin(frame.side);
  return window;
}

std::optional<EdgeWindow> window_of_segment(const PolylinePiece& segment, const SideFrame& frame,
                                            std::size_t k) {
  const PlanePoint p = frame.at(segment.from, k), q = frame.at(segment.to, k);
  const double length = std::hypot(q.x - p.x, q.y - p.y);
  const double tx = (q.x - p.x) / length, ty = (q.y - p.y) / length;
  // A segment perpendicular to the side reaches the side only from its ends. The interior of a
  // segment that is perpendicular up to kUpright is nearer than the ends by less than rounding.
  if (!(std::abs(tx) > kUpright)) return {};
  const double first = p.x + p.y * ty / tx, last = q.x + q.y * ty / tx;
  EdgeWindow window;
  window.begin = std::max(0.0, std::min(first, last));
  window.end = std::min(frame.length, std::max(first, last));
  if (!(window.begin <= window.end)) return {};
  // The direction out of the face, which is downwards.
  window.px = tx > 0 ? ty : -ty;
  window.py = -std::abs(tx);
  window.arc_sign = tx > 0 ? -1 : 1;
  window.offset = -(window.px * p.x + window.py * p.y);
  window.arc = segment.arc - (tx * p.x + ty * p.y);
  window.curve = segment.curve;
  window.into = twin(frame.side);
  return window;
}

void send_pieces(const Surface& surface, const PolylinePieces& pieces, WindowFront& front) {
  // Segments go first, because they hide most of the windows that points would send.
  constexpr std::size_t kOfPiece = 8;  // units of work
  for (const PolylinePiece& segment : pieces.segments) {
    front.work().report();
    front.work().add(kOfPiece);
    for (std::size_t k = 0; k < 3; ++k) {
      const SideFrame frame = side_frame(surface, segment.face, k);
      if (const auto window = window_of_segment(segment, frame, k)) front.send(*window);
    }
  }
  for (const PolylinePiece& point : pieces.points) {
    front.work().report();
    front.work().add(kOfPiece);
    if (point.vertex.valid()) {
      front.start_at(point.vertex, {0, point.curve, point.arc});
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      front.send(window_of_point(point, side_frame(surface, point.face, k), k));
    }
  }
}

namespace {

/// The width of a face: about the mean length of its sides, but less in a needle, where a step of
/// that width would spread windows over a thousand needles at once.
double width_of(const Surface& surface, FaceId face) {
  constexpr double kLeast = 1.0 / 4096;  // in faces without area
  const HalfedgeId h = surface.halfedge(face);
  const double a = surface.length(edge_of(h)), b = surface.length(edge_of(surface.next(h))),
               c = surface.length(edge_of(surface.prev(h)));
  const double mean = (a + b + c) / 3, longest = std::max({a, b, c});
  if (!(longest > 0)) return 0;
  const double height = 2 * triangle_area(a, b, c) / longest;
  return std::min(mean, std::max(2 * height, kLeast * mean));
}

}  // namespace

double step_width(const Surface& surface, const PolylinePieces& pieces) {
  double sum = 0;
  std::size_t count = 0;
  for (const auto* kind : {&pieces.segments, &pieces.points}) {
    for (const PolylinePiece& piece : *kind) {
      if (piece.face.valid()) {
        sum += width_of(surface, piece.face);
      } else if (const HalfedgeId h = surface.halfedge(piece.vertex); h.valid()) {
        sum +=
            surface.has_face(h) ? width_of(surface, surface.face(h)) : surface.length(edge_of(h));
      } else {
        continue;
      }
      ++count;
    }
  }
  if (sum > 0) return sum / static_cast<double>(count) / 8;
  const auto lengths = surface.lengths();
  const auto longest = std::max_element(lengths.begin(), lengths.end());
  return longest != lengths.end() && *longest > 0 ? *longest : 1.0;
}

}  // namespace talweg
