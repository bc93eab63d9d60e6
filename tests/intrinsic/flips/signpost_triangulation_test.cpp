#include "talweg/intrinsic/flips/signpost_triangulation.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"

namespace talweg {
namespace {

using namespace test;

double planar_distance(const TestMesh& mesh, VertexId a, VertexId b) {
  return distance(mesh.points[a.index()], mesh.points[b.index()]);
}

/// The planar angle from direction a → b counterclockwise to a → c, in [0, 2 pi).
double planar_angle(const TestMesh& mesh, VertexId a, VertexId b, VertexId c) {
  const Point u = mesh.points[b.index()] - mesh.points[a.index()];
  const Point v = mesh.points[c.index()] - mesh.points[a.index()];
  const double angle = std::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
  return angle < 0 ? angle + 2 * kPi : angle;
}

/// The difference of two angles modulo 2 pi.
double turn_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

TEST(SignpostTriangulation, FlipThenUndoRestoresEveryBit) {
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    const Surface s = k % 4 == 0 ? surface_of(torus(4, 3, 3, 1))
                                 : random_complex(random, 2 + random.below(8), 0.2, k % 3);
    SignpostTriangulation t(s);
    const Snapshot before = snapshot(t);
    const std::size_t flips = flip_at_random(t, random, 60);
    EXPECT_EQ(t.flip_count(), flips);
    while (t.flip_count() > 0) t.undo_flip();
    EXPECT_EQ(snapshot(t), before);
  }
}

TEST(SignpostTriangulation, FourFlipsOfOneEdgeTurnItAroundOnce) {
  const TestMesh mesh = grid(1, 1);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const EdgeId diagonal = edge_of(s.find_halfedge(VertexId{0}, VertexId{3}));
  const HalfedgeId h = halfedge_of(diagonal);
  std::vector<std::size_t> tails;
  for (int k = 0; k < 4; ++k) {
    tails.push_back(t.tail(h).index());
    const VertexId old_tail = t.tail(h), old_head = t.head(h);
    ASSERT_TRUE(t.flip(diagonal));
    EXPECT_NE(t.tail(h), old_tail);
    EXPECT_NE(t.tail(h), old_head);
    EXPECT_NEAR(t.length(h), std::sqrt(2), 1e-15);
  }
  EXPECT_EQ(t.tail(h).index(), tails[0]);
  EXPECT_EQ(t.tail(h).index(), s.tail(h).index());
  // Each flip turns the edge counterclockwise by a quarter.
  EXPECT_NE(tails[0], tails[2]);
  EXPECT_NE(tails[1], tails[3]);
}

TEST(SignpostTriangulation, RefusesFlipsThatLeaveTheDiamond) {
  // The edge 0-1 of a kite that is not convex at vertex 0.
  const TestMesh dart = {{{0, 0, 0}, {3, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  const Surface s = surface_of(dart);
  SignpostTriangulation t(s);
  const Snapshot before = snapshot(t);
  for (std::size_t e = 0; e < s.edge_count(); ++e) EXPECT_FALSE(t.flip(EdgeId{e}));
  EXPECT_EQ(snapshot(t), before);
  EXPECT_EQ(t.flip_count(), 0U);
  // Two right angles side by side: the diamond is a triangle, and its other diagonal one of the
  // sides.
  const TestMesh flat = {{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  const Surface flat_surface = surface_of(flat);
  SignpostTriangulation flat_t(flat_surface);
  EXPECT_FALSE(flat_t.flip(edge_of(flat_surface.find_halfedge(VertexId{0}, VertexId{1}))));
}

TEST(SignpostTriangulation, FaceGluedToItselfDoesNotFlip) {
  const std::vector<Triangle> one = {{0, 0, 1}};
  Surface s = Surface::from_gluing(2, one, std::vector<std::uint32_t>{Surface::kNoSide, 2, 1});
  s.set_lengths({1, 1});
  SignpostTriangulation t(s);
  EXPECT_FALSE(t.flip(EdgeId{0}));
  EXPECT_FALSE(t.flip(EdgeId{1}));
  EXPECT_NEAR(t.cone_angle(VertexId{1}), kPi / 3, 1e-15);
  EXPECT_NEAR(t.cone_angle(VertexId{0}), 2 * kPi / 3, 1e-15);
}

TEST(SignpostTriangulation, LengthsAndDirectionsAgreeWithThePlane) {
  // A flip computes a length from five others with an error of a few ulp divided by the smallest
  // angle, here 20 times that. Errors add up over thousands of flips.
  constexpr double kTolerance = 1e-11;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const TestMesh mesh = grid(8, 8, 0.24, seed);
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    Random random(seed);
    EXPECT_GT(flip_fat(t, random, 20000, 0.05), 2000U);
    for (std::size_t e = 0; e < t.edge_count(); ++e) {
      const HalfedgeId h = halfedge_of(EdgeId{e});
      EXPECT_NEAR(t.length(h), planar_distance(mesh, t.tail(h), t.head(h)), kTolerance);
    }
    for (std::size_t v = 0; v < t.vertex_count(); ++v) {
      const HalfedgeId first = t.halfedge(VertexId{v});
      HalfedgeId h = first;
      do {
        const double expected = planar_angle(mesh, VertexId{v}, t.head(first), t.head(h));
        EXPECT_LT(turn_between(t.angle_ccw(first, h), expected), 100 * kTolerance);
        if (!t.has_face(h)) break;
        h = t.turn_ccw(h);
      } while (h != first);
      // The cone angle of the signposts stays the sum of the corners after any flips.
      if (!t.on_boundary(VertexId{v})) {
        EXPECT_NEAR(corner_sum(t, first, first), 2 * kPi, 100 * kTolerance);
        EXPECT_NEAR(t.cone_angle(VertexId{v}), 2 * kPi, 1e-14);
      }
    }
  }
}

TEST(SignpostTriangulation, AnglesBetweenSpokesAreSumsOfCorners) {
  Random random(11);
  for (int k = 0; k < 300; ++k) {
    const Surface s = random_complex(random, 2 + random.below(10), random.uniform(0, 0.3));
    SignpostTriangulation t(s);
    flip_at_random(t, random, random.below(20));
    for (std::size_t v = 0; v < t.vertex_count(); ++v) {
      std::vector<HalfedgeId> spokes;
      const HalfedgeId first = t.halfedge(VertexId{v});
      HalfedgeId h = first;
      do {
        spokes.push_back(h);
        if (!t.has_face(h)) break;
        h = t.turn_ccw(h);
      } while (h != first);
      for (const HalfedgeId a : spokes) {
        for (const HalfedgeId b : spokes) {
          if (a == b) {
            EXPECT_EQ(t.angle_ccw(a, b), 0);
            continue;
          }
          const double expected = corner_sum(t, a, b), angle = t.angle_ccw(a, b);
          if (std::isinf(expected)) {
            EXPECT_TRUE(std::isinf(angle));
          } else {
            EXPECT_NEAR(angle, expected, 1e-6);
          }
        }
      }
    }
  }
}

TEST(SignpostTriangulation, ConeAnglesOfKnownVertices) {
  const Surface cube = surface_of(box(1, 1, 1));
  SignpostTriangulation t(cube);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_NEAR(t.cone_angle(VertexId{v}), 1.5 * kPi, 1e-14);
  const Surface square = surface_of(grid(1, 1));
  SignpostTriangulation flat(square);
  for (std::size_t v = 0; v < 4; ++v) EXPECT_NEAR(flat.cone_angle(VertexId{v}), kPi / 2, 1e-15);
  const Surface lonely = Surface::from_triangles(4, std::vector<Triangle>{{0, 1, 2}});
  SignpostTriangulation with_lonely(lonely);
  EXPECT_EQ(with_lonely.cone_angle(VertexId{3}), 0);
  with_lonely.prepare_all();
}

SignpostTriangulation::Metric bumpy(const TestMesh& mesh) {
  return [&mesh](VertexId a, VertexId b, double length) {
    const auto height = [&](VertexId v) {
      const Point& p = mesh.points[v.index()];
      return std::sin(p[0]) * std::cos(2 * p[1]) + p[2];
    };
    return std::hypot(length, height(a) - height(b));
  };
}

TEST(SignpostTriangulation, LazyAndPreparedAgreeBitForBit) {
  for (const bool lifted : {false, true}) {
    const TestMesh mesh = grid(7, 7, 0.2);
    const Surface s = surface_of(mesh);
    SignpostTriangulation lazy(s), prepared(s);
    if (lifted) {
      lazy.set_metric(bumpy(mesh));
      prepared.set_metric(bumpy(mesh));
    }
    prepared.prepare_all();
    EXPECT_TRUE(lazy.touched().empty());
    EXPECT_EQ(prepared.touched().size(), s.vertex_count());
    Random a(9), b(9);
    EXPECT_EQ(flip_at_random(lazy, a, 500), flip_at_random(prepared, b, 500));
    EXPECT_EQ(snapshot(lazy), snapshot(prepared));
  }
}

TEST(SignpostTriangulation, OneFlipTouchesFourVertices) {
  const Surface s = surface_of(grid(20, 20));
  SignpostTriangulation t(s);
  int asked = 0;
  t.set_metric([&](VertexId, VertexId, double length) {
    ++asked;
    return length;
  });
  EXPECT_EQ(asked, 0);
  ASSERT_TRUE(t.flip(edge_of(s.find_halfedge(VertexId{220}, VertexId{242}))));
  EXPECT_EQ(t.touched().size(), 4U);
  // The stars of four vertices, with six triangles each.
  EXPECT_LE(asked, 4 * 12);
}

TEST(SignpostTriangulation, SetMetricForgetsAndReturns) {
  const TestMesh mesh = grid(5, 5, 0.2);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const Snapshot own = snapshot(t);
  t.set_metric(bumpy(mesh));
  const Snapshot lifted = snapshot(t);
  EXPECT_FALSE(own == lifted);
  for (std::size_t e = 0; e < t.edge_count(); ++e) {
    EXPECT_GE(t.length(EdgeId{e}), s.length(EdgeId{e}));
  }
  t.set_metric({});
  EXPECT_EQ(snapshot(t), own);
}

TEST(SignpostTriangulation, FindHalfedgeAfterFlips) {
  const Surface s = surface_of(grid(6, 6, 0.2));
  SignpostTriangulation t(s);
  Random random(4);
  flip_at_random(t, random, 500);
  for (std::size_t i = 0; i < 2 * t.edge_count(); ++i) {
    const HalfedgeId found = t.find_halfedge(t.tail(HalfedgeId{i}), t.head(HalfedgeId{i}));
    ASSERT_TRUE(found.valid());
    EXPECT_EQ(t.tail(found), t.tail(HalfedgeId{i}));
    EXPECT_EQ(t.head(found), t.head(HalfedgeId{i}));
  }
}

TEST(SignpostTriangulation, SplitsAfterALookAreSeen) {
  // Directions and lengths computed before an insertion must not be used after it.
  const TestMesh mesh = grid(2, 2);
  const Surface s = surface_of(mesh);
  SignpostTriangulation looked(s), fresh(s);
  looked.prepare_all();
  for (SignpostTriangulation* t : {&looked, &fresh}) {
    const HalfedgeId h = s.find_halfedge(VertexId{1}, VertexId{4});
    // The faces of the edge are (1, 4, 0) on the left and (4, 1, 5) on the right.
    const VertexId m = t->split_edge(h, {0.25, 0.75, std::hypot(1, 0.25), std::hypot(1, 0.75)},
                                     SurfacePoint::on_edge(s, edge_of(h), 0.25));
    EXPECT_EQ(t->head(h), m);
    EXPECT_NEAR(t->cone_angle(m), 2 * kPi, 1e-14);
    const HalfedgeId f = s.halfedge(FaceId{7});
    const double third = std::sqrt(5) / 3, half = std::sqrt(2) / 3;
    const auto corners = s.corners(FaceId{7});
    std::array<double, 3> lengths{};
    for (std::size_t k = 0; k < 3; ++k) {
      // The corner with the right angle is nearest to the centre of the face.
      lengths[k] = corners[k].index() == 7 ? half : third;
    }
    const VertexId c =
        t->split_face(f, lengths, SurfacePoint::in_face(s, FaceId{7}, {1 / 3., 1 / 3., 1 / 3.}));
    EXPECT_NEAR(t->cone_angle(c), 2 * kPi, 1e-14);
  }
  EXPECT_EQ(snapshot(looked), snapshot(fresh));
}

TEST(SignpostTriangulation, RemoveInsertedRestoresEveryBit) {
  const Surface s = surface_of(grid(3, 3, 0.2));
  SignpostTriangulation t(s);
  const Snapshot before = snapshot(t);
  Random random(8);
  for (int round = 0; round < 3; ++round) {
    for (int k = 0; k < 10; ++k) {
      const HalfedgeId h{random.below(2 * s.edge_count())};
      if (!t.has_face(h)) continue;
      const SurfacePoint somewhere = SurfacePoint::at_vertex(s, VertexId{0});
      if (k % 2 == 0) {
        const double half = t.surface_length(edge_of(h)) / 2;
        t.split_edge(h, {half, half, 1, 1}, somewhere);
      } else {
        t.split_face(h, {1, 1, 1}, somewhere);
      }
    }
    EXPECT_GT(t.inserted_count(), 0U);
    t.remove_inserted();
    EXPECT_EQ(t.inserted_count(), 0U);
    EXPECT_EQ(snapshot(t), before);
  }
}

}  // namespace
}  // namespace talweg
