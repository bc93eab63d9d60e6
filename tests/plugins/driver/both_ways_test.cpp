// `talweg smooth`, `draw`, `cut`, `offset`, `labels`, `measure` and `info` call the library;
// `talweg run` goes through the loader and the C interface. Both give the same bytes.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/jagged_curves.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"

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

/// A mesh with attributes of all kinds, and a curve across it.
class BothWaysOnAttributes : public BothWays {
 protected:
  void SetUp() override {
    BothWays::SetUp();
    lists_ = test::hills(40);
    attributes_.vertices = {
        column("nx", NumberType::kFloat32, 0.6), column("ny", NumberType::kFloat32, 0.8),
        column("nz", NumberType::kFloat32, 0),   column("red", NumberType::kUint8, 17),
        column("label", NumberType::kInt32, 3),  column("quality", NumberType::kFloat64, 0.1)};
    AttributeColumn& segment = attributes_.faces.emplace_back();
    segment = {"segment", NumberType::kInt32, {}};
    std::string labels;
    for (const Triangle& t : lists_.triangles) {
      const int side = lists_.points[t[0]].y() < 20 ? 1 : 2;
      segment.values.push_back(side);
      labels += std::to_string(side) + "\n";
    }
    write("labels.txt", labels);
    write_mesh(file("mesh.ply"), lists_, attributes_);
    attributes_.texture.dimension = 2;
    for (const Point& p : lists_.points) {
      attributes_.texture.values.insert(attributes_.texture.values.end(), {p.x(), p.y()});
    }
    attributes_.texture.corners.assign(lists_.triangles.begin(), lists_.triangles.end());
    attributes_.names = {{"usemtl", {"", "skin", "bone"}, {}}};
    for (const double side : segment.values) {
      attributes_.names[0].of_face.push_back(static_cast<std::uint32_t>(side));
    }
    write_mesh(file("mesh.obj"), lists_, attributes_);
    ASSERT_EQ(run("draw hills.ply --through 574,1106 --straight -o across.json").code, 0);
  }
  [[nodiscard]] AttributeColumn column(const char* name, NumberType type, double slope) const {
    AttributeColumn result{name, type, {}};
    for (std::size_t v = 0; v < vertices_; ++v) {
      const double value = slope * static_cast<double>(v % 13);
      result.values.push_back(type == NumberType::kFloat32 ? slope : value);
    }
    return result;
  }
  void expect_done(const std::string& command) {
    const Outcome outcome = run("-q " + command);
    EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
  }

  MeshLists lists_;
  MeshAttributes attributes_;
};

TEST_F(BothWaysOnAttributes, CutTheSame) {
  for (const std::string ending : {".ply", ".obj"}) {
    for (const char* options :
         {"", "--open", "--split", "--keep left", "--keep right --cap", "--split --cap=planar",
          "--merge 1e-4", "--tag", "--open --tag", "--split --tag"}) {
      std::string loaded = options;
      if (loaded.ends_with("--cap")) loaded += " auto";
      if (const auto at = loaded.find("--cap=planar"); at != loaded.npos) {
        loaded.replace(at, std::string::npos, "--cap planar");
      }
      SCOPED_TRACE(ending + " " + options);
      expect_done("cut mesh" + ending + " --curve across.json -o a" + ending +
                  " --map a.json --report a-report.json " + options);
      expect_done("run talweg.cut mesh" + ending + " --curve across.json --write-mesh b" + ending +
                  " --map b.json --report b-report.json " + loaded);
      EXPECT_EQ(report("a-report.json"), report("b-report.json"));
      const bool split = loaded.find("--split") != std::string::npos;
      for (const std::string part : {split ? "-0" : "", split ? "-1" : ""}) {
        EXPECT_EQ(bytes_of(file("a" + part + ending)), bytes_of(file("b" + part + ending)));
      }
      auto a = nlohmann::json::parse(bytes_of(file("a.json")));
      auto b = nlohmann::json::parse(bytes_of(file("b.json")));
      for (auto* map : {&a, &b}) {
        for (auto& part : (*map)["parts"]) part.erase("file");
      }
      EXPECT_EQ(a, b);
    }
  }
}

