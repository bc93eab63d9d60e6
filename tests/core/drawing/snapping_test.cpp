#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

CurveInput of_ids(const std::vector<std::size_t>& ids, bool closed = false) {
  std::vector<VertexId> points;
  for (const std::size_t id : ids) points.emplace_back(id);
  return {closed, points, {}};
}

CurveInput of_positions(const std::vector<Point>& points, bool closed = false) {
  return {closed, points, {}};
}

std::string refusal(const SurfaceMesh& mesh, const CurveInput& curve) {
  try {
    snap(mesh, curve);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
    return error.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' not in: " << message;
  }
}

class Snapping : public ::testing::Test {
 protected:
  const SurfaceMesh mesh_ = SurfaceMesh::open(test::grid(3, 3));  // vertices 0 to 15
};

TEST_F(Snapping, TakesVertexIds) {
  const SnappedCurve curve = snap(mesh_, of_ids({0, 1, 6, 10, 15}));
  ASSERT_EQ(curve.points.size(), 5U);
  EXPECT_EQ(curve.points[2], SurfacePoint::at_vertex(mesh_.surface(), VertexId{6}));
  EXPECT_FALSE(curve.closed);
  EXPECT_EQ(curve.largest_snap_distance, 0);
  EXPECT_EQ(curve.merged, 0U);
}

TEST_F(Snapping, TakesClosedCurvesAndBoundaries) {
  EXPECT_TRUE(snap(mesh_, of_ids({0, 1, 5}, true)).closed);
  EXPECT_EQ(snap(mesh_, of_ids({3, 2, 1, 0, 4, 8, 12})).points.size(), 7U);
}

TEST_F(Snapping, RefusesIdsOutOfRange) {
  expect_parts(refusal(mesh_, of_ids({0, 1, 16})), {"vertex 16", "position 2", "16"});
  expect_parts(refusal(mesh_, of_ids({4294967294U, 1})), {"4294967294", "position 0"});
}

TEST_F(Snapping, RefusesIdsThatShareNoEdge) {
  expect_parts(refusal(mesh_, of_ids({0, 1, 11, 10})), {"1 and 11", "positions 1 and 2"});
  expect_parts(refusal(mesh_, of_ids({0, 1, 2, 6}, true)), {"6 and 0", "positions 3 and 0"});
  EXPECT_EQ(snap(mesh_, of_ids({0, 11, 3}), {true}).points.size(), 3U);
}

TEST_F(Snapping, TakesRepeatedVertices) {
  EXPECT_EQ(snap(mesh_, of_ids({0, 1, 1, 2})).points.size(), 3U);
  EXPECT_EQ(snap(mesh_, of_ids({0, 1, 5, 0, 4})).points.size(), 5U);
}

TEST_F(Snapping, RefusesPositionsFarFromTheMesh) {
  expect_parts(refusal(mesh_, of_positions({Point(0, 0, 0), Point(1, 0, 500)})),
               {"position 1", "500", "another unit or place"});
}

TEST_F(Snapping, RefusesTooFewPoints) {
  expect_parts(refusal(mesh_, of_ids({})), {"two different", "has 0"});
  expect_parts(refusal(mesh_, of_ids({3})), {"two different", "has 1"});
  expect_parts(refusal(mesh_, of_ids({0, 1}, true)), {"three different", "has 2"});
  expect_parts(refusal(mesh_, of_positions({})), {"two different"});
  expect_parts(refusal(mesh_, of_positions({Point(0, 0, 1), Point(0, 0, 2)})), {"has 1"});
  expect_parts(refusal(mesh_, of_positions({Point(0, 0, 0), Point(1, 0, 0), Point(0, 0, 1)}, true)),
               {"three different", "has 2"});
}

TEST_F(Snapping, TakesPointsInFaces) {
  CurveInput input;
  input.points = std::vector<FaceCoordinates>{
      {FaceId{0}, {1, 0, 0}}, {FaceId{0}, {0.25, 0, 0.75}}, {FaceId{1}, {0.5, 0.25, 0.25}}};
  const SnappedCurve curve = snap(mesh_, input);
  ASSERT_EQ(curve.points.size(), 3U);
  EXPECT_TRUE(curve.points[0].is_vertex());
  EXPECT_TRUE(std::holds_alternative<OnEdge>(curve.points[1].where()));
  EXPECT_EQ(mesh_.position(curve.points[1]), Point(0.75, 0.75, 0));
  EXPECT_TRUE(std::holds_alternative<InFace>(curve.points[2].where()));
}

