// The driver as its users see it: options, exit codes, one line on stderr, names in the report.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "core/reference_data.hpp"
#include "plugins/driver_runs.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/measure/report.hpp"

namespace talweg {
namespace {

class Driver : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("mesh.ply"), test::grid(30, 20));
  }
};

TEST_F(Driver, DrawsAndSmoothsInEveryFormat) {
  for (const char* ending : {"obj", "ply", "vtp", "vtk", "mrk.json", "txt", "json"}) {
    const std::string name = std::string("drawn.") + ending;
    ASSERT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o " + name).code, 0)
        << ending;
    const Outcome outcome =
        run("-q smooth mesh.ply --curve " + name + " -o smooth-" + ending + ".json");
    ASSERT_EQ(outcome.code, 0) << ending << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_EQ(bytes_of(file(std::string("smooth-") + ending + ".json")),
              bytes_of(file("smooth-obj.json")))
        << ending;
  }
}

TEST_F(Driver, TheReportHasAllKeysOfTheLibrary) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 -o drawn.obj").code, 0);
  ASSERT_EQ(
      run("smooth mesh.ply --curve drawn.obj --tau 2 --relax 5 --repeat 3 --report r.json").code,
      0);
  const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
  // report_test.cpp holds the names.
  const auto names = nlohmann::json::parse(to_json(SmoothingReport{}));
  for (const auto& [name, value] : names.items()) EXPECT_TRUE(report.contains(name)) << name;
  for (const auto& [name, value] : names["time_ms"].items()) {
    EXPECT_TRUE(report["time_ms"].contains(name)) << name;
  }
  EXPECT_EQ(report["faces"], 1200);
  EXPECT_EQ(report["vertices"], 651);
  EXPECT_EQ(report["tau"], 2);
  EXPECT_EQ(report["termination"], "converged");
  EXPECT_EQ(report["deviation_at"].size(), 3U);
}

/// A U whose arms are 15 long and 3 apart becomes the straight line between its ends.
TEST_F(Driver, TheSummaryBeginsWithDecisiveWarnings) {
  ASSERT_EQ(run("draw mesh.ply --through 67,532,535,70 --points rough -o u.json").code, 0);
  const std::string smooth = "smooth mesh.ply --curve u.json --tau 0.001";
  const Outcome table = run(smooth);
  EXPECT_TRUE(table.out.starts_with("warning: The result cuts off parts of the drawing"))
      << table.out;
  EXPECT_NE(table.out.find("\nfarthest apart: at least 15 mesh units, the drawing from the result"),
            std::string::npos)
      << table.out;
  const Outcome quick = run(smooth + " --report r.json");
  EXPECT_TRUE(quick.err.starts_with("talweg: warning: The result cuts off parts")) << quick.err;
  const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
  EXPECT_LT(report["deviation_to_drawn_max"], 2);
  EXPECT_NEAR(report["farthest"], 15, 1e-6);
  EXPECT_TRUE(report["farthest_at_most"].is_null());
  EXPECT_EQ(report["farthest_of"], "drawing");
  EXPECT_NEAR(report["farthest_at"][1], 17, 1e-9);
  EXPECT_EQ(report["decisive"].size(), 1U);
}

TEST_F(Driver, FinishIsFairOrTaut) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o drawn.json").code, 0);
  const auto bending = [&](const std::string& options) {
    EXPECT_EQ(run("smooth mesh.ply --curve drawn.json " + options + " --report r.json").code, 0);
    return nlohmann::json::parse(bytes_of(file("r.json")))["bending_after"].get<double>();
  };
  const double fair = bending("--finish fair");
  EXPECT_EQ(fair, bending(""));
  EXPECT_LT(fair, bending("--finish taut"));
  const Outcome paper = run("smooth mesh.ply --curve drawn.json --potential paper --finish taut");
  EXPECT_EQ(paper.code, 1);
  EXPECT_NE(paper.err.find("--finish needs --potential corridor."), std::string::npos) << paper.err;
}

