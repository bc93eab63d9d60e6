// Several paths on one triangulation: they share edges, meet, block each other, and never cross.
#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {
namespace {

using namespace test;

double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The number of proper crossings of two planar polylines: inside both segments by more than
/// rounding.
std::size_t crossings(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t j = 0; j + 1 < b.size(); ++j) {
      const Point u = a[i + 1] - a[i], v = b[j + 1] - b[j], w = b[j] - a[i];
      const double area = cross(u, v);
      if (std::abs(area) < 1e-6 * norm(u) * norm(v)) continue;
      const double s = cross(w, v) / area, t = cross(w, u) / area;
      const double margin = 1e-6;
      if (s > margin && s < 1 - margin && t > margin && t < 1 - margin) ++count;
    }
  }
  return count;
}

struct Outcome {
  FlipOutResult result;
  std::vector<std::vector<Point>> lines;
};

Outcome straighten_all(const Surface& s, const TestMesh& mesh, const std::vector<EdgePath>& paths,
                       SignpostTriangulation& t) {
  Outcome outcome{FlipOut(t).run(paths, {}), {}};
  std::vector<EdgePath> ends;
  for (const auto& p : outcome.result.paths) ends.push_back(p.path);
  const TraceResult traced = Tracer(t).trace_and_undo(ends);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const SurfaceCurve& curve = traced.curves[k];
    EXPECT_TRUE(runs_in_faces(s, curve));
    EXPECT_NEAR(length_of(s, mesh.points, curve), outcome.result.paths[k].length_after, 1e-9);
    std::vector<Point> line;
    for (const SurfacePoint& p : curve.points) line.push_back(position(s, mesh.points, p));
    if (curve.closed) line.push_back(line.front());
    outcome.lines.push_back(line);
  }
  return outcome;
}

TEST(FlipOutSets, SecondPathLeansOnTheFirst) {
  // The first path is straight along the middle row. The second path runs from below to above the
  // row around the end of the first path and may not cross it.
  const TestMesh mesh = grid(8, 8);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const auto id = [](std::size_t i, std::size_t j) { return i + 9 * j; };
  std::vector<std::size_t> wall, around;
  for (std::size_t i = 0; i <= 5; ++i) wall.push_back(id(i, 4));
  for (std::size_t i = 2; i <= 7; ++i) around.push_back(id(i, 1));
  for (std::size_t j = 2; j <= 7; ++j) around.push_back(id(7, j));
  for (std::size_t i = 7; i-- > 2;) around.push_back(id(i, 7));
  const auto [result, lines] =
      straighten_all(s, mesh, {path_through(t, wall), path_through(t, around)}, t);
  EXPECT_NEAR(result.paths[0].length_after, 5, 1e-12);
  // Taut around the wall's end at (5, 4).
  EXPECT_NEAR(result.paths[1].length_after, 2 * std::hypot(3, 3), 1e-9);
  EXPECT_GE(result.blocked, 1U);
  EXPECT_EQ(crossings(lines[0], lines[1]), 0U);
}

TEST(FlipOutSets, BlockedPathsAreFreeOnceTheOtherHasMoved) {
  // Nested arches over the same columns: in either order, both become straight.
  const TestMesh mesh = grid(10, 10, 0.2);
  const Surface s = surface_of(mesh);
  const auto id = [](std::size_t i, std::size_t j) { return i + 11 * j; };
  const auto arch = [&](std::size_t left, std::size_t right, std::size_t low, std::size_t high) {
    std::vector<std::size_t> v;
    for (std::size_t j = low; j < high; ++j) v.push_back(id(left, j));
    for (std::size_t i = left; i < right; ++i) v.push_back(id(i, high));
    for (std::size_t j = high; j > low; --j) v.push_back(id(right, j));
    v.push_back(id(right, low));
    return v;
  };
  for (const bool outer_first : {false, true}) {
    SignpostTriangulation t(s);
    // The inner arch starts lower, so the chord of the outer arch is free once the inner arch is
    // straight.
    const auto inner = arch(3, 7, 1, 7), outer = arch(2, 8, 2, 8);
    const auto a = path_through(t, outer_first ? outer : inner);
    const auto b = path_through(t, outer_first ? inner : outer);
    const auto [result, lines] = straighten_all(s, mesh, {a, b}, t);
    EXPECT_EQ(result.blocked, 0U);
    for (const auto& line : lines) {
      double length = 0;
      for (std::size_t k = 0; k + 1 < line.size(); ++k) length += distance(line[k], line[k + 1]);
      EXPECT_NEAR(length, distance(line.front(), line.back()), 1e-8);
    }
    EXPECT_EQ(crossings(lines[0], lines[1]), 0U);
  }
}

