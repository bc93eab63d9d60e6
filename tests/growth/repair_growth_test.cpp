#include <cmath>
#include <cstdint>
#include <numbers>

#include "growth/counted_work.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/repair/vertex_welding.hpp"

namespace talweg::test {
namespace {

/// A fraction in [0, 1) for each number, evenly spread and unordered.
double spread(std::size_t i, double step) {
  const double x = static_cast<double>(i) * step;
  return x - std::floor(x);
}

/// Faces with long sides, each with a corner within `size` tolerances of one place.
MeshLists crowd(std::size_t n, double size) {
  constexpr double kFar = 1e6;
  const double tolerance = 2 * std::numeric_limits<double>::epsilon() * kFar;
  MeshLists lists;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const auto first = static_cast<std::uint32_t>(lists.points.size());
    lists.points.push_back(
        size * tolerance *
        Point(spread(i, 0.6180339887), spread(i, 0.7548776662), spread(i, 0.5698402910)));
    for (const double turn : {0.0, 1.0 / static_cast<double>(n)}) {
      lists.points.emplace_back(kFar * std::cos(angle + turn), kFar * std::sin(angle + turn),
                                static_cast<double>(i % 7));
    }
    lists.triangles.push_back({first, first + 1, first + 2});
  }
  return lists;
}

TEST(Growth, WeldingACrowdWithinTheTolerance) {
  for (const double size : {0.5, 1.5, 20.0}) {
    expect_growth("weld_vertices, all close", 1.3, {500, 4000, 32000}, [&](std::size_t n) {
      return [lists = crowd(n, size)] { (void)weld_vertices(lists); };
    });
  }
}

TEST(Growth, WeldingEqualVertices) {
  expect_growth("weld_vertices, equal", 1.2, {500, 4000, 32000}, [](std::size_t n) {
    return [lists = crowd(n, 0)] { (void)weld_vertices(lists); };
  });
}

TEST(Growth, RepairAndInspectionOfACrowd) {
  expect_growth("repair, all close", 1.3, {500, 4000, 32000},
                [](std::size_t n) { return [lists = crowd(n, 0.5)] { (void)repair(lists); }; });
  expect_growth("inspect, all at one vertex", 1.3, {500, 4000, 32000}, [](std::size_t n) {
    MeshLists lists = crowd(n, 0);
    for (Triangle& t : lists.triangles) t[0] = 0;
    return [lists] { (void)inspect(lists); };
  });
}

/// n faces without area at one edge, and a face with area.
MeshLists flat_fan(std::size_t n) {
  MeshLists lists;
  lists.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  lists.triangles.push_back({0, 1, 2});
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::uint32_t>(lists.points.size());
    lists.points.emplace_back(static_cast<double>(i + 1) / static_cast<double>(n + 1), 0, 0);
    lists.triangles.push_back({1, 0, at});
  }
  return lists;
}

TEST(Growth, FlatFacesAtOneEdge) {
  expect_growth("repair, flat faces at an edge", 1.2, {500, 4000, 32000},
                [](std::size_t n) { return [lists = flat_fan(n)] { (void)repair(lists); }; });
}

}  // namespace
}  // namespace talweg::test
