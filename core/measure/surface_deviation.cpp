#include "talweg/core/measure/surface_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "talweg/core/measure/bounded_deviation.hpp"
#include "talweg/core/measure/curve_segments.hpp"
#include "talweg/core/measure/face_bounds.hpp"
#include "talweg/core/measure/local_distance.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"

namespace talweg {
namespace {

constexpr double kTolerance = 1e-3;
constexpr int kMaxHalvings = 40;
// The most samples for one segment. In slivers, rounding may keep the bounds from meeting the
// tolerance; then the largest sample is used.
constexpr int kMostSamples = 2000;
constexpr int kMeanHalvings = 10;
constexpr std::size_t kMostWindows = 2;  // windows of all parts together, per edge of the mesh
constexpr double kNoLimit = HUGE_VAL;
constexpr const char* kStage = "measure";
constexpr std::size_t kOfGuess = 32;  // units of work of ProgressPoller

class Measurement {
 public:
  /// Distances of `limit` and more count as infinite.
  Measurement(const Surface& surface, PolylineDistance& to, const PolylinePieces& pieces,
              double tolerance, double limit, ProgressPoller& poller)
      : surface_(&surface),
        to_(&to),
        bounds_(surface, to, pieces),
        tolerance_(tolerance),
        limit_(limit),
        poller_(&poller) {}

  /// Adds a part of the segments. Between parts, `to` and `pieces` may be set to other curves.

  void add(std::span<const CurveSegment> segments) {
    struct Sampled {
      SegmentSample a, middle, b;
    };
    std::vector<Sampled> sampled;
    double length = 0, integral = 0;
    const std::size_t before = known_.size();
    for (const CurveSegment& s : segments) {
      if (std::isfinite(limit_) && !std::isfinite(max_)) return;
      const SegmentSample a = sample(s, 0), middle = sample(s, 0.5), b = sample(s, 1);
      sampled.push_back({a, middle, b});
      known_.push_back({a.distance, middle.distance, b.distance});
      length += s.length;
      integral += s.length * simpson(a, middle, b);
    }
    if (!std::isfinite(max_)) return;
    const double missed = std::max(tolerance_, kTolerance * integral / length);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Sampled& s = sampled[i];
      integral_ += segments[i].length * mean(segments[i], s.a, s.middle, s.b, missed);
    }
    length_ += length;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      samples_left_ = kMostSamples;
      search(segments[i], sampled[i].a, sampled[i].middle);
      search(segments[i], sampled[i].middle, sampled[i].b);
      if (samples_left_ >= 0) known_[before + i].most = enough_by_now();
    }
  }
  /// The results for the first segments, as far as they were measured.
  [[nodiscard]] std::span<const KnownSegment> known() const { return known_; }
  /// The largest sample.
  [[nodiscard]] double largest() const { return max_; }

  [[nodiscard]] OneSidedSurfaceDeviation result() const {
    const bool is_mean = std::isfinite(max_) && length_ > 0;
    return {max_, is_mean ? integral_ / length_ : max_, *at_, true, max_};
  }
  [[nodiscard]] bool is_finite() const { return std::isfinite(max_); }

  /// Samples the distance at a point.
  double see(const SurfacePoint& point) {
    constexpr std::size_t kWork = 32;
    poller_->add_work(kWork);
    const double distance =
        std::isfinite(limit_) ? to_->below(limit_, point) : to_->at(point).distance;
    if (!at_ || distance > max_) {
      max_ = distance;
      at_ = point;
    }
    return distance;
  }

 private:
  SegmentSample sample(const CurveSegment& s, double t) { return {t, see(s.point(*surface_, t))}; }

  static double simpson(const SegmentSample& a, const SegmentSample& middle,
                        const SegmentSample& b) {
    return (a.distance + 4 * middle.distance + b.distance) / 6;
  }

  /// The mean between a and b by adaptive Simpson's rule. The error is estimated by comparison with
  /// the trapezoidal rule, because both rules have similar errors at kinks of the distance.
  double mean(const CurveSegment& s, const SegmentSample& a, const SegmentSample& middle,
              const SegmentSample& b, double missed, int halvings = 0) {
    const double bend = std::abs(a.distance - 2 * middle.distance + b.distance) / 12;
    if (bend <= missed || halvings >= kMeanHalvings) return simpson(a, middle, b);
    const SegmentSample first = sample(s, (a.t + middle.t) / 2),
                        second = sample(s, (middle.t + b.t) / 2);
    return (mean(s, a, first, middle, missed, halvings + 1) +
            mean(s, middle, second, b, missed, halvings + 1)) /
           2;
  }

  /// The largest sample plus the tolerance: the search looks for larger distances only.
  [[nodiscard]] double enough_by_now() const {
    return max_ + std::max(tolerance_, kTolerance * max_);
  }

