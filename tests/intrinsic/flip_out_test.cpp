#include "talweg/intrinsic/flip_out.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/point_insertion.hpp"
#include "talweg/intrinsic/trace.hpp"

namespace talweg {
namespace {

using namespace test;

constexpr double kStraight = kPi - 1e-5;

FlipOutResult straighten(SignpostTriangulation& t, const EdgePath& path,
                         const FlipOutOptions& options = {}) {
  return FlipOut(t).run(std::span(&path, 1), options);
}

/// Straightens, checks what every result must keep, and traces.
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
      // Joints up to 1e-5 off straight: longer by at most (1e-5)² / 2 for each, never shorter.
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
  const double step = 2 * std::sin(kPi / kAround);  // the prism's side
  for (std::size_t turn = 1; turn < 2 * kAround; turn += 5) {
    SignpostTriangulation t(s);
    // Around along the lowest ring, then up: homotopic to the helix of as many steps.
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
    // Two vertices of the octahedron's middle edges, 60° apart; both are in every level.
    std::size_t a = 0, b = 0;
    const double r = std::sqrt(0.5);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (distance(mesh.points[v], {r, r, 0}) < 1e-9) a = v;
      if (distance(mesh.points[v], {0, r, r}) < 1e-9) b = v;
    }
    const auto curve = straight_between(mesh, a, b);
    const double error = std::abs(length_of(s, mesh.points, curve) - kPi / 3);
    // Chords lie below the sphere: the error goes with the square of the edge length.
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
  // Half around on the outer ring: two tangents to the inner polygon and its arc between them.
  std::vector<std::size_t> half;
  for (std::size_t k = 0; k <= n / 2; ++k) half.push_back(k);
  const FlipOutResult result = straighten(t, path_through(t, half));
  // The polygon is touched at the vertex that is seen highest from the end (3, 0).
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
  // Towards the hole nothing can be cleared; on the other side no angle is below pi.
  const EdgePath& path = result.paths[0].path;
  for (std::size_t i = 0; i + 1 < path.halfedges().size(); ++i) {
    EXPECT_GE(corner_sum(t, path.halfedges()[i + 1], twin(path.halfedges()[i])), kStraight - 1e-9);
  }
}

TEST(FlipOut, GeodesicPassesThroughASaddleVertex) {
  // The inner corner (2, 2, ·) of an L-shaped solid's top: cone angle 5/2 pi at (2, 2, 2) where the
  // step meets the wall. The path between two walls is pinned to it from both sides.
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
  // Two spokes at least pi apart on both sides: a quarter of the cone more than straight.
  HalfedgeId back = h;
  while (back == h || corner_sum(t, h, back) < kPi - 1e-9) back = t.turn_ccw(back);
  ASSERT_GE(corner_sum(t, back, h), kPi);
  const EdgePath path = EdgePath::make(t, {twin(h), back}, false);
  const FlipOutResult result = straighten(t, path);
  EXPECT_EQ(result.iterations, 0U);
  EXPECT_EQ(result.paths[0].length_after, result.paths[0].length_before);
  // A cone of 2.5 pi holds paths that wander near it.
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
    if (!path.back().valid()) continue;  // a mesh edge that an insertion has split
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
  // 0 → 8 → 16, on to 17, 18 and back, then to 24.
  const FlipOutResult result =
      straighten(t, path_through(t, {0, 8, 16, 17, 18, 17, 16, 24, 16, 24}));
  EXPECT_NEAR(result.paths[0].length_after, distance(mesh.points[0], mesh.points[24]), 1e-9);
  Tracer(t).trace_and_undo({});
  // Out and back is all there is: the two ends are one vertex.
  const FlipOutResult nothing = straighten(t, path_through(t, {24, 25, 24}));
  EXPECT_EQ(nothing.paths[0].termination, Termination::kCollapsed);
  Tracer(t).trace_and_undo({});
  const FlipOutResult longer = straighten(t, path_through(t, {24, 25, 26, 25, 24}));
  EXPECT_EQ(longer.paths[0].termination, Termination::kCollapsed);
  EXPECT_GT(longer.paths[0].length_after, 0);
}

TEST(FlipOut, PinnedVerticesAreKept) {
  const TestMesh mesh = grid(6, 6);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  FlipOutOptions options;
  options.pinned = {VertexId{6}};
  const EdgePath around = path_through(t, {0, 1, 2, 3, 4, 5, 6, 13, 20, 27, 34, 41, 48});
  const FlipOutResult kept = straighten(t, around, options);
  EXPECT_NEAR(kept.paths[0].length_after, 12, 1e-12);
  Tracer(t).trace_and_undo({});
  options.pinned = {VertexId{20}};
  const FlipOutResult other = straighten(t, around, options);
  EXPECT_NEAR(other.paths[0].length_after, std::hypot(6, 2) + 4, 1e-8);
  EXPECT_EQ(other.paths[0].termination, Termination::kConverged);
}

TEST(FlipOut, PinsThatThePathDoesNotPassAreNothingToIt) {
  // On its way to the straight line the path meets vertices that are pinned for others.
  const TestMesh mesh = grid(8, 8, 0.2);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  std::vector<std::size_t> arch;
  for (std::size_t j = 1; j < 8; ++j) arch.push_back(9 * j);
  for (std::size_t i = 0; i < 8; ++i) arch.push_back(72 + i);
  for (std::size_t j = 8; j > 0; --j) arch.push_back(8 + 9 * j);
  FlipOutOptions options;
  for (std::size_t v = 0; v < s.vertex_count(); ++v) {
    if (std::find(arch.begin(), arch.end(), v) == arch.end()) options.pinned.emplace_back(v);
  }
  const FlipOutResult result = straighten(t, path_through(t, arch), options);
  EXPECT_NEAR(result.paths[0].length_after, 8, 1e-8);
  Tracer(t).trace_and_undo({});
  // A spike that ends at a pin stays; its foot may not slide when the pin is there.
  const EdgePath spike = path_through(t, {0, 10, 20, 21, 20, 30, 40});
  options.pinned = {VertexId{21}};
  const Point &a = mesh.points[0], &b = mesh.points[21], &c = mesh.points[40];
  EXPECT_NEAR(straighten(t, spike, options).paths[0].length_after, distance(a, b) + distance(b, c),
              1e-8);
  Tracer(t).trace_and_undo({});
  const Point& foot = mesh.points[20];
  options.pinned = {VertexId{20}};
  EXPECT_NEAR(straighten(t, spike, options).paths[0].length_after,
              distance(a, foot) + distance(foot, c), 1e-8);
}

TEST(FlipOut, OptionsAreChecked) {
  const Surface s = surface_of(grid(1, 1));
  SignpostTriangulation t(s);
  const EdgePath path = path_through(t, {0, 1});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, 1.0, nan}) {
    FlipOutOptions o;
    o.angle_tolerance = bad;
    EXPECT_THROW(straighten(t, path, o), Error);
  }
  for (const double bad : {-0.1, 1.0, nan}) {
    FlipOutOptions o;
    o.min_relative_length = bad;
    EXPECT_THROW(straighten(t, path, o), Error);
    o.min_relative_length = 0;
    o.length_floor = bad == 1.0 ? std::numeric_limits<double>::infinity() : bad;
    EXPECT_THROW(straighten(t, path, o), Error);
  }
  FlipOutOptions o;
  o.pinned = {VertexId{3}, VertexId{1}};
  EXPECT_THROW(straighten(t, path, o), Error);
}

