// Properties of one curve: its name and number, tau and tolerance, pins, continuing it; the leg
// that a new point belongs to; combs.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plugins/editing_drawings.hpp"
#include "talweg/editing/comb.hpp"
#include "talweg/editing/legs.hpp"
#include "talweg/editing/screen_line.hpp"
#include "talweg/editing/sight.hpp"

namespace talweg {
namespace {

using editing::Curve;
using editing::Drawing;
using editing::Editor;
using editing::Stage;
using editing::Vector;
using test::at;
using test::refusal;

const Curve& curve(const Editor& editor, std::size_t c) { return *editor.drawing().curves.at(c); }

/// Three curves through the faces 1 to 3, 11 to 13 and 21 to 23.
Editor three_curves() {
  Editor editor;
  for (const std::uint32_t first : {1U, 11U, 21U}) {
    editor.add_curve({{at(first), at(first + 1), at(first + 2)}, false});
  }
  return editor;
}

std::vector<std::uint32_t> numbers(const Editor& editor) {
  std::vector<std::uint32_t> all;
  for (const auto& c : editor.drawing().curves) all.push_back(c->number);
  return all;
}

TEST(Curves, KeepTheirNumbers) {
  Editor editor = three_curves();
  EXPECT_EQ(numbers(editor), (std::vector<std::uint32_t>{1, 2, 3}));
  editor.remove_curve(1);
  EXPECT_EQ(numbers(editor), (std::vector<std::uint32_t>{1, 3}));
  editor.add_point(at(30));
  editor.add_point(at(31));
  editor.finish_curve();
  EXPECT_EQ(numbers(editor), (std::vector<std::uint32_t>{1, 3, 4}));
  editor.move_point(1, 0, at(99));
  editor.continue_curve(0);
  EXPECT_EQ(numbers(editor), (std::vector<std::uint32_t>{3, 4, 1}));
}

TEST(Curves, GoOnAtTheirEnd) {
  Editor editor = three_curves();
  editor.continue_curve(0);
  EXPECT_TRUE(editor.is_drawing());
  EXPECT_EQ(editor.history().undo_name(), "Continue curve");
  editor.add_point(at(4));
  editor.finish_curve();
  ASSERT_EQ(curve(editor, 2).points.size(), 4U);
  EXPECT_EQ(curve(editor, 2).points[0], at(1));
  EXPECT_EQ(curve(editor, 2).points[3].face, 4U);
  EXPECT_EQ(curve(editor, 0).points[0].face, 11U);
  for (int k = 0; k < 3; ++k) editor.history().undo();
  EXPECT_FALSE(editor.is_drawing());
  EXPECT_EQ(curve(editor, 0).points[0].face, 1U);
  EXPECT_EQ(editor.drawing(), three_curves().drawing());
}

TEST(Curves, WithoutAnEndDoNotGoOn) {
  Editor editor = three_curves();
  editor.set_closed(0, true);
  EXPECT_EQ(refusal([&] { editor.continue_curve(0); }),
            "A closed curve has no end to go on at; open it first.");
  EXPECT_EQ(refusal([&] { editor.continue_curve(3); }), "There is no curve 3; the drawing has 3.");
  editor.continue_curve(1);
  EXPECT_EQ(refusal([&] { editor.continue_curve(1); }), "First end the curve that is being drawn.");
}

TEST(Curves, HaveATauOfTheirOwn) {
  Editor editor = three_curves();
  const Drawing before = editor.drawing();
  editor.set_curve_tau(1, 4.5);
  EXPECT_EQ(curve(editor, 1).tau, 4.5);
  EXPECT_EQ(curve(editor, 0).tau, std::nullopt);
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kRun);
  editor.history().undo();
  EXPECT_EQ(editor.drawing(), before);
  editor.history().redo();
  editor.set_curve_tau(1, {});
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kNothing);
  EXPECT_EQ(refusal([&] { editor.set_curve_tau(0, -1); }), "Tau must be 0 or more.");
  EXPECT_EQ(refusal([&] { editor.set_curve_tau(5, 1); }),
            "There is no curve 5; the drawing has 3.");
}

