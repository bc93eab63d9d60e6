#include "talweg/core/mesh/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// The cube [-1, 1]^3, each side a sheet of n x n squares of two triangles.
MeshLists cube(int n) {
  MeshLists lists;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto first = static_cast<std::uint32_t>(lists.points.size());
      const auto row = static_cast<std::uint32_t>(n + 1);
      for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
          Point p;
          p[axis] = side;
          p[(axis + 1) % 3] = 2.0 * i / n - 1;
          p[(axis + 2) % 3] = 2.0 * j / n - 1;
          lists.points.push_back(p);
        }
      }
      for (std::uint32_t j = 0; j + 1 < row; ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
          const std::uint32_t a = first + j * row + i;
          lists.triangles.push_back({a, a + 1, a + row + 1});
          lists.triangles.push_back({a, a + row + 1, a + row});
        }
      }
    }
  }
  return lists;
}

double distance_to_cube(const Point& p) {
  const Point outside = (p.cwiseAbs() - Point::Ones()).cwiseMax(0.0);
  const double inside = (Point::Ones() - p.cwiseAbs()).minCoeff();
  return outside.norm() > 0 ? outside.norm() : std::max(inside, 0.0);
}

// The six sheets are not glued: only distances matter here.
TEST(ClosestPoint, DistanceToACubeInsideAndOutside) {
  const SurfaceMesh mesh = SurfaceMesh::open(cube(7));
  const ClosestPoint closest(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  for (int k = 0; k < 2000; ++k) {
    const Point p(coordinate(random), coordinate(random), coordinate(random));
    const ClosestPoint::Result found = closest.nearest(p);
    EXPECT_NEAR(found.distance, distance_to_cube(p), 1e-14);
    EXPECT_NEAR((mesh.position(found.point) - p).norm(), found.distance, 1e-14);
    const auto& b = found.barycentric;
    EXPECT_GE(*std::min_element(b.begin(), b.end()), 0);
    EXPECT_NEAR(b[0] + b[1] + b[2], 1, 1e-15);
  }
}

TEST(ClosestPoint, VerticesAndEdgesAreClassified) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(3));
  const ClosestPoint closest(mesh);
  const Surface& surface = mesh.surface();
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    const ClosestPoint::Result found = closest.nearest(mesh.point(VertexId{v}));
    EXPECT_EQ(found.point, SurfacePoint::at_vertex(surface, VertexId{v}));
    EXPECT_EQ(found.distance, 0);
  }
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const SurfacePoint middle = SurfacePoint::on_edge(surface, EdgeId{e}, 0.5);
    const ClosestPoint::Result found = closest.nearest(mesh.position(middle));
    const auto* at = std::get_if<OnEdge>(&found.point.where());
    ASSERT_NE(at, nullptr);
    EXPECT_EQ(at->edge, EdgeId{e});
    EXPECT_NEAR(at->t, 0.5, 1e-14);
  }
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const SurfacePoint inside = SurfacePoint::in_face(surface, FaceId{f}, {0.2, 0.3, 0.5});
    const ClosestPoint::Result found = closest.nearest(mesh.position(inside));
    EXPECT_EQ(found.face, FaceId{f});
    EXPECT_NEAR(found.barycentric[2], 0.5, 1e-13);
  }
}

TEST(ClosestPoint, OfEquallyNearFacesTheSmallest) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(9, 9));
  const ClosestPoint closest(mesh);
  for (std::size_t v = 0; v < mesh.surface().vertex_count(); ++v) {
    const ClosestPoint::Result found = closest.nearest(mesh.point(VertexId{v}) + Point(0, 0, 2));
    EXPECT_EQ(found.face, any_face(mesh.surface(), found.point));
    EXPECT_EQ(found.distance, 2);
  }
}

TEST(ClosestPoint, ZeroAreaTrianglesAreSegments) {
  MeshLists lists;
  lists.points = {Point(0, 0, 0), Point(1, 0, 0), Point(3, 0, 0),
                  Point(7, 7, 7), Point(7, 7, 7), Point(7, 7, 7)};
  lists.triangles = {{0, 1, 2}, {3, 4, 5}};
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const ClosestPoint closest(mesh);
  const ClosestPoint::Result on_segment = closest.nearest(Point(2, 1, 0));
  EXPECT_EQ(on_segment.distance, 1);
  EXPECT_EQ(mesh.position(on_segment.point), Point(2, 0, 0));
  EXPECT_EQ(closest.nearest(Point(7, 7, 9)).distance, 2);
}

TEST(ClosestPoint, ANeedleIsMetWithinItsRounding) {
  MeshLists lists;
  lists.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0.3, 1e-9, 0)};
  lists.triangles = {{0, 1, 2}};
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const ClosestPoint closest(mesh);
  for (const double x : {0.1, 0.3, 0.5, 0.9}) {
    EXPECT_NEAR(closest.nearest(Point(x, 2, 3)).distance, std::sqrt(13.0), 4e-9);
    EXPECT_NEAR(closest.nearest(Point(x, -1, 0)).distance, 1, 1e-15);
  }
}

// Powers of two scale without rounding, so results must agree bit for bit.
TEST(ClosestPoint, FollowsTheScale) {
  MeshLists lists = test::sphere(2);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const ClosestPoint closest(mesh);
  for (const double scale : {std::ldexp(1.0, 27), std::ldexp(1.0, -27)}) {
    MeshLists scaled = lists;
    for (Point& p : scaled.points) p *= scale;
    const SurfaceMesh scaled_mesh = SurfaceMesh::open(scaled);
    const ClosestPoint scaled_closest(scaled_mesh);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-2, 2);
    for (int k = 0; k < 200; ++k) {
      const Point p(coordinate(random), coordinate(random), coordinate(random));
      const ClosestPoint::Result a = closest.nearest(p);
      const ClosestPoint::Result b = scaled_closest.nearest(scale * p);
      EXPECT_EQ(a.point, b.point);
      EXPECT_EQ(a.distance * scale, b.distance);
    }
  }
}

TEST(ClosestPoint, RefusesPositionsThatHaveNoNearestPoint) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(2, 2));
  const ClosestPoint closest(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(closest.nearest(Point(0, nan, 0))), Error);
  EXPECT_THROW(
      static_cast<void>(closest.nearest(Point(std::numeric_limits<double>::infinity(), 0, 0))),
      Error);
  EXPECT_THROW(static_cast<void>(closest.nearest(Point(1e200, 0, 0))), Error);
  EXPECT_NEAR(closest.nearest(Point(0, 0, 1e100)).distance / 1e100, 1, 1e-15);
}

}  // namespace
}  // namespace talweg