TEST_F(BothWaysOnAttributes, SmoothLabelsTheSame) {
  for (const char* options : {"", "--tau 3 --ends slide", "--max-deviation 0.8"}) {
    SCOPED_TRACE(options);
    expect_done(std::string("labels mesh.ply labels.txt -o a.json --labels-out a.txt --cut a.ply "
                            "--report a-report.json ") +
                options);
    expect_done(std::string("run talweg.labels mesh.ply --triangle-labels labels.txt -o b.json "
                            "--write-labels b.txt --write-mesh b.ply --report b-report.json ") +
                options);
    for (const std::string ending : {".json", ".txt", ".ply"}) {
      EXPECT_EQ(bytes_of(file("a" + ending)), bytes_of(file("b" + ending))) << ending;
    }
    EXPECT_EQ(report("a-report.json"), report("b-report.json"));
  }
}

TEST_F(BothWaysOnAttributes, OffsetTheSame) {
  for (const char* options :
       {"", "--side left", "--side right --tolerance 0.01", "--caps none", "--closed"}) {
    SCOPED_TRACE(options);
    std::string loaded = options;
    if (loaded == "--closed") loaded = "--ends closed";
    expect_done(std::string("offset mesh.ply --curve across.json --distance 1.7 -o a.json --report "
                            "a-report.json ") +
                options);
    expect_done(
        "run talweg.offset mesh.ply --curve across.json --distance 1.7 -o b.json --report "
        "b-report.json " +
        loaded);
    EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
    EXPECT_EQ(report("a-report.json"), report("b-report.json"));
  }
}

TEST_F(BothWaysOnAttributes, MeasureTheSame) {
  expect_done("smooth mesh.ply --curve across.json -o smooth.json");
  expect_done("measure mesh.ply smooth.json --report a.json");
  expect_done("run talweg.measure mesh.ply --curve smooth.json --report b.json");
  EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
  expect_done("measure mesh.ply smooth.json across.json --edge 1.5 --report a.json");
  expect_done(
      "run talweg.measure mesh.ply --curve smooth.json --curve across.json --others 1 --edge 1.5 "
      "--report b.json");
  EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
}

TEST_F(BothWaysOnAttributes, InspectAndRepairTheSame) {
  std::swap(lists_.triangles[100][1], lists_.triangles[100][2]);
  lists_.triangles.push_back(lists_.triangles[7]);
  write_mesh(file("broken.ply"), lists_);
  write("a.json", run("info broken.ply --json --repair").out);
  expect_done("run talweg.repair broken.ply --report b.json --write-mesh whole.ply");
  EXPECT_EQ(report("a.json"), report("b.json"));
  write("a.json", run("info broken.ply --json --repair=drop").out);
  expect_done("run talweg.repair broken.ply --repair=drop --report b.json");
  EXPECT_EQ(report("a.json"), report("b.json"));
  EXPECT_EQ(run("info whole.ply").code, 0);
}

TEST_F(BothWaysOnAttributes, RepairInsideThePluginIsTheDrivers) {
  std::swap(lists_.triangles[100][1], lists_.triangles[100][2]);
  lists_.triangles.push_back(lists_.triangles[7]);
  write_mesh(file("broken.ply"), lists_);
  expect_done("smooth broken.ply --repair --curve across.json -o a.json --report a-report.json");
  expect_done(
      "run talweg.smooth broken.ply --repair --curve across.json -o b.json --report "
      "b-report.json");
  EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
  EXPECT_EQ(report("a-report.json"), report("b-report.json"));
  expect_done("cut broken.ply --repair --curve across.json -o a.ply --map a.json --open");
  expect_done(
      "run talweg.cut broken.ply --repair --curve across.json --write-mesh b.ply --map b.json "
      "--open");
  EXPECT_EQ(bytes_of(file("a.ply")), bytes_of(file("b.ply")));
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