TEST(Curves, HaveAToleranceOfTheirOwn) {
  Editor editor = three_curves();  // strokes
  for (const std::uint32_t face : {31U, 32U}) editor.add_point(at(face));
  editor.finish_curve();
  const Drawing before = editor.drawing();
  editor.set_curve_tolerance(3, 0.25);
  editor.set_curve_tolerance(0, 0.5);
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kCurves);
  const std::vector<host::Curve> curves = host_curves(editor.drawing());
  EXPECT_TRUE(curves.at(0).exact.empty()) << "a stroke stays one";
  EXPECT_EQ(curves.at(3).exact, (std::vector<double>{0.25, 0.25}));
  editor.set_pinned(3, 1, true);
  EXPECT_EQ(host_curves(editor.drawing()).at(3).exact, (std::vector<double>{0.25, 0}));
  editor.set_pinned(3, 1, false);
  editor.set_curve_tolerance(3, {});
  EXPECT_EQ(host_curves(editor.drawing()).at(3).exact, (std::vector<double>{0, 0}));
  EXPECT_EQ(refusal([&] { editor.set_curve_tolerance(0, std::nan("")); }),
            "The tolerance must be 0 or more.");
}

TEST(Curves, ArePinnedAsAWhole) {
  Editor editor = three_curves();
  editor.pin_curve(1, true);
  EXPECT_EQ(host_curves(editor.drawing()).at(1).pins, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(host_curves(editor.drawing()).at(0).pins.empty());
  editor.pin_curve(1, false);
  EXPECT_EQ(editor.drawing(), three_curves().drawing());
  EXPECT_EQ(editor.history().undo_name(), "Unpin curve");
}

TEST(Curves, HaveNames) {
  Editor editor = three_curves();
  const Drawing before = editor.drawing();
  editor.rename_curve(2, "sulcus");
  EXPECT_EQ(curve(editor, 2).name, "sulcus");
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kNothing);
  editor.reverse_curve(2);
  EXPECT_EQ(curve(editor, 2).name, "sulcus");
  editor.history().undo();
  editor.history().undo();
  EXPECT_EQ(curve(editor, 2).name, "");
}

TEST(Curves, OfOthersMayChangeWhileOneIsDrawn) {
  Editor editor = three_curves();
  editor.add_point(at(40));
  editor.set_curve_tau(0, 2);
  editor.pin_curve(1, true);
  editor.rename_curve(2, "third");
  EXPECT_TRUE(editor.is_drawing());
  EXPECT_EQ(editor.drawing().curves.size(), 4U);
}

// ---- Legs

TEST(Legs, AnOpenLineHasOneBetweenEachTwoPoints) {
  std::vector<Vector> line;
  for (int k = 0; k <= 30; ++k) line.push_back({k / 10.0, 0, 0});
  const std::vector<Vector> given = {{0, 0, 0}, {1, 0.1, 0}, {2, -0.1, 0}, {3, 0, 0}};
  EXPECT_EQ(editing::leg_at(given, line, false, 0), 1U);
  EXPECT_EQ(editing::leg_at(given, line, false, 9), 1U);
  EXPECT_EQ(editing::leg_at(given, line, false, 10), 2U);
  EXPECT_EQ(editing::leg_at(given, line, false, 19), 2U);
  EXPECT_EQ(editing::leg_at(given, line, false, 25), 3U);
  EXPECT_EQ(editing::leg_at(given, line, false, 29), 3U);
}

