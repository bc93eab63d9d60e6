// Random Δ-complexes, needles and faces of zero area: every run ends, lengths never grow, and a
// traced curve has the length of its path.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {
namespace {

using namespace test;

/// A random path; mostly closed if the walk returns to its beginning.
EdgePath random_path(SignpostTriangulation& t, Random& random, std::size_t steps) {
  const auto walk = random_walk(t, random, 1 + random.below(steps));
  bool closed = t.tail(walk.front()) == t.head(walk.back()) && random.below(4) != 0;
  return EdgePath::make(t, walk, closed);
}

/// Whether a joint is bent although nothing blocks it, not even another passage of the path itself.
bool has_free_bend(SignpostTriangulation& t, const EdgePath& path) {
  const auto h = path.halfedges();
  std::vector<char> used(t.edge_count(), 0);
  for (const HalfedgeId x : h) used[edge_of(x).index()] = 1;
  for (std::size_t i = 0; i + (path.closed() ? 0 : 1) < h.size(); ++i) {
    const HalfedgeId into = twin(h[i]), onward = h[(i + 1) % h.size()];
    if (into == onward) continue;
    for (const auto& [from, to] : {std::pair{into, onward}, {onward, into}}) {
      if (corner_sum(t, from, to) >= kPi - 1.1e-5) continue;
      bool free = true;
      for (HalfedgeId k = t.turn_ccw(from); k != to; k = t.turn_ccw(k)) {
        free &= used[edge_of(k).index()] == 0;
      }
      std::size_t on_from = 0, on_to = 0;
      for (const HalfedgeId x : h) {
        on_from += edge_of(x) == edge_of(from) ? 1U : 0U;
        on_to += edge_of(x) == edge_of(to) ? 1U : 0U;
      }
      if (free && on_from == 1 && on_to == 1) return true;
    }
  }
  return false;
}

TEST(Robustness, RandomComplexes) {
  Random random(31);
  std::size_t converged = 0, collapsed = 0, bends = 0;
  for (int k = 0; k < 3000; ++k) {
    const Surface s = random_complex(random, 1 + random.below(12), random.uniform(0, 0.4));
    SignpostTriangulation t(s);
    const Snapshot before = snapshot(t);
    const EdgePath path = random_path(t, random, 14);
    FlipOutOptions options;
    options.length_floor = k % 3 == 0 ? 0.5 : 0;
    const FlipOutResult result = FlipOut(t).run(std::span(&path, 1), options);
    const auto& end = result.paths[0];
    ASSERT_NE(end.termination, Termination::kLimit) << k;
    ASSERT_TRUE(std::isfinite(end.length_after));
    ASSERT_LE(end.length_after, end.length_before * (1 + 1e-12)) << k;
    ASSERT_GT(end.length_after, 0);
    const EdgePath checked = EdgePath::make(
        t, {end.path.halfedges().begin(), end.path.halfedges().end()}, path.closed());
    if (!path.closed()) {
      ASSERT_EQ(t.tail(checked.halfedges().front()), s.tail(path.halfedges().front()));
      ASSERT_EQ(t.head(checked.halfedges().back()), s.head(path.halfedges().back()));
    }
    if (end.termination == Termination::kConverged) {
      ++converged;
      if (result.blocked == 0 && has_free_bend(t, end.path)) {
        ++bends;
        ADD_FAILURE() << "complex " << k << " stays bent";
      }
    } else {
      ++collapsed;
    }
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{end.path});
    ASSERT_EQ(snapshot(t), before) << k;
    ASSERT_FALSE(traced.curves[0].points.empty());
  }
  EXPECT_GT(converged, 1000U);
  EXPECT_GT(collapsed, 50U);
}

TEST(Robustness, RandomComplexesOfNeedles) {
  Random random(32);
  for (int k = 0; k < 2000; ++k) {
    const Surface s = random_complex(random, 1 + random.below(12), random.uniform(0, 0.4),
                                     random.uniform(0.5, 6));
    SignpostTriangulation t(s);
    const Snapshot before = snapshot(t);
    const EdgePath path = random_path(t, random, 14);
    const FlipOutResult result = FlipOut(t).run(std::span(&path, 1), {});
    ASSERT_NE(result.paths[0].termination, Termination::kLimit) << k;
    ASSERT_TRUE(std::isfinite(result.paths[0].length_after));
    ASSERT_LE(result.paths[0].length_after, result.paths[0].length_before * (1 + 1e-12)) << k;
    Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    ASSERT_EQ(snapshot(t), before) << k;
  }
}

