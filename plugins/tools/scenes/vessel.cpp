#include "tools/scenes/vessel.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "tools/scenes/isosurface.hpp"
#include "tools/scenes/noise.hpp"
#include "tools/scenes/random.hpp"
#include "tools/scenes/relaxation.hpp"
#include "tools/scenes/scenes.hpp"
#include "tools/scenes/solids.hpp"

namespace talweg::scenes {
namespace {

const Point kNeck(0.05, 0.36, 0.05);  // centre of the aneurysm's neck
const Point kDome(0.20, 0.86, 0.18);  // centre of the aneurysm

// Lengths are about centimetres: a parent vessel from below, two branches, and an aneurysm on the
// fork.
Field vessel() {
  const Tube parent({{{0.28, -1.75, -0.10}, 0.215},
                     {{0.10, -1.35, 0.02}, 0.22},
                     {{-0.22, -0.90, 0.10}, 0.215},
                     {{-0.16, -0.42, 0.02}, 0.21},
                     {{0.00, 0.06, 0.00}, 0.225}});
  const Tube left({{{0.00, 0.02, 0.00}, 0.20},
                   {{-0.34, 0.30, -0.02}, 0.16},
                   {{-0.80, 0.38, 0.06}, 0.145},
                   {{-1.10, 0.72, 0.02}, 0.14},
                   {{-1.08, 1.20, -0.12}, 0.13},
                   {{-1.30, 1.75, -0.18}, 0.125}});
  const Tube right({{{0.00, 0.02, 0.00}, 0.20},
                    {{0.36, 0.16, -0.10}, 0.165},
                    {{0.80, 0.14, -0.16}, 0.15},
                    {{1.15, 0.40, -0.10}, 0.14},
                    {{1.25, 0.86, 0.02}, 0.13},
                    {{1.05, 1.30, 0.04}, 0.125},
                    {{1.16, 1.75, 0.00}, 0.12}});
  const Tube small({{{-0.20, -0.78, 0.12}, 0.09},
                    {{-0.52, -0.72, 0.22}, 0.072},
                    {{-0.82, -0.92, 0.18}, 0.066},
                    {{-1.20, -0.88, 0.05}, 0.06},
                    {{-1.60, -1.02, 0.02}, 0.055}});
  const Tube twig({{{0.80, 0.14, -0.16}, 0.08},
                   {{1.00, -0.14, -0.06}, 0.062},
                   {{1.30, -0.30, 0.04}, 0.056},
                   {{1.65, -0.26, 0.02}, 0.052}});
  const Tube neck({{{0.00, 0.10, 0.00}, 0.16}, {kNeck, 0.20}, {{0.12, 0.60, 0.11}, 0.26}});
  return [=](const Point& p) {
    double d = smooth_union(parent(p), smooth_union(left(p), right(p), 0.10), 0.14);
    d = smooth_union(d, small(p), 0.08);
    d = smooth_union(d, twig(p), 0.07);
    double sac = ellipsoid(p, kDome, {0.40, 0.36, 0.38});
    sac = smooth_union(sac, ellipsoid(p, {0.47, 1.10, 0.30}, {0.19, 0.18, 0.18}), 0.10);
    sac = smooth_union(sac, ellipsoid(p, {-0.06, 1.08, 0.32}, {0.15, 0.14, 0.15}), 0.10);
    d = smooth_union(d, smooth_union(neck(p), sac, 0.12), 0.10);
    // Uneven walls, and the roughness of segmented images.
    return d + 0.030 * fractal_noise(2.6 * p, 2, 11) + 0.007 * noise(13 * p, 23) +
           0.0030 * noise(34 * p, 37);
  };
}

// The point where a ray from inside leaves the solid.
Point surface_along(const Field& field, const Point& start, const Point& direction) {
  double t = 0;
  while (t < 2 && field(start + t * direction) < 0) t += 0.004;
  return start + t * direction;
}

}  // namespace

MeshLists vessel_mesh(double cell) {
  const Field field = vessel();
  MeshLists mesh = isosurface(field, {-1.60, -1.60, -0.75}, {1.62, 1.60, 0.95}, cell);
  relax(mesh, field, cell, 5);
  return mesh;
}

Waypoints vessel_loop(const MeshLists& mesh, std::uint64_t seed, int clicks) {
  const Field field = vessel();
  Random hand(seed);
  const Point axis = (kDome - kNeck).normalized();
  const Point side = axis.unitOrthogonal(), other = axis.cross(side);
  std::vector<Point> places;
  for (int i = 0; i < clicks; ++i) {
    const double angle = 2 * std::numbers::pi * (i + hand.in(-0.2, 0.2)) / clicks;
    const Point outwards = std::cos(angle) * side + std::sin(angle) * other;
    const Point middle = kNeck + (0.12 + hand.in(-0.05, 0.05)) * axis;
    places.push_back(surface_along(field, middle, outwards));
  }
  return nearest_vertices(mesh, places, true);
}

DemoScene vessel_scene() {
  DemoScene scene;
  scene.name = "vessel";
  scene.mesh = vessel_mesh(kVesselCell);
  scene.through = vessel_loop(scene.mesh, 5);
  return scene;
}

}  // namespace talweg::scenes
