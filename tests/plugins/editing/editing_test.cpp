// The editing model: every edit, what it refuses, undo and redo; selections in order.
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "plugins/editing_drawings.hpp"
#include "talweg/editing/selection_order.hpp"

namespace talweg::editing_test {
namespace {

using editing::Curve;
using editing::Drawing;
using editing::Editor;
using editing::Stage;
using test::at;
using test::refusal;

editing::Point clicked_at(std::uint32_t face) { return {face, {0.25, 0.25, 0.5}, false, 0}; }

TEST(Editor, DrawsAnOpenCurve) {
  Editor editor;
  for (const std::uint32_t face : {3U, 4U, 4U, 7U}) editor.add_point(at(face));
  EXPECT_TRUE(editor.is_drawing());
  EXPECT_EQ(editor.drawing().curves.at(0)->points,
            (std::vector<editing::Point>{clicked_at(3), clicked_at(4), clicked_at(7)}));
  editor.take_back_point();
  editor.finish_curve();
  EXPECT_FALSE(editor.is_drawing());
  EXPECT_EQ(*editor.drawing().curves.at(0), (Curve{{clicked_at(3), clicked_at(4)}, false}));
}

std::vector<double> marks_of(const Editor& editor, std::size_t curve = 0) {
  std::vector<double> marks;
  for (const editing::Point& p : editor.drawing().curves.at(curve)->points) {
    marks.push_back(p.exact);
  }
  return marks;
}

TEST(Editor, ClickedPointsAreWayPointsAndPaintedOnesAStroke) {
  constexpr double kPainted = TALWEG_MARK_PAINTED;
  Editor editor;
  editor.add_point(at(1));
  editor.add_point(at(2));
  editor.paint_point(at(3));
  editor.paint_point(at(4));
  editor.add_point(at(5));
  editor.finish_curve();
  EXPECT_EQ(marks_of(editor), (std::vector<double>{0, 0, kPainted, kPainted, 0}));
  EXPECT_EQ(host_curves(editor.drawing()).at(0).exact, marks_of(editor));

  editor.move_point(0, 2, at(7));  // both stay what they are
  editor.move_point(0, 4, at(8));
  EXPECT_EQ(marks_of(editor), (std::vector<double>{0, 0, kPainted, kPainted, 0}));
  editor.reverse_curve(0);
  editor.insert_point(0, 1, at(9));
  EXPECT_EQ(marks_of(editor), (std::vector<double>{0, 0, kPainted, kPainted, 0, 0}));
}

TEST(Editor, AStrokeBeginsWhereTheMouseWasPressed) {
  Editor editor;
  editor.add_point(at(1));
  editor.paint_point(at(1));  // it did not move
  EXPECT_EQ(marks_of(editor), std::vector<double>{0});
  editor.paint_point(at(2));
  EXPECT_EQ(marks_of(editor), std::vector<double>(2, TALWEG_MARK_PAINTED));
}

TEST(Editor, PointsWithoutAMarkStayWithoutOneAndMarksAreKept) {
  Editor editor;
  editor.add_curve({{at(1), at(2), at(3)}, false});
  editor.insert_point(0, 1, at(5));
  EXPECT_EQ(marks_of(editor), std::vector<double>(4, TALWEG_MARK_NONE));
  EXPECT_TRUE(host_curves(editor.drawing()).at(0).exact.empty());
  // A point with a mark keeps the mark.
  editing::Point near = at(6);
  near.exact = 0.5;
  editor.insert_point(0, 4, near);
  EXPECT_EQ(marks_of(editor).back(), 0.5);
  EXPECT_EQ(host_curves(editor.drawing()).at(0).exact, marks_of(editor));
}

TEST(Editor, KnowsWhetherAllPointsWereClicked) {
  Editor editor;
  EXPECT_FALSE(all_clicked(editor.drawing()));
  editor.add_point(at(1));
  editor.add_point(at(2));
  editor.finish_curve();
  EXPECT_TRUE(all_clicked(editor.drawing()));
  editor.add_point(at(5));
  editor.paint_point(at(6));
  EXPECT_FALSE(all_clicked(editor.drawing()));
  editor.drop_curve();
  EXPECT_TRUE(all_clicked(editor.drawing()));
  editor.add_curve({{at(7), at(8)}, false});
  EXPECT_FALSE(all_clicked(editor.drawing()));
}

TEST(Editor, UndoRestoresTheMarkOfAPoint) {
  Editor editor;
  editor.add_point(at(1));
  editor.paint_point(at(2));
  EXPECT_TRUE(editor.history().undo());
  EXPECT_EQ(marks_of(editor), std::vector<double>{0});
  EXPECT_TRUE(editor.history().redo());
  EXPECT_EQ(marks_of(editor), std::vector<double>(2, TALWEG_MARK_PAINTED));
}

TEST(Editor, ClosesACurveOnce) {
  Editor editor;
  for (const std::uint32_t face : {1U, 2U, 3U, 1U}) editor.add_point(at(face));
  editor.close_curve();
  EXPECT_EQ(*editor.drawing().curves.at(0),
            (Curve{{clicked_at(1), clicked_at(2), clicked_at(3)}, true}));
}

TEST(Editor, BackspaceAndEscapeTakeACurveAway) {
  Editor editor;
  editor.add_point(at(1));
  editor.take_back_point();
  EXPECT_EQ(editor.drawing(), Drawing());
  editor.add_curve({{at(1), at(2)}, false});
  editor.add_point(at(5));
  editor.add_point(at(6));
  editor.drop_curve();
  EXPECT_FALSE(editor.is_drawing());
  EXPECT_EQ(editor.drawing().curves.size(), 1U);
  EXPECT_TRUE(editor.history().undo());
  EXPECT_TRUE(editor.is_drawing());
  EXPECT_EQ(editor.drawing().curves.size(), 2U);
}

TEST(Editor, RefusesWithASentenceAndChangesNothing) {
  Editor editor;
  EXPECT_EQ(refusal([&] { editor.finish_curve(); }), "No curve is being drawn.");
  EXPECT_EQ(refusal([&] { editor.drop_curve(); }), "No curve is being drawn.");
  EXPECT_EQ(refusal([&] { editor.remove_curve(2); }), "There is no curve 2; the drawing has 0.");
  editor.add_point(at(1));
  EXPECT_EQ(refusal([&] { editor.finish_curve(); }),
            "A curve needs two points in different places.");
  editor.add_point(at(2));
  EXPECT_EQ(refusal([&] { editor.close_curve(); }),
            "A closed curve needs three points in different places.");
  EXPECT_EQ(refusal([&] {
              editor.add_curve({{at(4), at(5)}, false});
            }),
            "First end the curve that is being drawn.");
  EXPECT_EQ(refusal([&] { editor.move_point(0, 7, at(1)); }), "Curve 0 has no point 7; it has 2.");
  EXPECT_EQ(refusal([&] { editor.set_tau(-1); }), "Tau must be 0 or more.");
  EXPECT_EQ(refusal([&] { editor.set_tau(std::nan("")); }), "Tau must be 0 or more.");
  EXPECT_EQ(refusal([&] { editor.set_max_deviation(0.0); }),
            "The largest deviation must be more than 0.");
  EXPECT_EQ(editor.drawing().curves.at(0)->points.size(), 2U);
  EXPECT_EQ(editor.history().undo_name(), "Add point");
}

TEST(Editor, ACurveGoesWhileAnotherIsDrawn) {
  Editor editor;
  editor.add_curve({{at(1), at(2)}, false});
  editor.add_curve({{at(3), at(4)}, false});
  editor.add_point(at(5));
  editor.add_point(at(6));
  editor.remove_curve(0);
  ASSERT_EQ(editor.drawing().curves.size(), 2U);
  EXPECT_EQ(editor.drawing().curves[0]->points[0].face, 3U);
  EXPECT_TRUE(editor.is_drawing());
  EXPECT_EQ(editor.history().undo_name(), "Remove curve");
  editor.remove_curve(1);  // the one that is drawn
  EXPECT_FALSE(editor.is_drawing());
  ASSERT_EQ(editor.drawing().curves.size(), 1U);
  editor.history().undo();
  editor.history().undo();
  EXPECT_EQ(editor.drawing().curves.size(), 3U);
  EXPECT_TRUE(editor.is_drawing());
}

TEST(Editor, InitialSettingsAreNoStep) {
  Editor editor({3.5, 0.25, {}});
  EXPECT_EQ(editor.drawing().settings.tau, 3.5);
  EXPECT_EQ(editor.drawing().settings.slack, 0.25);
  EXPECT_FALSE(editor.history().can_undo());
  EXPECT_EQ(refusal([] { Editor wrong({-1, {}, {}}); }), "Tau must be 0 or more.");
}

TEST(Editor, ThePapersMethodIsAStepThatCanBeUndone) {
  Editor editor;
  editor.set_paper(true);
  EXPECT_TRUE(editor.drawing().settings.paper);
  editor.set_paper(true);
  EXPECT_EQ(editor.history().undo_name(), "Method");
  editor.history().undo();
  EXPECT_FALSE(editor.drawing().settings.paper);
  EXPECT_FALSE(editor.history().can_undo());
}

TEST(Editor, EndsAndClickDistanceAreSteps) {
  Editor editor;
  editor.set_ends(editing::Ends::kOpen);
  editor.set_click_distance(0.5);
  EXPECT_EQ(editor.history().undo_name(), "Click distance");
  EXPECT_EQ(refusal([&] { editor.set_click_distance(-1.0); }),
            "The click distance must be 0 or more.");
  editor.history().undo();
  EXPECT_EQ(editor.drawing().settings.click_distance, std::nullopt);
  EXPECT_EQ(editor.drawing().settings.ends, editing::Ends::kOpen);
  for (const auto ends : {editing::Ends::kAuto, editing::Ends::kClosed, editing::Ends::kOpen}) {
    EXPECT_EQ(editing::ends_named(editing::name_of(ends)), ends);
  }
  editor.set_ridges(0.7);
  EXPECT_EQ(editor.history().undo_name(), "Snap to ridges");
  EXPECT_EQ(refusal([&] { editor.set_ridges(1.5); }),
            "The strength of ridges must be from 0 to 1.");
  EXPECT_EQ(editor.drawing().settings.ridges, 0.7);
  for (const auto kind :
       {editing::RidgeKind::kBoth, editing::RidgeKind::kConvex, editing::RidgeKind::kConcave}) {
    EXPECT_EQ(editing::ridges_named(editing::name_of(kind)), kind);
  }
  editor.set_ridge_kind(editing::RidgeKind::kConcave);
  EXPECT_EQ(editor.history().undo_name(), "Kind of ridges");
  EXPECT_EQ(refusal([] { editing::ridges_named("sharp"); }),
            "The kind of ridges must be both, convex or concave, not sharp.");
  EXPECT_EQ(refusal([] { editing::ends_named("ajar"); }),
            "Ends must be auto, closed or open, not ajar.");
}

TEST(Editor, TheOffsetIsAStepThatSmoothsNothing) {
  Editor editor;
  editor.add_curve({{at(1), at(2), at(3)}, true});
  const Drawing before = editor.drawing();
  editor.set_offset({true, 1U, 2.5, "left", "none"});
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kNothing);
  EXPECT_EQ(editor.history().undo_name(), "Offset");
  EXPECT_EQ(refusal([&] {
              editor.set_offset({true, {}, 0});
            }),
            "The distance of the offset must be more than 0.");
  editor.history().begin_gesture("Distance");  // a slider that is held
  for (const double distance : {3.0, 3.5, 4.0}) {
    editor.set_offset({true, 1U, distance, "left", "none"});
  }
  editor.history().end_gesture();
  EXPECT_EQ(editor.drawing().offset.distance, 4);
  editor.history().undo();
  EXPECT_EQ(editor.drawing().offset.distance, 2.5);
  editor.history().undo();
  EXPECT_EQ(editor.drawing(), before);
  editor.history().redo();
  editor.clear();
  EXPECT_EQ(editor.drawing().offset, (editing::Offset{true, {}, 2.5, "left", "none"}));
}

TEST(Editor, PointsKeepTheirPinsAndGo) {
  Editor editor;
  editor.add_curve({{at(1), at(2), at(3)}, true});
  editor.set_pinned(0, 1, true);
  editor.move_point(0, 1, at(9));
  EXPECT_TRUE(editor.drawing().curves.at(0)->points[1].pinned);
  EXPECT_EQ(editor.drawing().curves.at(0)->points[1].face, 9U);
  editor.insert_point(0, 3, at(4));
  editor.remove_point(0, 0);
  EXPECT_EQ(host_curves(editor.drawing()).at(0).pins, std::vector<std::uint32_t>{0});
  editor.remove_point(0, 0);  // two points make no closed curve
  EXPECT_TRUE(editor.drawing().curves.empty());
}

TEST(Editor, TellsTheFirstStageToRepeat) {
  Editor editor;
  editor.add_curve({{at(1), at(2)}, false});
  const Drawing before = editor.drawing();
  editor.set_tau(5);
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kRun);
  editor.set_tau(1);
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kNothing);
  editor.set_pinned(0, 0, true);
  EXPECT_EQ(stage_between(before, editor.drawing()), Stage::kCurves);
}