TEST(FlipOutSets, PathsThatShareEdgesKeepTheirSides) {
  // Both paths run along the middle row; one comes from above and leaves above, the other below.
  const TestMesh mesh = grid(8, 8);
  const Surface s = surface_of(mesh);
  const auto id = [](std::size_t i, std::size_t j) { return i + 9 * j; };
  const auto along = [&](std::size_t from, std::size_t to, bool reversed) {
    std::vector<std::size_t> v;
    const std::size_t step = 1;
    for (std::size_t j = from; j != 4; j += j < 4 ? step : -step) v.push_back(id(1, j));
    for (std::size_t i = 1; i <= 7; ++i) v.push_back(id(i, 4));
    for (std::size_t j = 4; j != to;) v.push_back(id(7, j += j < to ? step : -step));
    if (reversed) std::reverse(v.begin(), v.end());
    return v;
  };
  for (const bool reversed : {false, true}) {
    for (const bool upper_first : {false, true}) {
      SignpostTriangulation t(s);
      const auto upper = along(6, 6, false), lower = along(2, 2, reversed);
      const auto [result, lines] = straighten_all(s, mesh,
                                                  {path_through(t, upper_first ? upper : lower),
                                                   path_through(t, upper_first ? lower : upper)},
                                                  t);
      EXPECT_EQ(result.blocked, 0U);
      EXPECT_NEAR(result.paths[0].length_after, 6, 1e-9);
      EXPECT_NEAR(result.paths[1].length_after, 6, 1e-9);
      EXPECT_EQ(crossings(lines[0], lines[1]), 0U);
      // A path from above to below has to cross; its two bends at the shared row are on different
      // sides.
      SignpostTriangulation u(s);
      const auto through = along(6, 2, reversed), flat = along(4, 4, false);
      const auto outcome =
          straighten_all(s, mesh, {path_through(u, flat), path_through(u, through)}, u);
      EXPECT_NEAR(outcome.result.paths[0].length_after, 6, 1e-9);
      EXPECT_LE(outcome.result.paths[1].length_after, 10);
      EXPECT_LE(crossings(outcome.lines[0], outcome.lines[1]), 1U);
    }
  }
}

TEST(FlipOutSets, PathCannotPassAWallWhoseEdgesItShares) {
  // The wall turns by a right angle at a pin. The other path shares both edges there, on the outer
  // side, and is pulled towards the inner side.
  const TestMesh mesh = grid(8, 8);
  const Surface s = surface_of(mesh);
  const auto id = [](std::size_t i, std::size_t j) { return i + 9 * j; };
  const std::vector<std::size_t> wall = {id(2, 4), id(3, 4), id(4, 4), id(4, 5), id(4, 6)};
  std::vector<std::size_t> leaning = {id(3, 3), id(3, 4), id(4, 4), id(4, 5), id(5, 6)};
  FlipOutOptions options;
  options.pinned = {VertexId{id(4, 4)}};
  const double wall_length = 4, taut = std::sqrt(2) + std::sqrt(5);
  for (const bool reversed : {false, true}) {
    if (reversed) std::reverse(leaning.begin(), leaning.end());
    for (const std::size_t wall_first : {0U, 1U}) {
      SignpostTriangulation t(s);
      std::vector<EdgePath> paths = {path_through(t, leaning), path_through(t, wall)};
      if (wall_first == 1) std::swap(paths[0], paths[1]);
      const FlipOutResult result = FlipOut(t).run(paths, options);
      EXPECT_NEAR(result.paths[1 - wall_first].length_after, wall_length, 1e-12);
      EXPECT_NEAR(result.paths[wall_first].length_after, taut, 1e-9);
    }
  }
  // Without the pin the wall yields, and both paths become straight.
  SignpostTriangulation t(s);
  const std::array paths = {path_through(t, wall), path_through(t, leaning)};
  const FlipOutResult result = FlipOut(t).run(paths, {});
  EXPECT_NEAR(result.paths[0].length_after, std::hypot(2, 2), 1e-9);
  EXPECT_NEAR(result.paths[1].length_after, std::hypot(2, 3), 1e-9);
}

