#include <cmath>
#include <numbers>

#include "tools/scenes/isosurface.hpp"
#include "tools/scenes/noise.hpp"
#include "tools/scenes/random.hpp"
#include "tools/scenes/relaxation.hpp"
#include "tools/scenes/scenes.hpp"
#include "tools/scenes/solids.hpp"

namespace talweg::scenes {
namespace {

// The lower end of a thigh bone, y along the shaft, z to the front.
Field bone() {
  const Tube shaft({{{0.02, 2.05, -0.10}, 0.36},
                    {{0.02, 1.20, -0.02}, 0.34},
                    {{0.00, 0.55, 0.02}, 0.40},
                    {{0.00, 0.10, 0.00}, 0.55}});
  const Tube inner({{{-0.40, -0.05, 0.28}, 0.36},
                    {{-0.46, -0.28, 0.0}, 0.44},
                    {{-0.46, -0.16, -0.42}, 0.38},
                    {{-0.42, 0.10, -0.60}, 0.26}});
  const Tube outer({{{0.42, -0.02, 0.34}, 0.37},
                    {{0.47, -0.24, 0.02}, 0.42},
                    {{0.47, -0.14, -0.40}, 0.37},
                    {{0.42, 0.12, -0.56}, 0.25}});
  return [=](const Point& p) {
    double d = smooth_union(shaft(p), smooth_union(inner(p), outer(p), 0.10), 0.30);
    d = smooth_union(d, ellipsoid(p, {-0.72, 0.16, -0.02}, {0.16, 0.26, 0.22}), 0.16);
    d = smooth_union(d, ellipsoid(p, {0.72, 0.14, -0.02}, {0.14, 0.22, 0.20}), 0.16);
    d = smooth_union(d, ellipsoid(p, {0.02, 0.08, 0.36}, {0.42, 0.30, 0.14}), 0.14);
    return d + 0.014 * fractal_noise(3.1 * p, 2, 211) + 0.005 * noise(15 * p, 223);
  };
}

}  // namespace

DemoScene bone_scene() {
  DemoScene scene;
  scene.name = "bone";
  const Field field = bone();
  const double cell = 0.042;
  scene.mesh = isosurface(field, {-1.2, -0.95, -1.3}, {1.2, 2.0, 1.1}, cell);
  relax(scene.mesh, field, cell, 5);
  // Around the bone above its two knuckles, a little inclined, by an unsteady hand.
  Random hand(41);
  std::vector<Point> places;
  constexpr int kCount = 30;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * (i + hand.in(-0.2, 0.2)) / kCount;
    const Point outwards(std::sin(angle), 0, std::cos(angle));
    const Point axis(0, 0.50 + 0.06 * std::cos(angle) + hand.in(-0.035, 0.035), 0);
    double t = 0;
    while (t < 2 && field(axis + t * outwards) < 0) t += 0.004;
    places.push_back(axis + t * outwards);
  }
  scene.through = nearest_vertices(scene.mesh, places, true);
  return scene;
}

}  // namespace talweg::scenes
