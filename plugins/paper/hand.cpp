#include "paper/hand.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/random.hpp"
#include "scenes/waypoints.hpp"
#include "talweg/core/curve_smoother.hpp"
#include "talweg/core/drawing.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::paper {
namespace {

std::vector<double> distance_from(const OpenedMesh& mesh, VertexId v) {
  const std::vector<WeightedVertex> source{{v, 1.0}};
  return mesh.heat(10)->solve(source);
}

// Where the value is largest, of those that are finite.
VertexId largest_of(const std::vector<double>& values) {
  std::size_t best = 0;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!std::isfinite(values[v])) continue;
    if (!std::isfinite(values[best]) || values[v] > values[best]) best = v;
  }
  return VertexId{best};
}

// The stations of the tour: each as far as possible from those before, but none near the tip of a
// limb, where the way out and the way back would run side by side.
std::vector<VertexId> stations(const OpenedMesh& mesh, std::size_t count) {
  const VertexId tip = largest_of(distance_from(mesh, VertexId{0}));
  const std::vector<double> from_tip = distance_from(mesh, tip);
  const VertexId other = largest_of(from_tip);
  const std::vector<double> from_other = distance_from(mesh, other);
  std::vector<double> distance(from_tip.size());
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const bool near_a_tip = std::max(from_tip[v], from_other[v]) > 0.7 * from_tip[other.index()];
    distance[v] = near_a_tip ? -HUGE_VAL : from_tip[v];
  }
  std::vector<VertexId> result;
  while (result.size() < count) {
    result.push_back(largest_of(distance));
    const std::vector<double> from = distance_from(mesh, result.back());
    for (std::size_t v = 0; v < distance.size(); ++v) {
      distance[v] = result.size() == 1 && std::isfinite(distance[v])
                        ? from[v]
                        : std::min(distance[v], from[v]);
    }
  }
  return result;
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

// Draws as many of the way-points as can be joined without crossing.
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
  const std::vector<VertexId> ends = stations(mesh, 8);
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
