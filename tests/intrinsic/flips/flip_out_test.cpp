#include "talweg/intrinsic/flips/flip_out.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/point_insertion.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {
namespace {

using namespace test;

constexpr double kStraight = kPi - 1e-5;

FlipOutResult straighten(SignpostTriangulation& t, const EdgePath& path,
                         const FlipOutOptions& options = {}) {
  return FlipOut(t).run(std::span(&path, 1), options);
}

/// Straightens and traces a path, and checks the invariants of every result.
SurfaceCurve straight_curve(const Surface& s, const TestMesh& mesh, const EdgePath& path,
                            SignpostTriangulation& t) {
  const Snapshot before = snapshot(t);
  const double length_before = path_length(t, path);
  const FlipOutResult result = straighten(t, path);
  EXPECT_EQ(result.paths.size(), 1U);
  EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
  EXPECT_EQ(result.blocked, 0U);
  EXPECT_DOUBLE_EQ(result.paths[0].length_before, length_before);
  EXPECT_LE(result.paths[0].length_after, length_before);
  EXPECT_NEAR(result.paths[0].length_after, path_length(t, result.paths[0].path), 1e-15);
  for (const double angle : side_angles(t, result.paths[0].path)) {
    EXPECT_GE(angle, kStraight - 1e-9);
  }
  const double length = result.paths[0].length_after;
  TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
  EXPECT_EQ(snapshot(t), before);
  EXPECT_EQ(traced.clamped, 0U);
  EXPECT_TRUE(runs_in_faces(s, traced.curves[0]));
  EXPECT_NEAR(length_of(s, mesh.points, traced.curves[0]) / length, 1.0, 1e-10);
  return traced.curves[0];
}

SurfaceCurve straight_between(const TestMesh& mesh, std::size_t from, std::size_t to) {
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const auto curve = straight_curve(s, mesh, path_through(t, shortest_vertices(s, from, to)), t);
  EXPECT_EQ(curve.points.front(), SurfacePoint::at_vertex(s, VertexId{from}));
  EXPECT_EQ(curve.points.back(), SurfacePoint::at_vertex(s, VertexId{to}));
  return curve;
}

TEST(FlipOut, PlaneGivesStraightLines) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const TestMesh mesh = grid(12, 12, 0.24, seed);
    const Surface s = surface_of(mesh);
    Random random(seed);
    for (int k = 0; k < 10; ++k) {
      const std::size_t a = random.below(169), b = random.below(169);
      if (a == b) continue;
      const Point &p = mesh.points[a], &q = mesh.points[b];
      const SurfaceCurve curve = straight_between(mesh, a, b);
      const double exact = distance(p, q), length = length_of(s, mesh.points, curve);
      // A joint may be off straight by 1e-5, so the length is longer by at most a relative (1e-5)²
      // / 2 per joint, and never shorter.
      EXPECT_GE(length, exact * (1 - 1e-12));
      EXPECT_LE(length, exact * (1 + 1e-9));
      for (const SurfacePoint& x : curve.points) {
        const Point d = q - p, e = position(s, mesh.points, x) - p;
        EXPECT_NEAR((d[0] * e[1] - d[1] * e[0]) / exact, 0, 1e-4);
      }
    }
  }
}

TEST(FlipOut, WanderingPathsInThePlaneBecomeStraightToo) {
  const TestMesh mesh = grid(9, 9, 0.2);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  Random random(17);
  for (int k = 0; k < 200; ++k) {
    const auto walk = self_avoiding_walk(t, random, 1 + random.below(60));
    const VertexId a = t.tail(walk.front()), b = t.head(walk.back());
    const FlipOutResult result = straighten(t, EdgePath::make(t, walk, false));
    EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
    EXPECT_EQ(result.blocked, 0U);
    const double exact = distance(mesh.points[a.index()], mesh.points[b.index()]);
    EXPECT_NEAR(result.paths[0].length_after, exact, 1e-8);
    EXPECT_EQ(t.tail(result.paths[0].path.halfedges().front()), a);
    EXPECT_EQ(t.head(result.paths[0].path.halfedges().back()), b);
    Tracer(t).trace_and_undo({});
  }
}

TEST(FlipOut, CylinderGivesHelices) {
  constexpr std::size_t kAround = 17, kUp = 9;
  const TestMesh mesh = cylinder(kAround, kUp, 1, 4);
  const Surface s = surface_of(mesh);
  const double step = 2 * std::sin(kPi / kAround);  // side of the prism
  for (std::size_t turn = 1; turn < 2 * kAround; turn += 5) {
    SignpostTriangulation t(s);
    // Around the lowest ring, then up: homotopic to the helix with as many steps.
    std::vector<std::size_t> vertices;
    for (std::size_t k = 0; k <= turn; ++k) vertices.push_back(k % kAround);
    for (std::size_t r = 1; r <= kUp; ++r) vertices.push_back(turn % kAround + r * kAround);
    const auto curve = straight_curve(s, mesh, path_through(t, vertices), t);
    const double exact = std::hypot(static_cast<double>(turn) * step, 4);
    EXPECT_NEAR(length_of(s, mesh.points, curve), exact, 1e-9 * exact);
    EXPECT_GE(length_of(s, mesh.points, curve), exact * (1 - 1e-12));
  }
}