TEST(FlipOutSets, PathHangsOnTheEndOfAWallWhoseLastEdgeItShares) {
  const TestMesh mesh = grid(8, 8);
  const Surface s = surface_of(mesh);
  const auto id = [](std::size_t i, std::size_t j) { return i + 9 * j; };
  const std::vector<std::size_t> wall = {id(4, 6), id(4, 5), id(4, 4)};
  const std::vector<std::size_t> from_right = {id(5, 6), id(4, 5), id(4, 4),
                                               id(3, 4), id(3, 5), id(2, 5)};
  const std::vector<std::size_t> from_left = {id(3, 6), id(3, 5), id(4, 5),
                                              id(4, 4), id(5, 4), id(6, 5)};
  for (std::vector<std::size_t> hanging : {from_right, from_left}) {
    for (const bool reversed : {false, true}) {
      if (reversed) std::reverse(hanging.begin(), hanging.end());
      for (const std::size_t place : {0U, 1U}) {
        SignpostTriangulation t(s);
        std::vector<EdgePath> paths = {path_through(t, hanging), path_through(t, wall)};
        if (place == 1) std::swap(paths[0], paths[1]);
        const FlipOutResult result = FlipOut(t).run(paths, {});
        EXPECT_NEAR(result.paths[1 - place].length_after, 2, 1e-12);
        EXPECT_NEAR(result.paths[place].length_after, 2 * std::sqrt(5), 1e-9);
      }
    }
  }
}

TEST(FlipOutSets, EqualPathsStayTogether) {
  const TestMesh mesh = grid(8, 8, 0.2);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  Random random(41);
  for (int k = 0; k < 30; ++k) {
    const auto walk = self_avoiding_walk(t, random, 40);
    std::vector<HalfedgeId> back;
    for (std::size_t i = walk.size(); i-- > 0;) back.push_back(twin(walk[i]));
    const EdgePath there = EdgePath::make(t, walk, false);
    const EdgePath again = EdgePath::make(t, back, false);
    const auto [result, lines] = straighten_all(s, mesh, {there, again, there}, t);
    const double exact = distance(lines[0].front(), lines[0].back());
    for (const auto& p : result.paths) EXPECT_NEAR(p.length_after, exact, 1e-8);
  }
}

TEST(FlipOutSets, DisjointPathsNeverCross) {
  Random random(42);
  std::size_t blocked = 0;
  for (int k = 0; k < 400; ++k) {
    const TestMesh mesh = grid(9, 9, 0.2, 1 + random.below(1000));
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    // Self-avoiding walks that avoid each other, too.
    std::vector<EdgePath> paths;
    std::set<VertexId> met;
    for (int p = 0; p < 5; ++p) {
      auto walk = self_avoiding_walk(t, random, 40);
      std::vector<HalfedgeId> kept;
      for (const HalfedgeId h : walk) {
        if (met.contains(t.tail(h)) || met.contains(t.head(h))) break;
        kept.push_back(h);
      }
      if (kept.empty()) continue;
      met.insert(t.tail(kept.front()));
      for (const HalfedgeId h : kept) met.insert(t.head(h));
      paths.push_back(EdgePath::make(t, kept, false));
    }
    const Snapshot before = snapshot(t);
    const auto [result, lines] = straighten_all(s, mesh, paths, t);
    EXPECT_EQ(snapshot(t), before);
    blocked += result.blocked;
    for (std::size_t a = 0; a < lines.size(); ++a) {
      EXPECT_EQ(result.paths[a].termination, Termination::kConverged);
      EXPECT_LE(result.paths[a].length_after, result.paths[a].length_before);
      EXPECT_GE(result.paths[a].length_after,
                distance(lines[a].front(), lines[a].back()) * (1 - 1e-12));
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_EQ(crossings(lines[a], lines[b]), 0U) << k << ": " << a << ", " << b;
      }
    }
    // A path that no other path blocks becomes a straight line.
    if (result.blocked == 0) {
      for (std::size_t a = 0; a < lines.size(); ++a) {
        EXPECT_NEAR(result.paths[a].length_after, distance(lines[a].front(), lines[a].back()),
                    1e-8);
      }
    }
  }
  EXPECT_GT(blocked, 30U);
}

