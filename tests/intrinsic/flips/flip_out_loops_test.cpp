// Closed paths: loops that stay, loops that collapse, loops of one edge.
#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {
namespace {

using namespace test;

constexpr double kLoopStraight = kPi - 1e-5;

FlipOutResult straighten_loop(SignpostTriangulation& t, const EdgePath& path, double floor = 0) {
  FlipOutOptions options;
  options.length_floor = floor;
  return FlipOut(t).run(std::span(&path, 1), options);
}

std::vector<std::size_t> ring(std::size_t n, std::size_t r) {
  std::vector<std::size_t> vertices(n);
  for (std::size_t k = 0; k < n; ++k) vertices[k] = k + r * n;
  return vertices;
}

void expect_geodesic(SignpostTriangulation& t, const FlipOutResult& result) {
  EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
  EXPECT_EQ(result.blocked, 0U);
  for (const double angle : side_angles(t, result.paths[0].path)) {
    EXPECT_GE(angle, kLoopStraight - 1e-9);
  }
}

TEST(FlipOutLoops, CylinderLoopIsItsCircumference) {
  for (const std::size_t n : {3U, 4U, 5U, 12U, 40U}) {
    const TestMesh mesh = cylinder(n, 6, 1, 2);
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    const double circumference =
        2 * static_cast<double>(n) * std::sin(kPi / static_cast<double>(n));
    // A loop that climbs from ring to ring and comes down again.
    std::vector<std::size_t> wavy;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t low = 1, high = 5;
      for (std::size_t r = low; r <= high; ++r) {
        wavy.push_back(k + (k % 2 == 0 ? r : high + low - r) * n);
      }
    }
    if (n % 2 == 1) {  // down again after the climb of the last column
      for (std::size_t r = 4; r >= 1; --r) wavy.push_back(n - 1 + r * n);
    }
    std::vector<std::size_t> tidy;
    for (const std::size_t v : wavy) {
      if (tidy.empty() || tidy.back() != v) tidy.push_back(v);
    }
    const FlipOutResult result = straighten_loop(t, path_through(t, tidy, true));
    expect_geodesic(t, result);
    EXPECT_NEAR(result.paths[0].length_after, circumference, 1e-8) << n;
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_TRUE(traced.curves[0].closed);
    EXPECT_TRUE(runs_in_faces(s, traced.curves[0]));
    EXPECT_NEAR(length_of(s, mesh.points, traced.curves[0]), circumference, 1e-8);
    // A ring is straight from the beginning.
    EXPECT_EQ(straighten_loop(t, path_through(t, ring(n, 2), true)).iterations, 0U);
  }
}

TEST(FlipOutLoops, TwiceAroundTheCylinder) {
  const TestMesh mesh = cylinder(5, 4, 1, 2);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  std::vector<std::size_t> twice = ring(5, 2);
  const auto again = ring(5, 2);
  twice.insert(twice.end(), again.begin(), again.end());
  const FlipOutResult result = straighten_loop(t, path_through(t, twice, true));
  EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
  EXPECT_NEAR(result.paths[0].length_after, 20 * std::sin(kPi / 5), 1e-12);
}

TEST(FlipOutLoops, TorusLoopsKeepTheirHandle) {
  const TestMesh mesh = torus(24, 10, 3, 1);
  const Surface s = surface_of(mesh);
  for (std::size_t i = 0; i < 24; i += 5) {
    SignpostTriangulation t(s);
    // A loop around the tube at column i, with detours.
    std::vector<std::size_t> loop;
    for (std::size_t j = 0; j < 10; ++j) {
      loop.push_back(i * 10 + j);
      if (j % 3 == 1) {
        loop.push_back((i + 1) % 24 * 10 + j);
        loop.push_back((i + 2) % 24 * 10 + j);
        loop.push_back((i + 2) % 24 * 10 + j + 1);
        loop.push_back((i + 1) % 24 * 10 + j + 1);
      }
    }
    const FlipOutResult result = straighten_loop(t, path_through(t, loop, true));
    expect_geodesic(t, result);
    // The section of the tube is a decagon at a column, narrower between two columns.
    double shortest = 0;
    for (int j = 0; j < 10; ++j) {
      const double u = 2 * kPi * j / 10, v = u + 2 * kPi / 10;
      shortest +=
          std::hypot((std::cos(v) - std::cos(u)) * std::cos(kPi / 24), std::sin(v) - std::sin(u));
    }
    EXPECT_GE(result.paths[0].length_after, shortest * (1 - 1e-12));
    EXPECT_LE(result.paths[0].length_after, 20 * std::sin(kPi / 10) * (1 + 1e-8));
    Tracer(t).trace_and_undo({});
    // A loop around the hole slides to the inner rim; no loop around the hole is shorter.
    std::vector<std::size_t> around;
    for (std::size_t k = 0; k < 24; ++k) around.push_back(k * 10 + 3);
    const FlipOutResult hole = straighten_loop(t, path_through(t, around, true));
    EXPECT_GE(hole.paths[0].length_after, 2 * 24 * 2 * std::sin(kPi / 24) * (1 - 1e-12));
    EXPECT_LE(hole.paths[0].length_after, 2 * 24 * 2 * std::sin(kPi / 24) * (1 + 1e-8));
    Tracer(t).trace_and_undo({});
  }
}

