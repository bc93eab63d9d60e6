// Long work asks the progress callback in proportion to the work; a cancelled call leaves no trace.
#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "core/voronoi_labels.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/talweg.hpp"

namespace talweg {
namespace {

using test::hills;
using test::ids;

constexpr std::size_t kNever = SIZE_MAX;

/// Counts the questions of the callback, and answers no from a chosen question on.
class Answers {
 public:
  explicit Answers(std::size_t yes = kNever) : yes_(yes) {}
  Progress progress() {
    return [this](const char* stage, double fraction) {
      EXPECT_GE(fraction, 0) << stage;
      EXPECT_LE(fraction, 1) << stage;
      ++of_stage_[stage];
      return asked_++ < yes_;
    };
  }
  [[nodiscard]] std::size_t asked() const { return asked_; }
  [[nodiscard]] std::size_t of(const std::string& stage) { return of_stage_[stage]; }
  [[nodiscard]] bool said_no() const { return asked_ > yes_; }

 private:
  std::size_t yes_;
  std::size_t asked_ = 0;
  std::map<std::string, std::size_t> of_stage_;
};

std::vector<std::vector<SurfacePoint>> points_of(std::span<const SurfaceCurve> curves) {
  std::vector<std::vector<SurfacePoint>> points;
  for (const SurfaceCurve& curve : curves) points.push_back(curve.points);
  return points;
}

/// A wave over hills(size) in as many legs as there is room for.
SurfaceCurve long_wave(const SurfaceMesh& mesh, std::uint32_t size) {
  std::vector<VertexId> way;
  for (std::uint32_t x = 3; x + 3 < size; x += 7) {
    way.emplace_back((size / 2 + (x % 2 == 0 ? size / 5 : 0)) * (size + 1) + x);
  }
  return test::vertex_curve(mesh.surface(), draw_edge_path(mesh.surface(), way), false);
}

// ---- how often ----

TEST(Asking, ADistanceIsAskedInProportionToItsWindows) {
  const auto opened = OpenedMesh::open(hills(150));
  const SurfaceCurve drawn = long_wave(opened->mesh(), 150);
  PolylineDistance distance(opened->surface());
  Answers answers;
  ProgressPoller poller(answers.progress(), "distance");
  const ScopedPoller scoped(distance, poller);
  distance.set(std::span(&drawn, 1));
  distance.reach(1000);
  ASSERT_GT(distance.window_count(), 200'000U);
  // A window costs at least four units of work when it spreads; a few hidden windows do not spread.
  EXPECT_GE(answers.asked(), 3 * distance.window_count() / ProgressPoller::kEvery);
}

TEST(Asking, EveryStageOfTheDefaultPathAsks) {
  const auto opened = OpenedMesh::open(hills(300));
  const SurfaceCurve drawn = long_wave(opened->mesh(), 300);
  ASSERT_GT(drawn.points.size(), 1000U);
  Answers setting, smoothing, again;
  CurveSmoother smoother(opened);
  ASSERT_TRUE(smoother.set_curve(drawn, {}, setting.progress()));
  EXPECT_GE(setting.of("embed"), 32 * drawn.points.size() / ProgressPoller::kEvery);
  EXPECT_GE(setting.of("solve"), 1U);
  SmoothingOptions options;
  smoother.smooth(options, smoothing.progress());
  for (const char* stage : {"straighten", "trace", "fair", "measure"}) {
    EXPECT_GE(smoothing.of(stage), 1U) << stage;
  }
  // Fairing moves every sample in at least two rounds on either level.
  EXPECT_GE(smoothing.of("fair"), 4 * drawn.points.size() / ProgressPoller::kEvery);
  // The rung at tau = 1 is kept; the next rung and the deviation are computed.
  options.tau = 1.01;
  smoother.smooth(options, again.progress());
  EXPECT_EQ(again.of("trace"), 0U);
  EXPECT_GE(again.of("fair"), 4 * drawn.points.size() / ProgressPoller::kEvery);
  EXPECT_GE(again.of("measure"), 1U);
}

// Marching to far distances, for tau < 1/8 and for the report, asks the callback.
TEST(Asking, FarDistancesAreAskedAbout) {
  const auto opened = OpenedMesh::open(hills(150));
  const SurfaceCurve drawn = long_wave(opened->mesh(), 150);
  CurveSmoother smoother(opened);
  smoother.set_curve(drawn);
  Answers answers;
  SmoothingOptions options;
  options.tau = 0.05;
  options.deviation = DeviationMeasure::kAlongSurface;
  const SmoothingReport report = smoother.smooth(options, answers.progress()).report();
  PolylineDistance distance(opened->surface());
  distance.set(std::span(&drawn, 1));
  distance.reach(0.9 * report.deviation_to_drawn_max);
  EXPECT_GE(answers.of("straighten") + answers.of("fair") + answers.of("measure"),
            3 * distance.window_count() / ProgressPoller::kEvery);
}

TEST(Asking, DrawingAndSnappingAsk) {
  const auto opened = OpenedMesh::open(hills(150));
  const Surface& surface = opened->surface();
  Answers drawing;
  const auto path = EdgeDijkstra(surface).draw(ids({0, 151 * 151 - 1}), false, drawing.progress());
  EXPECT_GE(drawing.asked(), 8 * surface.vertex_count() / 2 / ProgressPoller::kEvery);
  CurveInput input;
  std::vector<Point> positions;
  for (const VertexId v : path) {
    for (int k = 0; k < 8; ++k) positions.push_back(opened->mesh().point(v) + Point(0, 0, 0.1 * k));
  }
  input.points = positions;
  Answers snapping;
  snap(opened->mesh(), input, {}, snapping.progress());
  EXPECT_GE(snapping.asked(), 64 * positions.size() / ProgressPoller::kEvery);
}

// ---- at any moment ----

struct Job {
  const char* name;
  std::shared_ptr<const OpenedMesh> opened;
  std::vector<SurfaceCurve> drawn;
  CurveOptions options;
};

SurfaceCurve straight_through(const SurfaceMesh& mesh, const std::vector<Point>& points,
                              bool closed) {
  return StraightLines(mesh.surface()).join(snap(mesh, {closed, points, {}}).points, closed);
}

SurfaceCurve fine_wave(const SurfaceMesh& mesh) {
  std::vector<Point> points;
  for (int i = 0; i < 160; ++i) {
    const double t = i / 159.0;
    points.emplace_back(0.55 + 6.9 * t, 4 + 1.5 * std::sin(9 * t) + (i % 2 == 0 ? 0.05 : -0.05), 0);
  }
  return straight_through(mesh, points, false);
}

/// One job for each code path of a smoother.
std::vector<Job> jobs() {
  std::vector<Job> all;
  const auto hilly = OpenedMesh::open(hills(60));
  const auto row = [&](std::uint32_t y) {
    const std::uint32_t way[] = {y * 61 + 2, (y + 6) * 61 + 17, y * 61 + 31, (y + 5) * 61 + 57};
    return test::vertex_curve(hilly->surface(), draw_edge_path(hilly->surface(), ids(way)), false);
  };
  all.push_back({"a curve", hilly, {row(20)}, {}});
  all.push_back({"a curve, the paper's method", hilly, {row(20)}, {.method = Method::kPaper}});
  all.push_back({"a set", hilly, {row(12), row(23), row(38)}, {}});
  all.push_back({"a loop",
                 hilly,
                 {test::drawn_near(
                     hilly->mesh(),
                     test::circle(Point(30, 30, 0), Point(14, 0, 0), Point(0, 14, 0), 12), true)},
                 {}});
  all.push_back(
      {"a tangle",
       hilly,
       {straight_through(hilly->mesh(),
                         {Point(8, 8, 0), Point(40, 42, 0), Point(42, 10, 0), Point(11, 39, 0)},
                         false)},
       {}});
  MeshLists sheet = test::grid(4, 4);
  for (Point& p : sheet.points) p *= 2;
  const auto coarse = OpenedMesh::open(sheet);
  all.push_back({"a drawing finer than the mesh", coarse, {fine_wave(coarse->mesh())}, {}});
  return all;
}

/// A random question of a call with `asked` questions.
std::size_t moment(std::mt19937& random, std::size_t asked) {
  return std::uniform_int_distribution<std::size_t>(0, asked - 1)(random);
}

TEST(Cancelling, AtAnyMomentLeavesNoCurveOrTheOneThatIsSet) {
  std::mt19937 random(11);
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    Answers whole;
    CurveSmoother fresh(job.opened), smoother(job.opened);
    ASSERT_TRUE(fresh.set_curves(job.drawn, job.options, whole.progress()));
    const auto expected = points_of(fresh.smooth(1.5).curves);
    for (int k = 0; k < 12; ++k) {
      Answers answers(moment(random, whole.asked()));
      const bool set = smoother.set_curves(job.drawn, job.options, answers.progress());
      ASSERT_EQ(set, !answers.said_no());
      EXPECT_EQ(smoother.drawn().empty(), !set);
      if (!set) {
        EXPECT_THROW(smoother.smooth(1), Error);
      }
    }
    ASSERT_TRUE(smoother.set_curves(job.drawn, job.options));
    EXPECT_EQ(points_of(smoother.smooth(1.5).curves), expected);
  }
}

TEST(Cancelling, SmoothingAtAnyMomentGivesTheDrawingAndChangesNothing) {
  std::mt19937 random(12);
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    struct Expected {
      double tau;
      std::size_t asked = 0;
      std::vector<std::vector<SurfacePoint>> points;
    };
    std::vector<Expected> all = {{0}, {1e-6}, {0.05}, {0.7}, {1.5}, {9}};
    SmoothingOptions options;
    for (Expected& e : all) {
      CurveSmoother fresh(job.opened);
      fresh.set_curves(job.drawn, job.options);
      Answers answers;
      options.tau = e.tau;
      e.points = points_of(fresh.smooth(options, answers.progress()).curves);
      e.asked = answers.asked();
      ASSERT_GT(e.asked, 1U);
    }
    CurveSmoother smoother(job.opened);
    smoother.set_curves(job.drawn, job.options);
    for (int k = 0; k < 40; ++k) {
      const Expected& e = all[moment(random, all.size())];
      Answers answers(moment(random, e.asked));
      options.tau = e.tau;
      const SmoothingResult result = smoother.smooth(options, answers.progress());
      const bool cancelled = result.report().termination == Outcome::kCancelled;
      ASSERT_EQ(cancelled, answers.said_no());
      EXPECT_EQ(points_of(result.curves), cancelled ? points_of(job.drawn) : e.points);
      if (k % 4 == 0) {
        EXPECT_EQ(points_of(smoother.smooth(e.tau).curves), e.points);
      }
    }
    for (const Expected& e : all) EXPECT_EQ(points_of(smoother.smooth(e.tau).curves), e.points);
  }
}

// An exception of the callback reaches the caller, and leaves the smoother unchanged.
TEST(Cancelling, AnExceptionOfACallbackReachesTheCallerAndChangesNothing) {
  struct Thrown {};
  std::mt19937 random(19);
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const bool within = job.options.method == Method::kCorridor && job.drawn.size() == 1;
    CurveOptions curve_options = job.options;
    if (within) curve_options.pins = {job.drawn[0].points[9]};
    CurveSmoother fresh(job.opened), smoother(job.opened);
    fresh.set_curves(job.drawn, curve_options);
    smoother.set_curves(job.drawn, curve_options);
    const auto expected = points_of(fresh.smooth(1.5).curves);
    for (int k = 0; k < 12; ++k) {
      std::size_t left = moment(random, 60);
      SmoothingOptions options;
      options.tau = k % 2 == 0 ? 1.5 : 0.05;
      const Progress progress = [&](const char*, double) {
        if (left-- == 0) throw Thrown();
        return true;
      };
      try {
        if (within && k % 3 == 0) {
          smooth_within(smoother, 0.5, options, progress);
        } else {
          smoother.smooth(options, progress);
        }
      } catch (const Thrown&) {
      }
      EXPECT_EQ(std::vector(smoother.pins().begin(), smoother.pins().end()), curve_options.pins);
      EXPECT_EQ(points_of(smoother.smooth(1.5).curves), expected);
    }
  }
}