TEST_F(Driver, PrintsATableWithoutOutputs) {
  ASSERT_EQ(run("draw mesh.ply --through 64,590 -o drawn.txt").code, 0);
  const Outcome outcome = run("smooth mesh.ply --curve drawn.txt");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("total curvature"), std::string::npos);
}

TEST_F(Driver, ReportsSeveralCurvesAndTheirTotals) {
  write("two.txt", "64\n65\n66\n67\n\n126\n127\n128\n");
  ASSERT_EQ(run("smooth mesh.ply --curve two.txt --report r.json -o two.json").code, 0);
  const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
  ASSERT_EQ(report["curves"].size(), 2U);
  EXPECT_EQ(report["curves"][0]["points_before"], 4);
  EXPECT_EQ(report["points_before"], 7);
  EXPECT_EQ(read_curves(file("two.json")).size(), 2U);
}

TEST_F(Driver, ALoopThatShrinksAwayIsWrittenWithExitCode3) {
  ASSERT_EQ(run("draw mesh.ply --through 200,215,450,440 --closed -o loop.txt").code, 0);
  const Outcome outcome =
      run("smooth mesh.ply --curve loop.txt --tau 0 -o out.json --report r.json");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(nlohmann::json::parse(bytes_of(file("r.json")))["termination"], "collapsed");
  EXPECT_EQ(read_curves(file("out.json")).size(), 1U);
}

TEST_F(Driver, ResultsAreTheSameBytesEveryTime) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o drawn.json").code, 0);
  ASSERT_EQ(run("smooth mesh.ply --curve drawn.json -o a.json -o a.vtp --threads 1").code, 0);
  ASSERT_EQ(run("smooth mesh.ply --curve drawn.json -o b.json -o b.vtp --threads 2").code, 0);
  EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
  EXPECT_EQ(bytes_of(file("a.vtp")), bytes_of(file("b.vtp")));
}

TEST_F(Driver, KeepsPins) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 -o drawn.txt").code, 0);
  ASSERT_EQ(run("smooth mesh.ply --curve drawn.txt --tau 0 --pin 400 -o out.obj").code, 0);
  const auto curves = read_curves(file("out.obj"));
  const auto& points = std::get<std::vector<Point>>(curves.at(0).points);
  const Point pin = test::grid(30, 20).points[400];
  EXPECT_NE(std::find(points.begin(), points.end(), pin), points.end());
}

TEST_F(Driver, UsesAGivenDistance) {
  ASSERT_EQ(run("draw mesh.ply --through 64,590 -o drawn.txt").code, 0);
  std::string flat;
  for (int v = 0; v < 651; ++v) flat += "1\n";
  write("flat.txt", flat);
  ASSERT_EQ(run("smooth mesh.ply --curve drawn.txt --potential paper --tau 3 --distance flat.txt "
                "--report r.json")
                .code,
            0);
  // A constant distance lifts nothing: the result is the straight line.
  const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
  EXPECT_EQ(report["lifted_length_before"], report["length_before"]);
  EXPECT_LT(report["curvature_after"], 1e-6);
}

TEST_F(Driver, KeepsWithinTheLargestDeviation) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o drawn.json").code, 0);
  for (const char* bound : {"2", "0.5", "0.2"}) {
    const Outcome outcome =
        run(std::string("smooth mesh.ply --curve drawn.json -o within.json --report r.json "
                        "--max-deviation ") +
            bound);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
    EXPECT_EQ(report["max_deviation"], std::stod(bound));
    ASSERT_EQ(run("measure mesh.ply within.json drawn.json --report m.json").code, 0);
    const auto measured = nlohmann::json::parse(bytes_of(file("m.json")));
    const double largest = std::stod(bound);
    for (const char* name : {"deviation_to_drawn_max", "deviation_from_drawn_max"}) {
      EXPECT_LE(report[name], largest) << name;
    }
    for (const char* name : {"deviation_to_other_max", "deviation_from_other_max"}) {
      EXPECT_LE(measured[name], largest * (1 + 1e-3) + 1e-3) << name;  // the error of measuring
    }
    EXPECT_LE(report["curvature_after"], report["curvature_before"]);
  }
}