TEST(FlipOut, NoPathsAndSingleEdges) {
  const Surface s = surface_of(grid(2, 2));
  SignpostTriangulation t(s);
  EXPECT_TRUE(FlipOut(t).run({}, {}).paths.empty());
  const FlipOutResult one = straighten(t, path_through(t, {0, 1}));
  EXPECT_EQ(one.paths[0].termination, Termination::kConverged);
  EXPECT_EQ(one.iterations, 0U);
}

TEST(FlipOut, LimitsAndCancelLeaveAUsableState) {
  const TestMesh mesh = sphere(4);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const Snapshot before = snapshot(t);
  Random random(2);
  const EdgePath path = EdgePath::make(t, random_walk(t, random, 400), false);
  const std::size_t whole = straighten(t, path).iterations;
  Tracer(t).trace_and_undo({});
  ASSERT_GT(whole, 100U);
  double last = path_length(t, path);
  for (std::size_t limit = 1; limit < whole + 3; limit += limit < 50 ? 1 : 17) {
    FlipOutOptions options;
    options.max_iterations = limit;
    const FlipOutResult result = straighten(t, path, options);
    EXPECT_EQ(result.iterations, std::min(limit, whole));
    EXPECT_LE(result.paths[0].length_after, last);
    EXPECT_EQ(result.paths[0].termination,
              limit < whole ? Termination::kLimit : Termination::kConverged);
    last = result.paths[0].length_after;
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_NEAR(length_of(s, mesh.points, traced.curves[0]), last, 1e-9 * last);
    EXPECT_EQ(snapshot(t), before);
  }
  for (int polls = 1; polls < 6; ++polls) {
    FlipOutOptions options;
    int left = polls;
    options.progress = [&](const char*, double share) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      return --left > 0;
    };
    const FlipOutResult result = straighten(t, path, options);
    EXPECT_EQ(result.paths[0].termination, Termination::kCancelled);
    Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_EQ(snapshot(t), before);
  }
  FlipOutOptions half;
  half.min_relative_length = 0.5;
  const FlipOutResult result = straighten(t, path, half);
  EXPECT_EQ(result.paths[0].termination, Termination::kLimit);
  EXPECT_LE(result.paths[0].length_after, 0.5 * result.paths[0].length_before);
  EXPECT_GT(result.paths[0].length_after, 0.3 * result.paths[0].length_before);
}

