#include "tools/scenes/patients.hpp"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "tools/scenes/noise.hpp"
#include "tools/scenes/vessel.hpp"

namespace talweg::scenes {
namespace {

constexpr int kSizes = 10;
constexpr double kFacesOfOne = 5000, kDemoFaces = 60146;
constexpr int kClicks = 9;  // few enough that legs do not collide on the coarsest mesh

/// Moves a point along a smooth random field: wide bends, and dents of a few triangles.
Point deformed(const Point& p, std::uint64_t seed) {
  const auto field = [&](double frequency, std::uint64_t which) {
    return Point(noise(frequency * p, 3 * which), noise(frequency * p, 3 * which + 1),
                 noise(frequency * p, 3 * which + 2));
  };
  return p + 0.12 * field(0.9, 2 * seed) + 0.006 * field(9, 2 * seed + 1);
}

}  // namespace

Patients::Patients() {
  for (int i = 1; i <= kSizes; ++i) {
    meshes_.push_back(vessel_mesh(kVesselCell * std::sqrt(kDemoFaces / (i * kFacesOfOne))));
  }
}

DemoScene Patients::scene(std::size_t number) const {
  DemoScene scene;
  scene.name = fmt::format("vessel{:05}", number);
  scene.mesh = meshes_[number % meshes_.size()];
  scene.through = vessel_loop(scene.mesh, number, kClicks);
  for (Point& p : scene.mesh.points) p = deformed(p, 1000 + number);
  return scene;
}

}  // namespace talweg::scenes
