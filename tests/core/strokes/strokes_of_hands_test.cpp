// Strokes with the trembling of hands and devices, on a plane, around a known intended curve.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/strokes/hand_rests.hpp"
#include "talweg/talweg.hpp"

namespace talweg::strokes_test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Trembling: waves of length 2.5 to 5 and height 0.6 across the intended curve.
double trembling(double along, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> wave(2.5, 5), phase(0, kTurn);
  double sum = 0;
  for (int k = 0; k < 12; ++k) {
    const double length = wave(random);
    sum += std::sin(kTurn * along / length + phase(random));
  }
  return 0.6 * sum / std::sqrt(12);
}

class StrokesOfHands : public testing::Test {
 protected:
  /// A point of the trembling stroke, which runs from left to right in a slow bend.
  [[nodiscard]] static Point hand(double along) {
    return {5 + along, 20 + 4 * std::sin(along / 20) + trembling(along, 7), 0};
  }
  [[nodiscard]] static std::vector<Point> stroke(double step, double jitter = 0) {
    std::mt19937 random(3);
    std::normal_distribution<double> off(0, 1);
    std::vector<Point> points;
    for (double x = 0; x <= 90; x += step) {
      points.push_back(hand(x) + jitter * Point(off(random), off(random), 0));
    }
    return points;
  }
  SmoothingResult smoothed(const std::vector<Point>& points, bool closed = false) {
    CurveInput input;
    input.points = points;
    input.closed = closed;
    const SnappedCurve snapped = snap(opened->mesh(), input);
    notes = snapped.notes;
    drawn = StraightLines(opened->surface()).join(snapped.points, closed);
    smoother.set_curve(drawn);
    return smoother.smooth(1);
  }
  [[nodiscard]] double apart(const SurfaceCurve& a, const SurfaceCurve& b) const {
    std::vector<Point> p, q;
    for (const Point& at : positions_of(opened->mesh(), a)) {
      if (at.x() > 9 && at.x() < 91) p.push_back(at);
    }
    for (const Point& at : positions_of(opened->mesh(), b)) {
      if (at.x() > 7 && at.x() < 93) q.push_back(at);
    }
    return deviation(p, false, q, false).to_drawn.max;
  }

  const std::shared_ptr<const OpenedMesh> opened = OpenedMesh::open(test::grid(100, 40));
  CurveSmoother smoother{opened};
  SurfaceCurve drawn;
  std::vector<std::string> notes;
};

TEST_F(StrokesOfHands, AreTheSameHoweverTheyAreSampled) {
  const SmoothingResult ten = smoothed(stroke(0.1));
  EXPECT_EQ(ten.report().slack_from, SlackSource::kTrembling);
  EXPECT_NEAR(ten.report().slack, 0.7, 0.2);  // √3 · 0.6 / √2
  EXPECT_LT(ten.report().after.bending, 0.3);
  const std::array<std::vector<Point>, 6> others{
      stroke(1), stroke(0.33), stroke(0.03), stroke(0.01), stroke(0.1, 0.05), stroke(0.03, 0.05)};
  for (std::size_t k = 0; k < others.size(); ++k) {
    const SmoothingResult result = smoothed(others[k]);
    EXPECT_LT(apart(result.curve(), ten.curve()), 0.5) << k;
    EXPECT_LT(apart(ten.curve(), result.curve()), 0.5) << k;
    EXPECT_LT(result.report().after.bending, 0.3) << k;
    EXPECT_TRUE(result.report().warnings.empty()) << k << result.report().warnings.front();
  }
}

/// The hand trembles little and wanders in longer waves.
TEST_F(StrokesOfHands, TremblingIsNotTakenForJitter) {
  const auto wandering = [](double step, double jitter, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> off(0, jitter);
    std::vector<Point> points;
    for (double x = 0; x <= 90; x += step) {
      const double y = 0.33 * trembling(x, 1) + 0.6 * trembling(x / 3, 2);
      points.push_back(Point(5 + x, 20 + y, 0));
      if (!(jitter > 0)) continue;
      for (const int k : {0, 1}) points.back()[k] += off(random);
    }
    return points;
  };
  const SmoothingResult calm = smoothed(wandering(0.1, 0, 0));
  EXPECT_GT(calm.report().slack, 0.1);
  for (unsigned seed = 1; seed < 5; ++seed) {
    const SmoothingResult jittery = smoothed(wandering(0.03, 0.05, seed));
    EXPECT_GT(jittery.report().slack, 0.67 * calm.report().slack) << seed;
    EXPECT_LT(jittery.report().slack, 1.5 * calm.report().slack) << seed;
  }
}

