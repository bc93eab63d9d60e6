// Smoothing in a thread: results of the plugin, the newest request wins, cancelling, closing.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "places.hpp"
#include "plugins/editing_drawings.hpp"
#include "plugins/found_plugins.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/editing/curve_files.hpp"
#include "talweg/editing/smoothing_thread.hpp"

namespace talweg::editing_thread_test {
namespace {

using editing::Hand;
using editing::Outcome;
using editing::SmoothingThread;
using editing::Task;
using test::found_plugins;

/// Hills with a drawing across them.
struct Hills {
  test::Subject subject;
  std::shared_ptr<const editing::MeshArrays> mesh =
      std::make_shared<const editing::MeshArrays>(test::arrays_of(subject.lists));
  editing::Editor editor;

  Hills() {
    editing::Curve curve;
    for (std::size_t k = 0; k < subject.curve.faces.size(); ++k) {
      curve.points.push_back({subject.curve.faces[k], subject.curve.barycentrics[k], false});
    }
    editor.add_curve(std::move(curve));
  }
  /// What the plugin gives without a thread.
  [[nodiscard]] std::vector<host::Curve> expected(const editing::Drawing& drawing) const {
    const host::Services services("test", "1");
    host::Instance instance(found_plugins().find("talweg.smooth"), services);
    set_mesh(instance, *mesh);
    instance.set_curves(host_curves(drawing));
    apply(drawing, instance);
    return instance.run().curves;
  }
};

std::vector<Outcome> all_of(SmoothingThread& thread) {
  thread.wait();
  std::vector<Outcome> outcomes;
  while (auto outcome = thread.take()) outcomes.push_back(std::move(*outcome));
  return outcomes;
}

void expect_same(const std::vector<host::Curve>& a, const std::vector<host::Curve>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_TRUE(test::same_bits(a[k], b[k])) << k;
}

TEST(EditingThread, GivesTheResultsOfThePlugin) {
  Hills hills;
  std::atomic<int> woken = 0;
  SmoothingThread thread(found_plugins(), hills.mesh, [&] { ++woken; });
  std::vector<Outcome> outcomes = all_of(thread);
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].task, Task::kOpen);
  EXPECT_EQ(outcomes[0].status, TALWEG_OK) << outcomes[0].sentence;
  for (const double tau : {4.0, 0.5}) {
    hills.editor.set_tau(tau);
    const std::uint64_t ticket = thread.smooth(hills.editor.drawing());
    outcomes = all_of(thread);
    ASSERT_EQ(outcomes.size(), 1U);
    EXPECT_EQ(outcomes[0].ticket, ticket);
    EXPECT_EQ(outcomes[0].results.number("tau"), tau);
    expect_same(outcomes[0].results.curves, hills.expected(hills.editor.drawing()));
  }
  hills.editor.set_pinned(0, 20, true);
  hills.editor.set_max_deviation(0.5);
  thread.smooth(hills.editor.drawing());
  expect_same(all_of(thread).at(0).results.curves, hills.expected(hills.editor.drawing()));
  EXPECT_EQ(woken, 4);
}

TEST(EditingThread, UndoAndRedoBringTheSameCurvesBack) {
  Hills hills;
  SmoothingThread thread(found_plugins(), hills.mesh);
  all_of(thread);
  std::vector<std::vector<host::Curve>> seen;
  const auto look = [&] {
    thread.smooth(hills.editor.drawing());
    return all_of(thread).at(0).results.curves;
  };
  seen.push_back(look());
  hills.editor.set_tau(7);
  seen.push_back(look());
  hills.editor.remove_point(0, 11);
  seen.push_back(look());
  hills.editor.set_pinned(0, 5, true);
  seen.push_back(look());
  for (std::size_t k = 3; k-- > 0;) {
    ASSERT_TRUE(hills.editor.history().undo());
    expect_same(look(), seen[k]);
  }
  for (std::size_t k = 1; k < 4; ++k) {
    ASSERT_TRUE(hills.editor.history().redo());
    expect_same(look(), seen[k]);
  }
}

