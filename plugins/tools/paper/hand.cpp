#include "tools/paper/hand.hpp"

#include <algorithm>
#include <cmath>

#include "talweg/core/drawing/curve_through.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/intrinsic/error.hpp"
#include "tools/scenes/random.hpp"
#include "tools/scenes/waypoints.hpp"

namespace talweg::paper {
namespace {

// The ends of the tour: each as far as possible from all earlier ends.
std::vector<VertexId> far_ends(const OpenedMesh& mesh, std::size_t count) {
  const auto heat = mesh.heat(10);
  std::vector<VertexId> ends{VertexId{0}};
  std::vector<double> distance(mesh.surface().vertex_count(), HUGE_VAL);
  for (std::size_t k = 0; k <= count; ++k) {
    const std::vector<WeightedVertex> source{{ends.back(), 1.0}};
    const std::vector<double> from = heat->solve(source);
    std::size_t farthest = 0;
    for (std::size_t v = 0; v < distance.size(); ++v) {
      distance[v] = k == 1 ? from[v] : std::min(distance[v], from[v]);  // vertex 0 is not an end
      if (!std::isfinite(distance[v])) continue;
      if (!std::isfinite(distance[farthest]) || distance[v] > distance[farthest]) farthest = v;
    }
    if (k == 0) ends.clear();
    ends.push_back(VertexId{farthest});
  }
  return ends;
}

VertexId strayed(const Surface& surface, VertexId v, int steps, scenes::Random& random) {
  for (int k = 0; k < steps; ++k) {
    const HalfedgeId first = surface.halfedge(v);
    HalfedgeId h = first;
    for (auto turns = static_cast<int>(random.in(0, 6)); turns > 0; --turns) {
      if (!surface.has_face(h)) break;
      h = surface.turn_ccw(h);
    }
    v = surface.head(h);
  }
  return v;
}

// Draws through as many of the way-points as can be joined without crossings.
std::vector<VertexId> draw_most(EdgeDijkstra& dijkstra, std::vector<VertexId> through) {
  while (through.size() > 2) {
    try {
      return dijkstra.draw(through, false);
    } catch (const Error&) {
      through.resize(through.size() * 9 / 10);
    }
  }
  return dijkstra.draw(through, false);
}

}  // namespace

SurfaceCurve tour(const OpenedMesh& mesh, std::size_t vertices, std::uint64_t seed) {
  constexpr std::size_t kStride = 9;
  constexpr int kSteps = 3;
  const Surface& surface = mesh.surface();
  EdgeDijkstra dijkstra(surface);
  const std::vector<VertexId> ends = far_ends(mesh, 8);
  scenes::Random random(seed);
  std::vector<VertexId> through;
  std::size_t along = 0;
  for (std::size_t k = 0; k + 1 < ends.size() && along < vertices; ++k) {
    const std::vector<VertexId> leg = dijkstra.draw(std::vector{ends[k], ends[k + 1]}, false);
    for (std::size_t i = 0; i < leg.size(); i += kStride) {
      const VertexId v = strayed(surface, leg[i], kSteps, random);
      if (std::find(through.begin(), through.end(), v) == through.end()) through.push_back(v);
    }
    along += leg.size();
  }
  std::vector<VertexId> path = draw_most(dijkstra, std::move(through));
  path.resize(std::min(path.size(), vertices));
  return curve_through(surface, path);
}

SurfaceCurve painted(const OpenedMesh& mesh, const MeshLists& lists,
                     const std::vector<Point>& places, bool closed) {
  const scenes::Waypoints nearest = scenes::nearest_vertices(lists, places, closed);
  std::vector<VertexId> through;
  for (const std::uint32_t v : nearest.vertices) through.push_back(VertexId{v});
  std::vector<VertexId> path = EdgeDijkstra(mesh.surface()).draw(through, closed);
  if (closed) path.push_back(path.front());
  return curve_through(mesh.surface(), path);
}

}  // namespace talweg::paper