/// Where two stretches lie side by side the nearer points are those of the other one.
TEST(Legs, ALineThatComesBackIsNotTakenForItsOtherStretch) {
  std::vector<Vector> line;
  for (int k = 0; k <= 20; ++k) line.push_back({k / 10.0, 0, 0});
  for (int k = 20; k >= 0; --k) line.push_back({k / 10.0, 0.01, 0});
  const std::vector<Vector> given = {
      {0, 0, 0}, {1, 0.009, 0}, {2, 0.005, 0}, {1.2, 0.001, 0}, {0, 0.01, 0}};
  EXPECT_EQ(editing::leg_at(given, line, false, 5), 1U);
  EXPECT_EQ(editing::leg_at(given, line, false, 15), 2U);
  EXPECT_EQ(editing::leg_at(given, line, false, 24), 3U);
  EXPECT_EQ(editing::leg_at(given, line, false, 35), 4U);
}

TEST(Legs, AClosedLineMayBeginAnywhere) {
  const std::vector<Vector> given = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<Vector> square;  // from the middle of the side from (1, 0) to (1, 1)
  square.reserve(40);
  for (int k = 0; k < 5; ++k) square.push_back({1, 0.5 + k / 10.0, 0});
  for (int k = 10; k > 0; --k) square.push_back({k / 10.0, 1, 0});
  for (int k = 10; k > 0; --k) square.push_back({0, k / 10.0, 0});
  for (int k = 0; k < 10; ++k) square.push_back({k / 10.0, 0, 0});
  for (int k = 0; k < 5; ++k) square.push_back({1, k / 10.0, 0});
  EXPECT_EQ(editing::leg_at(given, square, true, 0), 2U);
  EXPECT_EQ(editing::leg_at(given, square, true, 8), 3U);
  EXPECT_EQ(editing::leg_at(given, square, true, 20), 4U);
  EXPECT_EQ(editing::leg_at(given, square, true, 28), 1U);
  EXPECT_EQ(editing::leg_at(given, square, true, 39), 2U) << "back to where the line begins";
}

TEST(Legs, AMissingPartIsRefused) {
  const std::vector<Vector> line = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(refusal([&] { (void)editing::leg_at(line, line, false, 1); }),
            "There is no such part of the curve.");
  EXPECT_EQ(editing::leg_at(line, line, true, 1), 2U);
  EXPECT_NE(refusal([&] { (void)editing::leg_at({{0, 0, 0}}, line, false, 0); }), "no refusal");
  EXPECT_NE(refusal([&] { (void)editing::leg_at(line, {}, false, 0); }), "no refusal");
}

// ---- Lines on the screen

TEST(ScreenLine, TellsTheSegmentUnderTheMouse) {
  const std::vector<editing::Pixel> line = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const auto near = editing::nearest_segment(line, false, {7, 4});
  EXPECT_EQ(near.segment, 1U);
  EXPECT_EQ(near.away, 3);
  EXPECT_EQ(near.along, 0.4);
  EXPECT_EQ(editing::nearest_segment(line, false, {1, 4}).segment, 0U);
  EXPECT_EQ(editing::nearest_segment(line, true, {1, 4}).segment, 3U);
  EXPECT_EQ(editing::nearest_segment(line, false, {13, 14}).away, 5) << "beyond an end";
}

TEST(ScreenLine, ALineWithoutSegmentsIsInfinitelyFar) {
  EXPECT_TRUE(std::isinf(editing::nearest_segment({}, true, {0, 0}).away));
  EXPECT_TRUE(std::isinf(editing::nearest_segment({{1, 1}}, false, {0, 0}).away));
  EXPECT_EQ(editing::nearest_segment({{3, 4}, {3, 4}}, false, {0, 0}).away, 5) << "of no length";
}

// ---- Combs

/// A curve on a flat sheet, or on a sheet that is bent along its middle, with its curvatures.
struct OnSheet {
  editing::MeshArrays mesh;
  host::Curve line;