TEST(Robustness, LengthNeverRisesStepByStep) {
  Random random(33);
  for (int k = 0; k < 200; ++k) {
    const Surface s = random_complex(random, 2 + random.below(10), random.uniform(0, 0.3));
    SignpostTriangulation t(s);
    const EdgePath path = random_path(t, random, 12);
    double last = path_length(t, path);
    for (std::size_t limit = 1; limit < 60; ++limit) {
      FlipOutOptions options;
      options.max_iterations = limit;
      const FlipOutResult result = FlipOut(t).run(std::span(&path, 1), options);
      ASSERT_LE(result.paths[0].length_after, last * (1 + 1e-14)) << k << " " << limit;
      last = result.paths[0].length_after;
      Tracer(t).trace_and_undo({});
      if (result.paths[0].termination != Termination::kLimit) break;
    }
  }
}

/// A mesh with some vertices moved onto their neighbours, exactly or almost.
TestMesh damaged(TestMesh mesh, Random& random, std::size_t count, bool exact) {
  const Surface s = Surface::from_triangles(mesh.points.size(), mesh.triangles);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t v = random.below(mesh.points.size());
    const Point target = mesh.points[s.head(s.halfedge(VertexId{v})).index()];
    for (std::size_t x = 0; x < 3; ++x) {
      mesh.points[v][x] = target[x] + (exact ? 0 : 1e-9 * random.uniform(-1, 1));
    }
  }
  return mesh;
}

TEST(Robustness, ZeroAreasAndNeedlesInRealSurfaces) {
  Random random(34);
  std::size_t clamped = 0;
  for (int k = 0; k < 400; ++k) {
    const TestMesh whole = k % 3 == 0   ? grid(8, 8, 0.2)
                           : k % 3 == 1 ? sphere(2)
                                        : torus(9, 6, 3, 1);
    const TestMesh mesh = damaged(whole, random, 1 + random.below(10), k % 2 == 0);
    const Surface s = surface_of(mesh);
    SignpostTriangulation t(s);
    const Snapshot before = snapshot(t);
    const auto walk = k % 4 == 0 ? random_walk(t, random, 30) : self_avoiding_walk(t, random, 30);
    const EdgePath path = EdgePath::make(t, walk, false);
    const FlipOutResult result = FlipOut(t).run(std::span(&path, 1), {});
    ASSERT_NE(result.paths[0].termination, Termination::kLimit) << k;
    const double length = result.paths[0].length_after;
    ASSERT_TRUE(std::isfinite(length));
    ASSERT_LE(length, result.paths[0].length_before * (1 + 1e-12));
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    clamped += traced.clamped;
    ASSERT_TRUE(runs_in_faces(s, traced.curves[0])) << k;
    ASSERT_EQ(snapshot(t), before);
    // Unfolding through faces of width 1e-9 loses digits, but gives a result.
    ASSERT_NEAR(length_of(s, mesh.points, traced.curves[0]), length, 1e-5 * (1 + length)) << k;
  }
  RecordProperty("clamped", static_cast<int>(clamped));
}

TEST(Robustness, AllLengthsZero) {
  Surface s = surface_of(octahedron());
  s.set_lengths(std::vector<double>(s.edge_count(), 0.0));
  SignpostTriangulation t(s);
  for (const bool closed : {false, true}) {
    const EdgePath path = path_through(t, {0, 2, 4}, closed);
    const FlipOutResult result = FlipOut(t).run(std::span(&path, 1), {});
    EXPECT_EQ(result.paths[0].length_after, 0);
    Tracer(t).trace_and_undo(std::array{result.paths[0].path});
  }
}

TEST(Robustness, OneWorkspaceServesManyRuns) {
  // State left by a run in FlipOut and Tracer must not affect the next run.
  const TestMesh mesh = torus(12, 7, 3, 1);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  FlipOut flip_out(t);
  Tracer tracer(t);
  Random random(35);
  for (int k = 0; k < 200; ++k) {
    std::vector<EdgePath> paths;
    for (std::size_t p = 0; p <= random.below(3); ++p) paths.push_back(random_path(t, random, 40));
    FlipOutOptions options;
    if (k % 4 == 0) options.max_iterations = 1 + random.below(30);
    const FlipOutResult used = flip_out.run(paths, options);
    std::vector<EdgePath> ends;
    for (const auto& p : used.paths) ends.push_back(p.path);
    const TraceResult a = tracer.trace_and_undo(ends);
    SignpostTriangulation fresh(s);
    const FlipOutResult again = FlipOut(fresh).run(paths, options);
    std::vector<EdgePath> other;
    for (const auto& p : again.paths) other.push_back(p.path);
    const TraceResult b = Tracer(fresh).trace_and_undo(other);
    for (std::size_t p = 0; p < paths.size(); ++p) {
      ASSERT_EQ(used.paths[p].length_after, again.paths[p].length_after);
      ASSERT_EQ(a.curves[p].points, b.curves[p].points);
    }
  }
}

}  // namespace
}  // namespace talweg