TEST(EditingThread, WhileAPointMovesThereArePreviews) {
  Hills hills;
  SmoothingThread thread(found_plugins(), hills.mesh);
  thread.smooth(hills.editor.drawing());
  all_of(thread);
  const editing::Point from = hills.editor.drawing().curves.at(0)->points.at(20);
  hills.editor.history().begin_gesture("Drag");
  for (const double part : {0.1, 0.2, 0.3}) {
    editing::Point to = from;
    for (double& b : to.barycentric) b += part * (1.0 / 3 - b);
    hills.editor.move_point(0, 20, to);
    thread.smooth(hills.editor.drawing(), {}, Hand::kDrags);
    const Outcome moving = all_of(thread).back();
    ASSERT_EQ(moving.status, TALWEG_OK) << moving.sentence;
    EXPECT_EQ(moving.results.text("engine"), "preview");
    EXPECT_EQ(moving.results.text("deviation"), "none");
  }
  hills.editor.history().end_gesture();
  thread.smooth(hills.editor.drawing());
  expect_same(all_of(thread).back().results.curves, hills.expected(hills.editor.drawing()));
}

TEST(EditingThread, UnderASliderTheCurveCountsAndTheDeviationWaits) {
  Hills hills;
  SmoothingThread thread(found_plugins(), hills.mesh);
  for (const double tau : {1.0, 1.3, 2.6}) {
    hills.editor.set_tau(tau);
    thread.smooth(hills.editor.drawing(), {}, Hand::kSlides);
    const Outcome moving = all_of(thread).back();
    ASSERT_EQ(moving.status, TALWEG_OK) << moving.sentence;
    EXPECT_EQ(moving.results.text("deviation"), "none");
    expect_same(moving.results.curves, hills.expected(hills.editor.drawing()));
  }
  thread.smooth(hills.editor.drawing());
  EXPECT_EQ(all_of(thread).back().results.text("deviation"), "surface");
}

TEST(EditingThread, TheNewestRequestWins) {
  Hills hills;
  for (const double patience : {0.0, 1e9}) {
    SmoothingThread thread(found_plugins(), hills.mesh, {}, patience);
    std::uint64_t last = 0;
    for (int k = 0; k < 60; ++k) {
      hills.editor.set_tau(0.1 * k);
      last = thread.smooth(hills.editor.drawing());
      if (k % 7 == 0) std::this_thread::yield();
    }
    const std::vector<Outcome> outcomes = all_of(thread);
    ASSERT_FALSE(outcomes.empty());
    EXPECT_EQ(outcomes.back().ticket, last);
    EXPECT_EQ(outcomes.back().status, TALWEG_OK);
    EXPECT_LT(outcomes.size(), 61U);
    expect_same(outcomes.back().results.curves, hills.expected(hills.editor.drawing()));
  }
}

TEST(EditingThread, CancelledWorkSaysSoAndTheNextIsWhole) {
  Hills hills;
  for (int round = 0; round < 20; ++round) {
    SmoothingThread thread(found_plugins(), hills.mesh);
    thread.smooth(hills.editor.drawing());
    for (int k = 0; k < 50 * round; ++k) std::this_thread::yield();
    thread.cancel();
    for (const Outcome& outcome : all_of(thread)) {
      EXPECT_TRUE(outcome.status == TALWEG_OK || outcome.status == TALWEG_CANCELLED)
          << outcome.sentence;
    }
    thread.smooth(hills.editor.drawing());
    const std::vector<Outcome> outcomes = all_of(thread);
    EXPECT_EQ(outcomes.back().status, TALWEG_OK) << outcomes.back().sentence;
    if (round % 10 == 0) {
      expect_same(outcomes.back().results.curves, hills.expected(hills.editor.drawing()));
    }
  }
}

TEST(EditingThread, TheMeshMayGoWhileAJobRuns) {
  Hills hills;
  for (int round = 0; round < 30; ++round) {
    auto thread = std::make_unique<SmoothingThread>(
        found_plugins(), std::make_shared<const editing::MeshArrays>(*hills.mesh));
    hills.editor.set_tau(round);
    thread->smooth(hills.editor.drawing());
    if (round % 3 == 0) thread->distance(hills.editor.drawing());
    for (int k = 0; k < 30 * round; ++k) std::this_thread::yield();
    thread.reset();
  }
}

/// Leaves a thread behind that is about to open a mesh, of which the making of lists takes a while.
[[noreturn]] void exit_while_a_thread_opens() {
  const auto large =
      std::make_shared<const editing::MeshArrays>(test::arrays_of(test::grid(90, 90)));
  SmoothingThread(found_plugins(), Hills().mesh).wait();
  { const SmoothingThread opens(found_plugins(), large); }
  std::exit(0);
}

