#include "talweg/core/smoothing/curve_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

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

/// Per curve the numbers of the points that other curves pass, too; ascending.
std::vector<Numbers> common_points(std::span<const SurfaceCurve> curves) {
  constexpr std::uint32_t kCommon = UINT32_MAX;
  PointLookup lookup;
  std::vector<std::uint32_t> owner;  // by the number of the first equal point
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

SpaceBox box_of(const Segment& s) { return SpaceBox{s.a, s.a}.with({s.b, s.b}); }

double distance_between(const SpaceBox& a, const SpaceBox& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).norm();
}

class GapSearch {
 public:
  GapSearch(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves, double limit,
            Asker& asker)
      : mesh_(&mesh),
        curves_(curves),
        set_(mesh, curves),
        common_(common_points(curves)),
        limit_(limit),
        asker_(&asker),
        gaps_(curves.size(), HUGE_VAL) {}

  /// Around each curve as far as its gap, which is not known: twice as far each time.
  std::vector<double> gaps() {
    constexpr double kFirst = 1.0 / 64;  // of the limit
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
  /// Segments of two curves whose boxes are near each other.
  struct Near {
    std::uint32_t other, own_segment, other_segment;
  };

  struct Other {
    double at_least;  ///< how far their boxes are apart
    std::span<const Near> near;
  };

  void look_around(std::uint32_t curve, double radius) {
    for (const Other& other : others_near(curve, std::min(radius, gaps_[curve]))) {
      const double most = std::min(radius, gaps_[curve]);
      if (other.at_least >= most) break;
      const double apart = gap(curve, other.near, most);
      if (!(apart < most) || apart <= 1e-9 * limit_) continue;
      gaps_[curve] = apart;
      double& gap_of_other = gaps_[other.near.front().other];
      gap_of_other = std::min(gap_of_other, apart);
    }
  }

  /// Those that do not touch the curve, the nearest first. Refers to near_.
  std::vector<Other> others_near(std::uint32_t curve, double reach) {
    set_near(curve, reach);
    std::vector<Other> others;
    for (std::size_t i = 0, end = 0; i < near_.size(); i = end) {
      double at_least = HUGE_VAL;
      for (; end < near_.size() && near_[end].other == near_[i].other; ++end) {
        const double apart = distance_between(box_of(set_.segment(near_[end].own_segment)),
                                              box_of(set_.segment(near_[end].other_segment)));
        at_least = std::min(at_least, apart);
      }
      if (have_common(common_[curve], common_[near_[i].other])) continue;
      others.push_back({at_least, std::span(near_).subspan(i, end - i)});
    }
    std::stable_sort(others.begin(), others.end(),
                     [](const Other& a, const Other& b) { return a.at_least < b.at_least; });
    return others;
  }

  void set_near(std::uint32_t curve, double reach) {
    constexpr std::size_t kOfSegment = 16;  // units of work
    near_.clear();
    for (std::uint32_t s = set_.first(curve); s < set_.first(curve + 1); ++s) {
      asker_->did(kOfSegment);
      const SpaceBox box = box_of(set_.segment(s));
      const Point margin = Point::Constant(reach);
      set_.tree().visit_near({box.low - margin, box.high + margin}, [&](std::uint32_t t) {
        asker_->did(1);
        const std::uint32_t other = set_.curve_of(t);
        if (other != curve) near_.push_back({other, s, t});
      });
    }
    std::stable_sort(near_.begin(), near_.end(),
                     [](const Near& a, const Near& b) { return a.other < b.other; });
  }

  double gap(std::uint32_t curve, std::span<const Near> near, double most) {
    Numbers own, others;
    for (const Near& n : near) {
      own.push_back(n.own_segment);
      others.push_back(n.other_segment);
    }
    sort_numbers(own);
    sort_numbers(others);
    const std::uint32_t other = near.front().other;
    std::vector<NearPoint> points;
    for (const Near& n : near) add_ends(n.own_segment, n.other_segment, curve, points);
    const double there = least_of(points, curve, others, most);
    points.clear();
    for (const Near& n : near) add_ends(n.other_segment, n.own_segment, other, points);
    return std::min(there, least_of(points, other, own, std::min(most, there)));
  }

  struct NearPoint {
    double through_space;
    std::uint32_t point;
  };

  void add_ends(std::uint32_t segment, std::uint32_t to, std::uint32_t curve,
                std::vector<NearPoint>& points) const {
    for (const std::uint32_t end : set_.ends(segment)) {
      const Point at = mesh_->position(curves_[curve].points[end]);
      points.push_back({distance_to(set_.segment(to), at), end});
    }
  }

  /// From points of a curve to segments of another, if it is below `most`. The points that are
  /// nearest in space come first, so the distance is needed only up to the smallest found so far.
  double least_of(std::vector<NearPoint>& points, std::uint32_t curve, const Numbers& segments,
                  double most) {
    std::erase_if(points, [&](const NearPoint& p) { return !(p.through_space < most); });
    if (points.empty()) return HUGE_VAL;
    std::sort(points.begin(), points.end(), [](const NearPoint& a, const NearPoint& b) {
      return a.through_space != b.through_space ? a.through_space < b.through_space
                                                : a.point < b.point;
    });
    if (!distance_) distance_.emplace(mesh_->surface());
    const AskedDuring asked(*distance_, *asker_);
    distance_->set(set_.as_curves(segments));
    double least = HUGE_VAL;
    std::vector<bool> seen;
    for (const NearPoint& p : points) {
      if (p.through_space >= least) break;
      if (p.point >= seen.size()) seen.resize(p.point + 1, false);
      if (seen[p.point]) continue;
      seen[p.point] = true;
      least =
          std::min(least, distance_->below(std::min(most, least), curves_[curve].points[p.point]));
    }
    return least;
  }

  const SurfaceMesh* mesh_;
  std::span<const SurfaceCurve> curves_;
  SegmentsInSpace set_;
  std::vector<Numbers> common_;
  double limit_;
  Asker* asker_;
  std::vector<double> gaps_;
  std::vector<Near> near_;
  std::optional<PolylineDistance> distance_;
};

}  // namespace

std::vector<double> gaps_to_others(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                   double limit, const Progress& progress) {
  Asker asker(progress, "solve");
  if (curves.size() < 2) return std::vector<double>(curves.size(), HUGE_VAL);
  return GapSearch(mesh, curves, limit, asker).gaps();
}

}  // namespace talweg