TEST_F(Driver, HoldsTheDrawingWhereTheSlackFieldIsSmall) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o drawn.json").code, 0);
  std::string zeros, wide;
  for (int v = 0; v < 651; ++v) {
    zeros += "0\n";
    wide += "2\n";
  }
  write("zeros.txt", zeros);
  write("wide.txt", wide);
  const auto deviation = [&](const std::string& field) -> double {
    EXPECT_EQ(run("smooth mesh.ply --curve drawn.json --tau 4 --slack-field " + field +
                  " --report r.json")
                  .code,
              0);
    return nlohmann::json::parse(bytes_of(file("r.json")))["deviation_to_drawn_max"];
  };
  const double held = deviation("zeros.txt"), free = deviation("wide.txt");
  // At its samples the potential is at most half the drawn length (about 35, so the distance is 0.2
  // with L = 3.5 and tau = 4), and any other point is at most a quarter of the longest edge from a
  // sample.
  EXPECT_LT(held, 0.2 + std::sqrt(2) / 4);
  EXPECT_GT(free, 1);
  expect_failure("smooth mesh.ply --curve drawn.json --slack-field drawn.json", 2, {"drawn.json"});
}

TEST_F(Driver, RefusesInvalidArguments) {
  expect_failure("", 1,
                 {"draw, smooth, measure, cut, offset, labels, compare, info, plugins or run"});
  expect_failure("smoth mesh.ply", 1, {"smoth"});
  expect_failure("smooth mesh.ply", 1, {"--curve"});
  expect_failure("smooth mesh.ply --curve a.txt --bogus", 1, {"--bogus"});
  write("a.txt", "64\n65\n66\n");
  expect_failure("smooth mesh.ply --curve a.txt --tau -1", 1, {"tau"});
  expect_failure("smooth mesh.ply --curve a.txt --tau 1 --max-deviation 1", 1, {"--max-deviation"});
  expect_failure("smooth mesh.ply --curve a.txt --max-deviation 0", 1, {"max_deviation", "> 0"});
  expect_failure("smooth mesh.ply --curve a.txt --heat-time 1", 1, {"--heat-time", "paper"});
  expect_failure("smooth mesh.ply --curve a.txt --potential paper --max-deviation 1", 1,
                 {"--max-deviation", "corridor"});
  expect_failure("smooth mesh.ply --curve a.txt --tau nan", 1, {"tau"});
  expect_failure("smooth mesh.ply --curve a.txt --tau much", 1, {"--tau", "much"});
  expect_failure("smooth mesh.ply --curve a.txt --potential paper --heat-time 0", 1, {"heat_time"});
  expect_failure("smooth mesh.ply --curve a.txt --relax -1", 1, {"relax", ">= 0"});
  expect_failure("smooth mesh.ply --curve a.txt --pin 5", 1, {"vertex 5"});
  expect_failure("smooth mesh.ply --curve a.txt --potential steep", 1, {"steep"});
}

TEST_F(Driver, RefusesInvalidCurves) {
  const auto refuse = [&](const char* curve, std::initializer_list<const char*> words) {
    write("c.txt", curve);
    expect_failure("smooth mesh.ply --curve c.txt -o out.obj", 2, words);
    EXPECT_FALSE(std::filesystem::exists(file("out.obj")));
  };
  refuse("", {"c.txt", "empty"});
  refuse("64\n", {"two different points"});
  refuse("64\n64\n", {"point"});
  refuse("64\n65\n64\n65\n64\n", {"comes back"});
  refuse("64\n200\n", {"64", "200"});
  refuse("64\n9999\n", {"9999", "651"});
  refuse("64\n-1\n", {"line 2"});
  refuse("64\nsixty\n", {"line 2", "sixty"});
  expect_failure("smooth mesh.ply --curve none.obj", 2, {"none.obj"});
  expect_failure("draw mesh.ply --through 1,1 -o out.obj", 2, {"1"});
  expect_failure("draw mesh.ply --through 1,99999 -o out.obj", 2, {"99999"});
  expect_failure("draw mesh.ply --through 1,20 -o nowhere/out.obj", 2, {"nowhere"});
}

