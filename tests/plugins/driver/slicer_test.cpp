// The driver with files of 3D Slicer: spaces, clicks, results as semilandmarks.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/small_meshes.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

/// A head whose front (y < 0) is deeper than its back, in LPS and turned to RAS, and a ring on its
/// front in LPS.
class SlicerHead : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    MeshLists head = test::sphere(4);
    for (Point& p : head.points) p = Point(7 * p.x(), (p.y() < 0 ? 11 : 8) * p.y(), 10 * p.z());
    write_mesh(file("lps.ply"), head);
    std::string points;
    for (int k = 0; k < 12; ++k) {
      const double a = M_PI * k / 6;
      points += fmt::format("{}{{\"position\": [{}, {}, {}], \"positionStatus\": \"defined\"}}",
                            k > 0 ? ", " : "", 3.5 * std::cos(a), -9.5, 5 * std::sin(a));
    }
    write("ring.mrk.json",
          "{\"markups\": [{\"type\": \"ClosedCurve\", \"coordinateSystem\": "
          "\"LPS\", \"controlPoints\": [" +
              points + "]}]}");
    for (Point& p : head.points) p = Point(-p.x(), -p.y(), p.z());
    write_mesh(file("silent.ply"), head);
    head.space = PatientSpace::kRas;
    for (const char* name : {"ras.ply", "ras.obj", "ras.stl"}) write_mesh(file(name), head);
  }

  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(bytes_of(file(name)));
  }
  /// The mean y of our JSON's only curve.
  [[nodiscard]] double middle(const std::string& name) const {
    double sum = 0;
    const nlohmann::json points = json(name)["curves"][0]["points"];
    for (const auto& point : points) sum += point["xyz"][1].get<double>();
    return sum / static_cast<double>(points.size());
  }
};