TEST(FlipOutLoops, LoopAroundAHandleOfADoubleTorus) {
  for (const int n : {1, 2}) {
    const TestMesh mesh = double_torus(n);
    const Surface s = surface_of(mesh);
    const auto at = [&](int i, int j, int k) {
      const Point p = {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
      const auto it = std::find_if(mesh.points.begin(), mesh.points.end(),
                                   [&](const Point& q) { return distance(p, q) < 1e-12; });
      return static_cast<std::size_t>(it - mesh.points.begin());
    };
    // Around the bar between the two holes, a square of side 1.
    const auto side = [&](std::size_t a, std::size_t b) {
      auto path = shortest_vertices(s, a, b);
      path.pop_back();
      return path;
    };
    std::vector<std::size_t> loop;
    const std::size_t corners[] = {at(2, 1, 0), at(2, 1, 1), at(3, 1, 1), at(3, 1, 0)};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto part = side(corners[k], corners[(k + 1) % 4]);
      loop.insert(loop.end(), part.begin(), part.end());
    }
    SignpostTriangulation t(s);
    const FlipOutResult result = straighten_loop(t, path_through(t, loop, true));
    EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
    EXPECT_NEAR(result.paths[0].length_after, 4, 1e-9);
  }
}

TEST(FlipOutLoops, ContractibleLoopsCollapse) {
  struct Case {
    TestMesh mesh;
    std::vector<std::size_t> loop;
  };
  std::vector<Case> cases;
  for (const std::size_t r : {1U, 2U, 4U}) cases.push_back({disc(12, 6), ring(12, r)});
  cases.push_back({cone(12, 6, 1, 3), ring(12, 2)});
  cases.push_back({cone(5, 6, 1, 0.5), ring(5, 1)});
  cases.push_back(
      {grid(6, 6, 0.2), {8, 9, 10, 11, 12, 19, 26, 33, 40, 39, 38, 37, 36, 29, 22, 15}});
  cases.push_back({tetrahedron(), {0, 1, 2}});
  cases.push_back({octahedron(), {0, 2, 4}});
  for (const Case& c : cases) {
    const Surface s = surface_of(c.mesh);
    double mean = 0;
    for (const double l : s.lengths()) mean += l / static_cast<double>(s.edge_count());
    for (const double floor : {0.0, 0.1 * mean, 3 * mean}) {
      SignpostTriangulation t(s);
      const Snapshot before = snapshot(t);
      const FlipOutResult result = straighten_loop(t, path_through(t, c.loop, true), floor);
      // A tetrahedron and an octahedron have closed geodesics of their own.
      if (result.paths[0].termination == Termination::kConverged) {
        for (const double angle : side_angles(t, result.paths[0].path)) {
          EXPECT_GE(angle, kLoopStraight - 1e-9);
        }
        EXPECT_LE(c.mesh.points.size(), 6U);
      } else {
        EXPECT_EQ(result.paths[0].termination, Termination::kCollapsed);
        // The loop is below the floor, or it was the last loop before an edge out and back.
        const auto h = result.paths[0].path.halfedges();
        EXPECT_TRUE(h.size() != 2 || edge_of(h[0]) != edge_of(h[1]));
        if (floor > mean && c.mesh.points.size() > 6) {
          EXPECT_LT(result.paths[0].length_after, floor);
        }
      }
      EXPECT_GT(result.paths[0].length_after, 0);
      const double length = result.paths[0].length_after;
      const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
      EXPECT_TRUE(runs_in_faces(s, traced.curves[0]));
      EXPECT_NEAR(length_of(s, c.mesh.points, traced.curves[0]), length, 1e-10);
      EXPECT_EQ(snapshot(t), before);
    }
  }
}

TEST(FlipOutLoops, LoopBelowTheFloorStaysAsItIs) {
  const Surface s = surface_of(disc(12, 6));
  SignpostTriangulation t(s);
  const FlipOutResult result = straighten_loop(t, path_through(t, ring(12, 3), true), 100);
  EXPECT_EQ(result.paths[0].termination, Termination::kCollapsed);
  EXPECT_EQ(result.iterations, 0U);
  EXPECT_EQ(result.paths[0].path.halfedges().size(), 12U);
  // The floor is for loops only.
  EXPECT_EQ(straighten_loop(t, path_through(t, {0, 1}), 100).paths[0].termination,
            Termination::kConverged);
}

