// Pins, limits, cancellation, and changes that must not affect a result.
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {
namespace {

using namespace test;

FlipOutResult straighten_with(SignpostTriangulation& t, const EdgePath& path,
                              const FlipOutOptions& options = {}) {
  return FlipOut(t).run(std::span(&path, 1), options);
}

TEST(FlipOutOptions, PinnedVerticesAreKept) {
  const TestMesh mesh = grid(6, 6);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  FlipOutOptions options;
  options.pinned = {VertexId{6}};
  const EdgePath around = path_through(t, {0, 1, 2, 3, 4, 5, 6, 13, 20, 27, 34, 41, 48});
  const FlipOutResult kept = straighten_with(t, around, options);
  EXPECT_NEAR(kept.paths[0].length_after, 12, 1e-12);
  Tracer(t).trace_and_undo({});
  options.pinned = {VertexId{20}};
  const FlipOutResult other = straighten_with(t, around, options);
  EXPECT_NEAR(other.paths[0].length_after, std::hypot(6, 2) + 4, 1e-8);
  EXPECT_EQ(other.paths[0].termination, Termination::kConverged);
}

TEST(FlipOutOptions, PinsOffThePathHaveNoEffect) {
  // While it is straightened, the path meets vertices that are pinned for other paths.
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
  const FlipOutResult result = straighten_with(t, path_through(t, arch), options);
  EXPECT_NEAR(result.paths[0].length_after, 8, 1e-8);
  Tracer(t).trace_and_undo({});
  // A spike with a pin at its tip stays. With a pin at its foot instead, the spike vanishes and the
  // foot stays.
  const EdgePath spike = path_through(t, {0, 10, 20, 21, 20, 30, 40});
  options.pinned = {VertexId{21}};
  const Point &a = mesh.points[0], &b = mesh.points[21], &c = mesh.points[40];
  EXPECT_NEAR(straighten_with(t, spike, options).paths[0].length_after,
              distance(a, b) + distance(b, c), 1e-8);
  Tracer(t).trace_and_undo({});
  const Point& foot = mesh.points[20];
  options.pinned = {VertexId{20}};
  EXPECT_NEAR(straighten_with(t, spike, options).paths[0].length_after,
              distance(a, foot) + distance(foot, c), 1e-8);
}

TEST(FlipOutOptions, OptionsAreChecked) {
  const Surface s = surface_of(grid(1, 1));
  SignpostTriangulation t(s);
  const EdgePath path = path_through(t, {0, 1});
  // The error message names the field.
  const auto expect_refused = [&](const FlipOutOptions& options, const char* field) {
    try {
      straighten_with(t, path, options);
      ADD_FAILURE() << field;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, 1.0, nan}) {
    expect_refused({.angle_tolerance = bad}, "angle_tolerance");
  }
  for (const double bad : {-0.1, 1.0, nan}) {
    expect_refused({.min_relative_length = bad}, "min_relative_length");
  }
  for (const double bad : {-0.1, infinity, nan})
    expect_refused({.length_floor = bad}, "length_floor");
  expect_refused({.pinned = {VertexId{3}, VertexId{1}}}, "sorted");
}

TEST(FlipOutOptions, NoPathsAndSingleEdges) {
  const Surface s = surface_of(grid(2, 2));
  SignpostTriangulation t(s);
  EXPECT_TRUE(FlipOut(t).run({}, {}).paths.empty());
  const FlipOutResult one = straighten_with(t, path_through(t, {0, 1}));
  EXPECT_EQ(one.paths[0].termination, Termination::kConverged);
  EXPECT_EQ(one.iterations, 0U);
}

TEST(FlipOutOptions, LimitsAndCancelLeaveAUsableState) {
  const TestMesh mesh = sphere(4);
  const Surface s = surface_of(mesh);
  SignpostTriangulation t(s);
  const Snapshot before = snapshot(t);
  Random random(2);
  const EdgePath path = EdgePath::make(t, random_walk(t, random, 400), false);
  const std::size_t whole = straighten_with(t, path).iterations;
  Tracer(t).trace_and_undo({});
  ASSERT_GT(whole, 100U);
  double last = path_length(t, path);
  for (std::size_t limit = 1; limit < whole + 3; limit += limit < 50 ? 1 : 17) {
    FlipOutOptions options;
    options.max_iterations = limit;
    const FlipOutResult result = straighten_with(t, path, options);
    EXPECT_EQ(result.iterations, std::min(limit, whole));
    EXPECT_LE(result.paths[0].length_after, last);
    EXPECT_EQ(result.paths[0].termination,
              limit < whole ? Termination::kLimit : Termination::kConverged);
    last = result.paths[0].length_after;
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_NEAR(length_of(s, mesh.points, traced.curves[0]), last, 1e-9 * last);
    EXPECT_EQ(snapshot(t), before);
  }
  for (const std::size_t most : {1U, 20U, 100U}) {
    FlipOutOptions options;
    options.max_flips = most;
    const FlipOutResult result = straighten_with(t, path, options);
    EXPECT_EQ(result.paths[0].termination, Termination::kLimit);
    EXPECT_GE(result.flips, most);
    EXPECT_LT(result.flips, most + 20);  // flips of the current wedge
    EXPECT_LT(result.paths[0].length_after, result.paths[0].length_before);
    const TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_NEAR(length_of(s, mesh.points, traced.curves[0]), result.paths[0].length_after,
                1e-9 * last);
    EXPECT_EQ(snapshot(t), before);
  }
  for (int polls = 1; polls < 6; ++polls) {
    FlipOutOptions options;
    int left = polls;
    const Progress progress = [&](const char*, double share) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      return --left > 0;
    };
    const FlipOutResult result = FlipOut(t).run(std::span(&path, 1), options, progress);
    EXPECT_EQ(result.paths[0].termination, Termination::kCancelled);
    Tracer(t).trace_and_undo(std::array{result.paths[0].path});
    EXPECT_EQ(snapshot(t), before);
  }
  FlipOutOptions half;
  half.min_relative_length = 0.5;
  const FlipOutResult result = straighten_with(t, path, half);
  EXPECT_EQ(result.paths[0].termination, Termination::kLimit);
  EXPECT_LE(result.paths[0].length_after, 0.5 * result.paths[0].length_before);
  EXPECT_GT(result.paths[0].length_after, 0.3 * result.paths[0].length_before);
}

TEST(FlipOutOptions, LazyAndPreparedAgreeBitForBit) {
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
    const FlipOutResult a = straighten_with(lazy, path), b = straighten_with(prepared, path);
    EXPECT_EQ(a.paths[0].length_after, b.paths[0].length_after);
    EXPECT_EQ(a.flips, b.flips);
    EXPECT_EQ(a.iterations, b.iterations);
    const auto x = Tracer(lazy).trace_and_undo(std::array{a.paths[0].path});
    const auto y = Tracer(prepared).trace_and_undo(std::array{b.paths[0].path});
    EXPECT_EQ(x.curves[0].points, y.curves[0].points);
  }
}

