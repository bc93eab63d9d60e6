// Fans of needles, caps, folds of no width, and lengths that violate the triangle inequality. Up to
// rounding each surface is a piece of the plane, so the straightened path is known.
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "intrinsic/test_paths.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/trace.hpp"

namespace talweg {
namespace {

using namespace test;

struct Straightened {
  double length = 0;
  SurfaceCurve curve;
  std::size_t clamped = 0;
};

/// Straightens and traces a path, and checks the invariants of every surface.
Straightened straighten(const TestMesh& mesh, const Surface& s,
                        const std::vector<std::size_t>& through) {
  SignpostTriangulation t(s);
  const Snapshot before = snapshot(t);
  const EdgePath path = path_through(t, through, false);
  const FlipOutResult result = FlipOut(t).run(std::span(&path, 1), {});
  EXPECT_EQ(result.paths[0].termination, Termination::kConverged);
  EXPECT_LE(result.paths[0].length_after, result.paths[0].length_before * (1 + 1e-12));
  TraceResult traced = Tracer(t).trace_and_undo(std::array{result.paths[0].path});
  EXPECT_EQ(snapshot(t), before);
  EXPECT_TRUE(runs_in_faces(s, traced.curves[0]));
  for (const SurfacePoint& p : traced.curves[0].points) {
    EXPECT_TRUE(std::isfinite(norm(position(s, mesh.points, p))));
  }
  return {result.paths[0].length_after, std::move(traced.curves[0]), traced.clamped};
}

/// A disc: the hub, 12 rim points, and `needles` rim points between the first two of them in two
/// narrow bundles. A needle is 1 long and 1 / aspect wide.
TestMesh fan(std::size_t needles, double aspect, std::size_t& middle) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < 12; ++k) {
    angles.push_back(2 * kPi * static_cast<double>(k) / 12);
    if (k != 1) continue;
    for (std::size_t i = 0; i < needles; ++i) {
      angles.push_back(angles[1] + static_cast<double>(i + 1) / aspect);
      if (i == needles / 2) middle = angles.size();  // counted after the hub
    }
  }
  TestMesh mesh;
  mesh.points.push_back({0, 0, 0});
  for (const double a : angles) mesh.points.push_back({std::cos(a), std::sin(a), 0});
  const auto n = static_cast<std::uint32_t>(angles.size());
  for (std::uint32_t k = 0; k < n; ++k) mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % n});
  return mesh;
}

TEST(DegenerateTriangles, FansOfNeedles) {
  for (const double aspect : {1e6, 1e8, 1e10, 1e12}) {
    for (const std::size_t needles : {100U, 400U}) {
      std::size_t middle = 0;
      const TestMesh mesh = fan(needles, aspect, middle);
      const Surface s = surface_of(mesh);
      // Past all needles over the hub: a chord. Also from within the bundle to the other side.
      const std::size_t last = 3 + needles;
      const std::pair<std::size_t, std::size_t> ends[] = {{1, last}, {middle, 4 + needles}};
      for (const auto& [from, to] : ends) {
        const Straightened r = straighten(mesh, s, {from, 0, to});
        const double chord = distance(mesh.points[from], mesh.points[to]);
        EXPECT_NEAR(r.length, chord, 1e-9) << aspect << ' ' << needles;
        EXPECT_NEAR(length_of(s, mesh.points, r.curve), chord, 1e-6) << aspect << ' ' << needles;
      }
    }
  }
}

TEST(DegenerateTriangles, PathsAlongTheRimOfNeedles) {
  // A path through every rim point of the bundle, in steps of length 1 / aspect.
  for (const double aspect : {1e6, 1e9, 1e12}) {
    std::size_t middle = 0;
    const std::size_t needles = 300;
    const TestMesh mesh = fan(needles, aspect, middle);
    const Surface s = surface_of(mesh);
    std::vector<std::size_t> rim;
    for (std::size_t k = 1; k <= 4 + needles; ++k) rim.push_back(k);
    const Straightened r = straighten(mesh, s, rim);
    EXPECT_NEAR(r.length, distance(mesh.points[rim.front()], mesh.points[rim.back()]), 1e-9);
    EXPECT_NEAR(length_of(s, mesh.points, r.curve), r.length, 1e-6);
  }
}