TEST(FlipOut, BoxGivesUnfoldedLines) {
  const TestMesh mesh = box(6, 6, 6);
  const Surface s = surface_of(mesh);
  const auto at = [&](Point p) {
    return static_cast<std::size_t>(std::find(mesh.points.begin(), mesh.points.end(), p) -
                                    mesh.points.begin());
  };
  // From the top (z = 6) over the edge x = 6 to the side: unfold z to x = 6 + (6 - z).
  const struct {
    Point from, to;
    double exact;
  } cases[] = {{{3, 3, 6}, {6, 3, 3}, 6},
               {{3, 2, 6}, {6, 4, 3}, std::hypot(6, 2)},
               {{5, 1, 6}, {6, 4, 5}, std::hypot(2, 3)},
               {{4, 3, 6}, {6, 2, 1}, std::hypot(7, 1)}};
  for (const auto& c : cases) {
    const auto curve = straight_between(mesh, at(c.from), at(c.to));
    EXPECT_NEAR(length_of(s, mesh.points, curve), c.exact, 1e-8);
    EXPECT_GE(length_of(s, mesh.points, curve), c.exact * (1 - 1e-12));
  }
}

TEST(FlipOut, SphereConvergesToGreatCircles) {
  double last_error = 1;
  for (int level = 2; level <= 5; ++level) {
    const TestMesh mesh = sphere(level);
    const Surface s = surface_of(mesh);
    // Midpoints of two edges of the octahedron, 60° apart; both are vertices at every level.
    std::size_t a = 0, b = 0;
    const double r = std::sqrt(0.5);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (distance(mesh.points[v], {r, r, 0}) < 1e-9) a = v;
      if (distance(mesh.points[v], {0, r, r}) < 1e-9) b = v;
    }
    const auto curve = straight_between(mesh, a, b);
    const double error = std::abs(length_of(s, mesh.points, curve) - kPi / 3);
    // Chords lie below the sphere, so the error is quadratic in the edge length.
    EXPECT_LT(error, level == 2 ? 0.05 : last_error / 3);
    last_error = error;
  }
}

TEST(FlipOut, BoundaryPathHugsTheReflexCorner) {
  // An L: the square 6 × 6 without the upper right quarter, reflex corner at (3, 3).
  const TestMesh mesh =
      grid_without(6, 6, [](std::size_t i, std::size_t j) { return i >= 3 && j >= 3; });
  const Surface s = surface_of(mesh);
  const auto id = [](std::size_t i, std::size_t j) { return i + 7 * j; };
  const auto curve = straight_between(mesh, id(6, 1), id(1, 6));
  EXPECT_NEAR(length_of(s, mesh.points, curve), 2 * std::hypot(3, 2), 1e-9);
  bool through = false;
  for (const SurfacePoint& p : curve.points) {
    through |= p == SurfacePoint::at_vertex(s, VertexId{id(3, 3)});
  }
  EXPECT_TRUE(through);
}

TEST(FlipOut, AnnulusPathLeansOnTheHole) {
  constexpr std::size_t n = 60;
  const TestMesh mesh = annulus(n, 6, 1, 3);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  // A path half around on the outer ring becomes two tangents to the inner polygon and the arc
  // between them.
  std::vector<std::size_t> half;
  for (std::size_t k = 0; k <= n / 2; ++k) half.push_back(k);
  const FlipOutResult result = straighten(t, path_through(t, half));
  // The tangent touches the polygon at the vertex with the largest elevation from the end (3, 0).
  double highest = 0, exact = 0;
  for (std::size_t k = 0; k <= n / 4; ++k) {
    const double angle = 2 * kPi * static_cast<double>(k) / n;
    const double x = 3 - std::cos(angle), y = std::sin(angle);
    if (y / x < highest) continue;
    highest = y / x;
    exact = 2 * std::hypot(x, y) + static_cast<double>(n / 2 - 2 * k) * 2 * std::sin(kPi / n);
  }
  EXPECT_NEAR(result.paths[0].length_after, exact, 1e-9);
  EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
  // On the side of the hole nothing can be cleared; on the other side no angle is below pi.
  const EdgePath& path = result.paths[0].path;
  for (std::size_t i = 0; i + 1 < path.halfedges().size(); ++i) {
    EXPECT_GE(corner_sum(t, path.halfedges()[i + 1], twin(path.halfedges()[i])), kStraight - 1e-9);
  }
}

