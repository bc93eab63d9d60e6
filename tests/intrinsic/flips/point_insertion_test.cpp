#include "talweg/intrinsic/flips/point_insertion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using namespace test;

/// Expects that the length of every edge is the distance of its ends, and every inner cone angle is
/// 2 pi.
void expect_planar(SignpostTriangulation& t, const TestMesh& mesh, double tolerance) {
  const auto where = [&](VertexId v) { return position(t.surface(), mesh.points, t.location(v)); };
  for (std::size_t e = 0; e < t.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    EXPECT_NEAR(t.length(h), distance(where(t.tail(h)), where(t.head(h))), tolerance);
  }
  for (std::size_t i = 0; i < 2 * t.edge_count(); ++i) {
    const HalfedgeId h{i};
    if (!t.has_face(h)) continue;
    EXPECT_EQ(t.next(t.next(t.next(h))), h);
    EXPECT_EQ(t.tail(t.next(h)), t.head(h));
    // The triangle is counterclockwise in the plane, or flat.
    const Point a = where(t.tail(h)), b = where(t.head(h)), c = where(t.tail(t.prev(h)));
    EXPECT_GE((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), -tolerance);
  }
}

SurfacePoint random_point(const Surface& s, Random& random) {
  if (random.below(3) == 0) {
    return SurfacePoint::on_edge(s, EdgeId{random.below(s.edge_count())},
                                 random.uniform(0.01, 0.99));
  }
  const double u = random.uniform(0.01, 0.98), v = random.uniform(0.01, 0.99 - u);
  return SurfacePoint::from_barycentric(s, FaceId{random.below(s.face_count())}, {u, v, 1 - u - v});
}

TEST(PointInsertion, VerticesAreThemselves) {
  const Surface s = surface_of(grid(2, 2));
  SignpostTriangulation t(s);
  PointInsertion insertion(t);
  EXPECT_EQ(insertion.insert(SurfacePoint::at_vertex(s, VertexId{4})), VertexId{4});
  EXPECT_EQ(t.inserted_count(), 0U);
}

TEST(PointInsertion, PointsKeepTheirPlacesAndLengths) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const TestMesh mesh = grid(3, 3, 0.2, seed);
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    PointInsertion insertion(t);
    Random random(seed);
    std::vector<SurfacePoint> points;
    std::vector<VertexId> vertices;
    for (int k = 0; k < 120; ++k) {
      points.push_back(random_point(s, random));
      vertices.push_back(insertion.insert(points.back()));
      EXPECT_EQ(t.location(vertices.back()), points.back());
    }
    EXPECT_EQ(t.inserted_count(), 120U);
    // Each length is computed in its face from coordinates of size 3: d² is exact to a few ulp of
    // 1, so the d of points 1e-3 apart to about 1e-12.
    expect_planar(t, mesh, 1e-11);
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_EQ(insertion.insert(points[k]), vertices[k]);
    }
    EXPECT_EQ(t.inserted_count(), 120U);
    t.remove_inserted();
    SignpostTriangulation fresh(s);
    EXPECT_EQ(snapshot(t), snapshot(fresh));
  }
}

TEST(PointInsertion, PointsOnTheBoundary) {
  const TestMesh mesh = grid(1, 1);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  PointInsertion insertion(t);
  for (std::size_t e = 0; e < s.edge_count(); ++e) {
    for (const double at : {0.25, 0.75, 0.5}) {
      const VertexId v = insertion.insert(SurfacePoint::on_edge(s, EdgeId{e}, at));
      EXPECT_EQ(t.on_boundary(v), s.on_boundary(EdgeId{e}));
    }
  }
  expect_planar(t, mesh, 1e-15);
  for (std::size_t v = 4; v < t.vertex_count(); ++v) {
    EXPECT_NEAR(t.cone_angle(VertexId{v}), t.on_boundary(VertexId{v}) ? kPi : 2 * kPi, 1e-7);
  }
}

