#include "talweg/core/smoothing/curve_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "talweg/core/measure/segments_in_space.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/surface/point_lookup.hpp"

namespace talweg {
namespace {

using Numbers = std::vector<std::uint32_t>;

void sort_numbers(Numbers& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Per curve, the points that other curves pass, too, by number, ascending.
std::vector<Numbers> common_points(std::span<const SurfaceCurve> curves) {
  constexpr std::uint32_t kCommon = UINT32_MAX;
  PointLookup lookup;
  std::vector<std::uint32_t> owner;  // the curve with the point, or kCommon; by point number
  std::vector<Numbers> passed(curves.size());
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    for (const SurfacePoint& point : curves[c].points) {
      lookup.add(point);
      owner.push_back(c);
      const auto first = static_cast<std::uint32_t>(*lookup.find(point));
      passed[c].push_back(first);
      if (owner[first] != c) owner[first] = kCommon;
    }
  }
  for (Numbers& numbers : passed) {
    std::erase_if(numbers, [&](std::uint32_t point) { return owner[point] != kCommon; });
    sort_numbers(numbers);
  }
  return passed;
}

bool have_common(const Numbers& a, const Numbers& b) {
  auto p = a.begin();
  auto q = b.begin();
  while (p != a.end() && q != b.end()) {
    if (*p == *q) return true;
    *p < *q ? ++p : ++q;
  }
  return false;
}

SpaceBox widened(const SpaceBox& box, double reach) {
  const Point margin = Point::Constant(reach);
  return {box.low - margin, box.high + margin};
}

class GapSearch {
 public:
  GapSearch(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves, double limit,
            ProgressPoller& poller)
      : mesh_(&mesh),
        curves_(curves),
        common_(common_points(curves)),
        limit_(limit),
        poller_(&poller),
        gaps_(curves.size(), HUGE_VAL) {
    for (const SurfaceCurve& curve : curves) {
      boxes_.push_back(SpaceBox::around(positions_of(mesh, curve)));
      segments_.emplace_back(mesh, std::span(&curve, 1));
    }
    tree_.emplace(boxes_.size(), [&](std::uint32_t i) { return boxes_[i]; });
  }

  /// Searches around each curve with a radius that doubles until it exceeds the gap.
  std::vector<double> gaps() {
    constexpr double kFirst = 1.0 / 64;  // times the limit
    std::vector<bool> known(gaps_.size(), false);
    for (double radius = kFirst * limit_;; radius = std::min(2 * radius, limit_)) {
      for (std::uint32_t c = 0; c < gaps_.size(); ++c) {
        if (known[c]) continue;
        look_around(c, radius);
        known[c] = gaps_[c] < radius;
      }
      if (radius >= limit_) break;
    }
    return std::move(gaps_);
  }

 private:
  void look_around(std::uint32_t curve, double radius) {
    std::vector<std::pair<double, std::uint32_t>> others;  // with the distances between boxes
    const auto box_of = [&](std::uint32_t i) { return boxes_[i]; };
    tree_->visit(widened(boxes_[curve], radius), box_of, [&](std::uint32_t other) {
      poller_->add_work(1);
      if (other != curve) others.emplace_back(distance_between(curve, other), other);
    });
    std::sort(others.begin(), others.end());
    for (const auto& [at_least, other] : others) {
      if (at_least < std::max(gaps_[curve], gaps_[other])) measure(curve, other);
    }
  }

  [[nodiscard]] double distance_between(std::uint32_t a, std::uint32_t b) const {
    const SpaceBox &p = boxes_[a], &q = boxes_[b];
    return (p.low - q.high).cwiseMax(q.low - p.high).cwiseMax(0.0).norm();
  }

  /// Measures the gap between two curves, once per pair.
  void measure(std::uint32_t a, std::uint32_t b) {
    if (!measured_.insert(std::uint64_t{std::min(a, b)} << 32U | std::max(a, b)).second) return;
    if (have_common(common_[a], common_[b])) return;
    const double most = std::min(limit_, std::max(gaps_[a], gaps_[b]));
    const double there = least_of(a, b, most);
    const double apart = std::min(there, least_of(b, a, std::min(most, there)));
    if (!(apart < most) || apart <= 1e-9 * limit_) return;
    gaps_[a] = std::min(gaps_[a], apart);
    gaps_[b] = std::min(gaps_[b], apart);
  }