TEST(Cancelling, SettingOtherPinsAtAnyMomentKeepsTheEarlierPins) {
  std::mt19937 random(13);
  for (const Job& job : jobs()) {
    if (job.options.method == Method::kPaper) continue;
    SCOPED_TRACE(job.name);
    const std::vector<SurfacePoint> first{job.drawn[0].points[9]};
    std::vector<SurfacePoint> other{job.drawn[0].points[20], job.drawn[0].points[5]};
    Answers whole;
    CurveSmoother fresh(job.opened), smoother(job.opened);
    CurveOptions options = job.options;
    options.pins = first;
    fresh.set_curves(job.drawn, options);
    smoother.set_curves(job.drawn, options);
    const auto expected = points_of(fresh.smooth(1.5).curves);
    ASSERT_TRUE(fresh.set_pins(other, whole.progress()));
    const auto with_others = points_of(fresh.smooth(1.5).curves);
    for (int k = 0; k < 10; ++k) {
      Answers answers(moment(random, whole.asked()));
      ASSERT_FALSE(smoother.set_pins(other, answers.progress()));
      EXPECT_EQ(std::vector(smoother.pins().begin(), smoother.pins().end()), first);
      EXPECT_EQ(points_of(smoother.smooth(1.5).curves), expected);
    }
    ASSERT_TRUE(smoother.set_pins(other));
    EXPECT_EQ(points_of(smoother.smooth(1.5).curves), with_others);
  }
}