TEST(FlipOutLoops, LoopOnAConvexSphereEndsWhateverItsShape) {
  // On the symmetric sphere an equator is a geodesic; elsewhere loops slip off.
  const TestMesh mesh = sphere(3);
  const Surface s = surface_of(mesh);
  Random random(9);
  std::size_t collapsed = 0;
  for (int k = 0; k < 60; ++k) {
    SignpostTriangulation t(s);
    const std::size_t a = random.below(s.vertex_count()), b = random.below(s.vertex_count()),
                      c = random.below(s.vertex_count());
    if (a == b || b == c || c == a) continue;
    std::vector<std::size_t> loop;
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) {
      const auto part = shortest_vertices(s, from, to);
      loop.insert(loop.end(), part.begin(), part.end() - 1);
    }
    const EdgePath path = path_through(t, loop, true);
    const FlipOutResult result = straighten_loop(t, path, k % 2 == 0 ? 0.3 : 0);
    EXPECT_LE(result.paths[0].length_after, result.paths[0].length_before);
    EXPECT_NE(result.paths[0].termination, Termination::kLimit);
    collapsed += result.paths[0].termination == Termination::kCollapsed ? 1U : 0U;
    if (result.paths[0].termination == Termination::kConverged && result.blocked == 0) {
      for (const double angle : side_angles(t, result.paths[0].path)) {
        EXPECT_GE(angle, kLoopStraight - 1e-9);
      }
    }
    const double length = result.paths[0].length_after;
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_NEAR(length_of(s, mesh.points, traced.curves[0]), length, 1e-9);
  }
  EXPECT_GT(collapsed, 5U);
}

TEST(FlipOutLoops, OneEdgeLoopOnAThinLimbOpensToItsWaist) {
  // Rings of three, thinner in the middle: the loop starts as one edge of a Δ-complex, made by
  // flipping, and must slide to the waist.
  std::vector<std::array<double, 2>> rings;
  for (int r = 0; r <= 12; ++r) {
    rings.push_back({0.2 + 0.02 * (r - 6) * (r - 6), 0.8 * r});
  }
  const TestMesh mesh = rings_of(3, rings);
  const Surface s = surface_of(mesh);
  for (const std::size_t r : {1U, 3U, 5U, 6U, 8U, 11U}) {
    SignpostTriangulation t(s);
    const FlipOutResult result = straighten_loop(t, path_through(t, ring(3, r), true));
    expect_geodesic(t, result);
    EXPECT_NEAR(result.paths[0].length_after, 6 * 0.2 * std::sin(kPi / 3), 1e-7) << r;
    EXPECT_GE(result.paths[0].length_after, 6 * 0.2 * std::sin(kPi / 3) * (1 - 1e-12));
  }
}

TEST(FlipOutLoops, OneEdgeLoopOfAConeEndsWithoutArea) {
  // One triangle glued to itself: a cone of angle 60° whose rim is one edge. The loop bends by
  // 2/3 pi < pi on its side and there is nothing but the tip: collapsed at once, as it was.
  const std::vector<Triangle> one = {{0, 0, 1}};
  Surface s = Surface::from_gluing(2, one, std::vector<std::uint32_t>{Surface::kNoSide, 2, 1});
  s.set_lengths({1, 1});
  for (const std::size_t h : {0U, 1U}) {
    SignpostTriangulation t(s);
    const FlipOutResult result = straighten_loop(t, EdgePath::make(t, {HalfedgeId{h}}, true));
    EXPECT_EQ(result.paths[0].termination, Termination::kCollapsed);
    EXPECT_EQ(result.paths[0].length_after, 1);
  }
}

TEST(FlipOutLoops, ClosedGeodesicOfOneEdgeOnTheFlatTorus) {
  // A square torus of one vertex: sides 1, diagonal √2, all of them straight loops.
  const std::vector<Triangle> two = {{0, 0, 0}, {0, 0, 0}};
  Surface s = Surface::from_gluing(1, two, std::vector<std::uint32_t>{4, 5, 3, 2, 0, 1});
  std::vector<double> lengths(3, 1.0);
  lengths[2] = std::sqrt(2);
  s.set_lengths(lengths);
  SignpostTriangulation t(s);
  EXPECT_NEAR(t.cone_angle(VertexId{0}), 2 * kPi, 1e-14);
  for (std::size_t h = 0; h < 6; ++h) {
    const FlipOutResult result = straighten_loop(t, EdgePath::make(t, {HalfedgeId{h}}, true));
    expect_geodesic(t, result);
    EXPECT_EQ(result.iterations, 0U);
  }
  // A loop once along each side is homotopic to one of the diagonals.
  const HalfedgeId a = halfedge_of(EdgeId{0}), b = halfedge_of(EdgeId{1});
  for (const HalfedgeId second : {b, twin(b)}) {
    const FlipOutResult result = straighten_loop(t, EdgePath::make(t, {a, second}, true));
    expect_geodesic(t, result);
    EXPECT_NEAR(result.paths[0].length_after, std::sqrt(2), 1e-12);
    Tracer(t).trace_and_undo({});
  }
}

}  // namespace
}  // namespace talweg
