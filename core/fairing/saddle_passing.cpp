#include "talweg/core/fairing/saddle_passing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "talweg/core/fairing/curve_trace.hpp"
#include "talweg/intrinsic/lines/straight_walk.hpp"

namespace talweg {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAside = 1.0 / 100;           // of the distance to the nearer neighbour
constexpr double kLeastGain = kPi / 360;       // rad
constexpr double kMostTurn = 3.5 * kPi / 180;  // a larger turn is a visible kink

/// The angle between two directions, in [0, π].
double angle_of(PlanePoint a, PlanePoint b) { return std::atan2(std::abs(cross(a, b)), dot(a, b)); }

}  // namespace

SaddlePassing::Side SaddlePassing::side(const FaceCoordinates& from, const FaceCoordinates& to,
                                        VertexId vertex, bool ccw) const {
  Side side{faces_around(*surface_, from.face, to.face, vertex, ccw), {}, 0, ccw};
  const auto to_edge = [&](const FaceCoordinates& at, bool next) {
    const FaceFrame frame(*surface_, at.face);
    const std::size_t k = frame.side_of(outgoing(*surface_, at.face, vertex));
    const PlanePoint edge = frame.corners[(k + (next ? 2 : 1)) % 3] - frame.corners[k];
    return angle_of(frame.at(at.barycentric) - frame.corners[k], edge);
  };
  double angle = to_edge(from, ccw);
  for (const HalfedgeId crossed : side.strip) {
    side.angles.push_back(angle);
    const FaceId face = surface_->face(twin(crossed));
    if (face == to.face) break;
    const FaceFrame frame(*surface_, face);
    const std::size_t k = frame.side_of(outgoing(*surface_, face, vertex));
    angle += angle_of(frame.corners[(k + 1) % 3] - frame.corners[k],
                      frame.corners[(k + 2) % 3] - frame.corners[k]);
  }
  side.sweep = angle + to_edge(to, !ccw);
  return side;
}

/// The point in the middle of the side's angle; sets `before` to the number of crossings before it.
FaceCoordinates SaddlePassing::in_middle(const Side& side, const FaceCoordinates& from,
                                         VertexId vertex, double aside, std::size_t& before) const {
  before = static_cast<std::size_t>(
      std::upper_bound(side.angles.begin(), side.angles.end(), side.sweep / 2) -
      side.angles.begin());
  const FaceId face = before == 0 ? from.face : surface_->face(twin(side.strip[before - 1]));
  const FaceFrame frame(*surface_, face);
  const std::size_t k = frame.side_of(outgoing(*surface_, face, vertex));
  const PlanePoint at = frame.corners[k];
  PlanePoint start = frame.corners[(k + (side.ccw ? 1 : 2)) % 3] - at;
  double angle = side.sweep / 2;
  if (before == 0) {
    start = frame.at(from.barycentric) - at;
  } else {
    angle -= side.angles[before - 1];
  }
  const double cosine = std::cos(angle) / norm(start), sine = std::sin(angle) / norm(start);
  const PlanePoint turned = side.ccw ? turned_left(start) : -1 * turned_left(start);
  const FaceFrame::Barycentric rates = frame.rates(cosine * start + sine * turned);
  FaceCoordinates middle{face, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    middle.barycentric[c] = (c == k ? 1 : 0) + aside * rates[c];
  }
  return moved_inside(middle);
}

bool SaddlePassing::add_line(const FaceCoordinates& from, const FaceCoordinates& to,
                             FaceStrip strip, std::vector<SurfacePoint>& points) {
  const StripLine line = lines_.join(from, to, strip);
  if (!line.found || !line.bends.empty()) return false;
  lines_.trace(line.from, line.to, strip);
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const double part = lines_.parts()[i];
    if (!(part > 0 && part < 1)) return false;
    const EdgeId edge = edge_of(strip[i]);
    points.push_back(
        SurfacePoint::on_edge(*surface_, edge, strip[i] == halfedge_of(edge) ? part : 1 - part));
  }
  return true;
}

std::vector<SurfacePoint> SaddlePassing::beside(const SurfacePoint& before, VertexId vertex,
                                                const SurfacePoint& after) {
  const SurfacePoint at = SurfacePoint::at_vertex(*surface_, vertex);
  if (surface_->on_boundary(vertex)) return {at};
  const auto neighbour = [&](const SurfacePoint& point) {
    return coordinates_in(*surface_, point, common_face(*surface_, point, at));
  };
  const auto away = [&](const FaceCoordinates& point) {
    return distance_in_face(*surface_, point, coordinates_in(*surface_, at, point.face));
  };
  const FaceCoordinates from = neighbour(before), to = neighbour(after);
  if (from.face == to.face) return {at};
  const double nearer = std::min(away(from), away(to));
  Side best = side(from, to, vertex, false), other = side(from, to, vertex, true);
  if (other.sweep < best.sweep) std::swap(best, other);
  const double here = (other.sweep - best.sweep) / 2;
  const double turn = std::abs(best.sweep - kPi);
  if (!(nearer > 0) || !(turn < here - kLeastGain && (turn <= kMostTurn || turn < here / 2)))
    return {at};
  std::size_t crossings = 0;
  const FaceCoordinates middle = in_middle(best, from, vertex, kAside * nearer, crossings);
  const auto halfway = best.strip.begin() + static_cast<std::ptrdiff_t>(crossings);
  std::vector<SurfacePoint> points;
  if (!add_line(from, middle, {best.strip.begin(), halfway}, points)) return {at};
  points.push_back(SurfacePoint::from_barycentric(*surface_, middle.face, middle.barycentric));
  if (!add_line(middle, to, {halfway, best.strip.end()}, points)) return {at};
  return points;
}

SurfaceCurve SaddlePassing::moved_off_saddles(const std::vector<KeptPoint>& points, bool closed) {
  const std::size_t n = points.size();
  SurfaceCurve curve{closed, {}};
  const auto may_move = [&](std::size_t i) {
    return n > 1 && (closed || (i > 0 && i + 1 < n)) && !points[i].stays &&
           std::holds_alternative<AtVertex>(points[i].point.where());
  };
  const auto passed = [&](std::size_t i, const SurfacePoint& before, const SurfacePoint& after) {
    if (!may_move(i)) return std::vector{points[i].point};
    return beside(before, std::get<AtVertex>(points[i].point.where()).vertex, after);
  };
  const auto add = [&](const std::vector<SurfacePoint>& more, bool in_front) {
    curve.points.insert(in_front ? curve.points.begin() : curve.points.end(), more.begin(),
                        more.end());
  };
  // The first point of a closed curve is replaced last, when both of its neighbours are known.
  const bool later = closed && n > 1;
  for (std::size_t i = later ? 1 : 0; i < n; ++i) {
    const SurfacePoint& before = curve.points.empty() ? points.front().point : curve.points.back();
    add(passed(i, before, points[(i + 1) % n].point), false);
  }
  if (later) add(passed(0, curve.points.back(), curve.points.front()), true);
  return curve;
}

}  // namespace talweg