TEST(Editor, AGestureIsOneStep) {
  Editor editor;
  editor.add_curve({{at(1), at(2)}, false});
  editor.history().begin_gesture("Drag");
  for (std::uint32_t face = 10; face < 200; ++face) editor.move_point(0, 1, at(face));
  editor.history().end_gesture();
  editor.set_tau(3);
  EXPECT_TRUE(editor.history().undo());
  EXPECT_EQ(editor.history().undo_name(), "Drag");
  EXPECT_EQ(editor.drawing().curves.at(0)->points[1], at(199));
  EXPECT_TRUE(editor.history().undo());
  EXPECT_EQ(editor.drawing().curves.at(0)->points[1], at(2));
  EXPECT_EQ(editor.history().redo_name(), "Drag");
}

TEST(Editor, PickedPointsComeIntoTheirTriangle) {
  const editing::Point point = editing::picked(7, {-1e-17, 0.5, 0.5 + 1e-17});
  EXPECT_EQ(point.barycentric[0], 0);
  EXPECT_EQ(point.barycentric[1] + point.barycentric[2], 1);
  EXPECT_EQ(refusal([] {
              editing::picked(7, {std::numeric_limits<double>::infinity(), 0, 0});
            }),
            "The point that was picked has no finite coordinates.");
  EXPECT_EQ(refusal([] {
              editing::picked(7, {-1, 0, 0});
            }),
            "The point that was picked lies outside of its triangle.");
}

