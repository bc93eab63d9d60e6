#include "talweg/intrinsic/flips/delaunay.hpp"

#include <cmath>

#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

/// Side lengths of the face of h, starting with h itself.
std::array<double, 3> side_lengths(SignpostTriangulation& triangulation, HalfedgeId h) {
  return {triangulation.length(h), triangulation.length(triangulation.next(h)),
          triangulation.length(triangulation.prev(h))};
}

/// True when the angles opposite the edge sum to more than pi. Their cotangents are N / (4 A) with
/// N = b² + c² - a²; the sign of their sum is the sign of N₁ A₂ + N₂ A₁, also for areas of 0.
bool wants_flip(SignpostTriangulation& triangulation, EdgeId e) {
  const HalfedgeId h = halfedge_of(e);
  double numerator[2] = {}, area[2] = {}, size[2] = {};
  int k = 0;
  for (const HalfedgeId side : {h, twin(h)}) {
    const auto [a, b, c] = side_lengths(triangulation, side);
    numerator[k] = b * b + (c - a) * (c + a);
    size[k] = a * a + b * b + c * c;
    area[k++] = triangle_area(a, b, c);
  }
  // If the four points lie on a circle, the sum is rounding only; such edges stay as they are.
  const double rounding = 1e-12 * (size[0] * area[1] + size[1] * area[0]);
  return numerator[0] * area[1] + numerator[1] * area[0] < -rounding;
}

void push(std::vector<EdgeId>& stack, std::vector<char>& waiting, EdgeId e) {
  if (waiting[e.index()] != 0) return;
  waiting[e.index()] = 1;
  stack.push_back(e);
}

std::size_t flip_to_delaunay(SignpostTriangulation& triangulation) {
  const std::size_t edges = triangulation.edge_count();
  std::vector<EdgeId> stack;
  std::vector<char> waiting(edges, 0);
  for (std::size_t e = edges; e-- > 0;) push(stack, waiting, EdgeId{e});
  // Each flip lowers the Dirichlet energy, so the loop ends; the limit only guards against
  // rounding.
  const std::size_t limit = 100 * edges;
  std::size_t flips = 0;
  while (!stack.empty() && flips < limit) {
    const EdgeId e = stack.back();
    stack.pop_back();
    waiting[e.index()] = 0;
    if (triangulation.on_boundary(e) || !wants_flip(triangulation, e) || !triangulation.flip(e)) {
      continue;
    }
    ++flips;
    for (const HalfedgeId side : {halfedge_of(e), twin(halfedge_of(e))}) {
      push(stack, waiting, edge_of(triangulation.next(side)));
      push(stack, waiting, edge_of(triangulation.prev(side)));
    }
  }
  return flips;
}

}  // namespace

std::vector<MetricTriangle> metric_triangles(const Surface& surface) {
  std::vector<MetricTriangle> triangles(surface.face_count());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    HalfedgeId h = surface.halfedge(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k, h = surface.next(h)) {
      triangles[f].corner[k] = surface.tail(h);
      triangles[f].length[k] = surface.length(edge_of(h));
    }
  }
  return triangles;
}

std::vector<MetricTriangle> delaunay_triangles(const Surface& surface, std::size_t* flips) {
  SignpostTriangulation triangulation(surface);
  triangulation.flip_without_trace();
  const std::size_t count = flip_to_delaunay(triangulation);
  if (flips != nullptr) *flips = count;

  std::vector<MetricTriangle> triangles;
  triangles.reserve(surface.face_count());
  for (std::size_t i = 0; i < surface.halfedge_count(); ++i) {
    HalfedgeId h{i};
    // Visits each face once, from its smallest halfedge.
    if (!triangulation.has_face(h) || triangulation.next(h) < h || triangulation.prev(h) < h) {
      continue;
    }
    MetricTriangle& triangle = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k, h = triangulation.next(h)) {
      triangle.corner[k] = triangulation.tail(h);
      triangle.length[k] = triangulation.length(h);
    }
  }
  return triangles;
}

}  // namespace talweg