TEST(FlipOut, GeodesicPassesThroughASaddleVertex) {
  // The vertex (2, 2, 2) of an L-shaped solid, where the step meets the inner edge of the wall, has
  // a cone angle of 5/2 pi.
  const TestMesh mesh =
      voxels(4, 4, 4, [](int i, int j, int k) { return k < 2 || (i < 2 && j < 2); });
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  std::size_t saddle = 0;
  for (std::size_t v = 0; v < s.vertex_count(); ++v) {
    if (t.cone_angle(VertexId{v}) > 2 * kPi + 0.1 && mesh.points[v] == Point{2, 2, 2}) saddle = v;
  }
  EXPECT_NEAR(t.cone_angle(VertexId{saddle}), 2.5 * kPi, 1e-12);
  const HalfedgeId h = s.halfedge(VertexId{saddle});
  // Two spokes with angles of at least pi on both sides: the cone has a quarter more than a full
  // turn.
  HalfedgeId back = h;
  while (back == h || corner_sum(t, h, back) < kPi - 1e-9) back = t.turn_ccw(back);
  ASSERT_GE(corner_sum(t, back, h), kPi);
  const EdgePath path = EdgePath::make(t, {twin(h), back}, false);
  const FlipOutResult result = straighten(t, path);
  EXPECT_EQ(result.iterations, 0U);
  EXPECT_EQ(result.paths[0].length_after, result.paths[0].length_before);
  // Straightened random paths have no side angle below pi, also near the cone of 2.5 pi.
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    const auto walk = random_walk(t, random, 30);
    const FlipOutResult wandering = straighten(t, EdgePath::make(t, walk, false));
    if (wandering.paths[0].termination == Termination::kConverged && wandering.blocked == 0) {
      for (const double angle : side_angles(t, wandering.paths[0].path)) {
        EXPECT_GE(angle, kStraight - 1e-9);
      }
    }
    Tracer(t).trace_and_undo({});
  }
}

TEST(FlipOut, PathsBetweenInsertedPoints) {
  const TestMesh mesh = grid(8, 8, 0.2);
  const Surface s = surface_of(mesh);
  Random random(5);
  for (int k = 0; k < 30; ++k) {
    SignpostTriangulation t(s);
    PointInsertion insertion(t);
    const FaceId f{random.below(s.face_count())}, g{random.below(s.face_count())};
    const VertexId a = insertion.insert(SurfacePoint::in_face(s, f, {0.5, 0.25, 0.25}));
    const VertexId b = insertion.insert(SurfacePoint::in_face(s, g, {0.125, 0.625, 0.25}));
    std::vector<HalfedgeId> path;
    const VertexId from = s.corners(f)[1], to = s.corners(g)[2];
    insertion.connect(a, from, path);
    for (const HalfedgeId h :
         halfedges_through(t, shortest_vertices(s, from.index(), to.index()))) {
      path.push_back(h);
    }
    if (!path.back().valid()) continue;  // an insertion has split this mesh edge
    insertion.connect(to, b, path);
    const FlipOutResult result = straighten(t, EdgePath::make(t, path, false));
    const Point p = position(s, mesh.points, t.location(a));
    const Point q = position(s, mesh.points, t.location(b));
    EXPECT_NEAR(result.paths[0].length_after, distance(p, q), 1e-8);
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_NEAR(length_of(s, mesh.points, traced.curves[0]), distance(p, q), 1e-8);
    EXPECT_EQ(traced.curves[0].points.front(), t.location(a));
    EXPECT_EQ(traced.curves[0].points.back(), t.location(b));
  }
}

TEST(FlipOut, SpikesAreTakenBack) {
  const TestMesh mesh = grid(6, 6, 0.1);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  // A path 0 → 8 → 16, to 17, 18 and back, then to 24.
  const FlipOutResult result =
      straighten(t, path_through(t, {0, 8, 16, 17, 18, 17, 16, 24, 16, 24}));
  EXPECT_NEAR(result.paths[0].length_after, distance(mesh.points[0], mesh.points[24]), 1e-9);
  Tracer(t).trace_and_undo({});
  // A path only out and back: its two ends are the same vertex.
  const FlipOutResult nothing = straighten(t, path_through(t, {24, 25, 24}));
  EXPECT_EQ(nothing.paths[0].termination, Termination::kCollapsed);
  Tracer(t).trace_and_undo({});
  const FlipOutResult longer = straighten(t, path_through(t, {24, 25, 26, 25, 24}));
  EXPECT_EQ(longer.paths[0].termination, Termination::kCollapsed);
  EXPECT_GT(longer.paths[0].length_after, 0);
}

}  // namespace
}  // namespace talweg