TEST_F(Driver, InfoTellsEveryDefectAndSmoothRefusesIt) {
  write("a.txt", "0\n1\n");
  const auto defect = [&](const MeshLists& lists, int info_code, const char* word) {
    write_mesh(file("bad.ply"), lists);
    const Outcome info = run("info bad.ply");
    EXPECT_EQ(info.code, info_code) << word;
    EXPECT_NE(info.out.find(word), std::string::npos) << info.out;
    EXPECT_TRUE(nlohmann::json::accept(run("info --json bad.ply").out)) << word;
    expect_failure("smooth bad.ply --curve a.txt -o out.obj", 2, {word});
  };
  defect(test::with_fin(test::grid(4, 4), 3), 0, "more than two faces");
  defect(test::with_turned_face(test::grid(4, 4), 3), 0, "orient");
  defect(test::with_bow_tie(test::grid(4, 4), 12), 0, "bow-tie");
  defect(test::with_coordinate(test::grid(4, 4), 5, std::nan("")), 2, "finite");
  EXPECT_EQ(run("info mesh.ply").code, 0);
}

TEST_F(Driver, InfoTellsWhereTheTimeWent) {
  const auto times = nlohmann::json::parse(run("info mesh.ply --json").out)["time_ms"];
  for (const char* name : {"load", "inspect", "open"}) EXPECT_GT(times[name], 0) << name;
  EXPECT_NE(run("info mesh.ply").out.find("ms to read the file"), std::string::npos);
  write_mesh(file("bad.ply"), test::with_fin(test::grid(4, 4), 3));
  EXPECT_TRUE(nlohmann::json::parse(run("info bad.ply --json").out)["time_ms"]["open"].is_null());
}

TEST_F(Driver, RefusesBrokenMeshFiles) {
  write("a.txt", "0\n1\n");
  write("empty.ply", "");
  const std::string whole = bytes_of(file("mesh.ply"));
  write("short.ply", whole.substr(0, whole.size() / 2));
  write("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n");
  write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  for (const char* name : {"empty.ply", "short.ply", "nan.obj", "index.obj", "none.ply"}) {
    expect_failure(std::string("smooth ") + name + " --curve a.txt", 2, {name});
    expect_failure(std::string("info ") + name, 2, {name});
  }
}

TEST_F(Driver, ListsItsPlugins) {
  const Outcome outcome = run("plugins");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out,
            "talweg.bipartition\tHeat-flow relaxation of a bipartition (Livesu 2018)\n"
            "talweg.cut\tCut along curves\n"
            "talweg.distance\tDistance to curves\ntalweg.draw\tDraw curves\n"
            "talweg.envelope\tLaplacian smoothing in an envelope (Lawonn et al. 2014)\n"
            "talweg.geodesic\tGeodesic\n"
            "talweg.labels\tSmooth label borders\ntalweg.measure\tMeasure curves\n"
            "talweg.midpoints\tSubdivision by geodesic midpoints (Morera et al. 2008)\n"
            "talweg.offset\tOffset curves\n"
            "talweg.repair\tInspect and repair\n"
            "talweg.smooth\tSmooth curves\n");
}

