#include "tools/picture/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace talweg::picture {
namespace {

std::size_t bounded(double value, std::size_t size) {
  return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(size)));
}

/// The pixels that a stroke may touch, with the covered part of each.
struct Mask {
  std::size_t left, top, right, bottom;
  std::vector<float> coverage;

  Mask(const Image& image, const std::vector<Spot>& spots, double reach) {
    const auto [a, b] = std::minmax_element(spots.begin(), spots.end());
    const auto [c, d] = std::minmax_element(
        spots.begin(), spots.end(), [](const Spot& p, const Spot& q) { return p[1] < q[1]; });
    left = bounded((*a)[0] - reach, image.width);
    right = bounded((*b)[0] + reach + 1, image.width);
    top = bounded((*c)[1] - reach, image.height);
    bottom = bounded((*d)[1] + reach + 1, image.height);
    coverage.resize((right - left) * (bottom - top));
  }

  void add(const Spot& a, const Spot& b, double radius) {
    const double reach = radius + 1;
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    const std::size_t x_end = bounded(std::max(a[0], b[0]) + reach + 1, right);
    const std::size_t y_end = bounded(std::max(a[1], b[1]) + reach + 1, bottom);
    for (auto y = bounded(std::min(a[1], b[1]) - reach, bottom); y < y_end; ++y) {
      for (auto x = bounded(std::min(a[0], b[0]) - reach, right); x < x_end; ++x) {
        const double px = double(x) + 0.5 - a[0], py = double(y) + 0.5 - a[1];
        const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
        const double distance = std::hypot(px - t * dx, py - t * dy);
        float& covered = coverage[(y - top) * (right - left) + x - left];
        covered = std::max(covered, float(std::clamp(radius + 0.5 - distance, 0.0, 1.0)));
      }
    }
  }
};

void blend(std::uint8_t* rgb, const Light& color, double coverage) {
  const Light below = to_linear({rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0});
  store((1 - coverage) * below + coverage * color, rgb);
}

}  // namespace

void draw_stroke(Image& image, const std::vector<Spot>& spots, double radius, const Light& color) {
  if (spots.size() < 2) return;
  Mask mask(image, spots, radius + 1);
  for (std::size_t k = 0; k + 1 < spots.size(); ++k) mask.add(spots[k], spots[k + 1], radius);
  const float* covered = mask.coverage.data();
  for (std::size_t y = mask.top; y < mask.bottom; ++y) {
    for (std::size_t x = mask.left; x < mask.right; ++x, ++covered) {
      if (*covered > 0) blend(image.pixel(x, y), color, double(*covered));
    }
  }
}

void fill_box(Image& image, const Spot& top_left, const Spot& bottom_right, const Light& color) {
  const std::size_t right = bounded(bottom_right[0], image.width);
  const std::size_t bottom = bounded(bottom_right[1], image.height);
  for (std::size_t y = bounded(top_left[1], image.height); y < bottom; ++y) {
    for (std::size_t x = bounded(top_left[0], image.width); x < right; ++x) {
      store(color, image.pixel(x, y));
    }
  }
}

}  // namespace talweg::picture
