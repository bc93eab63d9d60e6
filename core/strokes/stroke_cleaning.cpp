#include "talweg/core/strokes/stroke_cleaning.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "talweg/core/fairing/curve_trace.hpp"
#include "talweg/core/space/nearest_segment.hpp"
#include "talweg/core/strokes/compass_walk.hpp"
#include "talweg/core/strokes/hand_rests.hpp"
#include "talweg/core/strokes/turning_points.hpp"
#include "talweg/intrinsic/lines/face_frame.hpp"
#include "talweg/intrinsic/lines/strip_line.hpp"

namespace talweg {
namespace {

// Lengths as parts of the trembling.
constexpr double kStep = 0.25, kTooNear = kStep / 2, kHook = 0.5, kEnd = 2.5;
constexpr std::size_t kRest = 8;  // points in a step of a rest, per usual number of points

/// Whether successive points at which the stroke turns lie nearer to each other than `near`.
bool is_too_fine(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                 std::span<const Point> positions, double near) {
  const std::vector<std::size_t> turning = turning_points(mesh.surface(), stroke);
  return std::adjacent_find(turning.begin(), turning.end(), [&](std::size_t a, std::size_t b) {
           return (positions[b] - positions[a]).norm() < near;
         }) != turning.end();
}

/// The number of points of a hook at the start, 0 without a hook. The hook ends at the point that
/// lies farthest back, seen in the direction in which the stroke leaves a ball around its start.
std::size_t hook_at_start(std::span<const Point> positions, double trembling) {
  const Point& end = positions.front();
  std::size_t out = 0;
  while (out < positions.size() && (positions[out] - end).norm() <= kEnd * trembling) ++out;
  if (out == positions.size()) return 0;
  const Point along = (positions[out] - end).normalized();
  std::size_t back = 0;
  for (std::size_t k = 0; k < out; ++k) {
    if ((positions[k] - end).dot(along) < (positions[back] - end).dot(along)) back = k;
  }
  return (positions[back] - end).dot(along) < -kHook * trembling ? back : 0;
}

std::pair<std::size_t, std::size_t> hooks_of(std::vector<Point> positions, double trembling,
                                             FreeEnds ends) {
  const std::size_t start = ends.start ? hook_at_start(positions, trembling) : 0;
  std::reverse(positions.begin(), positions.end());
  return {start, ends.end ? hook_at_start(positions, trembling) : 0};
}

/// Removes the parts of a strip that return to an earlier face.
void erase_loops(const Surface& surface, FaceId first, FaceStrip& strip) {
  std::unordered_map<FaceId, std::size_t> entered{{first, 0}};  // face, number of edges before it
  std::vector<FaceId> faces{first};
  std::size_t kept = 0;
  for (const HalfedgeId h : FaceStrip(strip)) {
    const FaceId face = surface.face(twin(h));
    strip[kept++] = h;
    faces.push_back(face);
    const auto [known, is_new] = entered.try_emplace(face, kept);
    if (is_new) continue;
    while (faces.size() > known->second + 1) {
      if (faces.back() != face) entered.erase(faces.back());
      faces.pop_back();
    }
    kept = known->second;
  }
  strip.resize(kept);
}

/// Joins places of a stroke by straight lines through the faces that the stroke passes between
/// them.
class Joiner {
 public:
  Joiner(const Surface& surface, const SurfaceCurve& stroke)
      : surface_(&surface),
        stroke_(&stroke),
        trace_(trace_through(surface, stroke, {})),
        lines_(surface) {}

  std::optional<CleanedStroke> joined(const std::vector<PolylinePlace>& places) {
    result_ = {};
    result_.curve.closed = stroke_->closed;
    for (std::size_t i = 0; i < places.size(); ++i) {
      add(point_at(places[i]), place_of(places[i]));
      const bool is_last = i + 1 == places.size();
      if (is_last && !stroke_->closed) break;
      if (!add_line(places[i], is_last ? nullptr : &places[i + 1], places.front()))
        return std::nullopt;
    }
    if (stroke_->closed && result_.curve.points.back() == result_.curve.points.front()) {
      result_.curve.points.pop_back();
      result_.places.pop_back();
    }
    return std::move(result_);
  }

 private:
  static double place_of(const PolylinePlace& place) {
    return static_cast<double>(place.segment) + place.part;
  }

