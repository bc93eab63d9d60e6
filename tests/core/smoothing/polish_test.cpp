// The polish on surfaces where the shortest curve is known, and with lifts that keep it known.
#include "talweg/core/smoothing/polish.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using test::grid;
using test::ids;

/// Φ = slope · y: a plane stays a plane, tilted.
ExactPotential tilted(const SurfaceMesh& mesh, double slope) {
  return {[&mesh, slope](EdgeId e, double t) {
            const HalfedgeId h = halfedge_of(e);
            const double from = mesh.point(mesh.surface().tail(h)).y();
            const double along = mesh.point(mesh.surface().head(h)).y() - from;
            return PotentialOnEdge{{slope * (from + t * along), 0}, {slope * along, 0}, {0, 0}};
          },
          [&mesh, slope](const SurfacePoint& p) {
            return std::array<double, 2>{slope * mesh.position(p).y(), 0};
          },
          [&mesh, slope](FaceId f, const auto& b, const auto& d) {
            const auto corners = mesh.surface().corners(f);
            const auto height = [&](const ExactPotential::Barycentric& at) {
              double y = 0;
              for (std::size_t k = 0; k < 3; ++k) y += at[k] * mesh.point(corners[k]).y();
              return slope * y;
            };
            PotentialInFace phi;
            phi.value[0] = height(b);
            for (std::size_t i = 0; i < 2; ++i) phi.first[i][0] = height(d[i]);
            return phi;
          }};
}
ExactPotential flat(const SurfaceMesh& mesh) { return tilted(mesh, 0); }

void expect_each_in_a_face(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    EXPECT_TRUE(common_face(surface, curve.points[i], curve.points[(i + 1) % n]).valid()) << i;
  }
}

/// The vertices (i, j) of a grid, as a curve along its edges.
SurfaceCurve along(const SurfaceMesh& mesh, std::uint32_t columns,
                   const std::vector<std::array<std::uint32_t, 2>>& cells) {
  std::vector<VertexId> ways;
  for (const auto& [i, j] : cells) ways.emplace_back(j * (columns + 1) + i);
  return test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), ways, false), false);
}

// These curves begin far from straight, which FlipOut's results never are, so a small bend at a
// vertex may be left.
constexpr double kNear = 1e-3;

TEST(Polish, BentCurvesInThePlaneBecomeStraightWhateverTheTilt) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(20, 20));
  for (const double slope : {0.0, 0.5, 1.0}) {
    SurfaceCurve curve = along(mesh, 20, {{2, 3}, {8, 7}, {9, 6}, {18, 11}});
    const SurfaceCurve drawn = curve;
    const PolishResult result = polish(mesh, curve, tilted(mesh, slope), {}, {.max_rounds = 100});
    const double expected = std::hypot(16, 8 * std::hypot(1, slope));
    EXPECT_NEAR(result.length_after, expected, kNear * expected) << slope;
    EXPECT_GE(result.length_after, expected * (1 - 1e-12)) << slope;
    EXPECT_GT(result.length_before, 1.01 * expected);
    EXPECT_GT(result.passed_vertices, 0U);
    EXPECT_EQ(curve.points.front(), drawn.points.front());
    EXPECT_EQ(curve.points.back(), drawn.points.back());
    expect_each_in_a_face(mesh.surface(), curve);
  }
}

TEST(Polish, PinnedPointsStay) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(20, 20));
  SurfaceCurve curve = along(mesh, 20, {{2, 3}, {9, 8}, {18, 3}});
  const SurfacePoint pin = SurfacePoint::at_vertex(mesh.surface(), VertexId{8 * 21 + 9});
  polish(mesh, curve, flat(mesh), std::span(&pin, 1), {.max_rounds = 100});
  const double expected = std::hypot(7, 5) + std::hypot(9, 5);
  EXPECT_NEAR(curve_length(mesh.surface(), curve), expected, kNear * expected);
  EXPECT_EQ(std::count(curve.points.begin(), curve.points.end(), pin), 1);
  expect_each_in_a_face(mesh.surface(), curve);
}

TEST(Polish, BendsAroundACornerOfTheBoundary) {
  // Of a 10 x 10 sheet the quarter x > 5, y < 5 is missing; (5, 5) is in the
  // way.
  MeshLists lists = grid(10, 10);
  std::erase_if(lists.triangles, [&](const Triangle& t) {
    const Point centre = (lists.points[t[0]] + lists.points[t[1]] + lists.points[t[2]]) / 3;
    return centre.x() > 5 && centre.y() < 5;
  });
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  for (const auto& middle : {std::array<std::uint32_t, 2>{4, 6}, {5, 5}, {5, 6}}) {
    SurfaceCurve curve = along(mesh, 10, {{3, 1}, middle, {9, 6}});
    polish(mesh, curve, flat(mesh), {});
    EXPECT_NEAR(curve_length(mesh.surface(), curve), std::hypot(2, 4) + std::hypot(4, 1), kNear);
    const SurfacePoint corner = SurfacePoint::at_vertex(mesh.surface(), VertexId{5 * 11 + 5});
    EXPECT_EQ(std::count(curve.points.begin(), curve.points.end(), corner), 1);
    expect_each_in_a_face(mesh.surface(), curve);
  }
}