/// A sanitizer sees what the plugin destroys too early.
TEST(EditingThread, TheProgramMayEndWhileAThreadOpens) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exit_while_a_thread_opens(), ::testing::ExitedWithCode(0), "");
}

/// The plugins among the toys have a talweg.smooth that never opens a mesh.
const editing::Plugins& endless_plugins() {
  static const editing::Plugins plugins(test::toy_folder());
  return plugins;
}

TEST(EditingThread, APluginThatNeverEndsIsReported) {
  Hills hills;
  SmoothingThread thread(endless_plugins(), hills.mesh);
  while (thread.progress().stage != "endless") std::this_thread::yield();
  EXPECT_EQ(thread.progress().cancelled_ms, 0);
  thread.cancel();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(thread.progress().busy);
  EXPECT_GE(thread.progress().cancelled_ms, 20);
  EXPECT_STREQ(editing::plugin_of(thread.progress().task), "talweg.smooth");
}

/// A host that closes: the plugins are unloaded while a thread never returns from one of them.
[[noreturn]] void exit_while_a_plugin_never_ends() {
  {
    const editing::Plugins plugins(test::toy_folder());
    SmoothingThread thread(plugins, Hills().mesh);
    while (thread.progress().stage != "endless") std::this_thread::yield();
  }
  std::exit(0);
}

TEST(EditingThread, TheProgramEndsWhereAPluginNeverDoes) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exit_while_a_plugin_never_ends(), ::testing::ExitedWithCode(0), "");
}

TEST(EditingThread, PutsPositionsOntoTheMesh) {
  const auto sheet =
      std::make_shared<const editing::MeshArrays>(test::arrays_of(test::grid(30, 20)));
  SmoothingThread thread(found_plugins(), sheet);
  host::Curve line;
  line.positions = {{1.25, 2.5, 0.3}, {20.5, 11.25, -1}, {25.5, 3.5, 0}};
  thread.place({line});
  const std::vector<Outcome> outcomes = all_of(thread);
  ASSERT_EQ(outcomes.size(), 2U);
  ASSERT_EQ(outcomes[1].status, TALWEG_OK) << outcomes[1].sentence;
  const editing::Curve& placed = outcomes[1].placed.at(0);
  ASSERT_EQ(placed.points.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto position = position_of(*sheet, placed.points[k]);
    EXPECT_NEAR(position[0], line.positions[k][0], 1e-12);
    EXPECT_NEAR(position[1], line.positions[k][1], 1e-12);
    EXPECT_NEAR(position[2], 0, 1e-12);
  }
}

TEST(EditingThread, PlacedPointsAreWhatTheFileSays) {
  const auto sheet =
      std::make_shared<const editing::MeshArrays>(test::arrays_of(test::grid(30, 20)));
  SmoothingThread thread(found_plugins(), sheet);
  host::Curve silent, clicked, controls;
  silent.positions = {{1.25, 2.5, 0}, {20.5, 11.25, 0}, {25.5, 3.5, 0}};
  clicked = controls = silent;
  clicked.exact = {0, TALWEG_MARK_PAINTED, 0.5};
  controls.exact.assign(3, TALWEG_MARK_CONTROL);
  thread.place({silent, clicked, controls, silent});
  const std::vector<Outcome> outcomes = all_of(thread);
  ASSERT_EQ(outcomes.at(1).status, TALWEG_OK) << outcomes[1].sentence;
  const auto marks = [&](std::size_t curve) {
    std::vector<double> result;
    for (const editing::Point& p : outcomes[1].placed.at(curve).points) result.push_back(p.exact);
    return result;
  };
  EXPECT_EQ(marks(0), std::vector<double>(3, TALWEG_MARK_NONE));
  EXPECT_EQ(marks(1), clicked.exact);
  EXPECT_EQ(marks(2), std::vector<double>(3, 0));  // few and far apart
  EXPECT_EQ(marks(3), marks(0));
}

