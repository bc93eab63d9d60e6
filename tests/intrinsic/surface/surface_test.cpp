#include "talweg/intrinsic/surface/surface.hpp"

#include <chrono>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

using namespace test;

std::string bad_mesh(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

std::string refused(std::size_t vertices, const std::vector<Triangle>& triangles) {
  return bad_mesh([&] { Surface::from_triangles(vertices, triangles); });
}

std::string refused_gluing(std::size_t vertices, const std::vector<Triangle>& triangles,
                           const std::vector<std::uint32_t>& gluing) {
  return bad_mesh([&] { Surface::from_gluing(vertices, triangles, gluing); });
}

/// Expects all invariants of the connectivity.
void expect_consistent(const Surface& s) {
  for (std::size_t i = 0; i < s.halfedge_count(); ++i) {
    const HalfedgeId h{i};
    EXPECT_EQ(s.head(h), s.tail(twin(h)));
    if (!s.has_face(h)) {
      EXPECT_TRUE(s.has_face(twin(h)));
      EXPECT_FALSE(s.face(h).valid());
      continue;
    }
    EXPECT_EQ(s.next(s.next(s.next(h))), h);
    EXPECT_EQ(s.tail(s.next(h)), s.head(h));
    EXPECT_EQ(s.face(s.next(h)), s.face(h));
    EXPECT_EQ(s.tail(s.turn_ccw(h)), s.tail(h));
    EXPECT_EQ(s.turn_cw(s.turn_ccw(h)), h);
  }
  std::size_t corners = 0;
  for (std::size_t v = 0; v < s.vertex_count(); ++v) {
    const HalfedgeId first = s.halfedge(VertexId{v});
    if (!first.valid()) continue;
    EXPECT_EQ(s.tail(first), VertexId{v});
    HalfedgeId h = first;
    do {
      ++corners;
      h = s.turn_ccw(h);
    } while (h != first && s.has_face(h));
    EXPECT_EQ(s.on_boundary(VertexId{v}), h != first);
  }
  EXPECT_EQ(corners, 3 * s.face_count());
}

long euler_characteristic(const Surface& s) {
  return static_cast<long>(s.vertex_count()) - static_cast<long>(s.edge_count()) +
         static_cast<long>(s.face_count());
}

TEST(Surface, ConnectivityOfKnownSurfaces) {
  const struct {
    TestMesh mesh;
    long euler;
    bool closed;
  } cases[] = {
      {tetrahedron(), 2, true},    {octahedron(), 2, true},      {sphere(2), 2, true},
      {box(3, 2, 4), 2, true},     {torus(5, 4, 3, 1), 0, true}, {double_torus(1), -2, true},
      {grid(4, 3), 1, false},      {disc(7, 3), 1, false},       {cylinder(5, 2, 1, 1), 0, false},
      {cone(6, 2, 1, 2), 1, false}};
  for (const auto& c : cases) {
    const Surface s = surface_of(c.mesh);
    expect_consistent(s);
    EXPECT_EQ(euler_characteristic(s), c.euler);
    bool boundary = false;
    for (std::size_t e = 0; e < s.edge_count(); ++e) boundary |= s.on_boundary(EdgeId{e});
    EXPECT_EQ(boundary, !c.closed);
    EXPECT_EQ(components_of(s).count, 1U);
  }
}

TEST(Surface, FacesStartAtTheirFirstCorner) {
  const TestMesh mesh = grid(3, 2);
  const Surface s = surface_of(mesh);
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    const auto corners = s.corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(corners[k].index(), mesh.triangles[f][k]);
    EXPECT_EQ(s.tail(s.halfedge(FaceId{f})), corners[0]);
    EXPECT_EQ(s.face(s.halfedge(FaceId{f})), FaceId{f});
  }
}

TEST(Surface, BoundaryVertexStartsItsFanMostClockwise) {
  const Surface s = surface_of(grid(2, 2));
  EXPECT_FALSE(s.on_boundary(VertexId{4}));
  for (const std::size_t v : {0, 1, 2, 3, 5, 6, 7, 8}) {
    EXPECT_TRUE(s.on_boundary(VertexId{v}));
    EXPECT_FALSE(s.turn_cw(s.halfedge(VertexId{v})).valid());
  }
}