TEST_F(StrokesOfHands, RestsAreLeftOut) {
  const SmoothingResult ten = smoothed(stroke(0.33));
  std::vector<Point> points;
  std::mt19937 random(5);
  std::normal_distribution<double> off(0, 0.004);
  for (const Point& p : stroke(0.33)) {
    points.push_back(p);
    if (points.size() % 70 != 9) continue;
    for (int k = 0; k < 60; ++k) points.push_back(p + Point(off(random), off(random), 0));
  }
  const SmoothingResult result = smoothed(points);
  EXPECT_LT(apart(result.curve(), ten.curve()), 0.5);
  EXPECT_LT(result.report().after.bending, 0.3);
  EXPECT_EQ(result.report().points_before, drawn.points.size());
  EXPECT_GT(result.report().left_out, 150U);
  EXPECT_LT(result.report().left_out_max, result.report().slack / 2);
  ASSERT_FALSE(result.report().warnings.empty());
  EXPECT_NE(result.report().warnings.front().find("where the hand rested"), std::string::npos);
}

TEST_F(StrokesOfHands, TheMeasuresOfADrawingWithARestHaveItsDirection) {
  std::vector<Point> points = stroke(0.33);
  std::mt19937 random(5);
  std::normal_distribution<double> off(0, 0.004);
  std::vector<Point> rest;
  for (int k = 0; k < 60; ++k) rest.push_back(points[80] + Point(off(random), off(random), 0));
  points.insert(points.begin() + 81, rest.begin(), rest.end());
  for (const bool is_backwards : {false, true}) {
    const SmoothingReport report = smoothed(points).report();
    ASSERT_GT(report.left_out, 0U);
    const CurveMeasures expected = measure_curve(opened->mesh(), drawn, report.edge_length_near);
    EXPECT_NEAR(report.before.signed_curvature, expected.signed_curvature, 1e-9) << is_backwards;
    EXPECT_EQ(report.before.max_at, expected.max_at) << is_backwards;
    std::reverse(points.begin(), points.end());
  }
}

/// A mouse gives a point every two edges, and a hundred points where the hand rests. A tablet's pen
/// at rest wobbles by more than the spacing of its samples in motion.
TEST_F(StrokesOfHands, RestsAreLeftOutForAnySampling) {
  std::mt19937 random(5);
  for (const double step : {2.0, 1.0, 0.3, 0.1}) {
    for (const double wobble : {0.003, 0.05, 0.15}) {
      if (wobble > 0.5 * step) continue;
      const SmoothingResult moving = smoothed(stroke(step));
      std::normal_distribution<double> off(0, wobble);
      std::vector<Point> points;
      const std::vector<Point> without = stroke(step);
      for (std::size_t k = 0; k < without.size(); ++k) {
        points.push_back(without[k]);
        if (k % (without.size() / 4) != 5) continue;
        for (int i = 0; i < 100; ++i)
          points.push_back(without[k] + Point(off(random), off(random), 0));
      }
      const SmoothingResult result = smoothed(points);
      EXPECT_LT(apart(result.curve(), moving.curve()), 0.5) << step << ' ' << wobble;
      EXPECT_NEAR(result.report().slack, moving.report().slack, 0.15 * moving.report().slack)
          << step << ' ' << wobble;
      EXPECT_LT(result.report().after.bending, moving.report().after.bending + 0.3)
          << step << ' ' << wobble;
      EXPECT_GT(result.report().left_out, 350U) << step << ' ' << wobble;
    }
  }
}

/// A slow hand still moves: careful parts keep all their bends.
TEST_F(StrokesOfHands, SlowPartsAreNoRests) {
  std::vector<Point> points;
  for (double x = 0; x < 30; x += 2) points.emplace_back(5 + x, 20 + 0.3 * trembling(x, 7), 0);
  for (double x = 0; x < 12; x += 0.05) {
    points.emplace_back(35 + x, 20 + 1.5 * std::sin(kTurn * x / 6), 0);
  }
  for (double x = 12; x < 50; x += 2) points.emplace_back(35 + x, 20 + 0.3 * trembling(x, 8), 0);
  smoothed(points);
  EXPECT_TRUE(hand_rests(opened->mesh(), drawn).empty());
}