TEST_F(SlicerHead, ARingOnTheFrontIsOnTheFrontInEitherSpace) {
  ASSERT_EQ(run("smooth lps.ply --curve ring.mrk.json -o l.json --report l-report.json").code, 0);
  EXPECT_LT(middle("l.json"), -8);
  EXPECT_EQ(json("l-report.json")["warnings"].dump().find("turned"), std::string::npos);
  for (const char* mesh : {"ras.ply", "ras.obj", "ras.stl"}) {
    ASSERT_EQ(run(std::string("smooth ") + mesh +
                  " --curve ring.mrk.json -o r.json -o r.mrk.json "
                  "--report r-report.json")
                  .code,
              0);
    EXPECT_GT(middle("r.json"), 8) << mesh;
    const std::string warnings = json("r-report.json")["warnings"].dump();
    EXPECT_NE(warnings.find("ring.mrk.json were turned from LPS to RAS"), std::string::npos)
        << warnings;
    // It is written in LPS again.
    const nlohmann::json markup = json("r.mrk.json")["markups"][0];
    EXPECT_EQ(markup["coordinateSystem"], "LPS");
    EXPECT_LT(markup["controlPoints"][0]["position"][1], -5);
  }
  EXPECT_EQ(json("r-report.json")["faces"], 2048);
  EXPECT_NE(run("info ras.ply").out.find("RAS"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(run("info ras.ply --json").out)["space"], "RAS");
  EXPECT_EQ(nlohmann::json::parse(run("info lps.ply --json").out)["space"], "");
}

TEST_F(SlicerHead, EveryCommandTurnsCurves) {
  ASSERT_EQ(run("cut ras.ply --curve ring.mrk.json -o cut.ply --report cut.json").code, 0);
  EXPECT_EQ(read_mesh(file("cut.ply")).space, PatientSpace::kRas);
  EXPECT_NE(json("cut.json")["warnings"].dump().find("RAS"), std::string::npos);
  ASSERT_EQ(run("measure ras.ply ring.mrk.json --report m.json").code, 0);
  EXPECT_NE(json("m.json")["warnings"].dump().find("RAS"), std::string::npos);
  const Outcome plugin = run("run talweg.smooth ras.ply --curve ring.mrk.json -o p.json");
  ASSERT_EQ(plugin.code, 0) << plugin.err;
  EXPECT_NE(plugin.out.find("turned from LPS to RAS"), std::string::npos) << plugin.out;
  ASSERT_EQ(run("smooth ras.ply --curve ring.mrk.json -o s.json").code, 0);
  EXPECT_EQ(bytes_of(file("p.json")), bytes_of(file("s.json")));
  write("list.csv", "mesh,curve\nras.ply,ring.mrk.json\nlps.ply,ring.mrk.json\n");
  ASSERT_EQ(run("smooth --batch list.csv -o '{mesh}.json'").code, 0);
  EXPECT_EQ(bytes_of(file("ras.json")), bytes_of(file("s.json")));
  EXPECT_LT(middle("lps.json"), 0);
}

TEST_F(SlicerHead, AMeshWithoutASpaceIsWarnedOfABetterFit) {
  for (const char* command :
       {"smooth silent.ply --curve ring.mrk.json -o a.json", "measure silent.ply ring.mrk.json",
        "run talweg.smooth silent.ply --curve ring.mrk.json -o a.json"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("talweg: warning: ")) << outcome.err;
    EXPECT_NE(outcome.err.find("times better with x and y negated"), std::string::npos)
        << outcome.err;
  }
  EXPECT_EQ(run("smooth lps.ply --curve ring.mrk.json -o a.json").err, "");
}

TEST_F(SlicerHead, ClicksAreDrawnThroughInTheirOrder) {
  write("clicks.fcsv",
        "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n"
        "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
        "1,3.5,-9.5,0,0,0,0,1,1,1,0,\"a, b\",,\n2,0,-9.5,5,0,0,0,1,1,1,0,F-2,,\n"
        "3,-3.5,-9.5,0,0,0,0,1,1,1,0,F-3,,\n");
  const Outcome drawn = run("draw ras.ply --clicks clicks.fcsv --closed -o d.json -o d.mrk.json");
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(drawn.out.find("turned from LPS to RAS"), std::string::npos) << drawn.out;
  const nlohmann::json curve = json("d.json")["curves"][0];
  EXPECT_TRUE(curve["closed"]);
  std::vector<double> x;
  for (const auto& point : curve["points"]) {
    if (point.contains("exact")) x.push_back(point["xyz"][0]);
  }
  ASSERT_EQ(x.size(), 3U);
  EXPECT_NEAR(x[0], -3.5, 0.5);
  EXPECT_NEAR(x[1], 0, 0.5);
  EXPECT_NEAR(x[2], 3.5, 0.5);
  ASSERT_EQ(run("smooth ras.ply --curve d.json -o s.json").code, 0);
  EXPECT_GT(middle("s.json"), 7);
  ASSERT_EQ(run("draw lps.ply --clicks ring.mrk.json -o e.json").code, 0);
  EXPECT_TRUE(json("e.json")["curves"][0]["closed"]);

  const Outcome far = run("draw silent.ply --clicks clicks.fcsv -o f.json");
  EXPECT_EQ(far.code, 0);
  EXPECT_NE(far.err.find("x and y negated"), std::string::npos) << far.err;
  expect_failure("draw ras.ply -o a.json", 1, {"--through", "--clicks"});
  expect_failure("draw ras.ply --clicks nothing.fcsv -o a.json", 2, {"nothing.fcsv"});
  expect_failure("draw ras.ply --clicks lps.ply -o a.json", 2, {"lps.ply", ".fcsv"});
  EXPECT_EQ(run("draw ras.ply --clicks clicks.fcsv --through 1,2 -o a.json").code, 1);
}

TEST_F(SlicerHead, ResultsAreResampled) {
  ASSERT_EQ(run("smooth lps.ply --curve ring.mrk.json -o a.json --report a-report.json").code, 0);
  const double length = json("a-report.json")["length_after"];
  EXPECT_FALSE(json("a-report.json").contains("resampled_points"));
  ASSERT_EQ(run("smooth lps.ply --curve ring.mrk.json --resample 50 --normals -o r.mrk.json "
                "-o r.fcsv -o r.vtp -o r.ply -o r.json --report r.json2")
                .code,
            0);
  const nlohmann::json report = json("r.json2");
  EXPECT_EQ(report["resampled_points"], 50);
  EXPECT_NEAR(report["resampled_spacing"], length / 50, 1e-12);
  const nlohmann::json markup = json("r.mrk.json")["markups"][0];
  EXPECT_EQ(markup["type"], "ClosedCurve");
  ASSERT_EQ(markup["controlPoints"].size(), 50U);
  // The third column is the normal, which points out of the head.
  const nlohmann::json& first = markup["controlPoints"][0];
  EXPECT_LT(first["orientation"][5], -0.5);
  const nlohmann::json points = json("r.json")["curves"][0]["points"];
  ASSERT_EQ(points.size(), 50U);
  EXPECT_EQ(points[0]["normal"][1], first["orientation"][5]);
  EXPECT_NE(bytes_of(file("r.vtp")).find("Name=\"Normals\""), std::string::npos);
  EXPECT_NE(bytes_of(file("r.ply")).find("property double nz"), std::string::npos);
  // A result of even points is read again.
  ASSERT_EQ(run("measure lps.ply r.json a.json --report m.json").code, 0);
  EXPECT_LT(json("m.json")["deviation_to_other_max"], 0.05);

  ASSERT_EQ(run("smooth lps.ply --curve ring.mrk.json --resample 0.5 -o s.json").code, 0);
  EXPECT_EQ(json("s.json")["curves"][0]["points"].size(), std::round(length / 0.5));
  ASSERT_EQ(run("smooth lps.ply --curve ring.mrk.json --resample 0.05cm -o t.json").code, 0);
  EXPECT_EQ(bytes_of(file("t.json")), bytes_of(file("s.json")));
  const Outcome drawn = run("draw lps.ply --through 0,10,100 --resample 20 -o d.json");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(drawn.out.starts_with("20 points, ")) << drawn.out;
  EXPECT_EQ(json("d.json")["curves"][0]["points"].size(), 20U);
  for (const char* wrong : {"1", "0", "-3", "0.0", "x", "3furlong", "99999999999", "1.5.2"}) {
    expect_failure(
        std::string("smooth lps.ply --curve ring.mrk.json -o a.json --resample=") + wrong, 1, {});
  }
  expect_failure("smooth lps.ply --curve ring.mrk.json -o a.json --resample 2", 1, {"closed"});
}

}  // namespace
}  // namespace talweg
