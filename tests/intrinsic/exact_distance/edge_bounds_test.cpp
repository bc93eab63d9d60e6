#include "talweg/intrinsic/exact_distance/edge_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace talweg {
namespace {

EdgeWindow random_window(std::mt19937_64& random, double length) {
  std::uniform_real_distribution<double> part(0, 1);
  EdgeWindow window;
  window.begin = length * part(random);
  window.end = std::min(length, window.begin + length * std::pow(part(random), 4));
  window.px = length * (1.5 * part(random) - 0.25);
  window.py = -length * part(random) / 4;
  window.offset = length * part(random) / 4;
  return window;
}

/// The shortest distance to a place by any of the windows. A way may continue along the edge.
double shortest(const std::vector<EdgeWindow>& windows, double x) {
  double least = std::numeric_limits<double>::infinity();
  for (const EdgeWindow& w : windows) {
    const double bend = std::clamp(x, w.begin, w.end);
    least = std::min(least, w.value(bend) + std::abs(x - bend));
  }
  return least;
}

TEST(EdgeBounds, RuleOutOnlyPlacesWithAShorterKnownWay) {
  std::mt19937_64 random(7);
  double whole = 0, left = 0;
  for (int run = 0; run < 200; ++run) {
    SCOPED_TRACE(run);
    const double length = std::pow(10, run % 7 - 3);
    EdgeBounds bounds(length, std::size_t{1} << (run % 9));
    std::vector<EdgeWindow> windows;
    for (int k = 0; k < 40; ++k) {
      const EdgeWindow window = random_window(random, length);
      std::size_t visited = 0;
      const auto [begin, end] = bounds.not_longer(window, 1e-12 * length, visited);
      EXPECT_GT(visited, 0U);
      for (int i = 0; i <= 50; ++i) {
        const double along = window.begin + (window.end - window.begin) * i / 50;
        const double x = std::min(along, window.end);
        if (x >= begin && x <= end) continue;
        EXPECT_GE(window.value(x), shortest(windows, x) * (1 - 1e-12)) << x / length;
      }
      whole += (window.end - window.begin) / length;
      left += std::max(0.0, end - begin) / length;
      windows.push_back(window);
      bounds.add(window);
    }
  }
  EXPECT_LT(left, 0.6 * whole);  // the bounds rule out a good part
}

TEST(EdgeBounds, KeepTheWholeWindowAtFirst) {
  const EdgeBounds bounds(2, 8);
  EdgeWindow window;
  window.begin = 0.3;
  window.end = 1.9;
  window.py = -1;
  std::size_t visited = 0;
  const auto [begin, end] = bounds.not_longer(window, 0, visited);
  EXPECT_EQ(begin, 0.3);
  EXPECT_EQ(end, 1.9);
}

}  // namespace
}  // namespace talweg
