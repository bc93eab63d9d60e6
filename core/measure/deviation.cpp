#include "talweg/core/measure/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kMaxTolerance = 1e-6;
constexpr double kMeanTolerance = 1e-4;
constexpr int kMostHalvings = 40;
constexpr int kMostHalvingsOfMean = 12;

/// The rounding error of distances: a few ulp of the largest coordinate.
double rounding_of(std::span<const Segment> segments) {
  double largest = 0;
  for (const Segment& s : segments) {
    largest = std::max({largest, s.a.cwiseAbs().maxCoeff(), s.b.cwiseAbs().maxCoeff()});
  }
  return 8 * std::numeric_limits<double>::epsilon() * largest;
}

/// A point of a curve and the nearest segment of the other curve.
struct Sample {
  Point point;
  NearestSegment::Result nearest;
};

/// Takes samples of the distance to the other curve, and reports the work to `progress`.
class Samples {
 public:
  Samples(const NearestSegment& to, const Progress& progress)
      : to_(to), poller_(progress, "measure") {}

  Sample at(const Point& p) {
    constexpr std::size_t kWork = 16;
    poller_.add_work(kWork);
    return {p, to_.to(p)};
  }
  [[nodiscard]] const Segment& segment(const Sample& s) const {
    return to_.segments()[s.nearest.segment];
  }

 private:
  const NearestSegment& to_;
  ProgressPoller poller_;
};

class LargestDistance {
 public:
  LargestDistance(Samples& to, double rounding) : to_(to), rounding_(rounding) {}

  void see(const Sample& s) {
    if (s.nearest.distance <= max_) return;
    max_ = s.nearest.distance;
    at_ = s.point;
  }

  /// Searches between two samples for a distance larger than all samples.
  void search(const Sample& a, const Sample& b, int halvings = 0) {
    if (halvings > kMostHalvings || bound(a, b) <= max_ * (1 + kMaxTolerance) + rounding_) return;
    const Sample middle = to_.at(a.point + (b.point - a.point) / 2);
    see(middle);
    search(a, middle, halvings + 1);
    search(middle, b, halvings + 1);
  }

  [[nodiscard]] double max() const { return std::max(max_, 0.0); }
  [[nodiscard]] const Point& at() const { return at_; }

 private:
  [[nodiscard]] double bound(const Sample& a, const Sample& b) const {
    const double by_a = std::max(a.nearest.distance, distance_to(to_.segment(a), b.point));
    const double by_b = std::max(b.nearest.distance, distance_to(to_.segment(b), a.point));
    return std::min(by_a, by_b);
  }

  Samples& to_;
  double rounding_;
  double max_ = -1;
  Point at_ = Point::Zero();
};

class MeanDistance {
 public:
  MeanDistance(Samples& to, double tolerance) : to_(to), tolerance_(tolerance) {}

  /// The mean distance between two points by adaptive Simpson's rule, given the distances at the
  /// ends and in the middle. The error is about `tolerance_`.
  double between(const Point& a, const Point& b, double at_a, double at_middle, double at_b,
                 int halvings = 0) const {
    const Point middle = a + (b - a) / 2;
    const double at_first = to_.at(a + (middle - a) / 2).nearest.distance;
    const double at_second = to_.at(middle + (b - middle) / 2).nearest.distance;
    const double coarse = (at_a + 4 * at_middle + at_b) / 6;
    const double fine = (at_a + 4 * at_first + 2 * at_middle + 4 * at_second + at_b) / 12;
    if (halvings >= kMostHalvingsOfMean || std::abs(fine - coarse) <= tolerance_) return fine;
    return (between(a, middle, at_a, at_first, at_middle, halvings + 1) +
            between(middle, b, at_middle, at_second, at_b, halvings + 1)) /
           2;
  }

 private:
  Samples& to_;
  double tolerance_;
};

}  // namespace

OneSidedDeviation one_sided_deviation(std::span<const Segment> from, const NearestSegment& to,
                                      const Progress& progress) {
  if (from.empty()) throw Error(ErrorCode::kBadCurve, "A curve without points has no deviation.");
  const double rounding = std::max(rounding_of(from), rounding_of(to.segments()));
  if (!std::isfinite(rounding)) {
    throw Error(ErrorCode::kBadCurve, "The curve has a coordinate that is not finite.");
  }

  struct Sampled {
    Sample a;
    Sample middle;
    Sample b;
    double length;
  };
  std::vector<Sampled> sampled;
  sampled.reserve(from.size());
  Samples samples(to, progress);
  LargestDistance largest(samples, rounding);
  double length = 0;
  double integral = 0;
  for (const Segment& s : from) {
    const bool joined = !sampled.empty() && sampled.back().b.point == s.a;
    sampled.push_back({joined ? sampled.back().b : samples.at(s.a),
                       samples.at(s.a + (s.b - s.a) / 2), samples.at(s.b), (s.b - s.a).norm()});
    const Sampled& last = sampled.back();
    for (const Sample& point : {last.a, last.middle, last.b}) largest.see(point);
    length += last.length;
    integral +=
        last.length *
        (last.a.nearest.distance + 4 * last.middle.nearest.distance + last.b.nearest.distance) / 6;
  }
  for (const Sampled& s : sampled) {
    largest.search(s.a, s.middle);
    largest.search(s.middle, s.b);
  }
  OneSidedDeviation result{largest.max(), largest.max(), largest.at()};
  if (!(length > 0)) return result;

  const MeanDistance mean(samples, kMeanTolerance * integral / length + rounding);
  integral = 0;
  for (const Sampled& s : sampled) {
    integral += s.length * mean.between(s.a.point, s.b.point, s.a.nearest.distance,
                                        s.middle.nearest.distance, s.b.nearest.distance);
  }
  result.mean = integral / length;
  return result;
}

Deviation deviation(std::span<const Point> result, bool result_closed, std::span<const Point> drawn,
                    bool drawn_closed, const Progress& progress) {
  const NearestSegment result_tree(segments_of(result, result_closed));
  const NearestSegment drawn_tree(segments_of(drawn, drawn_closed));
  Deviation both;
  both.to_drawn = one_sided_deviation(result_tree.segments(), drawn_tree, progress);
  both.from_drawn = one_sided_deviation(drawn_tree.segments(), result_tree, progress);
  both.at = both.to_drawn.max >= both.from_drawn.max ? both.to_drawn.at : both.from_drawn.at;
  return both;
}

}  // namespace talweg
