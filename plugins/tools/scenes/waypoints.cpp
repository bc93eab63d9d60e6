#include "tools/scenes/waypoints.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "talweg/intrinsic/error.hpp"
#include "tools/scenes/random.hpp"

namespace talweg::scenes {
namespace {

using Neighbors = std::vector<std::vector<std::uint32_t>>;

Neighbors neighbors_of(const MeshLists& mesh) {
  Neighbors result(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      result[t[k]].push_back(t[(k + 1) % 3]);
      result[t[(k + 1) % 3]].push_back(t[k]);
    }
  }
  for (auto& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

// The number of the component of every vertex; isolated vertices are components, too.
std::vector<std::uint32_t> component_numbers(const MeshLists& mesh) {
  std::vector<std::uint32_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t a = root(t[k]), b = root(t[k + 1]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = root(v);
  return parent;
}

std::uint32_t largest_number(const MeshLists& mesh, const std::vector<std::uint32_t>& number) {
  std::vector<std::size_t> faces(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) ++faces[number[t[0]]];
  return static_cast<std::uint32_t>(std::max_element(faces.begin(), faces.end()) - faces.begin());
}

struct Distances {
  std::vector<double> distance;
  std::vector<std::uint32_t> before;
};

Distances distances_from(const MeshLists& mesh, const Neighbors& neighbors, std::uint32_t start) {
  Distances result{std::vector<double>(mesh.points.size(), std::numeric_limits<double>::infinity()),
                   std::vector<std::uint32_t>(mesh.points.size(), start)};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  result.distance[start] = 0;
  queue.push({0, start});
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > result.distance[v]) continue;
    for (const std::uint32_t w : neighbors[v]) {
      const double there = d + (mesh.points[w] - mesh.points[v]).norm();
      if (there < result.distance[w]) {
        result.distance[w] = there;
        result.before[w] = v;
        queue.push({there, w});
      }
    }
  }
  return result;
}

std::uint32_t farthest(const Distances& from) {
  std::uint32_t best = 0;
  double most = -1;
  for (std::uint32_t v = 0; v < from.distance.size(); ++v) {
    if (from.distance[v] < std::numeric_limits<double>::infinity() && from.distance[v] > most) {
      most = from.distance[v];
      best = v;
    }
  }
  return best;
}

// A few random steps away from a vertex.
std::uint32_t strayed(const Neighbors& neighbors, std::uint32_t v, int steps, Random& random) {
  for (int k = 0; k < steps; ++k) {
    const auto& list = neighbors[v];
    v = list[static_cast<std::size_t>(random.in(0, double(list.size())))];
  }
  return v;
}

void push_new(std::vector<std::uint32_t>& list, std::uint32_t v) {
  if (std::find(list.begin(), list.end(), v) == list.end()) list.push_back(v);
}

}  // namespace

std::string draw_arguments(const Waypoints& through) {
  std::string text = "--through ";
  for (std::size_t i = 0; i < through.vertices.size(); ++i) {
    if (i > 0) text += ',';
    text += std::to_string(through.vertices[i]);
  }
  if (through.closed) text += " --closed";
  return text + " --points rough";
}

Waypoints nearest_vertices(const MeshLists& mesh, const std::vector<Point>& places, bool closed) {
  Waypoints result;
  result.closed = closed;
  for (const Point& place : places) {
    std::uint32_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
      const double d = (mesh.points[v] - place).squaredNorm();
      if (d < least) {
        least = d;
        best = v;
      }
    }
    push_new(result.vertices, best);
  }
  return result;
}

MeshLists largest_component(const MeshLists& mesh) {
  if (mesh.triangles.empty()) return {};
  const std::vector<std::uint32_t> number = component_numbers(mesh);
  const std::uint32_t kept = largest_number(mesh, number);
  MeshLists result;
  std::vector<std::uint32_t> renamed(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (number[v] != kept) continue;
    renamed[v] = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(mesh.points[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    if (number[t[0]] != kept) continue;
    result.triangles.push_back({renamed[t[0]], renamed[t[1]], renamed[t[2]]});
  }
  return result;
}

Waypoints waypoints_across(const MeshLists& mesh, std::uint64_t seed) {
  if (mesh.triangles.empty()) throw Error(ErrorCode::kBadMesh, "the mesh has no faces");
  const Neighbors neighbors = neighbors_of(mesh);
  const std::vector<std::uint32_t> number = component_numbers(mesh);
  const std::uint32_t first = largest_number(mesh, number);
  const std::uint32_t start = farthest(distances_from(mesh, neighbors, first));
  const Distances from = distances_from(mesh, neighbors, start);
  std::vector<std::uint32_t> path{farthest(from)};
  while (path.back() != start) path.push_back(from.before[path.back()]);
  if (path.size() < 3) {
    throw Error(ErrorCode::kBadMesh, "the largest component of the mesh is too small to draw on");
  }
  const std::size_t skipped = path.size() * 15 / 100, end = path.size() - skipped;
  const std::size_t stride = std::clamp<std::size_t>((end - skipped) / 24, 1, 12);
  const int steps = static_cast<int>(stride) / 3;
  Random random(seed);
  Waypoints result;
  for (std::size_t i = skipped; i < end; i += stride) {
    push_new(result.vertices, strayed(neighbors, path[i], steps, random));
  }
  return result;
}

}  // namespace talweg::scenes