TEST(PointInsertion, PointsNearVerticesAndEdgesFallOnThem) {
  const TestMesh mesh = grid(2, 2);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  PointInsertion insertion(t);
  EXPECT_EQ(insertion.insert(SurfacePoint::on_edge(s, EdgeId{0}, 1e-11)),
            s.tail(halfedge_of(EdgeId{0})));
  EXPECT_EQ(insertion.insert(SurfacePoint::in_face(s, FaceId{1}, {1e-11, 1e-11, 1 - 2e-11})),
            s.corners(FaceId{1})[2]);
  EXPECT_EQ(t.inserted_count(), 0U);
  const VertexId v =
      insertion.insert(SurfacePoint::in_face(s, FaceId{1}, {0.5, 0.5 - 1e-11, 1e-11}));
  EXPECT_TRUE(std::holds_alternative<OnEdge>(t.location(v).where()));
  expect_planar(t, mesh, 1e-10);
  // Points that approach a corner and an edge, far outside the tolerance.
  for (double d = 0.4; d > 1e-6; d /= 2) {
    insertion.insert(SurfacePoint::in_face(s, FaceId{3}, {1 - 2 * d, d, d}));
    insertion.insert(SurfacePoint::in_face(s, FaceId{4}, {0.5, 0.5 - d, d}));
  }
  expect_planar(t, mesh, 1e-10);
}

TEST(PointInsertion, PointsOnTheSideOfASliverKeepTheirPlaces) {
  const Surface s = surface_of(grid(1, 1));
  for (double thin = 1e-2; thin > 1e-10; thin /= 10) {
    SignpostTriangulation t(s);
    PointInsertion insertion(t);
    insertion.insert(SurfacePoint::in_face(s, FaceId{0}, {0.6, 0.4 - thin, thin}));
    for (const double at : {0.1, 0.3, 0.7, 0.95}) {
      const VertexId v = insertion.insert(SurfacePoint::in_face(s, FaceId{0}, {1 - at, at, 5e-18}));
      const auto found = coordinates_in(s, t.location(v), FaceId{0}).barycentric;
      EXPECT_NEAR(found[1], at, 1e-15) << thin;
    }
  }
}

TEST(PointInsertion, AVertexLiesInEveryFaceOfItsPoint) {
  // Among slivers a vertex inside a face may be within rounding of a point on a side of the face.
  // The point must not become that vertex, because the face across the side does not have the
  // vertex.
  const Surface s = surface_of(grid(1, 1));
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SignpostTriangulation t(s);
    PointInsertion insertion(t);
    Random random(seed);
    std::vector<HalfedgeId> path;
    VertexId last;
    for (int k = 0; k < 120; ++k) {
      std::array<double, 3> at = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
      if (random.below(4) == 0) at[random.below(3)] = 0;
      if (random.below(3) == 0) at[random.below(3)] *= std::pow(10, -random.uniform(6, 18));
      const double sum = at[0] + at[1] + at[2];
      const SurfacePoint point = SurfacePoint::from_barycentric(
          s, FaceId{random.below(2)}, {at[0] / sum, at[1] / sum, at[2] / sum});
      const VertexId v = insertion.insert(point);
      const std::vector<FaceId> own = faces_at(s, t.location(v));
      for (const FaceId f : faces_at(s, point)) {
        ASSERT_NE(std::find(own.begin(), own.end(), f), own.end()) << "seed " << seed << ", " << k;
      }
      if (last.valid() && common_face(s, t.location(last), t.location(v)).valid()) {
        insertion.connect(last, v, path);
      }
      last = v;
    }
  }
}