TEST(FlipOut, LazyAndPreparedAgreeBitForBit) {
  const TestMesh mesh = torus(24, 12, 3, 1);
  const Surface s = surface_of(mesh);
  const auto lift = [&](VertexId a, VertexId b, double length) {
    return std::hypot(length, mesh.points[a.index()][2] - mesh.points[b.index()][2]);
  };
  Random random(4);
  for (int k = 0; k < 20; ++k) {
    SignpostTriangulation lazy(s), prepared(s);
    lazy.set_metric(lift);
    prepared.set_metric(lift);
    prepared.prepare_all();
    const auto walk = random_walk(lazy, random, 50);
    const EdgePath path = EdgePath::make(lazy, walk, false);
    const FlipOutResult a = straighten(lazy, path), b = straighten(prepared, path);
    EXPECT_EQ(a.paths[0].length_after, b.paths[0].length_after);
    EXPECT_EQ(a.flips, b.flips);
    EXPECT_EQ(a.iterations, b.iterations);
    const auto x = Tracer(lazy).trace_and_undo(std::array{a.paths[0].path});
    const auto y = Tracer(prepared).trace_and_undo(std::array{b.paths[0].path});
    EXPECT_EQ(x.curves[0].points, y.curves[0].points);
  }
}

TEST(FlipOut, ScaleReversalAndNumbering) {
  const TestMesh mesh = torus(20, 10, 3, 1);
  const Surface s = surface_of(mesh);
  const auto vertices = shortest_vertices(s, 3, 137);
  SignpostTriangulation t(s);
  const double length = straighten(t, path_through(t, vertices)).paths[0].length_after;
  Tracer(t).trace_and_undo({});
  for (const double scale : {1e-8, 1e8}) {
    TestMesh scaled = mesh;
    for (Point& p : scaled.points) {
      for (double& x : p) x *= scale;
    }
    const Surface other = surface_of(scaled);
    SignpostTriangulation u(other);
    EXPECT_NEAR(straighten(u, path_through(u, vertices)).paths[0].length_after / scale, length,
                1e-12 * length);
  }
  // Joints up to 1e-5 off straight: a relative difference of (1e-5)² at most for each.
  const std::vector<std::size_t> reversed(vertices.rbegin(), vertices.rend());
  EXPECT_NEAR(straighten(t, path_through(t, reversed)).paths[0].length_after, length,
              1e-9 * length);
  TestMesh renumbered = mesh;
  const std::size_t n = mesh.points.size();
  const auto moved = [&](std::size_t v) { return (v * 77 + 13) % n; };  // 77 is prime to 200
  for (std::size_t v = 0; v < n; ++v) renumbered.points[moved(v)] = mesh.points[v];
  std::reverse(renumbered.triangles.begin(), renumbered.triangles.end());
  for (Triangle& f : renumbered.triangles) {
    for (std::uint32_t& v : f) v = static_cast<std::uint32_t>(moved(v));
    std::rotate(f.begin(), f.begin() + 1, f.end());
  }
  const Surface other = surface_of(renumbered);
  SignpostTriangulation u(other);
  std::vector<std::size_t> same;
  for (const std::size_t v : vertices) same.push_back(moved(v));
  EXPECT_NEAR(straighten(u, path_through(u, same)).paths[0].length_after, length, 1e-9 * length);
}

}  // namespace
}  // namespace talweg
