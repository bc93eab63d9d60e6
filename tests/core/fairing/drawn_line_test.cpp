// The drawn line against hand-made drawings.
#include "talweg/core/fairing/drawn_line.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/fairing/drawn_band.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

/// A hairpin: 6 to the right, 1 up, 6 back.
std::vector<Point> hairpin() { return {{0, 0, 0}, {6, 0, 0}, {6, 1, 0}, {0, 1, 0}}; }

TEST(DrawnLine, PlacesAreArcLengths) {
  const DrawnLine line(hairpin(), false);
  EXPECT_EQ(line.length(), 13);
  EXPECT_LT((line.at(2.5) - Point(2.5, 0, 0)).norm(), 1e-15);
  EXPECT_LT((line.at(6.25) - Point(6, 0.25, 0)).norm(), 1e-15);
  EXPECT_EQ(line.at(-1), Point(0, 0, 0));
  EXPECT_EQ(line.at(20), Point(0, 1, 0));
  EXPECT_EQ(line.between(12, 1), -11);
}

TEST(DrawnLine, AClosedLineContinuesAtItsBeginning) {
  const DrawnLine line(hairpin(), true);
  EXPECT_EQ(line.length(), 14);
  EXPECT_EQ(line.between(13.5, 1), 1.5);
  EXPECT_EQ(line.between(1, 13.5), -1.5);
  EXPECT_EQ(line.at(15.5), line.at(1.5));
  EXPECT_EQ(line.at(-0.5), line.at(13.5));
  EXPECT_TRUE(line.stays_near(13, 1, 1.5));
  EXPECT_FALSE(line.is_straight(13, 15, 0.5));  // around a corner, in the second round
  EXPECT_TRUE(line.is_straight(13, 15, 0.8));
}

TEST(DrawnLine, AnotherStrandIsNotNearAlongTheLine) {
  const DrawnLine line(hairpin(), false);
  EXPECT_TRUE(line.stays_near(2, 3, 1.1));
  EXPECT_FALSE(line.stays_near(2, 11, 1.1));  // 1 above, but 9 along the line around the tip
  EXPECT_FALSE(line.stays_near(11, 2, 1.1));
  EXPECT_TRUE(line.stays_near(5.5, 7.5, 1.2));  // at the tip
}

TEST(DrawnLine, IsStraightWithinTheTolerance) {
  const DrawnLine line(hairpin(), false);
  EXPECT_TRUE(line.is_straight(0, 6, 1e-9));
  EXPECT_FALSE(line.is_straight(1, 12, 4.9));  // the tip is 5 away
  EXPECT_TRUE(line.is_straight(1, 12, 5.2));
}

TEST(DrawnLine, OfOnePointHasLengthZero) {
  for (const bool closed : {false, true}) {
    const DrawnLine line({{1, 2, 3}}, closed);
    EXPECT_EQ(line.length(), 0);
    EXPECT_EQ(line.at(4), Point(1, 2, 3));
    EXPECT_TRUE(line.stays_near(0, 0, 0));
    EXPECT_TRUE(line.is_straight(0, 0, 0));
  }
}

/// Curves in the plane, their distance and a band; the band joins curves that continue each other.
struct BandOnGrid {
  explicit BandOnGrid(std::vector<std::vector<VertexId>> ways) {
    for (const auto& way : ways) {
      curves.push_back(
          test::vertex_curve(opened->surface(), draw_edge_path(opened->surface(), way), false));
    }
    distance.set(curves);
  }
  static VertexId at(std::uint32_t column, std::uint32_t row) {
    return VertexId{row * 41 + column};
  }

  std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(40, 40));
  std::vector<SurfaceCurve> curves;
  PolylineDistance distance{opened->surface()};
};

TEST(DrawnBand, APlaceNearerToAnotherStrandDoesNotBelongToTheStrand) {
  const auto at = BandOnGrid::at;
  BandOnGrid grid({{at(5, 10), at(25, 10), at(25, 12), at(5, 12)}});
  const DrawnLine line(positions_of(grid.opened->mesh(), grid.curves[0]), false);
  const DrawnBand band(grid.distance, {{0, {1.5, {}, 0.1, 1}, 0, false}}, &line);
  const auto place = [&](std::uint32_t column, std::uint32_t row) {
    return band.at(SurfacePoint::at_vertex(grid.opened->surface(), at(column, row)));
  };
  EXPECT_NEAR(place(10, 9).arc, 5, 1e-12);
  EXPECT_TRUE(band.is_same_strand(place(10, 9), 5));
  EXPECT_TRUE(band.is_same_strand(place(10, 9), 6));
  EXPECT_FALSE(band.is_same_strand(place(10, 13), 5));  // on the strand above, within both walls
  EXPECT_TRUE(band.is_same_strand(place(10, 13), 37));
  EXPECT_TRUE(band.chord_cuts_off(15, 27));  // the tip
  EXPECT_FALSE(band.chord_cuts_off(0, 20));
}

TEST(DrawnBand, CurvesThatContinueEachOtherAreMeasuredAlongOneLine) {
  const auto at = BandOnGrid::at;
  BandOnGrid grid({{at(5, 10), at(15, 10)}, {at(35, 10), at(15, 10)}});
  const SurfaceCurve all = test::vertex_curve(
      grid.opened->surface(),
      draw_edge_path(grid.opened->surface(), std::vector{at(5, 10), at(35, 10)}), false);
  const DrawnLine line(positions_of(grid.opened->mesh(), all), false);
  std::vector<double> narrow(grid.curves[1].points.size(), 2);
  narrow[5] = 0.5;  // at (30, 10), 25 along the line
  const DrawnBand band(grid.distance,
                       {{0, {1, {}, 0.1, 1}, 0, false}, {1, {0, narrow, 0.1, 1}, 10, true}}, &line);
  for (const std::uint32_t column : {8U, 18U, 30U}) {
    const BandPlace place =
        band.at(SurfacePoint::at_vertex(grid.opened->surface(), at(column, 11)));
    EXPECT_NEAR(place.arc, column - 5, 1e-12);
  }
  EXPECT_EQ(band.slack_between(2, 8), 1);
  EXPECT_EQ(band.slack_between(11, 20), 2);
  EXPECT_EQ(band.slack_between(11, 28), 0.5);
  EXPECT_NEAR(band.slack_between(11, 24.5), 1.25, 1e-12);  // halfway between the slacks
  EXPECT_EQ(band.least_slack(), 0.5);
  EXPECT_EQ(band.largest_slack(), 2);
}

}  // namespace
}  // namespace talweg
