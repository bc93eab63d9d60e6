#include "talweg/core/strokes/stroke_slack.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "talweg/core/measure/measures.hpp"
#include "talweg/core/strokes/hand_trembling.hpp"
#include "talweg/core/strokes/strand_gap.hpp"
#include "talweg/core/strokes/stroke_cleaning.hpp"

namespace talweg {
namespace {

constexpr double kStraight = 0.1, kZigzag = 0.2, kRound = 1;  // radians
constexpr double kOfSegment = 0.7, kMostOfLength = 1.0 / 24;
constexpr double kLeastOfLength = kMostOfLength / 10, kLeastOfEdge = 0.1;
constexpr double kMostOfEdge = 8 * kOfSegment;
constexpr double kOfGap = 0.25, kApart = 6, kLeastGap = 0.25;

/// Lengths between successive points at which the curve has turned, at one point or gradually since
/// the last such point. A segment that ends in a small turn counts less in proportion to the turn,
/// since its zigzag is narrower.
std::vector<double> segment_lengths(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  const auto point = [&](std::size_t i) -> const SurfacePoint& { return curve.points[i % n]; };
  const auto turn = [&](std::size_t i) {
    const PointTurn found = turn_of(surface, point(i + n - 1), point(i), point(i + 1));
    return found.toward_left < 0 ? -found.angle : found.angle;
  };
  std::size_t first = 0;  // in a closed curve, the first point at which it turns, if any
  while (curve.closed && first + 1 < n && std::abs(turn(first)) <= kStraight) ++first;
  if (first + 1 == n) first = 0;
  std::vector<double> lengths{0};
  double turned = 0;
  for (std::size_t i = first; i + (curve.closed ? 0 : 1) < first + n; ++i) {
    const double here = i > first ? turn(i) : 0;
    turned += here;
    const bool sharp = std::abs(here) > kStraight;
    if (sharp || std::abs(turned) > kStraight) {
      lengths.back() *= sharp ? std::min(1.0, std::abs(here) / kZigzag) : std::abs(turned) / kRound;
      lengths.push_back(0);
      turned = 0;
    }
    lengths.back() += curve_length(surface, {false, {point(i), point(i + 1)}});
  }
  return lengths;
}

/// Whether most of the curve's length runs along edges of the mesh.
bool runs_along_edges(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  double along = 0, all = 0;
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    const FaceId face = common_face(surface, p, q);
    const FaceCoordinates from = coordinates_in(surface, p, face),
                          to = coordinates_in(surface, q, face);
    const double length = distance_in_face(surface, from, to);
    all += length;
    for (std::size_t k = 0; k < 3; ++k) {
      if (from.barycentric[k] != 0 || to.barycentric[k] != 0) continue;
      along += length;
      break;
    }
  }
  return along > all / 2;
}

/// The part of the curve's length before each point, from 0; in a closed curve also 1 at the end.
std::vector<double> parts_of_length(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  const std::vector<Point> positions = positions_of(mesh, curve);
  const std::size_t n = positions.size();
  std::vector<double> parts{0};
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    parts.push_back(parts.back() + (positions[(i + 1) % n] - positions[i]).norm());
  }
  const double length = parts.back();
  for (double& part : parts) part = length > 0 ? part / length : 0;
  return parts;
}

/// The slack at a part of the curve's length, interpolated between the middles of the parts in
/// `slack.along`. In a closed curve, 1 is the same place as 0.
double at_part(const StrokeSlack& slack, double part, bool closed) {
  const auto n = static_cast<double>(slack.along.size());
  double place = (closed ? part - std::floor(part) : part) * n - 0.5;
  if (!closed) place = std::clamp(place, 0.0, n - 1);
  const double before = std::floor(place), t = place - before;
  const auto value = [&](double k) {
    return slack.along[static_cast<std::size_t>(k < 0 ? k + n : k >= n ? k - n : k)];
  };
  return t > 0 ? (1 - t) * value(before) + t * value(before + 1) : value(before);
}

template <class Move>
StrokeSlack moved_along(const StrokeSlack& slack, bool closed, const Move& from) {
  StrokeSlack moved = slack;
  const auto n = static_cast<double>(slack.along.size());
  for (std::size_t k = 0; k < slack.along.size(); ++k) {
    moved.along[k] = at_part(slack, from((static_cast<double>(k) + 0.5) / n), closed);
  }
  return moved;
}