TEST(EditingThread, SmoothsThroughClicks) {
  Hills hills;
  SmoothingThread thread(found_plugins(), hills.mesh);
  editing::Editor editor;
  const std::vector<editing::Point> clicks = editing::points_at(*hills.mesh, {200, 760, 1500});
  for (const editing::Point& click : clicks) editor.add_point(click);
  editor.finish_curve();
  const auto passed = [&](const editing::Drawing& drawing) {
    thread.smooth(drawing);
    const host::Curve result = all_of(thread).back().results.curves.at(0);
    const auto& v = result.vertices;
    return std::find(v.begin(), v.end(), 760U) != v.end();
  };
  EXPECT_TRUE(passed(editor.drawing()));
  editing::Editor painted;
  for (const editing::Point& point : clicks) painted.paint_point(point);
  painted.finish_curve();
  EXPECT_FALSE(passed(painted.drawing()));
}

TEST(EditingThread, MeasuresDistances) {
  const auto sheet =
      std::make_shared<const editing::MeshArrays>(test::arrays_of(test::grid(30, 20)));
  SmoothingThread thread(found_plugins(), sheet);
  editing::Editor editor;
  const std::uint32_t row = 31 * 5;  // y = 5
  editor.add_curve({editing::points_at(*sheet, {row, row + 30}), false});
  thread.distance(editor.drawing());
  thread.draw(editor.drawing());
  const std::vector<Outcome> outcomes = all_of(thread);
  ASSERT_EQ(outcomes.size(), 3U);
  ASSERT_EQ(outcomes[1].status, TALWEG_OK) << outcomes[1].sentence;
  const host::Field& distance = outcomes[1].results.fields.at(0);
  EXPECT_EQ(distance.name, "distance");
  for (std::size_t v = 0; v < sheet->positions.size(); ++v) {
    EXPECT_NEAR(distance.values[v], std::abs(sheet->positions[v][1] - 5), 1e-12) << v;
  }
  EXPECT_EQ(outcomes[2].results.curves.at(0).positions.front(), sheet->positions[row]);
}

TEST(EditingThread, TellsWhatIsWrongAndGoesOn) {
  auto bad = std::make_shared<editing::MeshArrays>(test::arrays_of(test::grid(3, 3)));
  bad->triangles.push_back(bad->triangles.front());
  SmoothingThread refused(found_plugins(), bad);
  const Outcome open = all_of(refused).at(0);
  EXPECT_EQ(open.status, TALWEG_BAD_MESH);
  EXPECT_NE(open.sentence, "");

  Hills hills;
  SmoothingThread thread(found_plugins(), hills.mesh);
  editing::Editor wrong;
  wrong.add_curve({{{0, {1, 0, 0}, false}, {4000000, {1, 0, 0}, false}}, false});
  thread.smooth(wrong.drawing());
  const Outcome outcome = all_of(thread).back();
  EXPECT_EQ(outcome.status, TALWEG_BAD_CURVE);
  EXPECT_NE(outcome.sentence.find("4000000"), std::string::npos) << outcome.sentence;
  thread.smooth(hills.editor.drawing());
  EXPECT_EQ(all_of(thread).back().status, TALWEG_OK);
}

/// A sheet whose first face comes twice: its middle column of vertices is a curve.
struct Defective {
  std::shared_ptr<editing::MeshArrays> mesh =
      std::make_shared<editing::MeshArrays>(test::arrays_of(test::grid(8, 8)));
  editing::Editor editor;

  Defective() {
    mesh->triangles.insert(mesh->triangles.begin(), mesh->triangles.front());
    editor.add_curve({editing::points_at(*mesh, {4, 4 + 9 * 4, 4 + 9 * 8}), false});
  }
};

TEST(EditingThread, ADefectIsReportedWithTheChangesOfARepair) {
  Defective sheet;
  SmoothingThread thread(found_plugins(), sheet.mesh);
  const Outcome open = all_of(thread).at(0);
  EXPECT_EQ(open.status, TALWEG_BAD_MESH);
  ASSERT_EQ(open.repair.size(), 1U);
  EXPECT_NE(open.repair[0].find("1 face that repeats another was dropped"), std::string::npos)
      << open.repair[0];

  auto hopeless = std::make_shared<editing::MeshArrays>();
  hopeless->positions = {{0, 0, 0}, {1, 0, 0}, {2, std::nan(""), 0}};
  hopeless->triangles = {{0, 1, 2}};
  SmoothingThread refused(found_plugins(), hopeless);
  const Outcome none = all_of(refused).at(0);
  EXPECT_NE(none.status, TALWEG_OK);
  EXPECT_TRUE(none.repair.empty());
}

