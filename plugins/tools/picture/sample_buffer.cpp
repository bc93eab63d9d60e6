#include "tools/picture/sample_buffer.hpp"

#include <algorithm>
#include <cmath>

namespace talweg::picture {
namespace {

struct Range {
  std::size_t begin = 0, end = 0;
};

// The range of samples whose centres lie in [low, high].
Range samples_between(double low, double high, std::size_t size) {
  const auto limit = static_cast<double>(size);
  const double begin = std::clamp(std::ceil(low - 0.5), 0.0, limit);
  const double end = std::clamp(std::floor(high - 0.5) + 1, 0.0, limit);
  return {static_cast<std::size_t>(begin), static_cast<std::size_t>(std::max(begin, end))};
}

}  // namespace

void SampleBuffer::draw_triangle(std::uint32_t id, const Point& a, const Point& b, const Point& c) {
  const Range ys =
      samples_between(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}), height_);
  const Range xs =
      samples_between(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}), width_);
  if (ys.begin == ys.end || xs.begin == xs.end) return;
  const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  if (area == 0) return;
  const double inverse = 1 / area;
  // Barycentrics of b and c as linear functions of the raster.
  const double bx = (c.y() - a.y()) * inverse, by = -(c.x() - a.x()) * inverse;
  const double cx = -(b.y() - a.y()) * inverse, cy = (b.x() - a.x()) * inverse;
  for (std::size_t y = ys.begin; y < ys.end; ++y) {
    const double dy = static_cast<double>(y) + 0.5 - a.y();
    for (std::size_t x = xs.begin; x < xs.end; ++x) {
      const double dx = static_cast<double>(x) + 0.5 - a.x();
      const double beta = bx * dx + by * dy, gamma = cx * dx + cy * dy;
      if (beta < 0 || gamma < 0 || beta + gamma > 1) continue;
      put(x, y, a.z() + beta * (b.z() - a.z()) + gamma * (c.z() - a.z()), id);
    }
  }
}

void SampleBuffer::draw_tube(std::uint32_t id, const Point& a, const Point& b, double radius,
                             double lift) {
  const Range ys =
      samples_between(std::min(a.y(), b.y()) - radius, std::max(a.y(), b.y()) + radius, height_);
  const Range xs =
      samples_between(std::min(a.x(), b.x()) - radius, std::max(a.x(), b.x()) + radius, width_);
  const Point d = b - a;
  const double square = d.x() * d.x() + d.y() * d.y();
  for (std::size_t y = ys.begin; y < ys.end; ++y) {
    const double dy = static_cast<double>(y) + 0.5 - a.y();
    for (std::size_t x = xs.begin; x < xs.end; ++x) {
      const double dx = static_cast<double>(x) + 0.5 - a.x();
      const double t = square > 0 ? std::clamp((dx * d.x() + dy * d.y()) / square, 0.0, 1.0) : 0.0;
      const double away_x = dx - t * d.x(), away_y = dy - t * d.y();
      const double rest = radius * radius - away_x * away_x - away_y * away_y;
      if (rest < 0) continue;
      const double rise = std::sqrt(rest);
      put(x, y, a.z() + t * d.z() + rise + lift,
          id + static_cast<std::uint32_t>(255 * std::min(1.0, rise / radius)));
    }
  }
}

}  // namespace talweg::picture
