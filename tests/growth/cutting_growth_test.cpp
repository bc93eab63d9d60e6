#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "core/small_meshes.hpp"
#include "growth/counted_work.hpp"
#include "growth/stroke.hpp"
#include "talweg/core/cutting/cut_plan.hpp"
#include "talweg/core/cutting/face_triangulation.hpp"
#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/mixed_order.hpp"
#include "talweg/core/cutting/plane_filling.hpp"

namespace talweg::test {
namespace {

struct Rim {
  std::vector<Point> points;
  Loop loop;
};

/// A plane loop around the origin, with waves.
Rim rim(std::size_t n, double waves, double height = 0) {
  Rim rim;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double r = 2 + std::sin(waves * angle);
    rim.points.emplace_back(r * std::cos(angle), r * std::sin(angle), height * std::sin(3 * angle));
  }
  rim.loop.resize(n);
  std::iota(rim.loop.begin(), rim.loop.end(), 0U);
  return rim;
}

TEST(Growth, PlaneLids) {
  const auto fill = [](double waves) {
    return [waves](std::size_t n) {
      return
          [rim = rim(n, waves)] { ASSERT_TRUE(fill_plane(rim.points, std::span(&rim.loop, 1))); };
    };
  };
  expect_growth("fill_plane, round", 1.2, {10, 100, 1000, 10000}, fill(0));
  expect_growth("fill_plane, 5 waves", 1.2, {10, 100, 1000, 10000, 100000}, fill(5));
  expect_growth("fill_plane, 50 waves", 1.2, {10, 100, 1000, 10000}, fill(50));
}

TEST(Growth, LidsOfLeastArea) {
  expect_growth("fill_loop", 1.1, {100, 2000, 8000}, [](std::size_t n) {
    return [rim = rim(n, 5, 0.3)] { (void)fill_loop(rim.points, rim.loop); };
  });
}

TEST(Growth, PlaneLoopsBesideAndAroundEachOther) {
  for (const bool nested : {false, true}) {
    expect_growth(nested ? "plane_groups, nested" : "plane_groups, beside", nested ? 2.1 : 1.3,
                  {50, 200, 800}, [&](std::size_t n) {
                    Rim all;
                    std::vector<Loop> loops;
                    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
                    for (std::size_t k = 0; k < n; ++k) {
                      Loop loop;
                      for (std::size_t i = 0; i < 8; ++i) {
                        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / 8;
                        const double r = nested ? 1.0 + static_cast<double>(k) : 0.3;
                        loop.push_back(static_cast<std::uint32_t>(all.points.size()));
                        const Point at = nested ? Point(0, 0, 0)
                                                : Point(static_cast<double>(k % side),
                                                        static_cast<double>(k / side), 0);
                        all.points.push_back(at + r * Point(std::cos(angle), std::sin(angle), 0));
                      }
                      if (k % 2 == 1) std::reverse(loop.begin(), loop.end());
                      loops.push_back(loop);
                    }
                    return [all, loops] { (void)plane_groups(all.points, loops); };
                  });
  }
}

FaceTriangulation::Place place(double a, double b) {
  constexpr auto kOne = static_cast<double>(FaceTriangulation::kOne);
  FaceTriangulation::Place p{0, std::llround(a * kOne), std::llround(b * kOne)};
  p[0] = FaceTriangulation::kOne - p[1] - p[2];
  return p;
}

TEST(Growth, PointsAlongTheSidesOfAFace) {
  expect_growth("FaceTriangulation, points on its sides", 1.3, {100, 1000, 10000},
                [](std::size_t n) {
                  return [n] {
                    FaceTriangulation face({PlanePoint{0, 0}, PlanePoint{1, 0}, PlanePoint{0, 1}});
                    const double step = 1 / static_cast<double>(n + 1);
                    for (std::size_t i = 1; i <= n; ++i)
                      face.insert(place(static_cast<double>(i) * step, 0));
                    face.improve();
                  };
                });
}

/// Few segments cross others, but without improve() they would cross the sides of n triangles.
TEST(Growth, SegmentsAcrossAFace) {
  const auto segments = [](std::size_t n) {
    return [n] {
      FaceTriangulation face({PlanePoint{0, 0}, PlanePoint{1, 0}, PlanePoint{0, 1}});
      std::vector<std::uint32_t> low(n), left(n);
      const MixedOrder mixed(n);
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = mixed[k];
        const double at = static_cast<double>(i + 1) / static_cast<double>(n + 1);
        low[i] = face.insert(place(at, 0));
        left[i] = face.insert(place(0, at));
      }
      face.improve();
      for (std::size_t i = 0; i < n; ++i) face.connect(low[i], left[i]);
      face.improve();
    };
  };
  expect_growth("FaceTriangulation, parallel segments", 1.4, {100, 1000, 10000}, segments);
}

/// Flipping every edge on the way of the segment would be quadratic in the number of edges.
TEST(Growth, ASegmentAcrossParallelOnes) {
  const auto segments = [](std::size_t n) {
    return [n] {
      FaceTriangulation face({PlanePoint{0, 0}, PlanePoint{1, 0}, PlanePoint{0, 1}});
      std::vector<std::array<std::uint32_t, 2>> ends(n);
      const MixedOrder mixed(n);
      for (std::size_t k = 0; k < n; ++k) {
        const double at = 0.5 * static_cast<double>(mixed[k] + 1) / static_cast<double>(n + 1);
        ends[mixed[k]] = {face.insert(place(0.1, at)), face.insert(place(0.4, at))};
      }
      const std::uint32_t low = face.insert(place(0.25, 0)), high = face.insert(place(0.26, 0.6));
      face.improve();
      face.connect(low, high);
      for (std::size_t k = 0; k < n; ++k) face.connect(ends[mixed[k]][0], ends[mixed[k]][1]);
      face.improve();
    };
  };
  expect_growth("FaceTriangulation, a segment across parallel ones", 1.5, {100, 1000, 10000},
                segments);
}

TEST(Growth, CuttingAlongAStrokeInOneFace) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(3, 3));
  expect_growth("plan_cut, points in a face", 1.5, {100, 400, 1600, 6400}, [&](std::size_t n) {
    return [&mesh, curve = stroke_in(mesh.surface(), FaceId{0}, n)] {
      (void)plan_cut(mesh, std::span(&curve, 1));
    };
  });
}

}  // namespace
}  // namespace talweg::test