  /// Searches between two samples for a distance larger than all samples.
  void search(const CurveSegment& s, const SegmentSample& a, const SegmentSample& b,
              int halvings = 0) {
    const double enough = enough_by_now();
    const double length = (b.t - a.t) * s.length;
    const double middle_value = (a.distance + b.distance) / 2;
    if (halvings > kMaxHalvings || middle_value + length / 2 <= enough) return;
    if (samples_left_ <= 0) {
      samples_left_ = -1;
      return;
    }
    --samples_left_;
    if (bounds_.by_pieces(s, a, b) <= enough) return;
    if (bounds_.less_across_a_side(s, a, b, enough)) return;
    // less_by_sides() costs two distances, so it is called only if halving would continue for long.
    if (middle_value + length / 8 > enough && bounds_.less_by_sides(s, a, b, enough)) return;
    const SegmentSample middle = sample(s, (a.t + b.t) / 2);
    search(s, a, middle, halvings + 1);
    search(s, middle, b, halvings + 1);
  }

  const Surface* surface_;
  PolylineDistance* to_;
  FaceBounds bounds_;
  double tolerance_;
  double limit_;
  ProgressPoller* poller_;
  double length_ = 0, integral_ = 0;
  double max_ = 0;
  int samples_left_ = 0;  // -1: the limit cut the search off
  std::optional<SurfacePoint> at_;
  std::vector<KnownSegment> known_;
};

void refuse_nothing(std::span<const SurfaceCurve> curves) {
  if (curves.empty()) throw Error(ErrorCode::kBadCurve, "There is no curve to measure.");
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].points.empty()) {
      throw Error(ErrorCode::kBadCurve, "Curve " + std::to_string(c) + " has no points.");
    }
  }
}

/// A thousandth of the mean segment of both sets of curves, mesh units.
double tolerance_for(std::span<const CurveSegment> segments, std::span<const SurfaceCurve> others,
                     const std::vector<double>& other_lengths) {
  double length = 0;
  std::size_t count = segments.size();
  for (const CurveSegment& s : segments) length += s.length;
  for (std::size_t c = 0; c < others.size(); ++c) {
    length += other_lengths[c];
    count += others[c].points.size() - (others[c].closed ? 0 : 1);
  }
  return count > 0 ? kTolerance * length / static_cast<double>(count) : 0;
}

/// The end of the part that begins at `begin`. A part is at least four times as long as its largest
/// estimated distance, so neighbouring parts cover few faces twice.
std::size_t end_of_part(std::span<const CurveSegment> segments, std::span<const double> reach,
                        std::size_t begin) {
  constexpr double kLong = 4;
  double length = 0, farthest = 0;
  std::size_t end = begin;
  while (end < segments.size() && (end < begin + 8 || length < kLong * farthest)) {
    length += segments[end].length;
    farthest = std::max(farthest, reach[end]);
    ++end;
  }
  return end;
}

/// The curves of a one-sided deviation.
struct Sides {
  std::span<const SurfaceCurve> from, to;
};

/// Measures with a distance that is set to all of the other curves.
void measure_at_once(const Sides& sides, std::span<const CurveSegment> segments,
                     Measurement& measurement) {
  for (const SurfaceCurve& curve : sides.from) measurement.see(curve.points.front());
  measurement.add(segments);
}

/// Measures part by part, each with the distance to the nearby parts of the other curves, so that
/// one far corner does not cost a wide band along all curves. If parts cover the same faces again
/// and again, as for a drawing that winds far from its result, the rest is measured as one part.
/// `pieces` is the object that the measurement refers to.
void measure_by_parts(const SurfaceMesh& mesh, const Sides& sides,
                      std::span<const CurveSegment> segments, PolylineDistance& distance,
                      double limit, PolylinePieces& pieces, Measurement& measurement,
                      ProgressPoller& poller) {
  LocalDistance local(mesh, sides.to, distance, limit);
  std::vector<double> reach;
  reach.reserve(segments.size());
  for (const CurveSegment& segment : segments) {
    reach.push_back(local.guess(segment));
    poller.add_work(kOfGuess);
  }
  std::size_t windows = 0;
  for (std::size_t i = 0, end = 0; i < segments.size() && measurement.is_finite(); i = end) {
    if (windows > kMostWindows * mesh.surface().edge_count()) {
      pieces = pieces_of(mesh.surface(), sides.to);
      distance.set(sides.to);
      measurement.add(segments.subspan(i));
      break;
    }
    end = end_of_part(segments, reach, i);
    const auto part = segments.subspan(i, end - i);
    pieces = pieces_of(mesh.surface(), local.set_near(part, std::span(reach).subspan(i, end - i)));
    poller.add_work(pieces.segments.size());
    measurement.add(part);
    windows += distance.window_count();
  }
}

/// One direction of a deviation. If the budget ends the measurement, the result is
/// bounded_deviation().
class Direction {
 public:
  Direction(const SurfaceMesh& mesh, Sides sides, PolylineDistance& distance, double limit,
            ProgressPoller& poller)
      : mesh_(mesh),
        sides_(sides),
        distance_(distance),
        limit_(limit),
        poller_(poller),
        segments_(segments_of(mesh.surface(), sides.from)),
        pieces_(pieces_of(mesh.surface(), sides.to)),
        measurement_(mesh.surface(), distance, pieces_,
                     tolerance_for(segments_, sides.to, pieces_.lengths), limit, poller) {}