TEST(PointInsertion, ConnectsStraightAcrossEarlierPieces) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const TestMesh mesh = grid(1, 1);
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    PointInsertion insertion(t);
    Random random(seed);
    for (int k = 0; k < 40; ++k) {
      const FaceId face{random.below(2)};
      VertexId ends[2];
      for (VertexId& end : ends) {
        const double u = random.uniform(0.05, 0.9), v = random.uniform(0.02, 0.95 - u);
        end = insertion.insert(SurfacePoint::in_face(s, face, {u, v, 1 - u - v}));
      }
      std::vector<HalfedgeId> path;
      insertion.connect(ends[0], ends[1], path);
      const EdgePath checked = EdgePath::make(t, path, false);
      EXPECT_EQ(t.tail(path.front()), ends[0]);
      EXPECT_EQ(t.head(path.back()), ends[1]);
      const double straight = distance(position(s, mesh.points, t.location(ends[0])),
                                       position(s, mesh.points, t.location(ends[1])));
      EXPECT_NEAR(path_length(t, checked), straight, 1e-8);
    }
    expect_planar(t, mesh, 1e-8);
    for (std::size_t v = 4; v < t.vertex_count(); ++v) {
      EXPECT_NEAR(t.cone_angle(VertexId{v}), 2 * kPi, 1e-3);
    }
  }
}

TEST(PointInsertion, ConnectsAlongMeshEdgesAndCorners) {
  const TestMesh mesh = grid(2, 1);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  PointInsertion insertion(t);
  // The edge 0-1 on the boundary, with two points on it, walked both ways.
  const HalfedgeId h = s.find_halfedge(VertexId{0}, VertexId{1});
  const bool along = h == halfedge_of(edge_of(h));
  const VertexId a = insertion.insert(SurfacePoint::on_edge(s, edge_of(h), along ? 0.25 : 0.75));
  const VertexId b = insertion.insert(SurfacePoint::on_edge(s, edge_of(h), 0.5));
  std::vector<HalfedgeId> path;
  insertion.connect(VertexId{0}, VertexId{1}, path);
  EXPECT_EQ(path.size(), 3U);
  EXPECT_EQ(t.head(path[0]), a);
  EXPECT_EQ(t.head(path[1]), b);
  path.clear();
  insertion.connect(VertexId{1}, VertexId{0}, path);
  EXPECT_EQ(path.size(), 3U);
  EXPECT_EQ(t.head(path[0]), b);
  // From a corner of a face to its opposite side.
  const HalfedgeId opposite = s.find_halfedge(VertexId{1}, VertexId{4});
  const VertexId c = insertion.insert(SurfacePoint::on_edge(s, edge_of(opposite), 0.5));
  path.clear();
  insertion.connect(VertexId{0}, c, path);
  EXPECT_NEAR(path_length(t, EdgePath::make(t, path, false)), std::hypot(1, 0.5), 1e-15);
  path.clear();
  insertion.connect(c, c, path);
  EXPECT_TRUE(path.empty());
  expect_planar(t, mesh, 1e-14);
}

TEST(PointInsertion, RefusesPointsWithoutACommonFace) {
  const Surface s = surface_of(grid(3, 3));
  SignpostTriangulation t(s);
  PointInsertion insertion(t);
  std::vector<HalfedgeId> path;
  EXPECT_THROW(insertion.connect(VertexId{0}, VertexId{15}, path), Error);
  const Surface lonely = Surface::from_triangles(4, std::vector<Triangle>{{0, 1, 2}});
  SignpostTriangulation with_lonely(lonely);
  PointInsertion other(with_lonely);
  EXPECT_THROW(other.connect(VertexId{3}, VertexId{0}, path), Error);
}

TEST(PointInsertion, WorksInFacesWithoutArea) {
  // Barycentrics place the points, whatever the lengths: no division by the area.
  TestMesh mesh = grid(1, 1);
  mesh.points[3] = mesh.points[0];
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  PointInsertion insertion(t);
  Random random(3);
  std::vector<VertexId> vertices;
  for (int k = 0; k < 30; ++k) {
    const double u = random.uniform(0.05, 0.9), v = random.uniform(0.02, 0.95 - u);
    vertices.push_back(insertion.insert(SurfacePoint::in_face(s, FaceId{0}, {u, v, 1 - u - v})));
    std::vector<HalfedgeId> path;
    insertion.connect(vertices.front(), vertices.back(), path);
  }
  for (std::size_t e = 0; e < t.edge_count(); ++e) {
    EXPECT_TRUE(std::isfinite(t.length(EdgeId{e})));
  }
}

}  // namespace
}  // namespace talweg
