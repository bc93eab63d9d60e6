// Work on a mesh without a thread: drawn curves and legs on the surface, values of one curve.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plugins/editing_drawings.hpp"
#include "plugins/found_plugins.hpp"
#include "talweg/editing/smoothing_thread.hpp"

namespace talweg::workplace_test {
namespace {

using editing::Request;
using editing::Task;
using editing::Vector;
using test::found_plugins;

editing::Outcome work(editing::Workplace& place, Task task, const editing::Drawing& drawing = {}) {
  Request request;
  request.task = task;
  request.drawing = drawing;
  request.wanted.point_fields = task == Task::kSmooth;
  editing::Outcome outcome = place.work(request);
  EXPECT_EQ(outcome.status, TALWEG_OK) << outcome.sentence;
  return outcome;
}

double length_of(const host::Curve& curve) {
  double sum = 0;
  for (std::size_t k = 1; k < curve.positions.size(); ++k) {
    sum += editing::length(editing::minus(curve.positions[k], curve.positions[k - 1]));
  }
  return sum;
}

/// Whether a warning has these words.
bool says(const host::Results& results, const std::string& words) {
  const host::ReportEntry* warnings = results.find("warnings");
  if (warnings == nullptr) return false;
  return std::any_of(
      warnings->texts.begin(), warnings->texts.end(),
      [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

/// A tube around the z axis, of radius 1 and height 3.
struct Tube {
  std::shared_ptr<const editing::MeshArrays> mesh =
      std::make_shared<const editing::MeshArrays>(test::arrays_of(test::tube(48, 31, 3)));
  editing::Workplace place{found_plugins(), mesh};
  editing::Editor editor;

  /// The vertex in a row, counted around.
  static std::uint32_t vertex(std::uint32_t around, std::uint32_t row) { return 48 * row + around; }
  void click(const std::vector<std::uint32_t>& vertices) {
    for (const editing::Point& point : points_at(*mesh, vertices)) editor.add_point(point);
  }
};

/// A chord of the tube goes through it. The way over the surface is a screw line: half a turn and
/// half the height.
TEST(Workplace, DrawnCurvesLieOnTheSurface) {
  Tube tube;
  tube.click({Tube::vertex(0, 5), Tube::vertex(24, 20)});
  const editing::Outcome drawn = work(tube.place, Task::kDraw, tube.editor.drawing());
  ASSERT_EQ(drawn.results.curves.size(), 1U);
  const host::Curve& curve = drawn.results.curves[0];
  for (const Vector& p : curve.positions) {
    EXPECT_GT(std::hypot(p[0], p[1]), std::cos(M_PI / 48) - 1e-9) << "on the flat faces";
  }
  const double height = 1.5, half = 24 * 2 * std::sin(M_PI / 48);
  EXPECT_NEAR(length_of(curve), std::hypot(half, height), 1e-9);
  EXPECT_EQ(curve.positions.front(), tube.mesh->positions[Tube::vertex(0, 5)]);
}

TEST(Workplace, EveryCurveIsDrawnAndOnlyOnce) {
  Tube tube;
  tube.click({Tube::vertex(0, 5), Tube::vertex(10, 5)});
  tube.editor.finish_curve();
  tube.click({Tube::vertex(0, 15), Tube::vertex(10, 15), Tube::vertex(10, 20)});
  tube.editor.close_curve();
  tube.click({Tube::vertex(20, 8)});
  const editing::Outcome first = work(tube.place, Task::kDraw, tube.editor.drawing());
  ASSERT_EQ(first.results.curves.size(), 2U) << "a single point is not a curve yet";
  EXPECT_TRUE(first.results.curves[1].closed);
  tube.click({Tube::vertex(25, 8)});
  const editing::Outcome second = work(tube.place, Task::kDraw, tube.editor.drawing());
  ASSERT_EQ(second.results.curves.size(), 3U);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(second.results.curves[c].positions, first.results.curves[c].positions);
  }
  EXPECT_NEAR(length_of(second.results.curves[2]), 5 * 2 * std::sin(M_PI / 48), 1e-9);
  tube.editor.move_point(0, 1, points_at(*tube.mesh, {Tube::vertex(4, 5)}).at(0));
  tube.editor.remove_curve(1);
  const editing::Outcome third = work(tube.place, Task::kDraw, tube.editor.drawing());
  ASSERT_EQ(third.results.curves.size(), 2U);
  EXPECT_NEAR(length_of(third.results.curves[0]), 4 * 2 * std::sin(M_PI / 48), 1e-9);
  EXPECT_EQ(third.results.curves[1].positions, second.results.curves[2].positions);
  EXPECT_TRUE(work(tube.place, Task::kDraw).results.curves.empty());
}

TEST(Workplace, ALegGoesOverTheSurfaceAndLeavesDrawnCurvesAlone) {
  Tube tube;
  tube.click({Tube::vertex(0, 5), Tube::vertex(10, 5)});
  const editing::Outcome before = work(tube.place, Task::kDraw, tube.editor.drawing());
  const auto ends = points_at(*tube.mesh, {Tube::vertex(10, 5), Tube::vertex(34, 5)});
  editing::SmoothingThread thread(found_plugins(), tube.mesh);
  for (int k = 0; k < 20; ++k) thread.leg(ends[1], ends[0]);
  const std::uint64_t ticket = thread.leg(ends[0], ends[1]);
  thread.wait();
  std::vector<editing::Outcome> legs;
  bool opened = false;
  while (auto outcome = thread.take()) {
    if (outcome->task == Task::kOpen) opened = legs.empty();
    if (outcome->task == Task::kLeg) legs.push_back(std::move(*outcome));
  }
  EXPECT_TRUE(opened) << "first";
  ASSERT_FALSE(legs.empty());
  EXPECT_LT(legs.size(), 21U) << "only the newest counts";
  EXPECT_EQ(legs.back().ticket, ticket);
  ASSERT_EQ(legs.back().results.curves.size(), 1U);
  EXPECT_NEAR(length_of(legs.back().results.curves[0]), 24 * 2 * std::sin(M_PI / 48), 1e-9);
  const editing::Outcome after = work(tube.place, Task::kDraw, tube.editor.drawing());
  EXPECT_EQ(after.results.curves[0].positions, before.results.curves[0].positions);
}

TEST(Workplace, SeesTheMesh) {
  Tube tube;
  const editing::Outcome outcome = work(tube.place, Task::kSee);
  ASSERT_NE(outcome.sight, nullptr);
  const auto point = outcome.sight->first({5, 0.01, 1.51}, {-1, 0, 0});
  ASSERT_TRUE(point);
  EXPECT_NEAR(position_of(*tube.mesh, *point)[0], 1, 0.01);
}

/// Settings that the method does not know are kept for the other method, and do no harm.
TEST(Workplace, ThePapersMethodIsChosenByASetting) {
  Tube tube;
  tube.click({Tube::vertex(0, 5), Tube::vertex(12, 20), Tube::vertex(24, 10)});
  tube.editor.finish_curve();
  tube.editor.set_slack(0.1);
  tube.editor.set_max_deviation(0.2);
  tube.editor.set_curve_tau(0, 3.0);
  const auto potential = [&] {
    return work(tube.place, Task::kSmooth, tube.editor.drawing()).results.text("potential");
  };
  EXPECT_EQ(potential(), "corridor");
  tube.editor.set_paper(true);
  EXPECT_EQ(potential(), "paper");
  tube.editor.set_paper(false);
  EXPECT_EQ(potential(), "corridor");
  EXPECT_EQ(tube.editor.drawing().settings.slack, 0.1);
  EXPECT_EQ(tube.editor.drawing().settings.max_deviation, 0.2);
}

/// The stroke runs around the tube and a little past its own beginning, two rows higher.
TEST(Workplace, APaintedStrokeThatComesBackIsALoop) {
  Tube tube;
  for (std::uint32_t k = 0; k < 51; ++k) {
    const std::uint32_t row = 14 + k % 2 + (k > 40 ? 1 : 0);
    tube.editor.paint_point(points_at(*tube.mesh, {Tube::vertex(k % 48, row)}).at(0));
  }
  tube.editor.finish_curve();
  const auto smoothed = [&] {
    return work(tube.place, Task::kSmooth, tube.editor.drawing()).results;
  };
  const host::Results loop = smoothed();
  EXPECT_TRUE(loop.curves.at(0).closed);
  EXPECT_TRUE(says(loop, "taken as a loop"));
  tube.editor.set_ends(editing::Ends::kOpen);
  EXPECT_FALSE(smoothed().curves.at(0).closed);
  tube.editor.set_ends(editing::Ends::kClosed);
  EXPECT_TRUE(smoothed().curves.at(0).closed);
}

TEST(Workplace, ClicksBesideClicksAreOne) {
  Tube tube;
  tube.click({Tube::vertex(0, 5), Tube::vertex(10, 15), Tube::vertex(11, 15), Tube::vertex(20, 5)});
  tube.editor.finish_curve();
  const auto merged = [&](std::optional<double> distance) {
    tube.editor.set_click_distance(distance);
    return says(work(tube.place, Task::kSmooth, tube.editor.drawing()).results,
                "merged with that point");
  };
  EXPECT_FALSE(merged(0.0));
  EXPECT_TRUE(merged(0.2));
}

/// Two strokes around the tube, far apart: each is smoothed as if it was alone.
TEST(Workplace, ACurvesOwnTauIsItsOwn) {
  Tube tube;
  for (const std::uint32_t row : {8U, 22U}) {
    std::vector<std::uint32_t> steps;
    for (std::uint32_t k = 0; k < 24; ++k) steps.push_back(Tube::vertex(k, row + k / 4 % 2 * 4));
    tube.editor.add_curve({points_at(*tube.mesh, steps), false});
  }
  const auto smoothed = [&] {
    return work(tube.place, Task::kSmooth, tube.editor.drawing()).results;
  };
  const host::Results same = smoothed();
  tube.editor.set_curve_tau(1, 0);
  const host::Results own = smoothed();
  EXPECT_EQ(own.curves.at(0).positions, same.curves.at(0).positions);
  EXPECT_NE(own.curves.at(1).positions, same.curves.at(1).positions);
  EXPECT_EQ(own.number("tau", 0), 1);
  EXPECT_EQ(own.number("tau", 1), 0);
  tube.editor.set_tau(0);
  tube.editor.set_curve_tau(0, 1);
  EXPECT_EQ(smoothed().curves.at(1).positions, own.curves.at(1).positions);
  tube.editor.set_curve_tau(0, {});
  tube.editor.set_curve_tau(1, {});
  tube.editor.set_tau(1);
  EXPECT_EQ(smoothed().curves.at(1).positions, same.curves.at(1).positions);

  tube.editor.set_curve_tolerance(0, 0.001);  // the slack of a stroke
  const host::Results exact = smoothed();
  EXPECT_EQ(exact.number("slack", 0), 0.001);
  EXPECT_LT(exact.number("deviation_to_drawn_max", 0), same.number("deviation_to_drawn_max", 0));
  EXPECT_EQ(exact.curves.at(1).positions, same.curves.at(1).positions);
}

TEST(Workplace, ACurvesOwnToleranceLetsItPassBesideItsClicks) {
  Tube tube;
  std::vector<std::uint32_t> clicks;
  for (std::uint32_t k = 0; k < 5; ++k) clicks.push_back(Tube::vertex(4 * k, 12 + 3 * (k % 2)));
  tube.click(clicks);
  tube.editor.finish_curve();
  const auto farthest = [&] {  // of the clicks from the result's points
    const auto results = work(tube.place, Task::kSmooth, tube.editor.drawing()).results;
    double most = 0;
    for (const std::uint32_t v : clicks) {
      double least = 1e9;
      for (const Vector& p : results.curves.at(0).positions) {
        least = std::min(least, editing::length(editing::minus(p, tube.mesh->positions[v])));
      }
      most = std::max(most, least);
    }
    return most;
  };
  EXPECT_LT(farthest(), 1e-9);
  tube.editor.set_curve_tolerance(0, 0.1);
  const double beside = farthest();
  EXPECT_GT(beside, 0.02);
  EXPECT_LT(beside, 0.2);
  tube.editor.set_curve_tolerance(0, {});
  EXPECT_LT(farthest(), 1e-9);
}

}  // namespace
}  // namespace talweg::workplace_test
