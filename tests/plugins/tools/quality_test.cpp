// The measures of ./run quality: drawings, goals, tables, and the program on small meshes.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <set>
#include <variant>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/temporary_folder.hpp"
#include "places.hpp"
#include "talweg/core/drawing/curve_embedding.hpp"
#include "talweg/intrinsic/error.hpp"
#include "tools/paper/ball.hpp"
#include "tools/paper/refinement.hpp"
#include "tools/quality/bounded_runs.hpp"
#include "tools/quality/drawings.hpp"
#include "tools/quality/gallery.hpp"
#include "tools/quality/goals.hpp"
#include "tools/quality/level_sets.hpp"
#include "tools/quality/statistics.hpp"
#include "tools/quality/tables.hpp"
#include "tools/scenes/ply_writer.hpp"

namespace talweg::quality {
namespace {

using test::TemporaryFolder;
using Loops = std::vector<std::vector<VertexId>>;

double longest_edge(const Surface& surface) {
  double longest = 0;
  for (std::size_t e = 0; e < surface.edge_count(); ++e) {
    longest = std::max(longest, surface.length(EdgeId{e}));
  }
  return longest;
}

/// The winding number of a closed polygon around the z axis.
double turns_around_z(const SurfaceMesh& mesh, const std::vector<VertexId>& loop) {
  double angle = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point &a = mesh.point(loop[i]), &b = mesh.point(loop[(i + 1) % loop.size()]);
    angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  }
  return angle / (2 * std::numbers::pi);
}

void expect_edge_path(const Surface& surface, const std::vector<VertexId>& path, bool closed) {
  for (std::size_t i = 0; i + (closed ? 0 : 1) < path.size(); ++i) {
    EXPECT_TRUE(surface.find_halfedge(path[i], path[(i + 1) % path.size()]).valid()) << i;
  }
}

TEST(LevelSets, LevelSetsOfHeightAreCirclesOfLatitude) {
  const SurfaceMesh mesh = SurfaceMesh::open(paper::sphere(24));
  const double edge = longest_edge(mesh.surface());
  for (const double height : {-0.8, 0.013, 0.41}) {
    const Loops loops = closed_level_sets(mesh, [&](const Point& p) { return p.z() - height; });
    ASSERT_EQ(loops.size(), 1U);
    expect_edge_path(mesh.surface(), loops[0], false);
    // The vertex nearest to the first crossing may also be the nearest to the last crossing.
    const VertexId first = loops[0].front(), last = loops[0].back();
    EXPECT_TRUE(first == last || mesh.surface().find_halfedge(last, first).valid());
    EXPECT_NEAR(std::abs(turns_around_z(mesh, loops[0])), 1, 1e-12);
    double length = 0;
    for (std::size_t i = 0; i < loops[0].size(); ++i) {
      const Point& p = mesh.point(loops[0][i]);
      EXPECT_LT(std::abs(p.z() - height), edge);
      length += (p - mesh.point(loops[0][(i + 1) % loops[0].size()])).norm();
    }
    // A jagged path is longer than the circle. Along edges of nearly equilateral triangles it is at
    // most about twice as long.
    const double circle = 2 * std::numbers::pi * std::sqrt(1 - height * height);
    EXPECT_GT(length, 0.95 * circle);
    EXPECT_LT(length, 2.1 * circle);
  }
}

TEST(LevelSets, EveryLoopIsFoundAndTheLongestComesFirst) {
  const SurfaceMesh mesh = SurfaceMesh::open(paper::sphere(24));
  const Loops two =
      closed_level_sets(mesh, [](const Point& p) { return (p.z() - 0.31) * (p.z() + 0.83); });
  ASSERT_EQ(two.size(), 2U);
  EXPECT_GT(two[0].size(), two[1].size());
  EXPECT_GT(mesh.point(two[0][0]).z(), 0);
  EXPECT_LT(mesh.point(two[1][0]).z(), 0);
  // The positive side lies outside of the band, so the loops run in opposite directions.
  EXPECT_NEAR(turns_around_z(mesh, two[0]) + turns_around_z(mesh, two[1]), 0, 1e-12);
  EXPECT_TRUE(closed_level_sets(mesh, [](const Point&) { return 1.0; }).empty());
  EXPECT_TRUE(closed_level_sets(mesh, [](const Point&) { return -1.0; }).empty());
}

TEST(LevelSets, CurvesThatEndAtTheBoundaryAreLeftOut) {
  const SurfaceMesh disc = SurfaceMesh::open(paper::disc(12));
  EXPECT_TRUE(closed_level_sets(disc, [](const Point& p) { return p.x() - 0.011; }).empty());
  EXPECT_EQ(closed_level_sets(disc, [](const Point& p) { return 0.53 - p.norm(); }).size(), 1U);
}

TEST(Drawings, AreValidAndOfEveryKind) {
  const auto mesh = OpenedMesh::open(paper::bumpy_ball(40, 2));
  const std::vector<NamedPath> drawings = generated_drawings(*mesh, 1);
  std::set<std::string> kinds;
  for (const NamedPath& drawing : drawings) {
    const std::size_t space = drawing.name.find(' ');
    kinds.insert(drawing.name.substr(0, space));
    EXPECT_EQ(drawing.name.substr(space + 1), std::to_string(drawing.path.size()));
    EXPECT_EQ(drawing.closed, !drawing.name.starts_with("open")) << drawing.name;
    expect_edge_path(mesh->surface(), drawing.path, drawing.closed);
    EXPECT_NO_THROW(check_drawn(mesh->surface(), drawing.curve(mesh->surface()))) << drawing.name;
  }
  EXPECT_EQ(drawings.size(), 10U);
  EXPECT_EQ(kinds, (std::set<std::string>{"loop", "open", "section"}));
}

TEST(Drawings, DependOnTheSeedAlone) {
  const auto mesh = OpenedMesh::open(paper::bumpy_ball(20, 2));
  const auto paths = [&](std::uint64_t seed) {
    Loops result;
    for (const NamedPath& drawing : generated_drawings(*mesh, seed)) result.push_back(drawing.path);
    return result;
  };
  EXPECT_EQ(paths(1), paths(1));
  EXPECT_NE(paths(1), paths(2));
}

TEST(Drawings, SmallMeshesHaveFewerDrawings) {
  const auto tiny = OpenedMesh::open(paper::sphere(1));
  for (const NamedPath& drawing : generated_drawings(*tiny, 1)) {
    EXPECT_NO_THROW(check_drawn(tiny->surface(), drawing.curve(tiny->surface())));
  }
}

class StoredDrawings : public TemporaryFolder {
 protected:
  void store(const char* name, const char* text) const { std::ofstream(file(name)) << text; }
};

TEST_F(StoredDrawings, AStoredDrawingIsReadForItsMesh) {
  store("ball.txt", "1\n2\n3\n");
  store("ball_ring.txt", "4\n5\n6\n7\n4\n");
  store("balloon.txt", "1\n2\n");
  store("ball.json", "{}");
  const std::vector<NamedPath> drawings = stored_drawings(file(""), "ball");
  ASSERT_EQ(drawings.size(), 2U);
  EXPECT_EQ(drawings[0].path, (std::vector{VertexId{1U}, VertexId{2U}, VertexId{3U}}));
  EXPECT_FALSE(drawings[0].closed);
  EXPECT_EQ(drawings[0].name, "stored 3");
  EXPECT_EQ(drawings[1].path.size(), 4U);
  EXPECT_TRUE(drawings[1].closed);
  EXPECT_TRUE(stored_drawings(file("absent"), "ball").empty());
}

TEST_F(StoredDrawings, FilesWithOtherTextThanNumbersAreRefused) {
  store("ball.txt", "1\ntwo\n");
  EXPECT_THROW(stored_drawings(file(""), "ball"), Error);
}

TEST(Statistics, QuantilesAreLinearBetweenTheRanks) {
  EXPECT_EQ(quantile({}, 0.5), 0);
  EXPECT_EQ(quantile({7}, 0.3), 7);
  EXPECT_EQ(quantile({4, 1, 2, 3}, 0), 1);
  EXPECT_EQ(quantile({4, 1, 2, 3}, 1), 4);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 2, 3}, 0.5), 2.5);
  const std::vector<double> values{1, 2, 3, 4};
  EXPECT_EQ(share_within(values, 3), 0.75);
  EXPECT_EQ(share_within({}, 3), 1);
}