  struct NearPoint {
    double through_space;
    std::uint32_t point;
    auto operator<=>(const NearPoint&) const = default;
  };

  /// The least distance from the points of a curve to another curve, if below `most`. The points
  /// are visited by their distance in space, so the distance along the surface is needed only up to
  /// the least found so far.
  double least_of(std::uint32_t from, std::uint32_t to, double most) {
    const std::vector<NearPoint> points = points_near(from, to, most);
    if (points.empty()) return HUGE_VAL;
    if (!distance_) distance_.emplace(mesh_->surface());
    const ScopedPoller scoped(*distance_, *poller_);
    distance_->set(segments_[to].as_curves(segments_near(to, from, most)));
    double least = HUGE_VAL;
    for (const NearPoint& p : points) {
      if (p.through_space >= least) break;
      least =
          std::min(least, distance_->below(std::min(most, least), curves_[from].points[p.point]));
    }
    return least;
  }

  /// The points of a curve that are nearer in space than `most` to another curve, the nearest
  /// first.
  [[nodiscard]] std::vector<NearPoint> points_near(std::uint32_t curve, std::uint32_t other,
                                                   double most) const {
    Numbers ends;
    for (const std::uint32_t segment : segments_beside(curve, other, most)) {
      for (const std::uint32_t end : segments_[curve].ends(segment)) ends.push_back(end);
    }
    sort_numbers(ends);
    std::vector<NearPoint> near;
    for (const std::uint32_t end : ends) {
      const double distance = to_curve(other, mesh_->position(curves_[curve].points[end]));
      if (distance < most) near.push_back({distance, end});
    }
    std::sort(near.begin(), near.end());
    return near;
  }

  /// The segments of a curve that may be nearer than `most` to a point of the other curve,
  /// ascending.
  [[nodiscard]] Numbers segments_near(std::uint32_t curve, std::uint32_t other, double most) const {
    Numbers near = segments_beside(curve, other, most);
    std::erase_if(near, [&](std::uint32_t i) {
      const Segment& s = segments_[curve].segment(i);
      return to_curve(other, s.a) >= most + (s.b - s.a).norm();
    });
    return near;
  }

  /// The segments of a curve whose boxes are nearer than `most` to the box of the other curve,
  /// ascending.
  [[nodiscard]] Numbers segments_beside(std::uint32_t curve, std::uint32_t other,
                                        double most) const {
    Numbers beside;
    segments_[curve].tree().visit_near(widened(boxes_[other], most),
                                       [&](std::uint32_t i) { beside.push_back(i); });
    std::sort(beside.begin(), beside.end());
    return beside;
  }

  [[nodiscard]] double to_curve(std::uint32_t curve, const Point& at) const {
    constexpr std::size_t kOfPoint = 16;  // units of work
    poller_->add_work(kOfPoint);
    return segments_[curve].tree().to(at).distance;
  }

  const SurfaceMesh* mesh_;
  std::span<const SurfaceCurve> curves_;
  std::vector<Numbers> common_;
  double limit_;
  ProgressPoller* poller_;
  std::vector<double> gaps_;
  std::unordered_set<std::uint64_t> measured_;  // pairs of curves
  std::vector<SpaceBox> boxes_;                 // per curve
  std::deque<SegmentsInSpace> segments_;        // per curve; a deque does not move them
  std::optional<BoxTree> tree_;                 // of the curves' boxes
  std::optional<PolylineDistance> distance_;
};

}  // namespace

std::vector<double> gaps_to_others(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                   double limit, const Progress& progress) {
  ProgressPoller poller(progress, "solve");
  if (curves.size() < 2) return std::vector<double>(curves.size(), HUGE_VAL);
  return GapSearch(mesh, curves, limit, poller).gaps();
}

}  // namespace talweg