TEST_F(StrokesOfHands, WindingsAreNoRests) {
  std::vector<Point> points;
  for (double x = 0; x < 40; x += 1) points.emplace_back(5 + x, 20, 0);
  for (int k = 0; k < 60; ++k) {  // five turns, each a little farther to the right
    const double angle = kTurn * (k / 12.0 - 0.25);
    points.emplace_back(45 + 0.02 * k + 2 * std::cos(angle), 22 + 2 * std::sin(angle), 0);
  }
  for (double x = 0; x < 40; x += 1) points.emplace_back(48 + x, 20, 0);
  smoothed(points);
  EXPECT_TRUE(hand_rests(opened->mesh(), drawn).empty());
}

TEST_F(StrokesOfHands, LoseTheSpikesOfATracker) {
  const SmoothingResult ten = smoothed(stroke(0.1));
  std::vector<Point> points = stroke(0.1);
  for (const std::size_t k : {100U, 377U, 612U}) points[k] += Point(3, 9, 5);
  const SmoothingResult result = smoothed(points);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("3 of 901 points of a curve lie far from the points before and after"),
            std::string::npos)
      << notes[0];
  EXPECT_LT(apart(result.curve(), ten.curve()), 0.3);
}

TEST_F(StrokesOfHands, LoseAHookAtTheirEnd) {
  std::vector<Point> points = stroke(0.1);
  const Point end = points.back();
  for (double back = 0.1; back < 1.2; back += 0.1)
    points.emplace_back(end.x() - back, end.y() + 0.1, 0);
  const SmoothingResult result = smoothed(points);
  EXPECT_NEAR(opened->mesh().position(result.curve().points.back()).x(), end.x(), 0.2);
  ASSERT_FALSE(result.report().warnings.empty());
  EXPECT_NE(result.report().warnings.front().find("1 hook at an end"), std::string::npos);
}

TEST_F(StrokesOfHands, KeepAGivenSlack) {
  smoothed(stroke(0.1));
  SmoothingOptions options;
  options.slack = 0.3;
  const SmoothingReport report = smoother.smooth(options).report();
  EXPECT_EQ(report.slack, 0.3);
  EXPECT_EQ(report.slack_from, SlackSource::kGiven);
  // A slack field has a value for each given point, also for points left out.
  options.slack.reset();
  options.slack_at = {std::vector<double>(drawn.points.size(), 0.3)};
  EXPECT_EQ(smoother.smooth(options).report().slack, 0.3);
}

TEST_F(StrokesOfHands, PinsMayLieOnPointsLeftOut) {
  smoothed(stroke(0.01));
  const SurfacePoint pin = drawn.points[drawn.points.size() / 3];
  ASSERT_TRUE(smoother.set_pins(std::span(&pin, 1)));
  const SurfaceCurve result = smoother.smooth(1).curve();
  EXPECT_NE(std::find(result.points.begin(), result.points.end(), pin), result.points.end());
}

/// A scribble on a slow stroke: a pin in it leaves a scribble on either side, or none.
TEST_F(StrokesOfHands, ArePinnedAsIfTheyWereDrawnWithThePins) {
  std::vector<Point> points = stroke(0.3);
  const Point rest = points[150];
  std::vector<Point> scribble;
  for (int k = 0; k < 150; ++k) {
    scribble.push_back(rest + 0.15 * Point(std::sin(1.1 * k), std::cos(1.7 * k), 0));
  }
  points.insert(points.begin() + 150, scribble.begin(), scribble.end());
  const SurfaceCurve plain = smoothed(points).curve();
  CurveSmoother from_start(opened);
  const std::size_t n = drawn.points.size();
  std::size_t others = 0;
  for (std::size_t k = 2 * n / 5; k < 3 * n / 5; k += n / 40) {
    const SurfacePoint pin = drawn.points[k];
    smoother.set_pins(std::span(&pin, 1));
    from_start.set_curve(drawn, {.pins = {pin}});
    const SmoothingResult pinned = smoother.smooth(1), expected = from_start.smooth(1);
    ASSERT_EQ(pinned.curve().points, expected.curve().points) << k;
    ASSERT_EQ(pinned.report().left_out, expected.report().left_out) << k;
    ASSERT_EQ(pinned.report().warnings, expected.report().warnings) << k;
    others += static_cast<std::size_t>(pinned.curve().points != plain.points);
  }
  EXPECT_GT(others, 4U);
  smoother.set_pins({});
  EXPECT_EQ(smoother.smooth(1).curve().points, plain.points);
}

