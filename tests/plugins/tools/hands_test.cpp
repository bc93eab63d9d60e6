// Strokes on a bumpy mesh: the smoothed stroke must not depend on the device that drew it.
#include "tools/scenes/hands.hpp"

#include <gtest/gtest.h>

#include "talweg/talweg.hpp"
#include "tools/quality/hand_runs.hpp"
#include "tools/scenes/scenes.hpp"

namespace talweg::quality {
namespace {

const Subject& figure() {
  static const Subject subject = [] {
    Subject made{"figure", scenes::figure_scene().mesh, nullptr, {}};
    made.mesh = OpenedMesh::open(made.lists);
    return made;
  }();
  return subject;
}

TEST(Hands, TheSmoothedStrokeDoesNotDependOnItsSampling) {
  const std::vector<HandRun> runs = hand_runs(figure(), 2, 3);
  ASSERT_EQ(runs.size(), 22U);
  for (const HandRun& run : runs) {
    EXPECT_LT(run.bending, 0.4) << run.sampling << run.hand;
    EXPECT_LT(run.apart, 0.5) << run.sampling << run.hand;
    EXPECT_LT(run.ratio, 3) << run.sampling << run.hand;
    EXPECT_FALSE(run.warned) << run.sampling << run.hand;
  }
}

TEST(Hands, AStrokeHasTheRequestedTremblingAndSampling) {
  const SurfaceMesh& mesh = figure().mesh->mesh();
  scenes::Hand hand;
  hand.length = 30;
  const scenes::HandStroke stroke(mesh, hand, 8);
  ASSERT_TRUE(stroke.is_drawn());
  const double h = stroke.edge();
  EXPECT_EQ(stroke.way().size(), 301U);
  scenes::Sampling sampling;
  sampling.step = 1;
  EXPECT_EQ(stroke.sampled(sampling).size(), 31U);
  // The way of the hand does not depend on its sampling: samples at 12 edges agree.
  const Point at = stroke.sampled(sampling)[12];
  sampling.step = 0.5;
  EXPECT_NEAR((stroke.sampled(sampling)[24] - at).norm(), 0, 1e-9 * h);
  sampling.rests = 1;
  EXPECT_EQ(stroke.sampled(sampling).size(), 61U + 60);
  sampling.spikes = 1;
  EXPECT_EQ(stroke.sampled(sampling).size(), 61U + 60 + 1);
  double farthest = 0;
  for (const Point& p : stroke.sampled({})) {
    farthest = std::max(farthest, NearestSegment(segments_of(stroke.way(), false)).to(p).distance);
  }
  EXPECT_GT(farthest, 0.4 * h);
  EXPECT_LT(farthest, 2.2 * h);
}

TEST(Hands, AStrokeMayGoAroundAPoint) {
  scenes::Hand hand;
  hand.radius = 8;
  hand.over = 3;
  hand.amplitude = 0.2;
  const scenes::HandStroke stroke(figure().mesh->mesh(), hand, 5);
  ASSERT_TRUE(stroke.is_drawn());
  CurveInput input;
  input.points = stroke.sampled({});
  StraightLines lines(figure().mesh->surface());
  const SurfaceCurve drawn = lines.join(snap(figure().mesh->mesh(), input).points, false);
  const auto loop = closed_loop(figure().mesh->mesh(), drawn, lines);
  ASSERT_TRUE(loop);
  EXPECT_NEAR(loop->cut, 3 * stroke.edge(), 2 * stroke.edge());
}

}  // namespace
}  // namespace talweg::quality