TEST(EditingThread, ResultsOnARepairedMeshHaveTheNumbersOfTheInput) {
  Defective sheet;
  SmoothingThread thread(found_plugins(), sheet.mesh, {}, 400, editing::Defects::kRepair);
  thread.smooth(sheet.editor.drawing());
  thread.distance(sheet.editor.drawing());
  const std::vector<Outcome> outcomes = all_of(thread);
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].status, TALWEG_OK) << outcomes[0].sentence;
  ASSERT_EQ(outcomes[1].status, TALWEG_OK) << outcomes[1].sentence;
  const host::Curve& curve = outcomes[1].results.curves.at(0);
  for (std::size_t k = 0; k < curve.positions.size(); ++k) {
    const auto at = position_of(*sheet.mesh, {curve.faces[k], curve.barycentrics[k], false});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(at[axis], curve.positions[k][axis], 1e-12);
    }
  }
  ASSERT_EQ(outcomes[2].status, TALWEG_OK) << outcomes[2].sentence;
  const std::vector<double>& distance = outcomes[2].results.fields.at(0).values;
  ASSERT_EQ(distance.size(), sheet.mesh->positions.size());
  for (std::size_t v = 0; v < distance.size(); ++v) {
    EXPECT_NEAR(distance[v], std::abs(sheet.mesh->positions[v][0] - 4), 1e-12) << v;
  }
}

TEST(Workplace, WorksWithoutAThread) {
  Hills hills;
  editing::Workplace workplace(found_plugins(), hills.mesh);
  editing::Request request;
  EXPECT_EQ(workplace.work(request).status, TALWEG_OK);
  request.task = Task::kSmooth;
  request.ticket = 7;
  request.drawing = hills.editor.drawing();
  const Outcome outcome = workplace.work(request);
  EXPECT_EQ(outcome.ticket, 7U);
  expect_same(outcome.results.curves, hills.expected(hills.editor.drawing()));
}

TEST(Workplace, ForAnotherTauTheDistanceIsKept) {
  Hills hills;
  bool spreads = false;
  editing::Workplace workplace(found_plugins(), hills.mesh, editing::Defects::kRefuse,
                               [&](const char* stage, double) {
                                 spreads = spreads || std::string(stage) == "distance";
                                 return true;
                               });
  editing::Request request;
  request.task = Task::kDistance;
  request.drawing = hills.editor.drawing();
  const Outcome first = workplace.work(request);
  EXPECT_TRUE(spreads);
  spreads = false;
  hills.editor.set_tau(4);
  request.drawing = hills.editor.drawing();
  const Outcome steeper = workplace.work(request);
  EXPECT_FALSE(spreads);
  EXPECT_EQ(steeper.results.fields.at(0).values, first.results.fields.at(0).values);
  const std::vector<double>&before = first.results.fields.at(1).values,
        &after = steeper.results.fields.at(1).values;
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_NEAR(after[v], 16 * before[v], 1e-9 * after[v]);  // the square of tau
  }
}

TEST(EndingThreads, TakingReturnsAtOnceAndDestructionWaits) {
  std::atomic<bool> went_on = false, gone = false;
  {
    editing::EndingThreads ending;
    auto ended = std::make_shared<std::atomic<bool>>(false);
    ending.take(std::thread([&went_on, &gone, ended] {
                  while (!gone) std::this_thread::yield();
                  went_on = true;
                  *ended = true;
                }),
                ended);
    EXPECT_FALSE(went_on);
    gone = true;
  }
  EXPECT_TRUE(went_on);
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(CurveFiles, AreTheLibrarys) {
  const std::string folder = testing::TempDir() + "editing_curve_files";
  std::filesystem::create_directories(folder);
  Hills hills;
  SmoothingThread thread(found_plugins(), hills.mesh);
  thread.smooth(hills.editor.drawing());
  const std::vector<host::Curve> smoothed = all_of(thread).back().results.curves;
  CurveSmoother smoother(hills.subject.opened);
  smoother.set_curve(hills.subject.drawn);
  const std::vector<SurfaceCurve> expected = {smoother.smooth(1.0).curve()};
  for (const char* ending : {".json", ".vtp", ".vtk", ".obj", ".ply", ".mrk.json", ".border"}) {
    editing::write_curves(found_plugins(), folder + "/host" + ending, *hills.mesh, smoothed);
    write_curves(folder + "/library" + ending, hills.subject.opened->mesh(), expected);
    EXPECT_EQ(bytes_of(folder + "/host" + ending), bytes_of(folder + "/library" + ending))
        << ending;
  }
  const std::vector<host::Curve> read =
      editing::read_curves(found_plugins(), folder + "/host.json", *hills.mesh);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].faces, smoothed[0].faces);
  EXPECT_EQ(read[0].barycentrics, smoothed[0].barycentrics);
  std::ofstream(folder + "/loop.txt") << "3 4 5 3\n";
  const host::Curve loop =
      editing::read_curves(found_plugins(), folder + "/loop.txt", *hills.mesh).at(0);
  EXPECT_EQ(loop.vertices, (std::vector<std::uint32_t>{3, 4, 5}));
  EXPECT_TRUE(loop.closed);
}