/// Equal bit by bit, also where == would not tell 0 from -0.
void expect_identical(const Drawing& a, const Drawing& b) {
  ASSERT_TRUE(a == b);
  ASSERT_EQ(std::memcmp(&a.settings.tau, &b.settings.tau, sizeof(double)), 0);
  for (std::size_t c = 0; c < a.curves.size(); ++c) {
    for (std::size_t p = 0; p < a.curves[c]->points.size(); ++p) {
      ASSERT_EQ(std::memcmp(&a.curves[c]->points[p].barycentric,
                            &b.curves[c]->points[p].barycentric, 3 * sizeof(double)),
                0);
    }
  }
}

TEST(Editor, AThousandEditsUndoneAndRedoneGiveTheSameStates) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    Editor editor;
    test::RandomHand hand(seed, 5000);
    std::vector<Drawing> states = {test::deep_copy(editor.drawing())};
    std::vector<std::uint64_t> numbers = {editor.history().number()};
    std::size_t largest = 0;
    while (states.size() <= 1000) {
      const Drawing before = test::deep_copy(editor.drawing());
      const bool done = hand.edit(editor);
      if (!done) expect_identical(editor.drawing(), before);
      if (editor.drawing() == before) continue;
      states.push_back(test::deep_copy(editor.drawing()));
      numbers.push_back(editor.history().number());
      largest = std::max(largest, editor.drawing().curves.size());
    }
    EXPECT_GT(largest, 3U);
    for (std::size_t k = 1000; k > 0; --k) {
      expect_identical(editor.drawing(), states[k]);
      ASSERT_TRUE(editor.history().undo());
    }
    expect_identical(editor.drawing(), states[0]);
    EXPECT_FALSE(editor.history().undo());
    for (std::size_t k = 1; k <= 1000; ++k) {
      ASSERT_TRUE(editor.history().redo());
      expect_identical(editor.drawing(), states[k]);
    }
    EXPECT_FALSE(editor.history().redo());
    for (int jump = 0; jump < 200; ++jump) {
      const std::size_t k = hand.below(states.size());
      ASSERT_TRUE(editor.history().go_to(numbers[k]));
      expect_identical(editor.drawing(), states[k]);
    }
  }
}

