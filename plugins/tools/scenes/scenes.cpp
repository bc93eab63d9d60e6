#include "tools/scenes/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace talweg::scenes {

std::vector<DemoScene> demo_scenes() { return {vessel_scene(), figure_scene(), terrain_scene()}; }

std::vector<DemoScene> gallery_scenes() {
  DemoScene terrain = terrain_scene();
  // Its ends are extended to the nearest vertices of the boundary's first and last row.
  auto& through = terrain.through.vertices;
  const auto on_side = [&](const Point& from, double y) {
    std::uint32_t best = 0;
    double nearest = std::numeric_limits<double>::max();
    for (std::uint32_t v = 0; v < terrain.mesh.points.size(); ++v) {
      const Point& p = terrain.mesh.points[v];
      if (p.y() != y || std::abs(p.x() - from.x()) >= nearest) continue;
      nearest = std::abs(p.x() - from.x());
      best = v;
    }
    return best;
  };
  double top = 0;
  for (const Point& p : terrain.mesh.points) top = std::max(top, p.y());
  const Point first = terrain.mesh.points[through.front()];
  const Point last = terrain.mesh.points[through.back()];
  through.insert(through.begin(), on_side(first, 0));
  through.push_back(on_side(last, top));
  return {vessel_scene(), bone_scene(), cortex_scene(), std::move(terrain)};
}

}  // namespace talweg::scenes
