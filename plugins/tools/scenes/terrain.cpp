#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "tools/scenes/noise.hpp"
#include "tools/scenes/random.hpp"
#include "tools/scenes/scenes.hpp"

namespace talweg::scenes {
namespace {

constexpr int kCells = 174;      // along each side
constexpr double kSide = 10000;  // metres

// The river's easting over its northing, both in units of the side.
double river(double y) {
  return 0.50 + 0.13 * std::sin(6.0 * y + 0.6) + 0.05 * std::sin(15.0 * y + 2.0);
}

// Elevation in metres over (x, y) in units of the side: ridges, hills, and a valley along the
// river.
double elevation(double x, double y) {
  const Point p(x, y, 0.5);
  const Point bent = 3.0 * p + 0.45 * Point(noise(3 * p, 3), noise(3 * p, 4), 0);
  double ridges = 0, strength = 0.55;
  Point q = bent;
  double weight = 1;
  for (std::uint64_t k = 0; k < 6; ++k) {
    const double ridge = 1 - std::hypot(noise(q, 40 + k), 0.07);
    const double layer = ridge * ridge * weight;
    ridges += strength * layer;
    weight = std::clamp(1.6 * layer, 0.0, 1.0);
    q = 2.07 * q + Point(0.31, 0.17, 0.0);
    strength *= 0.48;
  }
  const double away = std::abs(x - river(y));
  const double valley = 1 - std::exp(-away * away / (2 * 0.085 * 0.085));
  const double bed = 90 * (1 - y) + 60 * std::min(1.0, away / 0.03);
  return bed + 200 * valley + 1900 * ridges * (0.06 + 0.94 * valley) * (0.65 + 0.5 * y);
}

// Positive if a, b, c turn counterclockwise seen from above (z up).
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// The corners of a cell, counterclockwise, as two triangles along the diagonal that gives the
// larger of the smallest areas.
void add_cell(MeshLists& mesh, const std::array<std::uint32_t, 4>& v) {
  const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
    return turn(mesh.points[v[a]], mesh.points[v[b]], mesh.points[v[c]]);
  };
  if (std::min(area(0, 1, 2), area(0, 2, 3)) >= std::min(area(0, 1, 3), area(1, 2, 3))) {
    mesh.triangles.push_back({v[0], v[1], v[2]});
    mesh.triangles.push_back({v[0], v[2], v[3]});
  } else {
    mesh.triangles.push_back({v[0], v[1], v[3]});
    mesh.triangles.push_back({v[1], v[2], v[3]});
  }
}

}  // namespace

DemoScene terrain_scene() {
  DemoScene scene;
  scene.name = "terrain";
  Random random(29);
  const auto place = [](double x, double y) {
    return Point(kSide * x, kSide * y, elevation(x, y));
  };
  constexpr int kRow = kCells + 1;
  for (int j = 0; j < kRow; ++j) {
    for (int i = 0; i < kRow; ++i) {
      const bool inner_x = i > 0 && i<kCells, inner_y = j> 0 && j < kCells;
      // Rows are shifted against each other by half a cell, then every point is moved at random.
      const double shift = inner_x ? (j % 2 == 0 ? 0.25 : -0.25) : 0;
      const double x = i + (inner_x ? shift + random.in(-0.24, 0.24) : 0);
      const double y = j + (inner_y ? random.in(-0.3, 0.3) : 0);
      scene.mesh.points.push_back(place(x / kCells, y / kCells));
    }
  }
  for (std::uint32_t j = 0; j < kCells; ++j) {
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t v = j * kRow + i;
      add_cell(scene.mesh, {v, v + 1, v + kRow + 1, v + kRow});
    }
  }
  // A border along the river, drawn by an unsteady hand.
  std::vector<Point> places;
  constexpr int kCount = 22;
  for (int i = 0; i <= kCount; ++i) {
    const double y = 0.08 + 0.84 * (i + random.in(-0.2, 0.2)) / kCount;
    const double at = std::clamp(y, 0.06, 0.94);
    places.push_back(place(river(at) + random.in(-0.016, 0.016), at));
  }
  scene.through = nearest_vertices(scene.mesh, places, false);
  return scene;
}

}  // namespace talweg::scenes