Run run_of(const char* mesh, double tau, double before, double after, double least = 0) {
  Run run;
  run.mesh = mesh;
  run.drawing = "by hand";
  run.edge = 1;
  run.tau = tau;
  run.curvature_before = before;
  run.curvature_after = after;
  run.bending_before = before;
  run.bending_after = after / 2;
  run.least_curvature = least;
  run.closed = least > 0;
  run.length_ratio = 0.5;
  run.termination = Outcome::kConverged;
  return run;
}

const Goal& goal(const std::vector<Goal>& goals, const std::string& words) {
  for (const Goal& g : goals) {
    if (g.what.find(words) != std::string::npos) return g;
  }
  ADD_FAILURE() << "no goal " << words;
  return goals.front();
}

TEST(Run, ALoopsRatioLeavesOutItsLeastTurn) {
  EXPECT_DOUBLE_EQ(run_of("a", 1, 100, 5).ratio(), 0.05);
  EXPECT_DOUBLE_EQ(run_of("a", 1, 106, 11, 6).ratio(), 0.05);
}

TEST(Goals, CurvatureGoalsCountJaggedDrawingsSeparately) {
  std::vector<quality::Run> runs{run_of("a", 1, 100, 1), run_of("a", 1, 100, 5),
                                 run_of("a", 1, 100, 30), run_of("a", 1, 24, 24)};
  std::vector<Goal> reached = goals(runs, {}, {});
  EXPECT_TRUE(goal(reached, "median, drawings").met);
  EXPECT_EQ(goal(reached, "median, drawings").reached, "0.050");
  EXPECT_FALSE(goal(reached, "worst, drawings").met);
  EXPECT_EQ(goal(reached, "worst, drawings").reached, "0.300; above in 1 of 3 runs");
  EXPECT_EQ(goal(reached, "median, all").reached, "0.175");
  EXPECT_EQ(goal(reached, "worst, all").reached, "1.000; above in 2 of 4 runs");
  EXPECT_TRUE(goal(reached, "collapse").met);
  runs[1].curvature_after = 7;
  runs[2].curvature_after = 25;
  runs[0].termination = Outcome::kCollapsed;
  reached = goals(runs, {}, {});
  EXPECT_FALSE(goal(reached, "median, drawings").met);
  EXPECT_TRUE(goal(reached, "worst, drawings").met);
  EXPECT_FALSE(goal(reached, "collapse").met);
}

