#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/small_meshes.hpp"
#include "growth/counted_work.hpp"
#include "growth/stroke.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"

namespace talweg::test {
namespace {

TEST(Growth, DistanceToManyPointsInAFace) {
  const Surface surface = surface_of_lists(grid(4, 4));
  PolylineDistance distance(surface);
  expect_growth("PolylineDistance, points in a face", 2.1, {250, 1000, 4000}, [&](std::size_t n) {
    return [&, curve = stroke_in(surface, FaceId{12}, n)] {
      distance.set(std::span(&curve, 1));
      distance.reach(3);
    };
  });
}

/// A zigzag with n points on each of the long edges of a strip of elongated squares.
struct Zigzag {
  Surface surface;
  SurfaceCurve curve;
};
Zigzag across_long_edges(std::size_t n) {
  constexpr std::uint32_t kRows = 6;
  MeshLists lists = grid(1, kRows);
  for (Point& p : lists.points) p.x() *= 1000;
  Zigzag result{surface_of_lists(lists), {}};
  const auto on = [&](std::uint32_t row, double t) {
    return between(result.surface, 2 * row, 2 * row + 1, t);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    // Over the diagonal of the square in the middle, between row 2 and row 3.
    const std::uint32_t from = i % 2 == 0 ? 2 : 3;
    if (i > 0) {
      const double between_them = t - 0.5 / static_cast<double>(n);
      result.curve.points.push_back(between(result.surface, 4, 7, between_them));
    }
    result.curve.points.push_back(on(from, t));
  }
  return result;
}

TEST(Growth, DistanceToManyPointsOnLongEdges) {
  expect_growth("PolylineDistance, points on long edges", 2.2, {250, 1000, 4000},
                [](std::size_t n) {
                  return [z = across_long_edges(n)] {
                    PolylineDistance distance(z.surface);
                    distance.set(std::span(&z.curve, 1));
                    distance.reach(2);
                  };
                });
}

TEST(Growth, DistanceAmongNeedles) {
  const auto strip = [](double ratio) {
    MeshLists lists = grid(40, 8);
    for (Point& p : lists.points) p.x() *= ratio;
    return surface_of_lists(lists);
  };
  // From a ratio of 1e-3 on, the work may not grow with the thinness of the needles.
  std::vector<Growth> growth;
  for (const double ratio : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const Surface surface = strip(ratio);
    SurfaceCurve curve;
    for (std::uint32_t i = 0; i <= 40; ++i)
      curve.points.push_back(SurfacePoint::at_vertex(surface, VertexId{4 * 41 + i}));
    const std::uint64_t before = blocks_run();
    PolylineDistance distance(surface);
    distance.set(std::span(&curve, 1));
    distance.reach(4);
    growth.push_back({static_cast<std::size_t>(std::lround(1 / ratio)), blocks_run() - before});
  }
  EXPECT_LE(exponent("PolylineDistance, needles 1:n", growth), 0.02);
  EXPECT_LE(growth.back().blocks, 4 * growth[1].blocks);
}

/// Exact distances would have windows of each strip on most edges, with an exponent of 1.84.
TEST(Growth, DistanceOfADrawingAcrossNeedles) {
  expect_growth(
      "PolylineDistance, few windows, across needles", 1.3, {1000, 2000, 4000}, [](std::size_t n) {
        const double width = 40.0 / static_cast<double>(n);
        MeshLists lists = grid(static_cast<std::uint32_t>(n), 1);
        for (Point& p : lists.points) {
          p = Point(width * p.x(), 20 * p.y(), 0.3 * width * std::cos(3 * p.x()));
        }
        const Surface surface = surface_of_lists(lists);
        SurfaceCurve curve;
        const auto add = [&](std::size_t from, std::size_t to, double t) {
          const HalfedgeId h = surface.find_halfedge(VertexId{from}, VertexId{to});
          const bool along = halfedge_of(edge_of(h)) == h;
          curve.points.push_back(SurfacePoint::on_edge(surface, edge_of(h), along ? t : 1 - t));
        };
        const auto height = [n](std::size_t i) {
          return 0.5 + 0.2 * std::sin(12 * static_cast<double>(i) / static_cast<double>(n));
        };
        for (std::size_t i = 0; i <= n; ++i) {
          add(i, n + 1 + i, height(i));
          if (i < n) add(i, n + 2 + i, (height(i) + height(i + 1)) / 2);
        }
        return [surface, curve] {
          PolylineDistance distance(surface);
          distance.set_with_few_windows(std::span(&curve, 1));
          distance.reach(8);
        };
      });
}

TEST(Growth, DeviationOfStrokesInOneFace) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  expect_growth("DeviationMeter, points in a face", 2.1, {60, 250, 1000}, [&](std::size_t n) {
    SurfaceCurve drawn = stroke_in(mesh.surface(), FaceId{12}, n), result;
    for (std::size_t i = 0; i < n; i += 3) result.points.push_back(drawn.points[i]);
    return [&mesh, drawn, result] {
      DeviationMeter meter(mesh);
      (void)meter.measure(std::span(&result, 1), std::span(&drawn, 1));
    };
  });
}

}  // namespace
}  // namespace talweg::test
