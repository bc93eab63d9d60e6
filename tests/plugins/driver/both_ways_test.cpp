// `talweg smooth` and `draw` call the library; `talweg run` goes through the loader and the C
// interface. Both give the same bytes.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/jagged_curves.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

class BothWays : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    MeshLists hills = test::hills(40);
    vertices_ = hills.points.size();
    write_mesh(file("hills.ply"), hills);
  }
  void field(const std::string& name, double constant, double slope) {
    std::string text;
    for (std::size_t v = 0; v < vertices_; ++v) {
      text += std::to_string(constant + slope * static_cast<double>(v % 41)) + "\n";
    }
    write(name, text);
  }
  /// Without what depends on the clock.
  nlohmann::json report(const std::string& name) {
    auto json = nlohmann::json::parse(bytes_of(file(name)));
    const auto strip = [](nlohmann::json& one) {
      one.erase("time_ms");
      one.erase("peak_memory_mib");
    };
    strip(json);
    if (json.contains("curves")) {
      for (auto& one : json["curves"]) strip(one);
    }
    return json;
  }
  void expect_same(const std::string& arguments) {
    SCOPED_TRACE(arguments);
    const Outcome direct = run("-q smooth hills.ply -o a.json --report a-report.json " + arguments);
    const Outcome loaded =
        run("-q run talweg.smooth hills.ply -o b.json --report b-report.json " + arguments);
    ASSERT_EQ(direct.code, loaded.code) << direct.err << loaded.err;
    ASSERT_LE(direct.code, 3) << direct.err;
    ASSERT_NE(direct.code, 2) << direct.err;
    EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
    EXPECT_EQ(report("a-report.json"), report("b-report.json"));
  }

  std::size_t vertices_ = 0;
};

TEST_F(BothWays, SmoothTheSame) {
  ASSERT_EQ(run("draw hills.ply --through 130,760,1500 -o open.txt").code, 0);
  ASSERT_EQ(
      run("draw hills.ply --through 400,430,1200,1180 --points rough --closed -o closed.json").code,
      0);
  ASSERT_EQ(run("draw hills.ply --through 131,1502 --points rough --straight -o across.vtp").code,
            0);
  field("slack.txt", 0.3, 0.02);
  field("distance.txt", 0, 0.5);
  for (const char* curve : {"--curve open.txt", "--curve closed.json", "--curve across.vtp",
                            "--curve open.txt --curve across.vtp"}) {
    for (const char* options :
         {"", "--tau 0", "--tau 0.05", "--tau 4 --relax 5", "--slack 0.4 --engine local",
          "--slack-field slack.txt", "--max-deviation 1.2", "--potential paper",
          "--potential paper --tau 3 --heat-time 5 --engine full",
          "--potential paper --distance distance.txt"}) {
      expect_same(std::string(curve) + " " + options);
    }
  }
  expect_same("--curve open.txt --pin 760");
  expect_same("--curve open.txt --corner 760");
}

TEST_F(BothWays, SmoothTheSameWithOptionsForEachCurve) {
  ASSERT_EQ(run("draw hills.ply --through 130,150 --points rough -o low.txt").code, 0);
  ASSERT_EQ(run("draw hills.ply --through 830,845 --points rough -o middle.txt").code, 0);
  ASSERT_EQ(run("draw hills.ply --through 1330,1355 --points rough -o high.txt").code, 0);
  const std::string curves = " --curve low.txt --curve middle.txt --curve high.txt";
  struct Case {
    const char* direct;
    const char* loaded;
  };
  for (const Case& one :
       {Case{"--tau 0,3,0.4", "--taus 0,3,0.4"},
        Case{"--slack auto,0.3,0.7 --tau 2", "--slacks=-1,0.3,0.7 --tau 2"},
        Case{"--finish fair,taut,fair", "--finishes 0,1,0"}, Case{"--tau 1,1,1", "--tau 1"}}) {
    SCOPED_TRACE(one.direct);
    const Outcome direct =
        run("-q smooth hills.ply -o a.json --report a-report.json" + curves + " " + one.direct);
    const Outcome loaded = run("-q run talweg.smooth hills.ply -o b.json --report b-report.json" +
                               curves + " " + one.loaded);
    ASSERT_EQ(direct.code, 0) << direct.err;
    ASSERT_EQ(loaded.code, 0) << loaded.err;
    EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
    EXPECT_EQ(report("a-report.json"), report("b-report.json"));
  }
}

TEST_F(BothWays, SmoothTheSameThroughWayPoints) {
  ASSERT_EQ(run("draw hills.ply --through 130,760,1500 -o open.json -o open.txt").code, 0);
  ASSERT_EQ(run("draw hills.ply --through 400,430,1200,1180 --closed -o closed.vtp").code, 0);
  write("few.mrk.json", R"({"markups": [{"type": "Curve", "controlPoints": [
    {"position": [5, 5, 0]}, {"position": [20, 12, 0]}, {"position": [30, 33, 0]}]}]})");
  for (const char* curve : {"--curve open.json", "--curve closed.vtp", "--curve few.mrk.json",
                            "--curve open.json --curve closed.vtp"}) {
    for (const char* options : {"", "--tau 0", "--tau 4", "--slack 0.4", "--max-deviation 1.2",
                                "--points rough", "--points exact", "--tolerance 0.3"}) {
      expect_same(std::string(curve) + " " + options);
    }
  }
  expect_same("--curve open.json --pin 760");
  expect_same("--curve open.json --corner 760");
  expect_same("--curve open.txt --points exact");
  ASSERT_EQ(run("smooth hills.ply --curve open.txt --points exact=130,760,1500 -o a.json").code, 0);
  ASSERT_EQ(run("run talweg.smooth hills.ply --curve open.txt --exact 130,760,1500 -o b.json").code,
            0);
  EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
}

TEST_F(BothWays, DrawTheSame) {
  struct Case {
    const char* through;
    const char* points;
    const char* drawn;   // options of draw
    const char* loaded;  // and of run
  };
  for (const Case& one :
       {Case{"130,760,1500", "130 760 1500", "", ""},
        Case{"130,760,1500", "130 760 1500", "--straight", "--straight"},
        Case{"400,430,1200", "400 430 1200 400", "--closed", ""},
        Case{"400,430,1200", "400 430 1200 400", "--closed --straight", "--straight"},
        Case{"130,760,1500", "130 760 1500", "--points rough", "--points rough"}}) {
    SCOPED_TRACE(one.drawn);
    write("points.txt", one.points);
    ASSERT_EQ(
        run(std::string("draw hills.ply -o a.json --through ") + one.through + " " + one.drawn)
            .code,
        0);
    ASSERT_EQ(
        run(std::string("run talweg.draw hills.ply -o b.json --curve points.txt ") + one.loaded)
            .code,
        0);
    EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
  }
}

}  // namespace
}  // namespace talweg
