#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tools/scenes/isosurface.hpp"
#include "tools/scenes/noise.hpp"
#include "tools/scenes/random.hpp"
#include "tools/scenes/relaxation.hpp"
#include "tools/scenes/scenes.hpp"
#include "tools/scenes/solids.hpp"

namespace talweg::scenes {
namespace {

Point noises(const Point& p, std::uint64_t seed) {
  return {noise(p, seed), noise(p, seed + 1), noise(p, seed + 2)};
}

// Grooves along the zeros of smooth noise.
double grooves(const Point& p) {
  const Point bent = p + 0.16 * noises(2.1 * p, 311);
  const double deep = noise(2.7 * bent, 331) / 0.22, small = noise(4.6 * bent, 337) / 0.26;
  return 0.10 * std::exp(-deep * deep) + 0.04 * std::exp(-small * small);
}

// One half of a brain, x to its side, z to the front.
Field cortex() {
  return [](const Point& p) {
    double d = ellipsoid(p, {0.10, 0, 0}, {0.72, 0.80, 1.12});
    d = smooth_union(d, ellipsoid(p, {0.34, -0.46, 0.30}, {0.32, 0.28, 0.66}), 0.14);
    const double other_half = p.x() - 0.02;  // negative inside
    return -smooth_union(-d, other_half, 0.16) + grooves(p);
  };
}

}  // namespace

DemoScene cortex_scene() {
  DemoScene scene;
  scene.name = "cortex";
  const Field field = cortex();
  const double cell = 0.05;
  scene.mesh = isosurface(field, {-0.3, -1.1, -1.4}, {1.1, 1.1, 1.4}, cell);
  relax(scene.mesh, field, cell, 5);
  return scene;
}

std::vector<int> cortex_parcels(const MeshLists& cortex) {
  // Each face belongs to the nearest of some places, measured in a distorted space.
  constexpr std::size_t kParcels = 26;
  Random random(53);
  std::vector<Point> places;
  for (int tries = 0; places.size() < kParcels && tries < 100000; ++tries) {  // at a minimum
                                                                              // distance from each
                                                                              // other
    const auto v =
        static_cast<std::size_t>(random.unit() * static_cast<double>(cortex.points.size()));
    const bool near = std::any_of(places.begin(), places.end(), [&](const Point& other) {
      return (cortex.points[v] - other).norm() < 0.3;
    });
    if (!near) places.push_back(cortex.points[v]);
  }
  std::vector<int> labels;
  labels.reserve(cortex.triangles.size());
  for (const auto& [a, b, c] : cortex.triangles) {
    const Point middle = (cortex.points[a] + cortex.points[b] + cortex.points[c]) / 3;
    const Point p = middle + 0.10 * noises(3.5 * middle, 401);
    const auto nearest =
        std::min_element(places.begin(), places.end(), [&p](const Point& q, const Point& r) {
          return (p - q).squaredNorm() < (p - r).squaredNorm();
        });
    labels.push_back(1 + static_cast<int>(nearest - places.begin()));
  }
  return labels;
}

}  // namespace talweg::scenes