TEST(FlipOutOptions, ScaleReversalAndNumbering) {
  const TestMesh mesh = torus(20, 10, 3, 1);
  const Surface s = surface_of(mesh);
  const auto vertices = shortest_vertices(s, 3, 137);
  SignpostTriangulation t(s);
  const double length = straighten_with(t, path_through(t, vertices)).paths[0].length_after;
  Tracer(t).trace_and_undo({});
  for (const double scale : {1e-8, 1e8}) {
    TestMesh scaled = mesh;
    for (Point& p : scaled.points) {
      for (double& x : p) x *= scale;
    }
    const Surface other = surface_of(scaled);
    SignpostTriangulation u(other);
    EXPECT_NEAR(straighten_with(u, path_through(u, vertices)).paths[0].length_after / scale, length,
                1e-12 * length);
  }
  // A joint may be off straight by 1e-5, which changes the length by at most a relative (1e-5)² per
  // joint.
  const std::vector<std::size_t> reversed(vertices.rbegin(), vertices.rend());
  EXPECT_NEAR(straighten_with(t, path_through(t, reversed)).paths[0].length_after, length,
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
  EXPECT_NEAR(straighten_with(u, path_through(u, same)).paths[0].length_after, length,
              1e-9 * length);
}

}  // namespace
}  // namespace talweg