TEST(Cancelling, CancelledDraggingGivesTheDraggedDrawing) {
  std::mt19937 random(14);
  for (const Job& job : jobs()) {
    if (job.options.method == Method::kPaper || job.drawn[0].closed) continue;
    SCOPED_TRACE(job.name);
    SurfaceCurve moved = job.drawn[0];
    moved.points.erase(moved.points.end() - 3, moved.points.end());
    Answers whole;
    CurveSmoother fresh(job.opened), smoother(job.opened);
    fresh.set_curves(job.drawn, job.options);
    smoother.set_curves(job.drawn, job.options);
    SmoothingOptions options;
    const auto expected = points_of(fresh.drag(0, moved, options, whole.progress()).curves);
    for (int k = 0; k < 12; ++k) {
      Answers answers(moment(random, whole.asked()));
      const SmoothingResult result = smoother.drag(0, moved, options, answers.progress());
      if (!answers.said_no()) continue;  // the last result is there already
      EXPECT_EQ(result.report().termination, Outcome::kCancelled);
      EXPECT_EQ(result.curve().points, moved.points);
    }
    EXPECT_EQ(points_of(smoother.drag(0, moved).curves), expected);
  }
}

TEST(Cancelling, ASearchWithinABoundAtAnyMomentLeavesPinsAndResults) {
  std::mt19937 random(15);
  const Job job = jobs().front();
  CurveOptions curve_options;
  curve_options.pins = {job.drawn[0].points[9]};
  Answers whole;
  CurveSmoother fresh(job.opened), smoother(job.opened);
  fresh.set_curves(job.drawn, curve_options);
  smoother.set_curves(job.drawn, curve_options);
  SmoothingOptions options;
  const auto expected = points_of(smooth_within(fresh, 0.9, options, whole.progress()).curves);
  for (int k = 0; k < 12; ++k) {
    Answers answers(moment(random, whole.asked()));
    const SmoothingResult result = smooth_within(smoother, 0.9, options, answers.progress());
    ASSERT_EQ(result.report().termination == Outcome::kCancelled, answers.said_no());
    if (answers.said_no()) {
      EXPECT_EQ(points_of(result.curves), points_of(job.drawn));
    }
    EXPECT_EQ(std::vector(smoother.pins().begin(), smoother.pins().end()), curve_options.pins);
  }
  EXPECT_EQ(points_of(smooth_within(smoother, 0.9).curves), expected);
}