TEST(Goals, SpreadGoalsUseTauOne) {
  std::vector<quality::Run> runs{run_of("a", 1, 100, 1), run_of("a", 1, 100, 5),
                                 run_of("a", 1, 100, 8), run_of("a", 4, 100, 99)};
  runs[2].window_turning = runs[3].window_turning = 0.5;  // 28.6 degrees
  runs[3].largest_turn = 1;
  const std::vector<Goal> reached = goals(runs, {}, {});
  EXPECT_EQ(goal(reached, "drawings of 25 rad and more, median").reached, "0.025");
  EXPECT_FALSE(goal(reached, "drawings of 25 rad and more, median").met);
  EXPECT_EQ(goal(reached, "drawings of 25 rad and more, worst").reached, "0.04; within in 67 %");
  EXPECT_TRUE(goal(reached, "turn in one h₀, worst").met);
  EXPECT_EQ(goal(reached, "turn in one h₀, worst").reached, "28.6°; within in 100 %");
  EXPECT_TRUE(goal(reached, "largest turn at one point, worst").met);
}

TEST(Goals, ClosenessGoalsUseTauOne) {
  std::vector<quality::Run> runs;
  for (int i = 0; i < 40; ++i) {
    runs.push_back(run_of("a", 1, 100, 5));
    runs.back().to_drawn = 1;
    runs.push_back(run_of("a", i % 2 == 0 ? 2 : 4, 100, 5));
    runs.back().to_drawn = 50;
  }
  runs[0].from_drawn = 3.5;  // one run of forty
  std::vector<Goal> reached = goals(runs, {}, {});
  EXPECT_TRUE(goal(reached, "result to drawing").met);
  EXPECT_EQ(goal(reached, "result to drawing").reached, "1.00 h₀");
  EXPECT_TRUE(goal(reached, "both directions").met);
  EXPECT_EQ(goal(reached, "both directions").reached, "97.5 %");
  runs[2].to_drawn = 3.5;
  EXPECT_FALSE(goal(goals(runs, {}, {}), "both directions").met);
}

