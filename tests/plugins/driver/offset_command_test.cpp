// talweg offset, as a user runs it.
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/small_meshes.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

using std::numbers::pi;

/// A plane of 40 x 40 squares, on it a line of 20 and a loop from border to border.
class OffsetCommand : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("plane.ply"), test::grid(40, 40));
    ASSERT_EQ(run("draw plane.ply --through 830,850 --straight -o line.json").code, 0);
    ASSERT_EQ(run("draw plane.ply --through 820,860 --straight -o across.json").code, 0);
  }
  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(bytes_of(file(name)));
  }
};

TEST_F(OffsetCommand, WritesACurveForEachComponentAndAReport) {
  const Outcome outcome =
      run("offset plane.ply --curve line.json --distance 1.5,3.2 -o out.json -o out.vtp --report "
          "report.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("2 curves in "), std::string::npos) << outcome.out;
  const auto report = json("report.json");
  EXPECT_EQ(report["components"], 2);
  ASSERT_EQ(report["curves"].size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const double d = k == 0 ? 1.5 : 3.2;
    const auto& curve = report["curves"][k];
    EXPECT_EQ(curve["distance"], d);
    EXPECT_EQ(curve["side"], "both");
    EXPECT_EQ(curve["closed"], true);
    EXPECT_NEAR(curve["length"].get<double>(), 40 + 2 * pi * d, 2 * pi * d * 1e-3);
    EXPECT_LE(curve["distance_off_max"].get<double>(), 1e-3 * d);
  }
  EXPECT_EQ(json("out.json")["curves"].size(), 2U);
}

TEST_F(OffsetCommand, MakesOneSideOrNoCaps) {
  const auto components = [&](const std::string& options) {
    const Outcome outcome =
        run("-q offset plane.ply --curve line.json --distance 2.5 -o out.json "
            "--report report.json " +
            options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json("report.json");
  };
  EXPECT_EQ(components("--caps none")["components"], 2);
  for (const char* side : {"left", "right"}) {
    const auto report = components(std::string("--side ") + side);
    EXPECT_EQ(report["components"], 1);
    EXPECT_EQ(report["side"], side);
    EXPECT_EQ(report["distance"], 2.5);
    EXPECT_EQ(report["closed"], false);
    EXPECT_NEAR(report["length"].get<double>(), 20, 1e-5);
  }
}

TEST_F(OffsetCommand, GivesABandThatCutMakesAPiece) {
  ASSERT_EQ(run("offset plane.ply --curve across.json --distance 2.3 -o band.json").code, 0);
  const Outcome cut = run("cut plane.ply --curve band.json -o part.ply --split");
  ASSERT_EQ(cut.code, 0) << cut.err;
  double area = 0;
  const MeshLists band = read_mesh(file("part-1.ply"));
  for (const Triangle& t : band.triangles) {
    area += (band.points[t[1]] - band.points[t[0]])
                .cross(band.points[t[2]] - band.points[t[0]])
                .norm() /
            2;
  }
  EXPECT_NEAR(area, 40 * 4.6, 1e-6);
}

TEST_F(OffsetCommand, SaysWhereThereIsNone) {
  expect_failure("offset plane.ply --curve across.json --distance 50 -o out.json", 1,
                 {"No point of the surface is at the distance 50", "20 away"});
  const Outcome outcome =
      run("offset plane.ply --curve across.json --distance 5,50 -o out.json --report report.json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("warning: No point of the surface is at the distance 50"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(json("report.json")["warnings"].size(), 1U);
  expect_failure("offset plane.ply --curve across.json --distance 0 -o out.json", 1,
                 {"must be finite and > 0"});
  expect_failure("offset plane.ply --curve across.json -o out.json", 1, {"--distance"});
  expect_failure("offset plane.ply --curve across.json --distance 1 --tolerance -1 -o out.json", 1,
                 {"tolerance"});
  expect_failure("offset plane.ply --curve across.json --distance 1 -o plane.ply", 1,
                 {"plane.ply"});
}

}  // namespace
}  // namespace talweg
