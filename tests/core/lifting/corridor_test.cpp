#include "talweg/core/lifting/corridor.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::grid;

using test::ids;

/// The middle row of a grid of 20 x 20 squares.
SurfaceCurve middle_row(const Surface& surface) {
  std::vector<VertexId> row;
  for (std::uint32_t i = 0; i <= 20; ++i) row.emplace_back(10 * 21 + i);
  return test::vertex_curve(surface, row, false);
}

TEST(Corridor, IsFlatWithinTheSlackAndAParabolaBeyond) {
  const auto opened = OpenedMesh::open(grid(20, 20));
  const Surface& surface = opened->surface();
  const SurfaceCurve drawn = middle_row(surface);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  const Corridor corridor(distance, 0.5, {{.slack = 1.5, .length = 4}});
  for (std::uint32_t j = 0; j <= 20; ++j) {
    const double d = std::abs(static_cast<double>(j) - 10);
    const double expected = d > 1.5 ? 4 * std::pow(10 * 0.5 * (d - 1.5) / 4, 2) : 0;
    EXPECT_NEAR(corridor.at_vertex(VertexId{j * 21 + 7})[0], expected, 1e-10);
  }
}

TEST(Corridor, AConstantFieldIsTheNumber) {
  const auto opened = OpenedMesh::open(grid(30, 30));
  const Surface& surface = opened->surface();
  const SurfaceCurve drawn = test::jagged_circle(opened->mesh(), 30, 8);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  const Corridor number(distance, 1, {{.closed = true, .slack = 0.3, .length = 8}});
  const Corridor field(
      distance, 1,
      {{.closed = true, .length = 8, .slack_at = std::vector<double>(drawn.points.size(), 0.3)}});
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    EXPECT_EQ(number.at_vertex(VertexId{v}), field.at_vertex(VertexId{v}));
  }
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const SurfacePoint p = SurfacePoint::on_edge(surface, EdgeId{e}, 0.3);
    EXPECT_EQ(number.at(p), field.at(p));
  }
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const SurfacePoint p = SurfacePoint::in_face(surface, FaceId{f}, {0.2, 0.3, 0.5});
    EXPECT_EQ(number.at(p), field.at(p));
  }
}

// A row of a plane grid with a slack that grows by 0.1 per unit; all values have a closed form.
TEST(Corridor, AFieldIsLinearBetweenThePointsOfTheDrawing) {
  const auto opened = OpenedMesh::open(grid(20, 20));
  const Surface& surface = opened->surface();
  const SurfaceCurve drawn = middle_row(surface);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  Corridor::Valley valley{.length = 4};
  for (int i = 0; i <= 20; ++i) valley.slack_at.push_back(0.1 * i);
  const Corridor corridor(distance, 0.5, {valley});
  const double steepness = std::pow(10 * 0.5, 2) / 4;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    const HalfedgeId h = halfedge_of(EdgeId{e});
    const Point &p = opened->mesh().point(surface.tail(h)),
                &q = opened->mesh().point(surface.head(h));
    if (p.y() < 10 || q.y() < 10) continue;
    const double t = 0.3;
    const Point x = p + t * (q - p);
    const double beyond = (x.y() - 10) - 0.1 * x.x();
    const auto value = corridor.at(SurfacePoint::on_edge(surface, EdgeId{e}, t));
    if (std::abs(beyond) < 1e-9) continue;  // on the border of the corridor
    const bool outside = beyond > 0;
    EXPECT_NEAR(value[0], outside ? steepness * beyond * beyond : 0, 1e-9);
  }
}

TEST(Corridor, AFieldGoesOnAcrossTheEndOfALoop) {
  const auto opened = OpenedMesh::open(grid(12, 12));
  const Surface& surface = opened->surface();
  // The square (4, 4), (8, 4), (8, 8), (4, 8); the last segment leads from (4, 8) back.
  const SurfaceCurve drawn = test::vertex_curve(
      surface, draw_edge_path(surface, ids({4 * 13 + 4, 4 * 13 + 8, 8 * 13 + 8, 8 * 13 + 4}), true),
      true);
  ASSERT_EQ(drawn.points.size(), 16U);
  PolylineDistance distance(surface);
  distance.set(std::span(&drawn, 1));
  Corridor::Valley valley{.closed = true, .length = 10, .turns = 0};
  valley.slack_at.assign(16, 0.5);
  valley.slack_at[15] = 1;  // at (4, 5); 0.5 at (4, 4)
  const Corridor corridor(distance, 1, {valley});
  // Left of the closing segment: the edge from (2, 4) to (2, 5).
  const HalfedgeId h = surface.find_halfedge(VertexId{4 * 13 + 2}, VertexId{5 * 13 + 2});
  const bool upwards = h == halfedge_of(edge_of(h));
  const auto value = corridor.at(SurfacePoint::on_edge(surface, edge_of(h), upwards ? 0.25 : 0.75));
  const double beyond = 2 - (0.5 + 0.25 * 0.5);
  EXPECT_NEAR(value[0], 10 * beyond * beyond, 1e-9);
}

TEST(Corridor, RefusesAFieldThatDoesNotFit) {
  const auto opened = OpenedMesh::open(grid(8, 8));
  const Surface& surface = opened->surface();
  const SurfaceCurve curves[] = {test::vertex_curve(surface, ids({10, 11, 12}), false),
                                 test::vertex_curve(surface, ids({46, 47}), false)};
  PolylineDistance distance(surface);
  distance.set(curves);
  const auto message = [&](const std::vector<std::vector<double>>& slack_at) -> std::string {
    try {
      const Corridor corridor(distance, 1, {{.slack_at = slack_at[0]}, {.slack_at = slack_at[1]}});
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadUsage);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({{0, 1, 0}, {2, 2}}), "");
  EXPECT_EQ(message({{0, 1, 0}, {2}}), "slack_at has 1 values for the 2 points of curve 1.");
  for (const double bad : {-1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(message({{0, 1, 0}, {2, bad}}),
              "The slack of curve 1 at its point 1 must be finite and >= 0.");
  }
}

}  // namespace
}  // namespace talweg