TEST_F(StrokesOfHands, AreTheSameFromTheirOtherEnd) {
  const std::vector<Point> points = stroke(0.03, 0.05);
  const SmoothingResult there = smoothed(points);
  SurfaceCurve reversed = drawn;
  std::reverse(reversed.points.begin(), reversed.points.end());
  smoother.set_curve(reversed);
  SurfaceCurve back = smoother.smooth(1).curve();
  std::reverse(back.points.begin(), back.points.end());
  EXPECT_EQ(back.points, there.curve().points);
}

/// A drawn U, 20 wide and 250 long, sampled every 13, all in units of 1/13.
TEST_F(StrokesOfHands, KeepNarrowShapesThatWereMeant) {
  const double width = 20.0 / 13, length = 250.0 / 13;
  std::vector<Point> points;
  const auto add = [&](double s) {
    const double round = 13.0 / 13 * s;
    if (round <= length) {
      points.emplace_back(10 + round, 10.3, 0);
    } else if (round <= length + width) {
      points.emplace_back(10 + length, 10.3 + round - length, 0);
    } else {
      points.emplace_back(10 + 2 * length + width - round, 10.3 + width, 0);
    }
  };
  for (double s = 0; s <= 2 * length + width; s += 1) add(s);
  const SmoothingResult result = smoothed(points);
  const double drawn_length = result.report().before.length;
  EXPECT_GT(result.report().after.length, 0.85 * drawn_length);
  EXPECT_LT(result.report().deviation_from_drawn_max, width / 2);
}

TEST_F(StrokesOfHands, KeepCornersAndWavesThatAreLargerThanTheirTrembling) {
  std::vector<Point> corner, waves;
  for (double x = 0; x <= 40; x += 0.1) corner.emplace_back(8 + x, 10 + trembling(x, 1), 0);
  for (double y = 0; y <= 25; y += 0.1) corner.emplace_back(48 + trembling(y, 2), 10 + y, 0);
  EXPECT_LT(smoothed(corner).report().deviation_from_drawn_max, 3);
  for (double x = 0; x <= 85; x += 0.1) {
    waves.emplace_back(6 + x, 20 + 3 * std::sin(kTurn * x / 20), 0);
  }
  EXPECT_LT(smoothed(waves).report().deviation_from_drawn_max, 0.5);
}

TEST_F(StrokesOfHands, CarefulAndRoughPartsHaveDifferentSlacks) {
  std::vector<Point> points;
  const auto fine = [](double x) { return trembling(x * 1.2, 4) / 6; };
  for (double x = 0; x <= 45; x += 0.05) points.emplace_back(3 + x, 20 + fine(x), 0);
  for (double x = 45.2; x <= 92; x += 0.2) points.emplace_back(3 + x, 20 + trembling(x, 9), 0);
  const SmoothingResult result = smoothed(points);
  EXPECT_LT(result.report().after.bending, 0.5);
  double careful = 0;
  for (const Point& p : positions_of(opened->mesh(), result.curve())) {
    if (p.x() > 5 && p.x() < 40) careful = std::max(careful, std::abs(p.y() - 20));
  }
  EXPECT_LT(careful, 0.3);  // would be 0.8 with the slack of the other half
}

TEST_F(StrokesOfHands, LoopsHaveTheSlackOfLines) {
  std::vector<std::vector<Point>> loops(2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double step = k == 0 ? 0.1 : 0.02;
    for (double s = 0; s < kTurn * 14; s += step) {
      const double radius = 14 + trembling(s, 11), angle = s / 14;
      loops[k].emplace_back(50 + radius * std::cos(angle), 20 + radius * std::sin(angle), 0);
    }
  }
  const SmoothingResult coarse = smoothed(loops[0], true);
  const SmoothingResult fine = smoothed(loops[1], true);
  for (const SmoothingResult* result : {&coarse, &fine}) {
    EXPECT_EQ(result->report().slack_from, SlackSource::kTrembling);
    for (const Point& p : positions_of(opened->mesh(), result->curve())) {
      EXPECT_NEAR((p - Point(50, 20, 0)).norm(), 14, 1);
    }
    EXPECT_LT(result->report().after.total_curvature, 1.15 * kTurn);
  }
}

}  // namespace
}  // namespace talweg::strokes_test