TEST(FlipOutSets, NestedLoopsOnADisc) {
  // Concentric loops shrink one inside the other; the inner loop collapses first, in either order.
  const TestMesh mesh = disc(12, 8);
  const Surface s = surface_of(mesh);
  for (const bool inner_first : {false, true}) {
    SignpostTriangulation t(s);
    std::vector<EdgePath> paths;
    for (const std::size_t r : {2U, 5U}) {
      std::vector<std::size_t> ring;
      for (std::size_t k = 0; k < 12; ++k) ring.push_back(k + 12 * r);
      paths.push_back(path_through(t, ring, true));
    }
    if (inner_first) std::swap(paths[0], paths[1]);
    FlipOutOptions options;
    options.length_floor = 0.8;
    const FlipOutResult result = FlipOut(t).run(paths, options);
    const std::size_t inner = inner_first ? 0 : 1;
    EXPECT_EQ(result.paths[inner].termination, Termination::kCollapsed);
    EXPECT_LT(result.paths[inner].length_after, 0.8);
    // The outer loop cannot pass through the rest of the inner loop.
    EXPECT_GE(result.paths[1 - inner].length_after, result.paths[inner].length_after * (1 - 1e-9));
    Tracer(t).trace_and_undo({});
  }
}

/// Whether a joint is bent although no path runs in its wedge or shares its edges.
bool has_free_bend(SignpostTriangulation& t, const std::vector<EdgePath>& paths) {
  std::vector<int> used(t.edge_count(), 0);
  for (const EdgePath& p : paths) {
    for (const HalfedgeId h : p.halfedges()) ++used[edge_of(h).index()];
  }
  for (const EdgePath& p : paths) {
    const auto h = p.halfedges();
    for (std::size_t i = 0; i + (p.closed() ? 0 : 1) < h.size(); ++i) {
      const HalfedgeId into = twin(h[i]), onward = h[(i + 1) % h.size()];
      if (used[edge_of(into).index()] > 1 || used[edge_of(onward).index()] > 1) continue;
      for (const auto& [from, to] : {std::pair{into, onward}, {onward, into}}) {
        if (corner_sum(t, from, to) >= kPi - 1.1e-5) continue;  // or past the boundary
        bool free = true;
        for (HalfedgeId k = t.turn_ccw(from); free && k != to; k = t.turn_ccw(k)) {
          free = used[edge_of(k).index()] == 0;
        }
        if (free) return true;
      }
    }
  }
  return false;
}

TEST(FlipOutSets, ManyPathsOnRandomComplexes) {
  Random random(43);
  std::size_t checked = 0;
  for (int k = 0; k < 4000; ++k) {
    const Surface s = random_complex(random, 1 + random.below(12), random.uniform(0, 0.4));
    SignpostTriangulation t(s);
    const Snapshot before = snapshot(t);
    std::vector<EdgePath> paths;
    for (std::size_t p = 0; p < 3; ++p) {
      const auto walk = random_walk(t, random, 1 + random.below(10));
      paths.push_back(EdgePath::make(
          t, walk, t.tail(walk.front()) == t.head(walk.back()) && random.below(2) == 0));
    }
    const FlipOutResult result = FlipOut(t).run(paths, {});
    std::vector<EdgePath> ends;
    bool converged = true;
    for (const auto& p : result.paths) {
      converged &= p.termination == Termination::kConverged;
      ASSERT_NE(p.termination, Termination::kLimit) << k;
      ASSERT_LE(p.length_after, p.length_before * (1 + 1e-12)) << k;
      ends.push_back(p.path);
    }
    // Blocked joints are examined again when the other paths have moved.
    if (converged) {
      ++checked;
      ASSERT_FALSE(has_free_bend(t, ends)) << k;
    }
    Tracer(t).trace_and_undo(ends);
    ASSERT_EQ(snapshot(t), before);
  }
  EXPECT_GT(checked, 2000U);
}

TEST(FlipOutSets, CancelAtAnyMoment) {
  const TestMesh mesh = torus(30, 16, 3, 1);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const Snapshot before = snapshot(t);
  Random random(44);
  for (int k = 0; k < 40; ++k) {
    std::vector<EdgePath> paths;
    for (int p = 0; p < 4; ++p) {
      paths.push_back(EdgePath::make(t, random_walk(t, random, 200), false));
    }
    FlipOutOptions options;
    std::size_t polls = 1 + random.below(12);
    const Progress progress = [&](const char*, double) { return --polls > 0; };
    const FlipOutResult result = FlipOut(t).run(paths, options, progress);
    std::vector<EdgePath> ends;
    for (const auto& p : result.paths) ends.push_back(p.path);
    const TraceResult traced = Tracer(t).trace_and_undo(ends);
    EXPECT_EQ(snapshot(t), before);
    for (std::size_t p = 0; p < 4; ++p) {
      EXPECT_NEAR(length_of(s, mesh.points, traced.curves[p]), result.paths[p].length_after, 1e-7);
    }
  }
}

}  // namespace
}  // namespace talweg