TEST(Goals, SteadinessGoalsCountStepsAndWorstCases) {
  Sweep calm{"a", "open 9"}, jumpy{"b", "open 9"};
  calm.steps = jumpy.steps = 50;
  calm.rises = 1;
  jumpy.rises = 1;
  jumpy.moves = 6;
  const std::vector<Sweep> sweeps{calm, jumpy};
  const std::vector<Subdivision> finer{{"a", "open 9", {2, 2.1, 1.9}, {1, 1.05, 1}, {0, 0.1, 0.2}},
                                       {"b", "open 9", {2, 1, 3}, {1, 0.8, 1}, {0, 0.6, 0.2}}};
  const std::vector<Goal> reached = goals({}, sweeps, finer);
  EXPECT_EQ(reached.size(), 7U);  // no goal without measured runs
  EXPECT_TRUE(goal(reached, "rises").met);
  EXPECT_EQ(goal(reached, "rises").reached, "2.0 %");
  EXPECT_FALSE(goal(reached, "moves").met);
  EXPECT_EQ(goal(reached, "worst drawing").reached, "12.0 %");
  EXPECT_EQ(goal(reached, "the result on the coarse mesh, median").reached, "0.4 h₀");
  EXPECT_EQ(goal(reached, "the result on the coarse mesh, worst").reached,
            "0.6 h₀; within in 50 %");
  EXPECT_EQ(goal(reached, "larger / smaller, worst").reached, "1.25; within in 50 %");
  EXPECT_TRUE(tables(reached).starts_with("| goal | asked | reached | met |\n|---|"));
  EXPECT_TRUE(goals({}, {}, {}).empty());
}

TEST(Goals, ClickGoalsUseTheRunsOfClicks) {
  quality::ClickedRun good{"a", "open 90", 4, 20, 0, 0.05, 0.1, 0.05, 0.2, 1.02, 0.03, 5, false};
  quality::ClickedRun far = good;
  far.mesh = "b";
  far.swing = 0.5;
  far.largest_turn = 0.2;
  const std::vector<quality::ClickedRun> runs{good, far};
  const std::vector<Goal> reached = goals({}, {}, {}, runs);
  EXPECT_EQ(reached.size(), 12U);
  EXPECT_TRUE(goal(reached, "clicks: largest distance of a click from the result, worst").met);
  EXPECT_EQ(goal(reached, "shorter adjacent leg, median").reached, "0.35");
  EXPECT_FALSE(goal(reached, "shorter adjacent leg, worst").met);
  EXPECT_EQ(goal(reached, "clicks: largest turn at one point, worst").reached,
            "11.5°; within in 50 %");
  EXPECT_TRUE(goal(reached, "clicks: bending").met);
  const std::string table = quality::tables(runs);
  EXPECT_NE(table.find("| b | 1 | 0.050 | 0.05 |"), std::string::npos) << table;
  EXPECT_NE(table.find("| all | 2 |"), std::string::npos) << table;
}