/// The slack, but no more than a quarter of the distance to another part of the stroke that runs
/// beside. A distance below `least` is the hand's, and no feature of the drawing.
double beside_strands(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double slack,
                      double least) {
  if (!(slack > 0)) return slack;
  return std::min(
      slack, kOfGap * strand_gap(mesh, stroke, slack / 2, kApart * slack, least, slack / kOfGap));
}

/// The slack of a stroke. The slack varies along the stroke only if the stroke is the only one.
StrokeSlack slack_of_stroke(const SurfaceMesh& mesh, const SurfaceCurve& stroke, bool is_only,
                            double edge) {
  const Surface& surface = mesh.surface();
  if (runs_along_edges(surface, stroke)) {
    const double slack = std::min(slack_of_segments(surface, stroke), kMostOfEdge * edge);
    // A zigzag along edges limits the slack by its segments. A path that runs straight along edges
    // may be a narrow U, so the gap between its strands limits the slack.
    const bool is_straight = slack == kMostOfEdge * edge;
    return {is_straight ? beside_strands(mesh, stroke, slack, kLeastGap * edge) : slack,
            SlackSource::kEdges,
            {}};
  }
  const std::optional<HandTrembling> found = hand_trembling(mesh, stroke, edge);
  if (!found) {
    const double slack = std::min(slack_of_segments(surface, stroke), kMostOfEdge * edge);
    return {beside_strands(mesh, stroke, slack, kLeastGap * edge), SlackSource::kSegments, {}};
  }
  const double length = curve_length(surface, stroke);
  const double least = std::min(kLeastOfEdge * edge, kLeastOfLength * length);
  const auto within = [&](double slack) {
    return std::clamp(slack, least, kMostOfLength * length);
  };
  const double wide = within(found->amplitude);
  // Two strands meant as one line may lie an amplitude away on either side of the line.
  StrokeSlack slack{beside_strands(mesh, stroke, wide, 2 * wide), SlackSource::kTrembling, {}};
  if (!is_only) return slack;
  for (const double amplitude : found->along) {
    slack.along.push_back(within(amplitude) * slack.slack / wide);
  }
  return slack;
}

}  // namespace

std::vector<double> slack_at_points(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                                    const StrokeSlack& slack) {
  std::vector<double> along;
  if (slack.along.empty()) return along;
  const std::vector<double> parts = parts_of_length(mesh, curve);
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    along.push_back(at_part(slack, parts[i], curve.closed));
  return along;
}

StrokeSlack in_order(const StrokeSlack& slack, const SurfaceMesh& mesh, const SurfaceCurve& curve,
                     const CurveOrder& order) {
  if (slack.along.empty()) return slack;
  const double start = curve.closed ? parts_of_length(mesh, curve)[order.start] : 0;
  return moved_along(slack, curve.closed, [&](double part) {
    if (order.reversed) return curve.closed ? start - part : 1 - part;
    return start + part;
  });
}

StrokeSlack turned_back(const StrokeSlack& slack, const SurfaceMesh& mesh,
                        const SurfaceCurve& curve, const CurveOrder& order) {
  const double start = curve.closed ? parts_of_length(mesh, curve)[order.start] : 0;
  return moved_along(slack, curve.closed, [&](double part) {
    if (order.reversed) return curve.closed ? start - part : 1 - part;
    return part - start;
  });
}

double slack_of_segments(const Surface& surface, const SurfaceCurve& curve) {
  if (curve.points.size() < 2) return 0;
  std::vector<double> lengths = segment_lengths(surface, curve);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return std::min(kOfSegment * *middle, kMostOfLength * curve_length(surface, curve));
}

StrokeSlack stroke_slack(const SurfaceMesh& mesh, std::span<const SurfaceCurve> strokes,
                         double edge) {
  const SurfaceCurve* longest = nullptr;
  double length = 0;
  for (const SurfaceCurve& stroke : strokes) {
    const double own = curve_length(mesh.surface(), stroke);
    if (longest != nullptr && !(own > length)) continue;
    longest = &stroke;
    length = own;
  }
  if (longest == nullptr) return {};
  return slack_of_stroke(mesh, without_rests(mesh, *longest).curve, strokes.size() == 1, edge);
}

}  // namespace talweg
