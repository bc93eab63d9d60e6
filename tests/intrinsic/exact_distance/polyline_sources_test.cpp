// The windows that curves send to the sides of a face: half of the unit square, with the corners
// (0, 0), (1, 0) and (1, 1).
#include "talweg/intrinsic/exact_distance/polyline_sources.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

class SourcesInAFace : public testing::Test {
 protected:
  /// Barycentric coordinates in the order of the corners.
  static std::array<double, 3> barycentric(double x, double y) { return {1 - x, x - y, y}; }
  PolylinePiece piece(double px, double py, double qx, double qy) const {
    PolylinePiece piece{face_, 3, barycentric(px, py), barycentric(qx, qy)};
    piece.arc = 10;
    return piece;
  }

  const Surface surface_ = test::surface_of(test::grid(1, 1));
  const FaceId face_{0};
  const std::array<SideFrame, 3> frames_ = {side_frame(surface_, face_, 0),
                                            side_frame(surface_, face_, 1),
                                            side_frame(surface_, face_, 2)};
  const double diagonal_ = std::sqrt(2.0);
};

TEST_F(SourcesInAFace, APointSeesTheWholeOfEverySide) {
  const PolylinePiece point = piece(0.75, 0.25, 0.75, 0.25);
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeWindow window = window_of_point(point, frames_[k], k);
    EXPECT_EQ(window.into, twin(frames_[k].side));
    EXPECT_EQ(window.begin, 0);
    EXPECT_EQ(window.end, frames_[k].length);
    EXPECT_NEAR(window.value(window.end / 2), diagonal_ / 4, 1e-15);  // to the side's middle
    EXPECT_EQ(window.arc, 10);
    EXPECT_EQ(window.curve, 3U);
  }
}

// A horizontal segment from (0.5, 0.25) to (0.75, 0.25).
TEST_F(SourcesInAFace, ASegmentReachesPlacesStraightAcross) {
  const PolylinePiece segment = piece(0.5, 0.25, 0.75, 0.25);
  const auto below = window_of_segment(segment, frames_[0], 0);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->begin, 0.5, 1e-15);
  EXPECT_NEAR(below->end, 0.75, 1e-15);
  EXPECT_NEAR(below->value(0.6), 0.25, 1e-15);
  EXPECT_NEAR(below->arc_at(0.6), 10.1, 1e-14);

  EXPECT_FALSE(window_of_segment(segment, frames_[1], 1));  // upright

  // The diagonal runs from (1, 1) to (0, 0).
  const auto above = window_of_segment(segment, frames_[2], 2);
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->begin, diagonal_ / 4, 1e-15);
  EXPECT_NEAR(above->end, diagonal_ / 2, 1e-15);
  EXPECT_NEAR(above->value(above->begin), 0.5, 1e-15);
  EXPECT_NEAR(above->value(above->end), 0.25, 1e-15);
  EXPECT_NEAR(above->arc_at(above->begin), 10.25, 1e-14);
}

TEST_F(SourcesInAFace, ASegmentSendsNothingPastASide) {
  // The normals of the segment at (0.9, 0.8) and (0.95, 0.9) meet the line of the base to the right
  // of the face.
  const PolylinePiece segment = piece(0.9, 0.8, 0.95, 0.9);
  const auto base = window_of_segment(segment, frames_[0], 0);
  EXPECT_FALSE(base);
}

TEST_F(SourcesInAFace, AStepIsAnEighthOfTheMeanSide) {
  PolylinePieces pieces;
  pieces.segments = {piece(0.5, 0.25, 0.75, 0.25)};
  EXPECT_NEAR(step_width(surface_, pieces), (2 + diagonal_) / 3 / 8, 1e-15);
  EXPECT_NEAR(step_width(surface_, {}), diagonal_, 1e-15);  // the longest edge
}

TEST(StepWidth, IsNotMuchMoreThanTheHeightOfANeedle) {
  const double height = 1e-3;
  const Surface surface = test::surface_of({{{0, 0, 0}, {2, 0, 0}, {1, height, 0}}, {{0, 1, 2}}});
  PolylinePieces pieces;
  pieces.segments.push_back({FaceId{0}, 0, {0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}});
  EXPECT_NEAR(step_width(surface, pieces), height / 4, 1e-9);
  const Surface flat = test::surface_of({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}});
  EXPECT_GT(step_width(flat, pieces), 1e-5);
}

}  // namespace
}  // namespace talweg