TEST(Tables, HaveARowPerTauKindAndMesh) {
  std::vector<quality::Run> runs{run_of("a", 1, 100, 2), run_of("a", 2, 100, 4),
                                 run_of("b", 2, 56, 16, 6)};
  runs[2].to_drawn = 4;
  runs[2].termination = Outcome::kCollapsed;
  runs[2].bending_after = 5.6;
  constexpr double kDegree = std::numbers::pi / 180;
  const double windows[] = {10, 20, 30}, turns[] = {30, 40, 20};
  for (std::size_t i = 0; i < 3; ++i) {
    runs[i].window_turning = windows[i] * kDegree;
    runs[i].largest_turn = turns[i] * kDegree;
  }
  const std::string text = tables(runs);
  const auto has = [&](const char* row) {
    EXPECT_NE(text.find(row), std::string::npos) << row << "\nis not in\n" << text;
  };
  has("| all | 3 | 0.020 | 0.100 | 20 | 30 | 40 | 0.040 | 0.200 | 0.00 | 0.00 | 67 % | 0.50 | 1 "
      "|\n");
  has("| τ = 2 | 2 | 0.060 | 0.100 | 25 | 30 | 40 | 0.120 | 0.200 | 2.00 | 0.00 | 50 % | 0.50 | 1 "
      "|");
  has("| open | 2 | 0.015 | 0.020 | 15 | 20 | 40 | 0.030 | 0.040 |");
  has("| closed | 1 | 0.100 | 0.100 | 30 | 30 | 20 | 0.200 | 0.200 | 4.00 |");
  has("| a | 2 |");
  has("| b | 1 |");
  EXPECT_EQ(text.find("τ = 4"), std::string::npos);
}

TEST(Tables, SideBySideHaveTheSameDrawings) {
  const std::vector<quality::Run> ours{run_of("a", 1, 100, 2), run_of("b", 1, 100, 50)};
  std::vector<quality::Run> paper{run_of("a", 1, 100, 70), run_of("a", 2, 100, 70)};
  const std::vector<quality::Run> relaxed{run_of("a", 1, 100, 40)};
  paper[0].solve_ms = paper[1].solve_ms = 7;  // one solution for both runs
  paper[0].smooth_ms = 2;
  paper[1].smooth_ms = 3;
  const std::string text = side_by_side(ours, paper, relaxed);
  EXPECT_NE(text.find("| default, all | 1 | 0.010 | 0.010 | 0 | 0 | 0 | 0.020 |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| paper, all | 2 | 0.350 | 0.350 | 0 | 0 | 0 | 0.700 |"), std::string::npos)
      << text;
  EXPECT_NE(text.find("| paper, relaxed, all | 1 | 0.200 | 0.200 | 0 | 0 | 0 | 0.400 |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| paper | 1 | 7.0 | 7.0 | 5.0 | 5.0 |"), std::string::npos) << text;
  EXPECT_NE(text.find("| paper, τ = 1 | 1 | 0.350 | 0.350 | 0 | 0 | 0 | 0.700 |"),
            std::string::npos)
      << text;
}

TEST(Tables, CommaSeparatedValuesHaveAsManyNamesAsNumbers) {
  const std::vector<quality::Run> runs{run_of("a", 1, 100, 2)};
  const std::string text = csv(runs);
  const std::size_t end = text.find('\n');
  EXPECT_EQ(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), ','),
            std::count(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), ','));
}

