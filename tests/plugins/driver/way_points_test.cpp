// The driver writes, reads and takes way-points.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/small_meshes.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

using nlohmann::json;

class DriverWayPoints : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("mesh.ply"), test::grid(30, 20));
  }
  void draw(const std::string& arguments) const {
    const Outcome outcome = run("draw mesh.ply --through 64,400,590 " + arguments);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  [[nodiscard]] json read(const char* name) const { return json::parse(bytes_of(file(name))); }
  /// The result of a smoothing, and its report in report.json.
  std::string smoothed(const std::string& arguments) const {
    const Outcome outcome =
        run("-q smooth mesh.ply -o result.json --report report.json " + arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << outcome.err;
    return bytes_of(file("result.json"));
  }
  /// Whether the result passes the middle vertex that was given to draw().
  [[nodiscard]] static bool passes_400(const std::string& result) {
    return result.find("\"xyz\": [28, 12, 0]") != std::string::npos;
  }
};

TEST_F(DriverWayPoints, AreWrittenByDraw) {
  draw("-o drawn.json");
  const json points = read("drawn.json")["curves"][0]["points"];
  std::vector<std::size_t> exact;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points[k].contains("exact")) continue;
    EXPECT_EQ(points[k]["exact"], true);
    exact.push_back(k);
  }
  ASSERT_EQ(exact.size(), 3U);
  EXPECT_EQ(exact.front(), 0U);
  EXPECT_EQ(points[exact[1]]["xyz"], (json{28, 12, 0}));
  EXPECT_EQ(exact.back(), points.size() - 1);
  draw("--points rough -o rough.json");
  EXPECT_EQ(bytes_of(file("rough.json")).find("exact"), std::string::npos);
}

TEST_F(DriverWayPoints, SaysWhereAFormatHasNone) {
  const Outcome outcome = run("draw mesh.ply --through 64,400,590 -o a.obj -o b.vtp -o c.txt");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("a.obj, c.txt: the path, a stroke"), std::string::npos) << outcome.out;
  EXPECT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o a.obj").out, "");
}

TEST_F(DriverWayPoints, AreTheSameFromEveryFormatThatHoldsThem) {
  draw("-o drawn.json -o drawn.vtp -o drawn.vtk -o drawn.obj");
  const std::string expected = smoothed("--curve drawn.json");
  EXPECT_TRUE(passes_400(expected));
  EXPECT_EQ(smoothed("--curve drawn.vtp"), expected);
  EXPECT_EQ(smoothed("--curve drawn.vtk"), expected);
  EXPECT_FALSE(passes_400(smoothed("--curve drawn.obj")));
}

TEST_F(DriverWayPoints, CanBeChosen) {
  draw("-o drawn.json -o drawn.txt");
  const std::string exact = smoothed("--curve drawn.json"), rough = smoothed("--curve drawn.txt");
  EXPECT_EQ(smoothed("--curve drawn.json --points rough"), rough);
  EXPECT_EQ(smoothed("--curve drawn.txt --points exact=64,400,590"), exact);
  EXPECT_EQ(smoothed("--curve drawn.json --points exact"), exact);
  EXPECT_NE(smoothed("--curve drawn.txt --points exact"), exact);  // then every point is one
  const std::string loose = smoothed("--curve drawn.json --tolerance 1");
  EXPECT_FALSE(passes_400(loose));
  EXPECT_NE(loose, rough);
}

TEST_F(DriverWayPoints, AreTheSameThroughThePlugin) {
  draw("-o drawn.json");
  const std::string expected = smoothed("--curve drawn.json");
  ASSERT_EQ(run("-q run talweg.smooth mesh.ply --curve drawn.json -o plugin.json").code, 0);
  EXPECT_EQ(bytes_of(file("plugin.json")), expected);
}

TEST_F(DriverWayPoints, WhatDoesNotApplyIsSaid) {
  draw("-o drawn.json");
  const std::string plain = smoothed("--curve drawn.json");
  EXPECT_TRUE(read("report.json")["warnings"].empty()) << read("report.json")["warnings"];
  EXPECT_EQ(smoothed("--curve drawn.json --slack 3 --max-deviation 0.1"), plain);
  const json warnings = read("report.json")["warnings"];
  ASSERT_EQ(warnings.size(), 1U) << warnings;
  for (const char* word : {"slack", "largest deviation", "way-points"}) {
    EXPECT_NE(warnings[0].get<std::string>().find(word), std::string::npos) << warnings;
  }
}

TEST_F(DriverWayPoints, OfOneCurveStayWithIt) {
  draw("-o drawn.json");
  ASSERT_EQ(run("draw mesh.ply --through 0,20 --points rough -o other.json").code, 0);
  smoothed("--curve drawn.json --curve other.json");
  const json together = read("result.json");
  smoothed("--curve drawn.json --curve other.json --independent");
  EXPECT_EQ(read("result.json")["curves"].size(), 2U);
  EXPECT_EQ(read("result.json")["curves"][0], together["curves"][0]);
}

TEST_F(DriverWayPoints, BadOnesAreRefused) {
  draw("-o drawn.json");
  expect_failure("draw mesh.ply --through 1,2 --points loose -o a.json", 1, {"--points", "loose"});
  for (const char* bad : {"loose", "exact=", "exact=1,", "exact=1;2", "exact=-1"}) {
    expect_failure(std::string("smooth mesh.ply --curve drawn.json --points '") + bad + "'", 1,
                   {"--points", bad});
  }
  expect_failure("smooth mesh.ply --curve drawn.json --points exact=3", 1, {"way-point", "3"});
  expect_failure("smooth mesh.ply --curve drawn.json --tolerance -1", 1, {"tolerance"});
  std::string text = bytes_of(file("drawn.json"));
  text.replace(text.find("\"exact\": true"), 13, "\"exact\": -0.5");
  write("negative.json", text);
  expect_failure("smooth mesh.ply --curve negative.json", 2, {"negative.json", "exact"});
  text.replace(text.find("\"exact\": -0.5"), 13, "\"exact\": \"no\"");
  write("word.json", text);
  expect_failure("smooth mesh.ply --curve word.json", 2, {"word.json", "exact"});
}

}  // namespace
}  // namespace talweg