  [[nodiscard]] SurfacePoint point_at(const PolylinePlace& place) const {
    if (place.part == 0) return stroke_->points[place.segment];
    if (place.part == 1) return stroke_->points[(place.segment + 1) % stroke_->points.size()];
    return trace_.pieces[place.segment].point(*surface_, place.part);
  }

  void add(const SurfacePoint& point, double place) {
    if (!result_.curve.points.empty() && result_.curve.points.back() == point) return;
    result_.curve.points.push_back(point);
    result_.places.push_back(place);
  }

  [[nodiscard]] FaceCoordinates coordinates(const PolylinePlace& place) const {
    const TracePiece& piece = trace_.pieces[place.segment];
    return {piece.face, piece.at(place.part)};
  }

  /// Adds the line to the next place, or, if `next` is null, to the first place of a closed stroke.
  /// False if there is no straight line.
  bool add_line(const PolylinePlace& from, const PolylinePlace* next, const PolylinePlace& first) {
    const PolylinePlace& to = next != nullptr ? *next : first;
    const auto begin = static_cast<std::ptrdiff_t>(trace_.pieces[from.segment].crossed);
    const auto end = static_cast<std::ptrdiff_t>(next != nullptr ? trace_.pieces[to.segment].crossed
                                                                 : trace_.crossed.size());
    strip_.assign(trace_.crossed.begin() + begin, trace_.crossed.begin() + end);
    const FaceCoordinates a = coordinates(from);
    erase_loops(*surface_, a.face, strip_);
    const StripLine line = lines_.join(a, coordinates(to), strip_);
    if (!line.found) return false;
    lines_.trace(line.from, line.to, strip_);
    FaceId face = line.from.face;
    const double gap =
        (next != nullptr ? place_of(to) : static_cast<double>(stroke_->points.size())) -
        place_of(from);
    for (std::size_t k = 0; k < strip_.size(); ++k) {
      const FaceFrame here(*surface_, face);
      std::array<double, 3> at{};
      at[here.side_of(strip_[k])] = 1 - lines_.parts()[k];
      at[(here.side_of(strip_[k]) + 1) % 3] = lines_.parts()[k];
      add(SurfacePoint::from_barycentric(*surface_, face, at),
          place_of(from) +
              gap * static_cast<double>(k + 1) / static_cast<double>(strip_.size() + 1));
      face = surface_->face(twin(strip_[k]));
    }
    return true;
  }

  const Surface* surface_;
  const SurfaceCurve* stroke_;
  CurveTrace trace_;
  StripLines lines_;
  FaceStrip strip_;
  CleanedStroke result_;
};

std::size_t rests_between(const std::vector<PolylinePlace>& places) {
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    counts.push_back(places[i + 1].segment - places[i].segment);
  }
  if (counts.empty()) return 0;
  std::vector<std::size_t> sorted = counts;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const std::size_t many = kRest * std::max<std::size_t>(*middle, 1);
  return static_cast<std::size_t>(
      std::count_if(counts.begin(), counts.end(), [&](std::size_t n) { return n > many; }));
}

bool is_sound(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  if (n < (curve.closed ? 3U : 2U)) return false;
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    if (!common_face(surface, curve.points[i], curve.points[(i + 1) % n]).valid()) return false;
  }
  return true;
}

double farthest_from(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                     std::span<const Point> points) {
  const NearestSegment nearest(segments_of(positions_of(mesh, curve), curve.closed));
  double farthest = 0;
  for (const Point& p : points) farthest = std::max(farthest, nearest.to(p).distance);
  return farthest;
}

/// All points of a stroke without its rests, each of which keeps one point.
std::vector<PolylinePlace> places_beside(std::span<const HandRest> rests,
                                         std::span<const Point> positions, bool closed) {
  std::vector<PolylinePlace> places;
  const std::size_t n = positions.size();
  std::size_t rest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    while (rest < rests.size() && rests[rest].last < k) ++rest;
    const bool rests_here = rest < rests.size() && rests[rest].first <= k;
    if (rests_here && rests[rest].kept != k) continue;
    const bool is_end = !closed && k + 1 == n;
    places.push_back(is_end ? PolylinePlace{k - 1, 1, positions[k]}
                            : PolylinePlace{k, 0, positions[k]});
  }
  return places;
}