TEST(DegenerateTriangles, Caps) {
  // A cap vertex lies `off` above the segment between two vertices of the low row, so the triangle
  // below it has an angle close to pi.
  for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
    TestMesh mesh;
    const std::size_t n = 24;  // rows of n + 1 at height 0, and of n in between
    for (std::size_t k = 0; k <= n; ++k) mesh.points.push_back({static_cast<double>(k), 0, 0});
    for (std::size_t k = 0; k < n; ++k)
      mesh.points.push_back({static_cast<double>(k) + 0.5, off, 0});
    for (std::size_t k = 0; k <= n; ++k) mesh.points.push_back({static_cast<double>(k), 1, 0});
    const auto low = [](std::size_t k) { return static_cast<std::uint32_t>(k); };
    const auto cap = [&](std::size_t k) { return static_cast<std::uint32_t>(n + 1 + k); };
    const auto top = [&](std::size_t k) { return static_cast<std::uint32_t>(2 * n + 1 + k); };
    for (std::size_t k = 0; k < n; ++k) {
      mesh.triangles.push_back({low(k), low(k + 1), cap(k)});
      mesh.triangles.push_back({low(k), cap(k), top(k)});
      mesh.triangles.push_back({cap(k), low(k + 1), top(k + 1)});
      mesh.triangles.push_back({cap(k), top(k + 1), top(k)});
    }
    const Surface s = surface_of(mesh);
    // Up, along the caps, and down; and from corner to corner.
    std::vector<std::size_t> along = {top(0)};
    for (std::size_t k = 0; k < n; ++k) {
      along.push_back(cap(k));
      if (k + 1 < n) along.push_back(low(k + 1));
    }
    along.push_back(top(n));
    const Straightened r = straighten(mesh, s, along);
    EXPECT_NEAR(r.length, static_cast<double>(n), 1e-9) << off;
    EXPECT_NEAR(length_of(s, mesh.points, r.curve), r.length, 1e-6) << off;
    along.front() = low(0);
    const Straightened across = straighten(mesh, s, along);
    EXPECT_NEAR(across.length, std::hypot(static_cast<double>(n), 1.0), 1e-9) << off;
  }
}

TEST(DegenerateTriangles, PleatsOfNextToNoWidth) {
  // Every third column of a sheet is folded back and forth by w, which gives three layers there.
  // The unrolled sheet is wider. (Opening a mesh gives edges of zero length a length.)
  for (const double w : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const std::size_t nx = 18, ny = 6;
    TestMesh mesh = grid(nx, ny);
    std::vector<double> folded(nx + 1, 0), unrolled(nx + 1, 0);
    for (std::size_t i = 1; i <= nx; ++i) {
      const double step = i % 3 == 0 ? -w : i % 3 == 1 ? 1 : w;
      folded[i] = folded[i - 1] + step;
      unrolled[i] = unrolled[i - 1] + std::abs(step);
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      mesh.points[v][0] = folded[v % (nx + 1)];
    }
    const Surface s = surface_of(mesh);
    std::vector<std::size_t> stairs;  // along the lower side, then up the right one
    for (std::size_t i = 0; i <= nx; ++i) stairs.push_back(i);
    for (std::size_t j = 1; j <= ny; ++j) stairs.push_back(j * (nx + 1) + nx);
    const Straightened r = straighten(mesh, s, stairs);
    const double straight = std::hypot(unrolled[nx], static_cast<double>(ny));
    EXPECT_NEAR(r.length, straight, 1e-7) << w;
    EXPECT_NEAR(length_of(s, mesh.points, r.curve), straight, 1e-5) << w;
  }
}

TEST(DegenerateTriangles, LengthsThatViolateTheTriangleInequalityByRounding) {
  // Vertices on a line: each long side has the length of the other two sides up to a few ulp, more
  // or less.
  Random random(5);
  for (int run = 0; run < 200; ++run) {
    const TestMesh flat = grid(8, 8);
    TestMesh mesh = flat;
    for (Point& p : mesh.points) p[1] *= run % 2 == 0 ? 0 : 1e-17;  // all in one line
    Surface s = surface_of(mesh);
    std::vector<double> lengths;
    for (std::size_t e = 0; e < s.edge_count(); ++e) {
      lengths.push_back(s.length(EdgeId{e}) * (1 + 4e-16 * (random.uniform(0, 2) - 1)));
    }
    s.set_lengths(lengths);
    std::vector<std::size_t> way = {0};
    for (std::size_t k = 1; k <= 8; ++k) {
      way.push_back(k * 9 + k - 1);
      way.push_back(k * 9 + k);
    }
    const Straightened r = straighten(mesh, s, way);
    EXPECT_NEAR(r.length, 8, 1e-13 * 8);  // the length of the line
  }
}

}  // namespace
}  // namespace talweg
