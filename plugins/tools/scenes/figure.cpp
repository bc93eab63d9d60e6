#include <cmath>

#include "tools/scenes/isosurface.hpp"
#include "tools/scenes/noise.hpp"
#include "tools/scenes/random.hpp"
#include "tools/scenes/relaxation.hpp"
#include "tools/scenes/scenes.hpp"
#include "tools/scenes/solids.hpp"

namespace talweg::scenes {
namespace {

Point mirrored(const Point& p) { return {-p.x(), p.y(), p.z()}; }

// A seated bear of clay, facing +z; symmetric but for the bumps and the turn of its head.
double limbs(const Point& p, const Tube& arm, const Tube& leg) {
  double d = std::min(arm(p), leg(p));
  d = smooth_union(d, ellipsoid(p, {0.46, -0.86, 0.80}, {0.19, 0.25, 0.13}), 0.08);
  return d;
}

Field figure() {
  const Tube arm({{{0.44, 0.32, 0.02}, 0.17},
                  {{0.70, 0.08, 0.14}, 0.155},
                  {{0.72, -0.22, 0.38}, 0.15},
                  {{0.56, -0.36, 0.56}, 0.17}});
  const Tube leg(
      {{{0.30, -0.78, 0.05}, 0.26}, {{0.44, -0.86, 0.40}, 0.235}, {{0.46, -0.88, 0.72}, 0.20}});
  return [=](const Point& p) {
    double d = ellipsoid(p, {0, -0.30, 0}, {0.60, 0.72, 0.52});
    d = smooth_union(d, ellipsoid(p, {0, -0.38, 0.22}, {0.44, 0.48, 0.40}), 0.15);
    // The head looks a little to its left.
    const double turn = 0.25, c = std::cos(turn), s = std::sin(turn);
    const Point q(c * p.x() - s * p.z(), p.y(), s * p.x() + c * p.z());
    const Point m(std::abs(q.x()), q.y(), q.z());
    double head = ellipsoid(q, {0, 0.72, 0.04}, {0.47, 0.43, 0.42});
    head = smooth_union(head, ellipsoid(q, {0, 0.62, 0.40}, {0.20, 0.155, 0.19}), 0.10);
    head = smooth_union(head, ellipsoid(q, {0, 0.70, 0.57}, {0.075, 0.055, 0.05}), 0.025);
    double ear = ellipsoid(m, {0.36, 1.10, 0.0}, {0.17, 0.18, 0.085});
    ear = -smooth_union(-ear, ellipsoid(m, {0.36, 1.11, 0.10}, {0.11, 0.12, 0.075}), 0.04);
    head = smooth_union(head, ear, 0.07);
    head = smooth_union(head, ellipsoid(m, {0.165, 0.79, 0.405}, {0.055, 0.06, 0.045}), 0.02);
    d = smooth_union(d, head, 0.10);
    const Point& right = p;
    d = smooth_union(d, limbs(right, arm, leg), 0.09);
    d = smooth_union(d, limbs(mirrored(p), arm, leg), 0.09);
    d = smooth_union(d, ellipsoid(p, {0, -0.72, -0.55}, {0.16, 0.16, 0.16}), 0.08);
    // Dents of fingers, and the grain of the clay.
    return d + 0.030 * fractal_noise(3.7 * p, 2, 101) + 0.012 * noise(9 * p, 131) +
           0.003 * noise(20 * p, 151);
  };
}

// The front of the figure over (x, y).
Point front(const Field& field, double x, double y) {
  double z = 1.2;
  while (z > -1 && field({x, y, z}) > 0) z -= 0.004;
  return {x, y, z};
}

}  // namespace

DemoScene figure_scene() {
  DemoScene scene;
  scene.name = "figure";
  const Field field = figure();
  const double cell = 0.0435;
  scene.mesh = isosurface(field, {-1.15, -1.35, -0.95}, {1.15, 1.50, 1.20}, cell);
  relax(scene.mesh, field, cell, 5);

  // A sash over the belly, from one shoulder to the other hip.
  Random hand(17);
  std::vector<Point> places;
  constexpr int kCount = 22;
  for (int i = 0; i <= kCount; ++i) {
    const double t = double(i) / kCount;
    const double x = -0.44 + 0.86 * t + 0.04 * std::sin(9 * t);
    const double y = 0.26 - 0.86 * t - 0.10 * std::sin(3.1 * t);
    places.push_back(front(field, x + hand.in(-0.035, 0.035), y + hand.in(-0.035, 0.035)));
  }
  scene.through = nearest_vertices(scene.mesh, places, false);
  return scene;
}

}  // namespace talweg::scenes