TEST(Surface, SpokesGoToEachNeighbourOnce) {
  TestMesh mesh = grid(2, 2);
  mesh.points.push_back({9, 9, 9});
  const Surface s = surface_of(mesh);
  for (std::size_t a = 0; a < 10; ++a) {
    std::set<std::size_t> expected, found;
    for (std::size_t h = 0; h < s.halfedge_count(); ++h) {
      if (s.tail(HalfedgeId{h}).index() == a) expected.insert(h);
    }
    std::size_t count = 0;
    for_each_spoke(s, VertexId{a}, [&](HalfedgeId h) {
      found.insert(h.index());
      ++count;
    });
    EXPECT_EQ(found, expected);
    EXPECT_EQ(count, expected.size());
  }
}

TEST(Surface, FindHalfedge) {
  const Surface s = surface_of(grid(2, 2));
  for (std::size_t a = 0; a < 9; ++a) {
    for (std::size_t b = 0; b < 9; ++b) {
      bool expected = false;
      for (std::size_t h = 0; h < s.halfedge_count(); ++h) {
        expected |= s.tail(HalfedgeId{h}).index() == a && s.head(HalfedgeId{h}).index() == b;
      }
      const HalfedgeId found = s.find_halfedge(VertexId{a}, VertexId{b});
      ASSERT_EQ(found.valid(), expected);
      if (!expected) continue;
      EXPECT_EQ(s.tail(found).index(), a);
      EXPECT_EQ(s.head(found).index(), b);
    }
  }
}

TEST(Surface, IsolatedVerticesAndComponents) {
  const std::vector<Triangle> two = {{1, 2, 3}, {5, 7, 6}};
  const Surface s = Surface::from_triangles(9, two);
  EXPECT_FALSE(s.halfedge(VertexId{0}).valid());
  EXPECT_FALSE(s.on_boundary(VertexId{0}));
  EXPECT_FALSE(s.find_halfedge(VertexId{0}, VertexId{1}).valid());
  const Components c = components_of(s);
  EXPECT_EQ(c.count, 5U);
  EXPECT_EQ(c.of_vertex, (std::vector<std::uint32_t>{0, 1, 1, 1, 2, 3, 3, 3, 4}));
}

TEST(Surface, EmptySurface) {
  const Surface s = Surface::from_triangles(0, {});
  EXPECT_EQ(s.vertex_count() + s.edge_count() + s.face_count(), 0U);
  EXPECT_EQ(components_of(s).count, 0U);
}