TEST(Polish, LoopsAroundAPrismHaveItsGirth) {
  const std::uint32_t columns = 24;
  const SurfaceMesh mesh = SurfaceMesh::open(test::tube(columns, 12, 6));
  const double girth = 2 * columns * std::sin(std::numbers::pi / columns);
  SurfaceCurve zigzag{true, {}};
  std::vector<VertexId> ways;
  for (std::uint32_t i = 0; i < columns; i += 4) {
    ways.emplace_back((5 + (i / 4) % 2) * columns + i);
  }
  const auto path = draw_edge_path(mesh.surface(), ways, true);
  for (const std::size_t start : {0U, 1U, 7U}) {  // wherever the seam is
    std::vector<VertexId> turned = path;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
    SurfaceCurve curve = test::vertex_curve(mesh.surface(), turned, true);
    const double before = curve_length(mesh.surface(), curve);
    const PolishResult result = polish(mesh, curve, flat(mesh), {});
    EXPECT_GT(before, 1.02 * girth);
    EXPECT_NEAR(result.length_before, before, 1e-6 * before);
    EXPECT_NEAR(result.length_after, girth, kNear * girth) << start;
    EXPECT_TRUE(curve.closed);
    expect_each_in_a_face(mesh.surface(), curve);
  }
}

TEST(Polish, TakesOutTurnsOnOneEdgeAndPointsInsideFaces) {
  // From inside a triangle to inside the one after next; over both edges in between it goes there
  // and back before it crosses for good.
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  const Surface& surface = mesh.surface();
  const auto face = [&](std::uint32_t a, std::uint32_t b) {
    return surface.face(surface.find_halfedge(VertexId{a}, VertexId{b}));
  };
  const SurfacePoint from = SurfacePoint::in_face(surface, face(6, 7), {0.4, 0.3, 0.3});
  const SurfacePoint to = SurfacePoint::in_face(surface, face(11, 12), {0.3, 0.3, 0.4});
  for (const double turn : {0.01, 0.05, 0.3}) {
    SurfaceCurve curve{false, {from}};
    for (const double t : {0.6, 0.6 - turn, 0.6 + turn}) {
      curve.points.push_back(test::between(surface, 6, 12, t));
    }
    curve.points.push_back(SurfacePoint::in_face(surface, face(12, 11), {0.3, 0.4, 0.3}));
    for (const double t : {0.6, 0.6 + turn, 0.6 - turn}) {
      curve.points.push_back(test::between(surface, 11, 12, t));
    }
    curve.points.push_back(to);
    expect_each_in_a_face(surface, curve);
    polish(mesh, curve, flat(mesh), {});
    EXPECT_NEAR(curve_length(surface, curve), (mesh.position(from) - mesh.position(to)).norm(),
                kNear)
        << turn;
    EXPECT_EQ(curve.points.front(), from);
    EXPECT_EQ(curve.points.back(), to);
    expect_each_in_a_face(surface, curve);
  }
}

TEST(Polish, LeavesAloneWhatHasNoInnerPoint) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  SurfaceCurve curve = test::vertex_curve(mesh.surface(), ids({6, 7}), false);
  const SurfaceCurve drawn = curve;
  const PolishResult result = polish(mesh, curve, flat(mesh), {});
  EXPECT_EQ(result.passed_vertices, 0U);
  EXPECT_EQ(curve.points, drawn.points);
}

// Straight over a vertex, but for a step of a billionth of an edge around it.
TEST(Polish, PointsAtAVertexAreTheVertex) {
  const SurfaceMesh mesh = SurfaceMesh::open(grid(4, 4));
  const Surface& s = mesh.surface();
  const std::uint32_t middle = 2 * 5 + 2;  // (2, 2)
  SurfaceCurve curve{
      false,
      {SurfacePoint::at_vertex(s, VertexId{middle - 1}), test::between(s, middle, middle + 5, 1e-9),
       test::between(s, middle, middle + 6, 1e-9),
       SurfacePoint::at_vertex(s, VertexId{middle + 1})}};
  polish(mesh, curve, flat(mesh), {}, {.max_rounds = 0});
  ASSERT_EQ(curve.points.size(), 3U);
  EXPECT_EQ(curve.points[1], SurfacePoint::at_vertex(s, VertexId{middle}));
}

}  // namespace
}  // namespace talweg