CleanedStroke without_trembling(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                double trembling, FreeEnds ends) {
  CleanedStroke as_given{stroke, {}};
  const std::vector<Point> positions = positions_of(mesh, stroke);
  const std::size_t n = positions.size();
  if (n < 3 || !(trembling > 0)) return as_given;
  std::pair<std::size_t, std::size_t> hooks{0, 0};
  if (!stroke.closed) hooks = hooks_of(positions, trembling, ends);
  const bool any_hook = hooks.first + hooks.second > 0;
  if (!any_hook && !is_too_fine(mesh, stroke, positions, kTooNear * trembling)) return as_given;
  if (hooks.first + hooks.second + 2 > n) return as_given;
  SurfaceCurve trimmed{stroke.closed,
                       {stroke.points.begin() + static_cast<std::ptrdiff_t>(hooks.first),
                        stroke.points.end() - static_cast<std::ptrdiff_t>(hooks.second)}};
  const std::span<const Point> kept =
      std::span(positions).subspan(hooks.first, trimmed.points.size());
  const std::vector<PolylinePlace> places = compass_walk(
      kept, stroke.closed, walkable_step(kept, stroke.closed, kStep * trembling), true);
  if (places.size() < (stroke.closed ? 3U : 2U)) return as_given;
  std::optional<CleanedStroke> cleaned = Joiner(mesh.surface(), trimmed).joined(places);
  if (!cleaned || !is_sound(mesh.surface(), cleaned->curve)) return as_given;
  for (double& place : cleaned->places) place += static_cast<double>(hooks.first);
  cleaned->hooks =
      static_cast<std::size_t>(hooks.first > 0) + static_cast<std::size_t>(hooks.second > 0);
  cleaned->rests = rests_between(places);
  cleaned->farthest = farthest_from(mesh, cleaned->curve, positions);
  return *std::move(cleaned);
}

/// The places on the given stroke of a stroke that was cleaned twice. `once`: places of the first
/// cleaning on the given stroke; `twice`: places of the second one on the result of the first.
std::vector<double> places_on_given(std::span<const double> once, std::span<const double> twice,
                                    std::size_t given_points) {
  std::vector<double> places;
  for (const double place : twice) {
    const auto k = static_cast<std::size_t>(place);
    const double next = k + 1 < once.size() ? once[k + 1] : static_cast<double>(given_points);
    const double part = place - static_cast<double>(k);
    places.push_back(part > 0 ? (1 - part) * once[k] + part * next : once[k]);
  }
  return places;
}

}  // namespace

std::optional<CleanedStroke> straight_line_along(const Surface& surface,
                                                 const SurfaceCurve& curve) {
  if (curve.closed || curve.points.size() < 2) return std::nullopt;
  const PolylinePlace first{0, 0, Point::Zero()};
  const PolylinePlace last{curve.points.size() - 2, 1, Point::Zero()};
  std::optional<CleanedStroke> line = Joiner(surface, curve).joined({first, last});
  return line && is_sound(surface, line->curve) ? line : std::nullopt;
}

CleanedStroke without_rests(const SurfaceMesh& mesh, const SurfaceCurve& stroke) {
  CleanedStroke as_given{stroke, {}};
  const std::vector<HandRest> rests = hand_rests(mesh, stroke);
  if (rests.empty()) return as_given;
  const std::vector<Point> positions = positions_of(mesh, stroke);
  const auto places = places_beside(rests, positions, stroke.closed);
  if (places.size() < (stroke.closed ? 3U : 2U)) return as_given;
  std::optional<CleanedStroke> still = Joiner(mesh.surface(), stroke).joined(places);
  if (!still || !is_sound(mesh.surface(), still->curve)) return as_given;
  still->rests = rests.size();
  still->farthest = farthest_from(mesh, still->curve, positions);
  return *std::move(still);
}

CleanedStroke cleaned_stroke(const SurfaceMesh& mesh, const SurfaceCurve& stroke, double trembling,
                             FreeEnds ends) {
  CleanedStroke still = without_rests(mesh, stroke);
  CleanedStroke cleaned = without_trembling(mesh, still.curve, trembling, ends);
  if (!still.is_cleaned()) return cleaned;
  if (!cleaned.is_cleaned()) return still;
  cleaned.places = places_on_given(still.places, cleaned.places, stroke.points.size());
  cleaned.rests += still.rests;
  cleaned.farthest = farthest_from(mesh, cleaned.curve, positions_of(mesh, stroke));
  return cleaned;
}

}  // namespace talweg
