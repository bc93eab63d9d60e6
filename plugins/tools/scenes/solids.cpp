#include "tools/scenes/solids.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talweg::scenes {
namespace {

Tube::Ball between(const Tube::Ball& a, const Tube::Ball& b, const Tube::Ball& c,
                   const Tube::Ball& d, double t) {
  const auto cubic = [t](const auto& p, const auto& q, const auto& r, const auto& s) {
    return 0.5 * ((2 * q) + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * (t * t) +
                  (3 * q - p - 3 * r + s) * (t * t * t));
  };
  return {cubic(a.center, b.center, c.center, d.center),
          cubic(a.radius, b.radius, c.radius, d.radius)};
}

}  // namespace

double smooth_union(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - 0.25 * h * h * k;
}

Tube::Tube(const std::vector<Ball>& balls, int steps)
    : low_(Point::Constant(std::numeric_limits<double>::max())), high_(-low_) {
  for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
    const Ball& before = balls[i == 0 ? 0 : i - 1];
    const Ball& after = balls[std::min(i + 2, balls.size() - 1)];
    for (int k = 0; k < steps; ++k) {
      chain_.push_back(between(before, balls[i], balls[i + 1], after, double(k) / steps));
    }
  }
  chain_.push_back(balls.back());
  for (const Ball& b : chain_) {
    low_ = low_.cwiseMin(b.center - Point::Constant(b.radius));
    high_ = high_.cwiseMax(b.center + Point::Constant(b.radius));
  }
}

double Tube::operator()(const Point& p) const {
  const double away = (low_ - p).cwiseMax(p - high_).cwiseMax(0.0).norm();
  if (away > 0.2) return away;  // beyond the rounding of any seam
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < chain_.size(); ++i) {
    const Point d = chain_[i + 1].center - chain_[i].center;
    const double t = std::clamp((p - chain_[i].center).dot(d) / d.squaredNorm(), 0.0, 1.0);
    const double radius = chain_[i].radius + t * (chain_[i + 1].radius - chain_[i].radius);
    nearest = std::min(nearest, (p - chain_[i].center - t * d).norm() - radius);
  }
  return nearest;
}

double ellipsoid(const Point& p, const Point& center, const Point& radii) {
  const Point q = p - center;
  const double first = q.cwiseQuotient(radii).norm();
  const double second = q.cwiseQuotient(radii.cwiseProduct(radii)).norm();
  return second > 0 ? first * (first - 1) / second : -radii.minCoeff();
}

}  // namespace talweg::scenes