TEST(Cancelling, LabelsAtAnyMomentGiveNothing) {
  std::mt19937 random(16);
  const auto mesh = OpenedMesh::open(hills(40));
  const auto labels = test::voronoi_labels(mesh->mesh(), 9, 3);
  LabelNetworkOptions options;
  options.max_deviation = 0.8;
  options.free_junctions = true;
  Answers whole;
  ASSERT_FALSE(smooth_labels(mesh, labels, options, whole.progress()).cancelled);
  for (int k = 0; k < 20; ++k) {
    Answers answers(moment(random, whole.asked()));
    const LabelNetwork network = smooth_labels(mesh, labels, options, answers.progress());
    ASSERT_TRUE(network.cancelled);
    EXPECT_TRUE(network.borders.empty());
  }
}

TEST(Cancelling, ADistanceGoesOnAsIfItHadNotBeenAsked) {
  std::mt19937 random(17);
  const auto opened = OpenedMesh::open(hills(60));
  const SurfaceCurve drawn = long_wave(opened->mesh(), 60);
  PolylineDistance fresh(opened->surface()), cut_short(opened->surface());
  fresh.set(std::span(&drawn, 1));
  cut_short.set(std::span(&drawn, 1));
  std::uniform_int_distribution<std::size_t> any(0, opened->surface().vertex_count() - 1);
  int times = 0;
  for (int k = 0; k < 400; ++k) {
    const VertexId v{any(random)};
    Answers answers(1 + moment(random, 4));
    ProgressPoller poller(answers.progress(), "distance");
    try {
      const ScopedPoller scoped(cut_short, poller);
      cut_short.at_vertex(v);
    } catch (const Cancelled&) {
      ++times;
    }
  }
  EXPECT_GT(times, 10);
  for (std::size_t v = 0; v < opened->surface().vertex_count(); ++v) {
    ASSERT_EQ(cut_short.at_vertex(VertexId{v}).distance, fresh.at_vertex(VertexId{v}).distance);
  }
}