TEST_F(Snapping, MovesClicksOntoAVertexOrEdgeWithinRounding) {
  for (const double beside : {1e-17, 1e-16, 1e-14, 1e-12, 1e-10}) {
    CurveInput input;
    input.points = std::vector<FaceCoordinates>{{FaceId{0}, {1 - 2 * beside, beside, beside}},
                                                {FaceId{0}, {0.25, beside, 0.75 - beside}},
                                                {FaceId{1}, {0, 1 - beside, beside}},
                                                {FaceId{1}, {0.5, 0.25, 0.25}}};
    input.way_points = {{0}, {1}, {3}};
    input.pins = {2};
    const SnappedCurve curve = snap(mesh_, input);
    ASSERT_EQ(curve.points.size(), 4U);
    EXPECT_TRUE(curve.points[0].is_vertex()) << beside;
    EXPECT_TRUE(std::holds_alternative<OnEdge>(curve.points[1].where())) << beside;
    EXPECT_TRUE(curve.points[2].is_vertex()) << beside;
    EXPECT_TRUE(std::holds_alternative<InFace>(curve.points[3].where()));
    input.way_points.clear();  // only clicks are moved; points of a line stay
    if (beside > 1e-15) {
      EXPECT_FALSE(snap(mesh_, input).points[0].is_vertex());
    }
  }
}

TEST_F(Snapping, RefusesPointsThatAreInNoFace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](std::size_t face, std::array<double, 3> b) {
    CurveInput input;
    input.points = std::vector<FaceCoordinates>{{FaceId{0}, {1, 0, 0}}, {FaceId{face}, b}};
    return input;
  };
  expect_parts(refusal(mesh_, with(18, {1, 0, 0})), {"position 1", "face 18"});
  for (const std::array<double, 3>& b : {std::array<double, 3>{0.5, 0.5, 0.5},
                                         {1.5, -0.5, 0},
                                         {nan, 0.5, 0.5},
                                         {0, 0, 0},
                                         {2, 0, 0}}) {
    expect_parts(refusal(mesh_, with(1, b)), {"position 1", "face 1"});
  }
}

TEST_F(Snapping, PutsPositionsOnTheNearestPoints) {
  const SnappedCurve curve =
      snap(mesh_, of_positions({Point(0.6, 0.2, 0.5), Point(4, 1, 0), Point(1.7, 0.4, -0.25)}));
  ASSERT_EQ(curve.points.size(), 3U);
  EXPECT_LT((mesh_.position(curve.points[0]) - Point(0.6, 0.2, 0)).norm(), 1e-15);
  EXPECT_EQ(mesh_.position(curve.points[1]), Point(3, 1, 0));  // not cut off: the curve returns
  EXPECT_LT((mesh_.position(curve.points[2]) - Point(1.7, 0.4, 0)).norm(), 1e-15);
  EXPECT_EQ(curve.largest_snap_distance, 1);
}

TEST_F(Snapping, WarnsOfPositionsFarFromTheMeshAndRefusesThoseFarther) {
  const SurfaceMesh fine = SurfaceMesh::open(test::grid(100, 100));  // edges of 1 and sqrt(2)
  const auto at = [](double height) {
    return of_positions({Point(20, 20, height), Point(50, 50, 0)});
  };
  const double h = fine.mean_edge_length(), diagonal = 100 * std::sqrt(2);
  EXPECT_EQ(snap_warning(snap(fine, at(0)).largest_snap_distance, fine), "");
  EXPECT_EQ(snap_warning(snap(fine, at(0.9e-4 * h)).largest_snap_distance, fine), "");  // rounding
  expect_parts(snap_warning(snap(fine, at(1.1e-4 * h)).largest_snap_distance, fine), {"0.000125"});
  const double near = snap(fine, at(2.9 * h)).largest_snap_distance;
  EXPECT_FALSE(moved_far(near, fine));
  expect_parts(snap_warning(near, fine), {"moved onto the mesh", fmt::format("{:.3g}", 2.9 * h)});
  const double far = snap(fine, at(-3.1 * h)).largest_snap_distance;
  EXPECT_TRUE(moved_far(far, fine));
  EXPECT_TRUE(snap_warning(far, fine).starts_with(kFarFromMesh));
  expect_parts(snap_warning(far, fine), {"3.1 mean edges"});
  EXPECT_NO_THROW(snap(fine, at(0.124 * diagonal)));
  expect_parts(refusal(fine, at(0.126 * diagonal)), {"position 0", "17.8", "17.7", "unit"});
  // On a mesh of few faces an eighth of the diagonal is less than an edge; the limit is ten edges.
  const double edge = mesh_.mean_edge_length();
  EXPECT_NO_THROW(snap(mesh_, of_positions({Point(0, 0, 9.9 * edge), Point(1, 1, 0)})));
  expect_parts(refusal(mesh_, of_positions({Point(0, 0, 10.1 * edge), Point(1, 1, 0)})),
               {"position 0", "unit"});
}