TEST(CurveFiles, ADrawingComesBackPointByPoint) {
  const std::string path = testing::TempDir() + "editing_drawing.json";
  const editing::MeshArrays sheet = test::arrays_of(test::grid(30, 20));
  editing::Editor editor;
  editor.add_curve({{{3, {0.25, 0.5, 0.25}, false}, {700, {0.1, 0.2, 0.7}, true}}, false});
  editing::write_curves(found_plugins(), path, sheet, drawn_curves(sheet, editor.drawing()));
  const std::vector<host::Curve> read = editing::read_curves(found_plugins(), path, sheet);
  EXPECT_EQ(read.at(0).faces, (std::vector<std::uint32_t>{3, 700}));
  EXPECT_EQ(read.at(0).barycentrics[1], (std::array<double, 3>{0.1, 0.2, 0.7}));
  EXPECT_EQ(read.at(0).pins, std::vector<std::uint32_t>{1});
  EXPECT_TRUE(read.at(0).exact.empty());
}

TEST(CurveFiles, ClickedAndPaintedPointsComeBack) {
  const std::string path = testing::TempDir() + "editing_clicks.json";
  const editing::MeshArrays sheet = test::arrays_of(test::grid(30, 20));
  editing::Editor editor;
  editor.add_point({3, {0.25, 0.5, 0.25}});
  editor.add_point({5, {0.25, 0.5, 0.25}});
  editor.paint_point({700, {0.1, 0.2, 0.7}});
  editor.add_point({720, {0.1, 0.2, 0.7}});
  editor.finish_curve();
  editing::write_curves(found_plugins(), path, sheet, drawn_curves(sheet, editor.drawing()));
  EXPECT_EQ(editing::read_curves(found_plugins(), path, sheet).at(0).exact,
            (std::vector<double>{0, 0, TALWEG_MARK_PAINTED, 0}));
}

TEST(CurveFiles, RefuseBadUse) {
  const auto status_of = [](auto body) {
    try {
      body();
    } catch (const host::Error& error) {
      EXPECT_NE(std::string(error.what()), "");
      return error.status();
    }
    return talweg_status{TALWEG_OK};
  };
  const std::vector<host::Curve> none, empty(1);
  EXPECT_EQ(status_of([&] { editing::read_curves(found_plugins(), "/nowhere.json", {}); }),
            TALWEG_BAD_FILE);
  EXPECT_EQ(status_of([&] {
              editing::write_curves(found_plugins(), testing::TempDir() + "none.json", {}, none);
            }),
            TALWEG_BAD_CURVE);
  EXPECT_EQ(status_of([&] {
              editing::write_curves(found_plugins(), testing::TempDir() + "none.json", {}, empty);
            }),
            TALWEG_BAD_USAGE);
}

TEST(EditingThread, MissingPluginsAreToldWithTheirFolder) {
  const editing::Plugins none("/nowhere");
  Hills hills;
  SmoothingThread thread(none, hills.mesh);
  EXPECT_EQ(all_of(thread).at(0).sentence,
            "The plugin talweg.smooth was not found in /nowhere; TALWEG_PLUGIN_PATH can name "
            "another folder.");
}

}  // namespace
}  // namespace talweg::editing_thread_test