TEST(Editor, ANewEditDiscardsUndoneEdits) {
  Editor editor;
  editor.set_tau(2);
  const std::uint64_t gone = editor.history().number();
  editor.history().undo();
  editor.set_tau(3);
  EXPECT_FALSE(editor.history().can_redo());
  EXPECT_FALSE(editor.history().go_to(gone));
}

TEST(History, ForgetsTheOldestSteps) {
  editing::History history(3);
  for (int k = 1; k <= 5; ++k) {
    Drawing next;
    next.settings.tau = k;
    history.add("step", next);
  }
  while (history.undo()) {
  }
  EXPECT_EQ(history.now().settings.tau, 2);
}

TEST(MeshArrays, PointsAtVerticesLieThere) {
  const editing::MeshArrays mesh = test::arrays_of(test::grid(5, 4));
  const std::vector<editing::Point> points = editing::points_at(mesh, {0, 29, 7, 7});
  EXPECT_EQ(editing::position_of(mesh, points.at(1)), mesh.positions[29]);
  EXPECT_EQ(editing::position_of(mesh, points.at(3)), mesh.positions[7]);
  EXPECT_EQ(refusal([&] { editing::points_at(mesh, {30}); }),
            "Vertex 30 is not a corner of any face.");
}

TEST(MeshArrays, TellsHowLargeItIs) {
  const editing::MeshArrays square{{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}},
                                   {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(editing::diagonal_of(square), 5);
  EXPECT_EQ(editing::mean_edge_of(square), (3 + 4 + 5) / 3.0);
  editing::MeshArrays lacking = square;
  lacking.triangles.push_back({0, 1, 9});
  EXPECT_EQ(editing::mean_edge_of(lacking), (2 * (3 + 4 + 5) + 3) / 9.0);
  EXPECT_EQ(editing::diagonal_of({}), 0);
  EXPECT_EQ(editing::mean_edge_of({}), 0);
}

// ---- Selections. Vertex (x, y) of the sheet is x + 31 y.

class Selection : public testing::Test {
 protected:
  static std::uint32_t v(std::uint32_t x, std::uint32_t y) { return x + 31 * y; }
  editing::MeshArrays sheet_ = test::arrays_of(test::grid(30, 20));
};

TEST_F(Selection, NeighboursFollowEachOther) {
  // Down one column, whose numbers jump, and along a row: the order of the numbers would zigzag.
  const std::vector<std::uint32_t> line = {v(3, 9), v(3, 8), v(3, 7), v(2, 7), v(1, 7), v(0, 7)};
  std::vector<std::uint32_t> by_number = line;
  std::sort(by_number.begin(), by_number.end());
  const auto curves = editing::order_along_mesh(sheet_, by_number);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(curves[0].vertices, std::vector<std::uint32_t>(line.rbegin(), line.rend()));
}

TEST_F(Selection, FarVerticesAreJoinedTheShortWay) {
  const auto curves = editing::order_along_mesh(sheet_, {v(2, 2), v(28, 3), v(10, 2), v(20, 2)});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].vertices,
            (std::vector<std::uint32_t>{v(2, 2), v(10, 2), v(20, 2), v(28, 3)}));
}