TEST_F(Snapping, MergesPositionsThatFallTogether) {
  CurveInput input = of_positions({Point(0, 0, 0), Point(0, 0, 1), Point(1, 0, 0), Point(1, 1, 0),
                                   Point(1, 1, 5), Point(0, 0, 2)},
                                  true);
  input.pins = {1, 4, 5};
  const SnappedCurve curve = snap(mesh_, input);
  EXPECT_EQ(curve.points.size(), 3U);
  EXPECT_EQ(curve.merged, 3U);
  EXPECT_EQ(curve.pins, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(curve.largest_snap_distance, 5);
}

TEST_F(Snapping, RefusesPinsOutOfRange) {
  CurveInput input = of_ids({0, 1, 2});
  input.pins = {3};
  expect_parts(refusal(mesh_, input), {"point 3", "pin"});
}

TEST_F(Snapping, RefusesPositionsThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_parts(refusal(mesh_, of_positions({Point(0, 0, 0), Point(nan, 0, 0)})), {"position 1"});
}

TEST_F(Snapping, NamesTheCurveWhereThereAreSeveral) {
  const std::vector<CurveInput> curves{of_ids({0, 1}), of_ids({0, 99})};
  try {
    snap(mesh_, curves);
    FAIL();
  } catch (const Error& error) {
    expect_parts(error.what(), {"Curve 1", "99", "position 1"});
  }
}

/// A fine sphere away from the origin, like a scanned part.
MeshLists scan(double scale) {
  MeshLists lists = test::sphere(4);
  for (Point& p : lists.points) p = scale * Point(p + Point(1.7, -2.3, 0.9));
  return lists;
}

double rounded_to_9_digits(double x) { return std::stod(fmt::format("{:.9g}", x)); }

TEST(SnappingOfRoundedFiles, VerticesComeBackAsVertices) {
  for (const double scale : {1e-6, 1.0, 123.0, 1e6}) {
    const SurfaceMesh mesh = SurfaceMesh::open(scan(scale));
    std::vector<Point> as_text;
    std::vector<Point> as_floats;
    for (const Point& p : mesh.points()) {
      as_text.push_back(p.unaryExpr(&rounded_to_9_digits));
      as_floats.push_back(p.cast<float>().cast<double>());
    }
    for (const std::vector<Point>& rounded : {as_text, as_floats}) {
      const SnappedCurve curve = snap(mesh, of_positions(rounded));
      ASSERT_EQ(curve.points.size(), mesh.points().size());
      for (std::size_t v = 0; v < curve.points.size(); ++v) {
        ASSERT_EQ(curve.points[v], SurfacePoint::at_vertex(mesh.surface(), VertexId{v}));
      }
      EXPECT_LT(curve.largest_snap_distance, 4e-7 * scale);
    }
  }
}

TEST(SnappingOfRoundedFiles, EdgePointsComeBackOnTheirEdges) {
  const SurfaceMesh mesh = SurfaceMesh::open(scan(10));
  const Surface& surface = mesh.surface();
  for (std::size_t e = 0; e < surface.edge_count(); e += 7) {
    const SurfacePoint point = SurfacePoint::on_edge(surface, EdgeId{e}, 0.3);
    const Point rounded = mesh.position(point).unaryExpr(&rounded_to_9_digits);
    const SnappedCurve curve =
        snap(mesh, of_positions({rounded, mesh.point(surface.head(halfedge_of(EdgeId{e})))}));
    const auto* at = std::get_if<OnEdge>(&curve.points[0].where());
    ASSERT_NE(at, nullptr);
    EXPECT_EQ(at->edge, EdgeId{e});
    EXPECT_NEAR(at->t, 0.3, 1e-6);
  }
}

// A point a thousandth of a side away from a vertex is not merged with the vertex, even far from
// the origin.
TEST(SnappingOfRoundedFiles, NearPointsStayApart) {
  MeshLists lists = test::grid(3, 3);
  for (Point& p : lists.points) p += Point(5e6, 5e6, 0);
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const SnappedCurve curve = snap(
      mesh, of_positions({Point(5e6 + 1.002, 5e6 + 1.001, 0), Point(5e6 + 2.5, 5e6 + 1.25, 0)}));
  EXPECT_TRUE(std::holds_alternative<InFace>(curve.points[0].where()));
  EXPECT_LT(curve.largest_snap_distance, 1e-8);
}

}  // namespace
}  // namespace talweg