TEST(Cancelling, StraightLinesAndPathsGoOnAsBefore) {
  std::mt19937 random(18);
  const auto opened = OpenedMesh::open(hills(60));
  const Surface& surface = opened->surface();
  std::vector<SurfacePoint> points;
  for (const VertexId v : ids({200, 3000, 900, 3600})) {
    points.push_back(SurfacePoint::at_vertex(surface, v));
  }
  StraightLines lines(surface);
  EdgeDijkstra dijkstra(surface);
  const auto line = lines.join(points, false).points;
  const auto path = dijkstra.draw(ids({200, 3000, 900, 3600}), false);
  for (int k = 0; k < 20; ++k) {
    Answers first(moment(random, 12)), second(moment(random, 4));
    try {
      lines.join(points, false, first.progress());
    } catch (const Cancelled&) {
      EXPECT_TRUE(first.said_no());
    }
    try {
      dijkstra.draw(ids({200, 3000, 900, 3600}), false, second.progress());
    } catch (const Cancelled&) {
      EXPECT_TRUE(second.said_no());
    }
    EXPECT_EQ(lines.join(points, false).points, line);
    EXPECT_EQ(dijkstra.draw(ids({200, 3000, 900, 3600}), false), path);
  }
}

}  // namespace
}  // namespace talweg