TEST_F(Selection, ARingIsClosed) {
  std::vector<std::uint32_t> ring;
  for (std::uint32_t k = 0; k < 6; ++k) {
    for (const std::uint32_t w : {v(4 + k, 4), v(10, 4 + k), v(10 - k, 10), v(4, 10 - k)}) {
      ring.push_back(w);
    }
  }
  const auto curves = editing::order_along_mesh(sheet_, ring);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  ASSERT_EQ(curves[0].vertices.size(), 24U);
  for (std::size_t k = 0; k < 24; ++k) {
    const int a = static_cast<int>(curves[0].vertices[k]);
    const int b = static_cast<int>(curves[0].vertices[(k + 1) % 24]);
    EXPECT_TRUE(std::abs(a - b) == 1 || std::abs(a - b) == 31 || std::abs(a - b) == 32) << k;
  }
}

TEST_F(Selection, CurvesApartStayApart) {
  std::vector<std::uint32_t> both;
  std::vector<std::uint32_t> first, second;
  for (std::uint32_t k = 0; k < 10; ++k) {
    first.push_back(v(2 + k, 3));
    second.push_back(v(15 + k, 16));
  }
  both.insert(both.end(), second.begin(), second.end());
  both.insert(both.end(), first.begin(), first.end());
  const auto curves = editing::order_along_mesh(sheet_, both);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].vertices, first);
  EXPECT_EQ(curves[1].vertices, second);
}

