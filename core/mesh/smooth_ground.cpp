#include "talweg/core/mesh/smooth_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "talweg/core/mesh/vertex_filter.hpp"

namespace talweg {
namespace {

constexpr std::array<double, 3> kScales{2, 4, 6};  // s, in edges
constexpr double kFull =
    1.35;  // of white noise, about 1 / 1.35 of the amplitude is finer than 2 edges

/// The unit normal at each vertex of the surface without its fine parts `finer`: the normalised sum
/// of the area vectors of the faces around; 0 where the sum is 0 or a neighbour is not in the
/// graph.
std::vector<Point> normals_without(const VertexGraph& graph, const SurfaceMesh& mesh,
                                   const std::vector<Point>& finer) {
  std::vector<Point> places(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    places[i] = mesh.point(graph.vertex(i)) - finer[i];
  }
  std::vector<Point> normals(graph.size(), Point::Zero());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto around = graph.neighbours(i);
    if (!graph.is_whole(i) || around.size() < 2) continue;
    const bool closed = !mesh.surface().on_boundary(graph.vertex(i));
    for (std::size_t k = closed ? 0 : 1; k < around.size(); ++k) {
      const std::uint32_t from = around[k == 0 ? around.size() - 1 : k - 1];
      normals[i] += (places[from] - places[i]).cross(places[around[k]] - places[i]);
    }
    const double length = normals[i].stableNorm();
    if (length > 0) normals[i] /= length;
  }
  return normals;
}

/// The mean length of the edges at each vertex, mesh units.
std::vector<double> edge_lengths(const VertexGraph& graph, const SurfaceMesh& mesh) {
  std::vector<double> lengths(graph.size(), 0);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Point& p = mesh.point(graph.vertex(i));
    for (const std::uint32_t j : graph.neighbours(i)) {
      lengths[i] += (mesh.point(graph.vertex(j)) - p).norm();
    }
    if (!graph.neighbours(i).empty()) {
      lengths[i] /= static_cast<double>(graph.neighbours(i).size());
    }
  }
  return lengths;
}

/// The fine relief of a surface, per vertex of a graph.
struct Relief {
  std::vector<std::vector<Point>> parts;  ///< per scale, the part finer than the scale
  std::vector<double> roughness;          ///< σ, in edge lengths
};

/// Projects the parts onto the normals.
void keep_along(const std::vector<Point>& normals, std::vector<Point>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = parts[i].dot(normals[i]) * normals[i];
}

/// The squares of the parts along the normals, averaged over the surroundings of each vertex.
std::vector<double> mean_squares(const VertexGraph& graph, const std::vector<Point>& normals,
                                 const std::vector<Point>& parts, ProgressPoller& poller) {
  std::vector<double> squares(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double height = parts[i].dot(normals[i]);
    squares[i] = height * height;
  }
  spread(graph, squares, poller);
  return squares;
}

Relief relief_of(const VertexGraph& graph, const SurfaceMesh& mesh, std::span<const double> scales,
                 ProgressPoller& poller) {
  Relief relief;
  std::vector<Point> points(graph.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = mesh.point(graph.vertex(i));
  relief.parts = finer_parts(graph, points, scales, poller);
  const std::vector<Point> normals = normals_without(graph, mesh, relief.parts[1]);
  const std::vector<double> at_2 = mean_squares(graph, normals, relief.parts[0], poller);
  const std::vector<double> at_4 = mean_squares(graph, normals, relief.parts[1], poller);
  std::vector<double> edges = edge_lengths(graph, mesh);
  spread(graph, edges, poller);
  relief.roughness.resize(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const double noise = std::max(0.0, (4 * at_2[i] - at_4[i]) / 3);
    relief.roughness[i] = edges[i] > 0 ? kFull * std::sqrt(noise) / edges[i] : 0;
  }
  return relief;
}

/// The part of vertex i finer than the scale 10 √(σ − kLeastRoughness) edges, at most 6 edges,
/// interpolated between the parts of the computed scales.
Point part_at(const Relief& relief, std::size_t i) {
  constexpr double kEdges = 10;
  const double rough = relief.roughness[i] - kLeastRoughness;
  if (!(rough > 0)) return Point::Zero();
  const double scale = std::min(kEdges * std::sqrt(rough), kScales.back());
  Point below = Point::Zero();
  double last = 0;
  for (std::size_t s = 0; s < kScales.size(); ++s) {
    const Point& part = relief.parts[s][i];
    if (scale <= kScales[s]) return below + (scale - last) / (kScales[s] - last) * (part - below);
    below = part;
    last = kScales[s];
  }
  return below;
}

/// Vertices near at most `most` points, evenly spread over the points of the curves, without
/// repeats.
std::vector<VertexId> vertices_along(const Surface& surface, std::span<const SurfaceCurve> curves,
                                     std::size_t most) {
  std::vector<const SurfacePoint*> points;
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) points.push_back(&point);
  }
  const std::size_t count = std::min(most, points.size());
  std::vector<VertexId> vertices;
  for (std::size_t k = 0; k < count; ++k) {
    const SurfacePoint& point = *points[k * points.size() / count];
    const auto* at = std::get_if<AtVertex>(&point.where());
    vertices.push_back(at != nullptr ? at->vertex : surface.corners(any_face(surface, point))[0]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

double roughness_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                       const Progress& progress) {
  ProgressPoller poller(progress, "embed");
  constexpr int kRings = 8;
  constexpr std::size_t kPlaces = 24;
  const std::vector<VertexId> beside = vertices_along(mesh.surface(), curves, kPlaces);
  if (beside.empty()) return 0;
  const VertexGraph graph(mesh.surface(), beside, kRings);
  constexpr std::size_t kFew = 200;  // fewer vertices cannot tell noise from shape
  if (graph.size() < kFew) return 0;
  Relief relief = relief_of(graph, mesh, std::span(kScales).first(2), poller);
  std::vector<double>& rough = relief.roughness;
  rough.resize(beside.size());  // the seeds are the first vertices of the graph
  const auto quartile = rough.begin() + static_cast<std::ptrdiff_t>(3 * rough.size() / 4);
  std::nth_element(rough.begin(), quartile, rough.end());
  return *quartile;
}

SurfaceMesh smooth_ground(const SurfaceMesh& mesh, const Progress& progress) {
  ProgressPoller poller(progress, "embed");
  const VertexGraph graph(mesh.surface());
  Relief relief = relief_of(graph, mesh, kScales, poller);
  for (std::vector<Point>& parts : relief.parts) {
    keep_along(normals_without(graph, mesh, parts), parts);
  }
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] -= part_at(relief, i);
  return mesh.moved(std::move(points));
}

}  // namespace talweg
