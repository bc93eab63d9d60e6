// The shortest way to a point of one face, half of the unit square with the corners (0, 0), (1, 0)
// and (1, 1), and how it changes; and copies of faces.
#include "talweg/intrinsic/exact_distance/face_paths.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/exact_distance/made_windows.hpp"
#include "intrinsic/test_surfaces.hpp"
#include "talweg/intrinsic/exact_distance/known_faces.hpp"

namespace talweg {
namespace {

class PathsIntoAFace : public testing::Test {
 protected:
  PathsIntoAFace() {
    for (std::size_t k = 0; k < 3; ++k) {
      paths_.frames[k] = side_frame(surface_, FaceId{0}, k);
      paths_.corners[k] = NearestOnCurve::none();
    }
    paths_.longest = std::sqrt(2.0);
  }
  static std::array<double, 3> barycentric(double x, double y) { return {1 - x, x - y, y}; }

  const Surface surface_ = test::surface_of(test::grid(1, 1));
  FacePaths paths_;
  const FacePaths::Barycentric at_ = barycentric(0.75, 0.5);
  const PlanePoint right_{1, 0}, up_{0, 1};
};

TEST_F(PathsIntoAFace, AreNoneAtFirst) {
  EXPECT_TRUE(std::isinf(paths_.hit(at_).nearest.distance));
}

TEST_F(PathsIntoAFace, ComeFromCorners) {
  paths_.corners[0] = {3, 0, 0};
  paths_.corners[1] = {2, 1, 7};
  const auto hit = paths_.hit(at_);
  const double way = std::hypot(0.25, 0.5);  // from (1, 0)
  EXPECT_NEAR(hit.nearest.distance, 2 + way, 1e-15);
  EXPECT_EQ(hit.nearest.curve, 1U);
  EXPECT_EQ(hit.side, 1U);
  EXPECT_NEAR(paths_.slopes(hit, at_, right_).distance, -0.25 / way, 1e-15);
  EXPECT_NEAR(paths_.slopes(hit, at_, up_).distance, 0.5 / way, 1e-15);
  EXPECT_EQ(paths_.slopes(hit, at_, up_).arc_length, 0);
}

TEST_F(PathsIntoAFace, AreCounted) {
  const EnteringWindow entering{test::window_from(0.25, -1, 0, 1), 1, 0, true};
  PolylinePiece piece;
  piece.from = barycentric(0.5, 0.1);
  piece.to = barycentric(0.9, 0.1);
  paths_.windows = {&entering, 1};
  paths_.segments = {&piece, 1};
  paths_.corners[1] = {5, 0, 0};
  ASSERT_EQ(paths_.count(), 5U);
  EXPECT_NEAR(paths_.path(1, at_).nearest.distance, 5 + std::hypot(0.25, 0.5), 1e-15);
  EXPECT_TRUE(std::isinf(paths_.path(2, at_).nearest.distance));
  EXPECT_NEAR(paths_.path(3, at_).nearest.distance, std::hypot(0.5, 1.5), 1e-15);
  EXPECT_EQ(paths_.path(3, at_).window, &entering);
  EXPECT_NEAR(paths_.path(4, at_).nearest.distance, 0.4, 1e-15);
  EXPECT_EQ(paths_.path(4, at_).segment, &piece);
}

TEST_F(PathsIntoAFace, ComeThroughWindows) {
  // From (0.25, -1), through all of the base.
  const EnteringWindow entering{test::window_from(0.25, -1, 0, 1), 1, 0, true};
  paths_.windows = {&entering, 1};
  paths_.corners[1] = {5, 0, 0};
  const auto hit = paths_.hit(at_);
  const double way = std::hypot(0.5, 1.5);
  EXPECT_EQ(hit.window, &entering);
  EXPECT_NEAR(hit.nearest.distance, way, 1e-15);
  EXPECT_NEAR(paths_.slopes(hit, at_, right_).distance, 0.5 / way, 1e-15);
  EXPECT_NEAR(paths_.slopes(hit, at_, up_).distance, 1.5 / way, 1e-15);
}

TEST_F(PathsIntoAFace, ComeThroughWindowsThatRunAgainstTheSide) {
  // The same, turned: now the face is below the edge.
  const EnteringWindow entering{test::window_from(0.25, -1, 0, 1).turned(1), 1, 0, false};
  paths_.windows = {&entering, 1};
  const auto hit = paths_.hit(at_);
  const double way = std::hypot(0.5, 1.5);
  EXPECT_NEAR(hit.nearest.distance, way, 1e-15);
  EXPECT_NEAR(paths_.slopes(hit, at_, right_).distance, 0.5 / way, 1e-15);
  EXPECT_NEAR(paths_.slopes(hit, at_, up_).distance, 1.5 / way, 1e-15);
}

TEST_F(PathsIntoAFace, ComeFromSegmentsInIt) {
  PolylinePiece segment{FaceId{0}, 2, barycentric(0.5, 0.25), barycentric(1, 0.25)};
  segment.arc = 10;
  paths_.segments = {&segment, 1};
  const auto hit = paths_.hit(at_);
  EXPECT_EQ(hit.segment, &segment);
  EXPECT_NEAR(hit.nearest.distance, 0.25, 1e-15);
  EXPECT_NEAR(hit.nearest.arc_length, 10.25, 1e-14);
  const auto right = paths_.slopes(hit, at_, right_), up = paths_.slopes(hit, at_, up_);
  EXPECT_NEAR(right.distance, 0, 1e-15);
  EXPECT_NEAR(right.arc_length, 1, 1e-15);
  EXPECT_NEAR(up.distance, 1, 1e-15);
  EXPECT_NEAR(up.arc_length, 0, 1e-15);
  EXPECT_EQ(paths_.hit(barycentric(0.75, 0.25)).nearest.distance, 0);
}

TEST(KnownFaces, StayAsTheyWereCopied) {
  const Surface surface = test::surface_of(test::grid(4, 4));
  const PolylinePieces no_pieces;
  WindowFront front(surface);
  front.reset(0.25);
  front.start_at(VertexId{0}, {0, 0, 0});
  // The lower triangle of the cell between (2, 1) and (3, 2), and its middle.
  const FaceId face{2 * (2 + 4 * 1)};
  const FacePaths::Barycentric middle{1.0 / 3, 1.0 / 3, 1.0 / 3};
  const double expected = std::hypot((2.0 + 3 + 3) / 3, (1.0 + 1 + 2) / 3);

  KnownFaces faces(surface);
  EXPECT_FALSE(faces.contain(face));
  faces.copy(face, front, no_pieces);
  ASSERT_TRUE(faces.contain(face));
  EXPECT_EQ(faces.at(face).front, 0);
  while (!front.is_done()) front.march();
  EXPECT_TRUE(std::isinf(faces.at(face).paths.hit(middle).nearest.distance));

  faces.copy(face, front, no_pieces);
  faces.copy(FaceId{0}, front, no_pieces);
  EXPECT_NEAR(faces.at(face).paths.hit(middle).nearest.distance, expected, 1e-9);
  EXPECT_TRUE(std::isinf(faces.at(face).front));
  faces.clear();
  EXPECT_FALSE(faces.contain(face));
}

}  // namespace
}  // namespace talweg