TEST(Surface, RefusesFacesThatAreNoSurface) {
  EXPECT_NE(refused(3, {{0, 1, 3}}).find("vertex 3"), std::string::npos);
  EXPECT_NE(refused(4, {{0, 1, 2}, {2, 1, 1}}).find("Face 1 uses a vertex twice"),
            std::string::npos);
  // Three faces at the edge 0-1, two of them with the same direction.
  const std::string three = refused(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_NE(three.find("vertices 0 and 1"), std::string::npos) << three;
  // Two faces that run along 0-1 in the same direction.
  EXPECT_NE(refused(4, {{0, 1, 2}, {0, 1, 3}}).find("Faces 0 and 1"), std::string::npos);
  EXPECT_NE(refused(3, {{0, 1, 2}, {0, 1, 2}}).find("Faces 0 and 1"), std::string::npos);
  // Bow-ties: two fans at the boundary; two closed fans.
  EXPECT_NE(refused(5, {{0, 1, 2}, {0, 3, 4}}).find("vertex 0"), std::string::npos);
  TestMesh twice = tetrahedron();
  for (const Triangle& t : tetrahedron().triangles) {
    Triangle shifted = t;
    for (std::uint32_t& v : shifted) v = v == 0 ? 0 : v + 3;
    twice.triangles.push_back(shifted);
  }
  EXPECT_NE(refused(7, twice.triangles).find("vertex 0"), std::string::npos);
}

TEST(Surface, TwoFacesBackToBackAreASphere) {
  const std::vector<Triangle> pillow = {{0, 1, 2}, {2, 1, 0}};
  const Surface s = Surface::from_triangles(3, pillow);
  expect_consistent(s);
  EXPECT_EQ(euler_characteristic(s), 2);
}

TEST(Surface, FanOfManyTrianglesIsBuiltInLinearTime) {
  // Quadratic in the degree would be 4·10^10 steps.
  constexpr std::uint32_t kRim = 200'000;
  std::vector<Triangle> fan;
  for (std::uint32_t k = 0; k < kRim; ++k) fan.push_back({0, 1 + k, 1 + (k + 1) % kRim});
  const auto start = std::chrono::steady_clock::now();
  const Surface s = Surface::from_triangles(kRim + 1, fan);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(s.edge_count(), 2U * kRim);
  EXPECT_LT(seconds.count(), 5.0);
}

TEST(Surface, GluingMakesATorusOfOneVertex) {
  // A square with opposite sides glued; its diagonal is a self-edge too.
  const std::vector<Triangle> t = {{0, 0, 0}, {0, 0, 0}};
  const Surface s = Surface::from_gluing(1, t, std::vector<std::uint32_t>{4, 5, 3, 2, 0, 1});
  expect_consistent(s);
  EXPECT_EQ(euler_characteristic(s), 0);
}

TEST(Surface, FaceGluedToItselfIsACone) {
  const std::vector<Triangle> t = {{0, 0, 1}};
  const Surface s = Surface::from_gluing(2, t, std::vector<std::uint32_t>{Surface::kNoSide, 2, 1});
  expect_consistent(s);
  EXPECT_TRUE(s.on_boundary(VertexId{0}));
  EXPECT_FALSE(s.on_boundary(VertexId{1}));
  EXPECT_EQ(euler_characteristic(s), 1);
  EXPECT_EQ(s.turn_ccw(s.halfedge(VertexId{1})), s.halfedge(VertexId{1}));
}

TEST(Surface, RefusesBadGluing) {
  const std::uint32_t no = Surface::kNoSide;
  const std::vector<Triangle> pair = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_NE(refused_gluing(4, pair, {no, no, no}).find("3 entries"), std::string::npos);
  EXPECT_NE(refused_gluing(4, pair, {3, no, no, no, no, no}).find("Side 0"), std::string::npos);
  EXPECT_NE(refused_gluing(4, pair, {0, no, no, no, no, no}).find("Side 0"), std::string::npos);
  EXPECT_NE(refused_gluing(4, pair, {17, no, no, no, no, no}).find("17"), std::string::npos);
  EXPECT_NE(refused_gluing(4, pair, {4, no, no, no, 0, no}).find("join different vertices"),
            std::string::npos);
  EXPECT_NE(refused_gluing(3, pair, {3, no, no, 0, no, no}).find("vertex 3"), std::string::npos);
  // Without gluing there are two fans at vertices 0 and 1.
  EXPECT_NE(refused_gluing(4, pair, {no, no, no, no, no, no}).find("fan"), std::string::npos);
}

TEST(Surface, RandomGluingsAreConsistent) {
  Random random(7);
  for (int k = 0; k < 300; ++k) {
    const Surface s = random_complex(random, 1 + random.below(9), random.uniform(0, 0.5));
    expect_consistent(s);
  }
}

TEST(Surface, RefusesInvalidLengths) {
  Surface s = surface_of(tetrahedron());
  EXPECT_NE(bad_mesh([&] { s.set_lengths({1, 2}); }).find("6 edges"), std::string::npos);
  for (const double bad :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> lengths(6, 1.0);
    lengths[3] = bad;
    const std::string message = bad_mesh([&] { s.set_lengths(lengths); });
    const HalfedgeId h = halfedge_of(EdgeId{3});
    const std::string where = "vertices " + std::to_string(s.tail(h).index()) + " and " +
                              std::to_string(s.head(h).index());
    EXPECT_NE(message.find(where), std::string::npos) << message;
  }
  s.set_lengths(std::vector<double>(6, 0.0));
  EXPECT_EQ(s.length(EdgeId{2}), 0.0);
}

}  // namespace
}  // namespace talweg