TEST_F(Selection, BothRimsOfATubeAreRings) {
  const MeshLists open_tube = test::tube(40, 30, 3.0);
  const editing::MeshArrays mesh = test::arrays_of(open_tube);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  }
  std::set<std::uint32_t> rim;
  for (const auto& [edge, count] : uses) {
    if (count == 1) rim.insert({edge.first, edge.second});
  }
  const auto curves = editing::order_along_mesh(mesh, {rim.begin(), rim.end()});
  ASSERT_EQ(curves.size(), 2U);
  for (const auto& curve : curves) {
    EXPECT_TRUE(curve.closed);
    EXPECT_EQ(curve.vertices.size(), rim.size() / 2);
  }
}

TEST_F(Selection, ABranchingSelectionIsRefused) {
  std::vector<std::uint32_t> junction;
  for (std::uint32_t k = 0; k < 9; ++k) junction.push_back(v(5 + k, 5));
  for (std::uint32_t k = 6; k < 10; ++k) junction.push_back(v(9, k));
  const std::string sentence = refusal([&] { editing::order_along_mesh(sheet_, junction); });
  EXPECT_TRUE(sentence.starts_with("The selection has no order: it branches at vertex 16"))
      << sentence;  // 164 is where the column meets the row
  EXPECT_EQ(refusal([&] {
              editing::order_along_mesh(sheet_, {4, 9000});
            }),
            "The mesh has no vertex 9000.");
}

TEST_F(Selection, EdgesJoinOnlyAtCommonVertices) {
  const auto curves = editing::order_along_edges({{5, 6}, {8, 7}, {6, 7}, {20, 21}, {21, 22}});
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0], (editing::OrderedVertices{{5, 6, 7, 8}, false}));
  EXPECT_EQ(curves[1], (editing::OrderedVertices{{20, 21, 22}, false}));
  const auto ring = editing::order_along_edges({{1, 2}, {2, 3}, {3, 1}});
  EXPECT_EQ(ring.at(0), (editing::OrderedVertices{{1, 2, 3}, true}));
  EXPECT_EQ(refusal([] {
              editing::order_along_edges({{1, 2}, {2, 3}, {2, 4}});
            }),
            "The selection has no order: it branches at vertex 2.");
}

}  // namespace
}  // namespace talweg::editing_test
