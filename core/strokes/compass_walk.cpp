#include "talweg/core/strokes/compass_walk.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace talweg {
namespace {

class Walker {
 public:
  Walker(std::span<const Point> points, bool closed, double step)
      : points_(points),
        segments_(points.empty() ? 0
                  : closed       ? points.size()
                                 : points.size() - 1),
        step_(step) {}

  [[nodiscard]] PolylinePlace first() const { return {0, 0, points_[0]}; }
  [[nodiscard]] PolylinePlace last() const {
    return {segments_ - 1, 1, points_[segments_ % points_.size()]};
  }

  [[nodiscard]] std::optional<PolylinePlace> next(const PolylinePlace& from, bool rejoining) const {
    std::optional<PolylinePlace> way_out = exit(from, from.at, step_);
    if (!way_out || !rejoining) return way_out;
    const std::optional<PolylinePlace> far = exit(*way_out, from.at, 2 * step_);
    return last_exit(*way_out, far ? far->segment : segments_ - 1, from.at);
  }

 private:
  [[nodiscard]] const Point& end_of(std::size_t segment) const {
    return points_[(segment + 1) % points_.size()];
  }

  /// The place at which a segment leaves the ball, at part `from` or later; none if it stays inside
  /// or left before.
  [[nodiscard]] std::optional<PolylinePlace> exit_on(std::size_t segment, double from,
                                                     const Point& centre, double radius) const {
    const Point &a = points_[segment], &b = end_of(segment);
    if (!((b - centre).norm() > radius)) return std::nullopt;
    const Point along = b - a, off = a - centre;
    const double squared = along.squaredNorm(), half = along.dot(off);
    const double root = half * half - squared * (off.squaredNorm() - radius * radius);
    if (!(squared > 0) || !(root >= 0)) return std::nullopt;
    const double part = std::min((std::sqrt(root) - half) / squared, 1.0);
    if (part < from) return std::nullopt;
    return PolylinePlace{segment, part, a + part * along};
  }

  /// The first place after `from` at which the polyline leaves the ball.
  [[nodiscard]] std::optional<PolylinePlace> exit(const PolylinePlace& from, const Point& centre,
                                                  double radius) const {
    for (std::size_t k = from.segment; k < segments_; ++k) {
      if (auto place = exit_on(k, k == from.segment ? from.part : 0, centre, radius)) return place;
    }
    return std::nullopt;
  }

  /// The last place at which the polyline leaves the ball of one step, up to segment `last`.
  [[nodiscard]] PolylinePlace last_exit(const PolylinePlace& first, std::size_t last,
                                        const Point& centre) const {
    for (std::size_t k = last; k > first.segment; --k) {
      if (auto place = exit_on(k, 0, centre, step_)) {
        if ((points_[k] - centre).norm() <= step_) return *place;
      }
    }
    return first;
  }

  std::span<const Point> points_;
  std::size_t segments_;
  double step_;
};

}  // namespace

double walkable_step(std::span<const Point> points, bool closed, double step) {
  constexpr std::size_t kMost = 4096, kMostOfPoint = 16;
  constexpr double kRounding = 1e-14;  // as part of the largest coordinate
  const std::size_t n = points.size();
  double length = 0, size = 0;
  for (std::size_t k = 0; k < n; ++k) {
    size = std::max(size, points[k].lpNorm<Eigen::Infinity>());
    if (closed || k + 1 < n) length += (points[(k + 1) % n] - points[k]).norm();
  }
  return std::max({step, length / static_cast<double>(kMost + kMostOfPoint * n), kRounding * size});
}

std::vector<PolylinePlace> compass_walk(std::span<const Point> points, bool closed, double step,
                                        bool rejoining) {
  const Walker walker(points, closed, step);
  std::vector<PolylinePlace> places{walker.first()};
  while (const auto place = walker.next(places.back(), rejoining)) places.push_back(*place);
  const PolylinePlace last = walker.last();
  while (places.size() > 1 && (places.back().at - last.at).norm() < step / 2) places.pop_back();
  if (!closed) places.push_back(last);
  return places;
}

}  // namespace talweg
