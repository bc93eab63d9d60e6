#include "tools/picture/ambient_occlusion.hpp"

#include <algorithm>
#include <cmath>

namespace talweg::picture {
namespace {

// The mean over 4 x 4 pixels, the period of the pattern of directions.
std::vector<float> blurred(const std::vector<float>& values, std::size_t width,
                           std::size_t height) {
  std::vector<float> result(values.size());
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      float sum = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
          const std::size_t u = std::min(width - 1, x + i - std::min<std::size_t>(x + i, 2));
          const std::size_t v = std::min(height - 1, y + j - std::min<std::size_t>(y + j, 2));
          sum += values[v * width + u];
        }
      }
      result[y * width + x] = sum / 16;
    }
  }
  return result;
}

}  // namespace

std::vector<float> openness(const SampleBuffer& buffer, std::size_t samples, double reach) {
  const std::size_t width = buffer.width() / samples, height = buffer.height() / samples;
  const auto depth = [&](double x, double y) {
    const double i = std::clamp(x, 0.0, double(width) - 1),
                 j = std::clamp(y, 0.0, double(height) - 1);
    return double(buffer.depth(std::size_t(i) * samples + samples / 2,
                               std::size_t(j) * samples + samples / 2));
  };
  std::vector<float> open(width * height, 1);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const double here = depth(double(x), double(y));
      if (!std::isfinite(here)) continue;
      double hidden = 0;
      const double turn = 0.4 * double((x % 4) * 4 + y % 4);  // rotated within each 4 x 4 block
      for (int k = 0; k < 16; ++k) {
        const double angle = turn + 2.39996323 * k, far = reach * std::sqrt((k + 0.5) / 16);
        const double dx = far * std::cos(angle), dy = far * std::sin(angle);
        // Opposite neighbours are taken together, so that a valley is darkened and a slope is not.
        const double one = (depth(double(x) + dx, double(y) + dy) - here) / double(samples);
        const double two = (depth(double(x) - dx, double(y) - dy) - here) / double(samples);
        const double rise =
            std::clamp(0.5 * (std::max(one, -2 * far) + std::max(two, -2 * far)) / far, 0.0, 1.0);
        const bool far_in_front = std::max(one, two) > 4 * reach;
        hidden += far_in_front ? 0.3 * rise : rise;
      }
      open[y * width + x] = static_cast<float>(1 - std::min(0.85, 1.15 * hidden / 16));
    }
  }
  return blurred(open, width, height);
}

}  // namespace talweg::picture
