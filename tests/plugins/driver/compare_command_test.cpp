// talweg compare, as a user runs it.
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

class CompareCommand : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("hills.ply"), test::hills(40));
    const SurfaceMesh mesh = SurfaceMesh::open(test::hills(40));
    const PlacedCurve wave = place(mesh, test::wave_on_hills(mesh));
    write_curves(file("wave.json"), std::span(&wave, 1));
    write_mesh(file("tube.ply"), test::tube(24, 20, 3));
    write_curves_of_tube();
  }
  void write_curves_of_tube() const {
    const SurfaceMesh mesh = SurfaceMesh::open(test::tube(24, 20, 3));
    std::vector<Point> points = test::circle({0, 0, 1.5}, {1, 0, 0}, {0, 1, 0}, 12);
    for (std::size_t k = 0; k < points.size(); ++k) points[k].z() += k % 2 == 0 ? 0.3 : -0.3;
    const PlacedCurve ring = place(mesh, test::drawn_near(mesh, points, true));
    write_curves(file("ring.json"), std::span(&ring, 1));
  }
  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(bytes_of(file(name)));
  }
};

TEST_F(CompareCommand, AgreesWithMeasure) {
  const Outcome outcome =
      run("compare hills.ply --curve wave.json --methods corridor,paper,paper-relaxed,geodesic "
          "--report all.json --results out --table all.csv -o all.png");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json all = json("all.json");
  ASSERT_EQ(all["runs"].size(), 4U);
  EXPECT_EQ(count(bytes_of(file("all.csv")), "\n"), 5U);
  EXPECT_EQ(bytes_of(file("all.png")).substr(1, 3), "PNG");
  for (const nlohmann::json& r : all["runs"]) {
    const std::string name = r["method"];
    EXPECT_TRUE(r["kind_kept"]) << name;
    EXPECT_NE(outcome.out.find("| " + name + " "), std::string::npos) << outcome.out;
    ASSERT_EQ(run("measure hills.ply out-" + name + ".json wave.json --report m.json").code, 0);
    const nlohmann::json m = json("m.json");
    EXPECT_NEAR(r["curvature"], m["curvature"], 1e-6) << name;
    EXPECT_NEAR(r["length"], m["length"], 1e-9 * r["length"].get<double>()) << name;
    EXPECT_NEAR(r["deviation_to_drawn_max"], m["deviation_to_other_max"], 1e-6) << name;
    EXPECT_NEAR(r["deviation_from_drawn_max"], m["deviation_from_other_max"], 1e-6) << name;
  }
  // A geodesic turns nowhere.
  EXPECT_LT(all["runs"][3]["curvature"], 1e-4);
}

TEST_F(CompareCommand, ASweepHasAPlotAndAVerdict) {
  const Outcome outcome =
      run("compare hills.ply --curve wave.json --methods corridor,paper --sweep --plot plot.svg "
          "--report all.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("corridor is as smooth or smoother"), std::string::npos);
  const nlohmann::json all = json("all.json");
  const std::string svg = bytes_of(file("plot.svg"));
  EXPECT_EQ(count(svg, "<circle "), all["runs"].size() + 2);  // and two in the legend
  EXPECT_EQ(count(svg, "<path "), 2U);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  double first = -1, last = -1;
  for (const nlohmann::json& r : all["runs"]) {
    if (r["method"] != "corridor") continue;
    if (first < 0) first = r["curvature"];
    last = r["curvature"];
  }
  EXPECT_LT(last, 0.2 * first);  // from close to smooth
}

TEST_F(CompareCommand, TellsWhetherALoopWasKept) {
  // On a tube of constant girth the loop becomes a ring that is a geodesic and separates the tube.
  const Outcome outcome =
      run("compare tube.ply --curve ring.json --methods corridor,geodesic --report all.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json ring_runs = json("all.json");
  ASSERT_EQ(ring_runs["runs"].size(), 2U);
  for (const nlohmann::json& r : ring_runs["runs"]) EXPECT_TRUE(r["kind_kept"]);
  // On a sphere the corridor keeps the loop, and the geodesic shrinks to a point.
  write_mesh(file("sphere.ply"), test::sphere(4));
  const SurfaceMesh mesh = SurfaceMesh::open(test::sphere(4));
  const double r = std::sqrt(1 - 0.36);
  const auto points = test::circle({0, 0, 0.6}, {r, 0, 0}, {0, r, 0}, 16);
  const PlacedCurve ring = place(mesh, test::drawn_near(mesh, points, true));
  write_curves(file("cap.json"), std::span(&ring, 1));
  const Outcome slipped =
      run("compare sphere.ply --curve cap.json --methods corridor,geodesic --report all.json");
  ASSERT_EQ(slipped.code, 0) << slipped.err;
  const nlohmann::json all = json("all.json");
  EXPECT_TRUE(all["runs"][0]["kind_kept"]);
  EXPECT_FALSE(all["runs"][1]["kind_kept"]);
}

TEST_F(CompareCommand, AMethodMayRefuseAndTheOthersGoOn) {
  const Outcome outcome =
      run("compare hills.ply --curve wave.json --methods corridor,example.none,talweg.distance "
          "--report all.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json all = json("all.json");
  EXPECT_FALSE(all["runs"][0].contains("refused"));
  EXPECT_NE(all["runs"][1]["refused"].get<std::string>().find("There is no plugin example.none"),
            std::string::npos);
  EXPECT_EQ(all["runs"][2]["refused"], "The method returned no curve.");
}

TEST_F(CompareCommand, RefusesBadUse) {
  expect_failure("compare hills.ply --curve wave.json --methods corridor,laplace", 1,
                 {"no method \"laplace\"", "corridor, corridor-tau"});
  expect_failure("compare hills.ply --curve wave.json --plot plot.svg", 1, {"--sweep"});
  expect_failure("compare hills.ply --curve none.json", 2, {"none.json"});
  expect_failure("compare hills.ply --curve wave.json --methods geodesic --report no/all.json", 2,
                 {"no/all.json"});
}

}  // namespace
}  // namespace talweg