  OnSheet(const std::vector<Vector>& places, bool closed, const std::vector<double>& turns) {
    mesh = test::arrays_of(test::grid(20, 20));
    const editing::Sight sight(std::make_shared<const editing::MeshArrays>(mesh));
    for (const Vector& place : places) {
      const auto point = sight.first({place[0], place[1], 5}, {0, 0, -1});
      line.faces.push_back(point.value().face);
      line.barycentrics.push_back(point->barycentric);
      line.positions.push_back(position_of(mesh, *point));
    }
    line.closed = closed;
    line.fields.push_back({"curvature", "radians", turns});
  }
};

double extent() { return test::arrays_of(test::grid(20, 20)).positions.back()[0]; }

TEST(Combs, ACircleHasTeethOfOneLength) {
  const double radius = 0.3 * extent(), middle = 0.5 * extent();
  const auto count = 180;
  std::vector<Vector> places;
  for (int k = 0; k < count; ++k) {
    const double a = 2 * M_PI * k / count;
    places.push_back({middle + radius * std::cos(a), middle + radius * std::sin(a), 0});
  }
  for (const bool reversed : {false, true}) {
    if (reversed) std::reverse(places.begin(), places.end());
    const OnSheet circle(places, true, std::vector<double>(count, 2 * M_PI / count));
    const auto teeth = comb_of(circle.mesh, circle.line, 2 * M_PI * radius / 45);
    EXPECT_NEAR(static_cast<double>(teeth.size()), 45, 1);
    for (const editing::Tooth& tooth : teeth) {
      EXPECT_NEAR(tooth.curvature, 1 / radius, 0.15 / radius);
      const Vector from_middle = editing::minus(tooth.root, {middle, middle, 0});
      EXPECT_NEAR(editing::dot(tooth.out, from_middle) / editing::length(from_middle), 1, 0.01)
          << "outwards";
      EXPECT_NEAR(editing::length(tooth.out), 1, 1e-12);
    }
  }
}

TEST(Combs, AStraightLineHasTeethOfNoLength) {
  std::vector<Vector> places;
  for (int k = 0; k <= 30; ++k) places.push_back({(0.1 + 0.02 * k) * extent(), 0.4 * extent(), 0});
  const OnSheet straight(places, false, std::vector<double>(31, 0));
  const auto teeth = comb_of(straight.mesh, straight.line, 0.1 * extent());
  EXPECT_EQ(teeth.size(), 7U);  // six gaps and both ends
  for (const editing::Tooth& tooth : teeth) EXPECT_EQ(tooth.curvature, 0);
}

TEST(Combs, TurnsToTheOtherSideHaveTeethOnTheOtherSide) {
  // Right, then left, each by a right angle.
  const double s = extent() / 10;
  const OnSheet step(
      {{0.5 * s, 8 * s, 0}, {5 * s, 8 * s, 0}, {5 * s, 2 * s, 0}, {8.5 * s, 2 * s, 0}}, false,
      {0, M_PI / 2, M_PI / 2, 0});
  const auto teeth = comb_of(step.mesh, step.line, s);
  ASSERT_EQ(teeth.size(), 15U);
  EXPECT_NEAR(teeth[4].curvature, M_PI / 2 / (2 * s), 1e-9);
  EXPECT_NEAR(teeth[4].out[1], 1, 1e-12) << "above the right turn";
  EXPECT_NEAR(teeth[11].curvature, M_PI / 2 / (2 * s), 1e-9);
  EXPECT_NEAR(teeth[11].out[1], -1, 1e-12) << "below the left turn";
  EXPECT_EQ(teeth[7].curvature, 0);
}

TEST(Combs, NeedCurvaturesAndASpacing) {
  OnSheet line({{0.2, 0.2, 0}, {0.4, 0.2, 0}}, false, {0, 0});
  EXPECT_NE(refusal([&] { comb_of(line.mesh, line.line, 0); }), "no refusal");
  line.line.fields.clear();
  EXPECT_EQ(refusal([&] { comb_of(line.mesh, line.line, 1); }),
            "The curve has no curvature; smooth it first.");
}

}  // namespace
}  // namespace talweg