TEST(BoundedRuns, AreTheRunsThatStrayedAtTauTwo) {
  Subject subject{"ball", paper::bumpy_ball(20, 2), nullptr, {}};
  subject.mesh = OpenedMesh::open(subject.lists);
  subject.drawings = generated_drawings(*subject.mesh, 1);
  ASSERT_GE(subject.drawings.size(), 2U);
  subject.drawings.resize(2);
  std::vector<quality::Run> runs{run_of("ball", 1, 100, 2), run_of("ball", 2, 100, 2),
                                 run_of("ball", 1, 100, 2), run_of("ball", 2, 100, 2)};
  for (quality::Run& run : runs) run.edge = longest_edge(subject.mesh->surface());
  EXPECT_TRUE(bounded_runs(subject, runs, {}).empty());
  runs[2].from_drawn = 7;  // the second drawing strays, but at another tau
  runs[3].from_drawn = 5;
  runs[3].drawing = subject.drawings[1].name;
  const std::vector<BoundedRun> bounded = bounded_runs(subject, runs, {});
  ASSERT_EQ(bounded.size(), 1U);
  EXPECT_EQ(bounded[0].drawing, subject.drawings[1].name);
  EXPECT_EQ(bounded[0].strayed, 5);
  EXPECT_TRUE(bounded[0].within);
  EXPECT_LE(bounded[0].deviation, 3 * (1 + 1e-9));
  const std::string text = tables(bounded);
  EXPECT_NE(text.find("Beyond 3 h₀ at τ = 2: 1 runs."), std::string::npos) << text;
  EXPECT_NE(text.find("1 within the bound"), std::string::npos) << text;
}

class QualityProgram : public TemporaryFolder {
 protected:
  [[nodiscard]] int run(const std::string& arguments) const {
    std::string command("cd '");
    command.append(file("").string())
        .append("' && '")
        .append(test::quality_program())
        .append("' ")
        .append(arguments);
    command.append(" >out.log 2>err.log </dev/null");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(QualityProgram, MeasuresAFolderOfMeshes) {
  std::filesystem::create_directory(file("meshes"));
  scenes::write_bytes(file("meshes/ball.ply"), scenes::ply_bytes(paper::bumpy_ball(12, 1)));
  std::ofstream(file("meshes/broken.off")) << "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n"
                                              "3 0 1 2\n3 0 1 2\n3 0 1 2\n";
  ASSERT_EQ(run("out --meshes meshes --parts runs,paper,gallery"), 0) << bytes_of(file("err.log"));
  EXPECT_EQ(bytes_of(file("out/quality_ball.png")).substr(1, 3), "PNG");
  const std::string text = bytes_of(file("out/results.md"));
  for (const char* part : {"## Goals", "## Default settings", "## Beside the paper's potential",
                           "| ball |", "| loops that collapse | none |"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(text.find("## τ from"), std::string::npos);
  EXPECT_NE(bytes_of(file("out.log")).find("broken: left out."), std::string::npos);
  // The table has a row for each of four τ of a drawing, and a row of names.
  const std::string table = bytes_of(file("out/runs.csv"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n') % 4, 1);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), [&] {
    const std::string paper = bytes_of(file("out/paper_runs.csv"));
    return std::count(paper.begin(), paper.end(), '\n');
  }());
}

TEST_F(QualityProgram, UnknownArgumentsAreRefused) {
  EXPECT_EQ(run("out --parts everything"), 1);
  EXPECT_EQ(run(""), 1);
  EXPECT_NE(bytes_of(file("err.log")).find("OUTDIR"), std::string::npos);
}

TEST_F(QualityProgram, DrawsThePicturesOfTheGallery) {
  Subject subject{"ball", paper::bumpy_ball(20, 2), nullptr, {}};
  subject.mesh = OpenedMesh::open(subject.lists);
  subject.drawings = generated_drawings(*subject.mesh, 1);
  const std::vector<NamedPath> shown = gallery_drawings(subject);
  ASSERT_EQ(shown.size(), 1U);  // there are no stored drawings
  EXPECT_FALSE(shown[0].closed);
  write_gallery_picture(subject, shown[0], file("ball.png"));
  EXPECT_EQ(bytes_of(file("ball.png")).substr(1, 3), "PNG");
  EXPECT_THROW(write_gallery_picture(subject, shown[0], file("absent/ball.png")), Error);
  subject.drawings.push_back({"stored 3", shown[0].path, false});
  EXPECT_EQ(gallery_drawings(subject).size(), 1U);
  EXPECT_EQ(gallery_drawings(subject)[0].name, "stored 3");
}

}  // namespace
}  // namespace talweg::quality