namespace talweg {
namespace {

/// A closed plate of 12 x 12 squares, 0.1 thick.
MeshLists plate() {
  MeshLists lists = test::grid(12, 12);
  const auto count = static_cast<std::uint32_t>(lists.points.size());
  const std::size_t faces = lists.triangles.size();
  for (std::uint32_t v = 0; v < count; ++v)
    lists.points.push_back(lists.points[v] - Point(0, 0, 0.1));
  for (std::size_t f = 0; f < faces; ++f) {
    const auto [a, b, c] = lists.triangles[f];
    lists.triangles.push_back({a + count, c + count, b + count});
  }
  const auto at = [](std::uint32_t x, std::uint32_t y) { return y * 13 + x; };
  const auto wall = [&](std::uint32_t a, std::uint32_t b) {  // along the rim, counterclockwise
    lists.triangles.push_back({b, a, a + count});
    lists.triangles.push_back({b, a + count, b + count});
  };
  for (std::uint32_t k = 0; k < 12; ++k) {
    wall(at(k, 0), at(k + 1, 0));
    wall(at(12, k), at(12, k + 1));
    wall(at(k + 1, 12), at(k, 12));
    wall(at(0, k + 1), at(0, k));
  }
  return lists;
}

TEST(SnappingToThinWalls, PutsAllPointsOnOneSide) {
  const SurfaceMesh mesh = SurfaceMesh::open(plate());
  for (const bool far_below : {false, true}) {
    std::vector<Point> points;
    for (int x = 2; x <= 10; ++x) points.emplace_back(x, 6, 0.01);
    points[4].z() = -0.06;  // nearer to the bottom
    if (far_below) points[5].z() = points[6].z() = -0.07;
    const SnappedCurve snapped = snap(mesh, {false, points, {}});
    for (const SurfacePoint& point : snapped.points)
      EXPECT_NEAR(mesh.position(point).z(), 0, 1e-12);
    ASSERT_EQ(snapped.notes.size(), 1U);
    EXPECT_NE(snapped.notes[0].find(far_below ? "3 of 9 points" : "1 of 9 points"),
              std::string::npos)
        << snapped.notes[0];
    EXPECT_NE(snapped.notes[0].find("the first at (6, 6, -0.06)"), std::string::npos);
  }
}

/// Two plates without thickness, 0.1 apart, which no path joins.
TEST(SnappingToThinWalls, KeepsAStrokeOnOneComponent) {
  MeshLists lists = test::grid(12, 12);
  const std::vector<Point> above = lists.points;
  for (const Point& p : above) lists.points.push_back(p - Point(0, 0, 0.1));
  for (std::size_t f = 0, faces = lists.triangles.size(); f < faces; ++f) {
    Triangle t = lists.triangles[f];
    for (std::uint32_t& v : t) v += static_cast<std::uint32_t>(above.size());
    lists.triangles.push_back(t);
  }
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  // The last third lies below the lower plate, for so long that its distances from the upper plate
  // add up to more than a jump costs.
  std::vector<Point> points;
  for (double x = 1; x <= 11; x += 0.02) points.emplace_back(x, 6, x < 7.5 ? 0 : -0.11);
  const SnappedCurve snapped = snap(mesh, {false, points, {}});
  for (const SurfacePoint& point : snapped.points) {
    EXPECT_NEAR(mesh.position(point).z(), 0, 1e-12);
  }
  ASSERT_EQ(snapped.notes.size(), 1U);
  EXPECT_NE(snapped.notes[0].find("put on the side of the rest"), std::string::npos)
      << snapped.notes[0];
}

TEST(SnappingToThinWalls, FollowsACurveAroundTheRim) {
  const SurfaceMesh mesh = SurfaceMesh::open(plate());
  std::vector<Point> points;
  for (double x = 9; x <= 12; x += 0.5) points.emplace_back(x, 6, 0);
  for (double x = 12; x >= 9; x -= 0.5) points.emplace_back(x, 6, -0.1);
  const SnappedCurve snapped = snap(mesh, {false, points, {}});
  EXPECT_TRUE(snapped.notes.empty());
  EXPECT_NEAR(mesh.position(snapped.points.back()).z(), -0.1, 1e-12);
}

TEST(SnappingToThinWalls, SaysWhereACurveLeavesTheSurface) {
  // Two sheets joined only at their rims: between them there is no short way.
  MeshLists lists = plate();
  for (std::size_t v = 169; v < lists.points.size(); ++v) lists.points[v].z() -= 3;
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  std::vector<Point> points;
  for (int x = 4; x <= 8; ++x) points.emplace_back(x, 6, x < 6 ? 0 : -3.1);
  const SnappedCurve snapped = snap(mesh, {false, points, {}});
  ASSERT_EQ(snapped.notes.size(), 1U);
  EXPECT_NE(snapped.notes[0].find("in 1 place where every way over the surface is much longer"),
            std::string::npos)
      << snapped.notes[0];
}

}  // namespace
}  // namespace talweg