  OneSidedSurfaceDeviation by_parts() {
    return measured([&] {
      const bool has_point =
          std::any_of(sides_.from.begin(), sides_.from.end(),
                      [](const auto& curve) { return curve.points.size() == 1; });
      if (!segments_.empty() && !has_point) {
        measure_by_parts(mesh_, sides_, segments_, distance_, limit_, pieces_, measurement_,
                         poller_);
        return;
      }
      distance_.set(sides_.to);
      measure_at_once(sides_, segments_, measurement_);
    });
  }
  /// Measures with a distance that the caller has set to the other curves.
  OneSidedSurfaceDeviation at_once() {
    return measured([&] { measure_at_once(sides_, segments_, measurement_); });
  }

 private:
  template <class Measure>
  OneSidedSurfaceDeviation measured(const Measure& measure) {
    const ScopedPoller scoped(distance_, poller_);
    try {
      poller_.end_with_budget();
      measure();
      return measurement_.result();
    } catch (const BudgetUsedUp&) {
      return bounded_deviation(mesh_, sides_.from, segments_, sides_.to, measurement_.known(),
                               measurement_.largest());
    }
  }

  const SurfaceMesh& mesh_;
  Sides sides_;
  PolylineDistance& distance_;
  double limit_;
  ProgressPoller& poller_;
  std::vector<CurveSegment> segments_;
  PolylinePieces pieces_;
  Measurement measurement_;
};

}  // namespace

OneSidedSurfaceDeviation one_sided_deviation(const Surface& surface,
                                             std::span<const SurfaceCurve> from,
                                             PolylineDistance& to,
                                             std::span<const SurfaceCurve> to_curves,
                                             const Progress& progress) {
  refuse_nothing(from);
  refuse_nothing(to_curves);
  ProgressPoller poller(progress, kStage);
  const ScopedPoller scoped(to, poller);
  const std::vector<CurveSegment> segments = segments_of(surface, from);
  const PolylinePieces pieces = pieces_of(surface, to_curves);
  Measurement measurement(surface, to, pieces, tolerance_for(segments, to_curves, pieces.lengths),
                          kNoLimit, poller);
  measure_at_once({from, to_curves}, segments, measurement);
  return measurement.result();
}

DeviationMeter::DeviationMeter(const SurfaceMesh& mesh) : mesh_(&mesh) {}
DeviationMeter::~DeviationMeter() = default;

PolylineDistance& DeviationMeter::distance() {
  if (!distance_) distance_ = std::make_unique<PolylineDistance>(mesh_->surface());
  return *distance_;
}

std::vector<bool> DeviationMeter::are_near(std::span<const SurfacePoint> points,
                                           std::span<const double> limits,
                                           const SurfaceCurve& curve) {
  distance().set(std::span(&curve, 1));
  std::vector<bool> near;
  near.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    near.push_back(std::isfinite(distance().below(limits[i], points[i])));
  }
  return near;
}

SurfaceDeviation DeviationMeter::measure(std::span<const SurfaceCurve> result,
                                         std::span<const SurfaceCurve> drawn,
                                         const Progress& progress) {
  return *measure_below(kNoLimit, result, drawn, progress);
}

SurfaceDeviation DeviationMeter::measure(std::span<const SurfaceCurve> result,
                                         std::span<const SurfaceCurve> drawn,
                                         PolylineDistance& to_drawn, const Progress& progress) {
  refuse_nothing(result);
  refuse_nothing(drawn);
  ProgressPoller poller(progress, kStage);
  return {Direction(*mesh_, {result, drawn}, to_drawn, kNoLimit, poller).at_once(),
          Direction(*mesh_, {drawn, result}, distance(), kNoLimit, poller).by_parts()};
}

std::optional<SurfaceDeviation> DeviationMeter::measure_below(double limit,
                                                              std::span<const SurfaceCurve> result,
                                                              std::span<const SurfaceCurve> drawn,
                                                              const Progress& progress) {
  refuse_nothing(result);
  refuse_nothing(drawn);
  ProgressPoller poller(progress, kStage);
  const auto is_beyond = [&](const OneSidedSurfaceDeviation& side) {
    return std::isfinite(limit) && !std::isfinite(side.max);
  };
  const auto to_drawn = Direction(*mesh_, {result, drawn}, distance(), limit, poller).by_parts();
  if (is_beyond(to_drawn)) return std::nullopt;
  const auto from_drawn = Direction(*mesh_, {drawn, result}, distance(), limit, poller).by_parts();
  if (is_beyond(from_drawn)) return std::nullopt;
  return SurfaceDeviation{to_drawn, from_drawn};
}

}  // namespace talweg
