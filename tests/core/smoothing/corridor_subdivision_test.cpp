// The corridor follows the drawing and the surface, not the mesh: the same on finer versions of it.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

/// A mesh and an edge path on it.
struct Drawn {
  MeshLists lists;
  std::vector<VertexId> path;
  bool closed = false;
};

/// Each face in four, on the same polyhedron; the path gets the vertices in the middle of its
/// edges.
Drawn finer(const Drawn& coarse) {
  Drawn fine{{coarse.lists.points, {}, {}}, {}, coarse.closed};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> made;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [it, fresh] = made.try_emplace({std::min(a, b), std::max(a, b)},
                                              static_cast<std::uint32_t>(fine.lists.points.size()));
    if (fresh) fine.lists.points.push_back((coarse.lists.points[a] + coarse.lists.points[b]) / 2);
    return it->second;
  };
  for (const auto& [a, b, c] : coarse.lists.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    auto& triangles = fine.lists.triangles;
    triangles.insert(triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  const std::size_t n = coarse.path.size();
  for (std::size_t i = 0; i < n; ++i) {
    fine.path.push_back(coarse.path[i]);
    if (i + 1 == n && !coarse.closed) break;
    fine.path.emplace_back(middle(static_cast<std::uint32_t>(coarse.path[i].index()),
                                  static_cast<std::uint32_t>(coarse.path[(i + 1) % n].index())));
  }
  return fine;
}

/// A sphere with gentle bumps.
MeshLists bumpy_sphere(int levels) {
  MeshLists lists = test::sphere(levels);
  for (Point& p : lists.points) {
    p *= 1 + 0.05 * std::sin(4 * p.x() + 1) * std::cos(5 * p.y()) + 0.04 * std::sin(6 * p.z());
  }
  return lists;
}

/// On the mesh and its once and twice subdivided versions, with the slack of the first.
void expect_the_same_on_finer_meshes(Drawn drawn, double tau) {
  SmoothingOptions options;
  options.tau = tau;
  std::vector<Point> coarsest;
  double edge = 0, curvature = 0;
  for (int level = 0; level < 3; ++level, drawn = finer(drawn)) {
    SCOPED_TRACE(testing::Message() << "tau " << tau << " level " << level);
    const auto opened = OpenedMesh::open(drawn.lists);
    const SurfaceCurve curve = test::vertex_curve(opened->surface(), drawn.path, drawn.closed);
    CurveSmoother smoother(opened);
    smoother.set_curve(curve);
    if (level == 0) options.slack = smoother.slack()[0];
    EXPECT_NEAR(smoother.slack()[0], *options.slack, 1e-9);
    const SmoothingResult result = smoother.smooth(options);
    const std::vector<Point> points = positions_of(opened->mesh(), result.curve());
    if (level == 0) {
      coarsest = points;
      edge = result.report().edge_length_near;
      curvature = result.report().after.total_curvature;
    }
    const Deviation apart = deviation(points, drawn.closed, coarsest, drawn.closed);
    EXPECT_LT(std::max(apart.to_drawn.max, apart.from_drawn.max), 0.6 * edge);
    EXPECT_LE(result.report().after.total_curvature, 1.1 * curvature + 0.6);
  }
}

TEST(CorridorSubdivision, ALineOnABumpySphere) {
  Drawn drawn{bumpy_sphere(4), {}, false};
  const Surface surface = test::surface_of_lists(drawn.lists);
  drawn.path = draw_edge_path(surface, test::ids({2, 300, 0, 700}));
  for (const double tau : {0.5, 1.0, 2.0, 4.0}) expect_the_same_on_finer_meshes(drawn, tau);
}

TEST(CorridorSubdivision, ALoopOnABumpySphere) {
  const Drawn sphere{bumpy_sphere(4), {}, true};
  const auto opened = OpenedMesh::open(sphere.lists);
  const Point axis = Point(1, 2, 3).normalized(), right = Point(2, -1, 0).normalized();
  const auto points = test::circle(0.7 * axis, 0.7 * right, 0.7 * axis.cross(right), 9);
  Drawn drawn = sphere;
  for (const SurfacePoint& p : test::drawn_near(opened->mesh(), points, true).points) {
    drawn.path.push_back(std::get<AtVertex>(p.where()).vertex);
  }
  for (const double tau : {0.5, 1.0, 2.0, 4.0}) expect_the_same_on_finer_meshes(drawn, tau);
}

}  // namespace
}  // namespace talweg