TEST_F(Driver, RunsAnyPluginByItsDescription) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o drawn.json").code, 0);
  ASSERT_EQ(run("run talweg.smooth mesh.ply --curve drawn.json --tau 2 --finish taut -o a.json "
                "--report r.json")
                .code,
            0);
  EXPECT_EQ(nlohmann::json::parse(bytes_of(file("r.json")))["tau"], 2);
  ASSERT_EQ(run("run talweg.smooth mesh.ply --curve drawn.json --tau 2 -o b.json").code, 0);
  EXPECT_NE(bytes_of(file("a.json")), bytes_of(file("b.json")));
  ASSERT_EQ(run("smooth mesh.ply --curve drawn.json --tau 2 -o c.json").code, 0);
  EXPECT_EQ(bytes_of(file("b.json")), bytes_of(file("c.json")));

  // A straight line over 30 x 20 squares, through the vertices' positions.
  write("ends.txt", "64 590");
  ASSERT_EQ(run("run talweg.draw mesh.ply --curve ends.txt --straight --report r.json").code, 0);
  EXPECT_NEAR(nlohmann::json::parse(bytes_of(file("r.json")))["length"], std::hypot(1, 17), 1e-9);
  ASSERT_EQ(run("run talweg.distance mesh.ply --curve drawn.json --write-distance d.txt").code, 0);
  EXPECT_EQ(
      run("smooth mesh.ply --curve drawn.json --potential paper --distance d.txt -o e.json").code,
      0);

  const std::string help = run("run talweg.smooth --help").out;
  const talweg_plugin& smooth = test::plugin_of_this_build("talweg.smooth");
  EXPECT_NE(help.find("--repair"), std::string::npos);
  for (std::uint32_t k = 0; k < smooth.parameter_count; ++k) {
    // They are told by --repair[=LIST].
    if (std::string_view(smooth.parameters[k]->id).starts_with("repair")) continue;
    std::string option = std::string("--") + smooth.parameters[k]->id;
    std::replace(option.begin(), option.end(), '_', '-');
    EXPECT_NE(help.find(option), std::string::npos) << option;
    EXPECT_NE(help.find(std::string(smooth.parameters[k]->doc).substr(0, 20)), std::string::npos);
  }
  expect_failure("run", 1, {"plugin", "talweg plugins"});
  expect_failure("run talweg.nothing mesh.ply", 2, {"talweg.nothing", "TALWEG_PLUGIN_PATH"});
  expect_failure("run talweg.smooth mesh.ply --curve drawn.json --taw 1", 1, {"--taw"});
  expect_failure("run talweg.smooth mesh.ply --curve drawn.json --tau -1", 1, {"tau", ">= 0"});
  expect_failure("run talweg.smooth none.ply --curve drawn.json", 2, {"none.ply"});
}

TEST_F(Driver, GoesOnWithoutBrokenPlugins) {
  std::filesystem::create_directory(file("plugins"));
  write("plugins/broken.so", "This is not a library.");
  setenv("TALWEG_PLUGIN_PATH", file("plugins").c_str(), 1);
  const Outcome outcome = run("plugins");
  unsetenv("TALWEG_PLUGIN_PATH");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("broken.so: It is not a shared library."), std::string::npos);
  EXPECT_NE(outcome.out.find("talweg.smooth\t"), std::string::npos);
}

TEST_F(Driver, SmoothsEveryManifoldRealMesh) {
  if (!std::filesystem::exists(test::mesh_folder())) {
    GTEST_SKIP() << test::missing("real meshes");
  }
  const std::set<std::string> refused = {"buildings_needles_400k", "car_nonmanifold_251k",
                                         "misoriented_25k", "teeth_bowtie_10k"};
  std::size_t smoothed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::mesh_folder())) {
    const std::string name = entry.path().stem().string();
    const std::string ending = entry.path().extension().string();
    // The two largest take most of a minute on a slow machine; other tests open them.
    if ((ending != ".ply" && ending != ".off") || entry.file_size() > 11'000'000) continue;
    std::string mesh = std::filesystem::absolute(entry.path()).string();
    mesh.insert(0, 1, '\'');
    mesh += '\'';
    if (refused.contains(name)) {
      write("a.txt", "0\n1\n");
      expect_failure("smooth " + mesh + " --curve a.txt", 2, {"first"});
      continue;
    }
    ASSERT_EQ(run("draw " + mesh + " --through 7,1500 -o drawn.txt").code, 0) << name;
    const Outcome outcome =
        run("smooth " + mesh + " --curve drawn.txt -o out.json --report r.json");
    ASSERT_EQ(outcome.code, 0) << name << outcome.err;
    const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
    EXPECT_LE(report["lifted_length_after"], report["lifted_length_before"]) << name;
    EXPECT_TRUE(report["curvature_after"].is_number()) << name;
    ++smoothed;
  }
  EXPECT_GE(smoothed, 12U);
}

}  // namespace
}  // namespace talweg
