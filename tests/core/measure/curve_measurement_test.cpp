#include "talweg/core/measure/curve_measurement.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// A sheet of unit squares; vertex (i, j) is 11 j + i.
class MeasuredSheet : public testing::Test {
 protected:
  [[nodiscard]] SurfaceCurve curve(std::initializer_list<std::size_t> vertices) const {
    std::vector<VertexId> list;
    for (const std::size_t v : vertices) list.emplace_back(v);
    return test::vertex_curve(mesh_.surface(), list, false);
  }
  [[nodiscard]] SurfaceCurve row(std::size_t j) const {  // from (2, j) to (6, j)
    return curve({11 * j + 2, 11 * j + 3, 11 * j + 4, 11 * j + 5, 11 * j + 6});
  }
  static nlohmann::json report(const CurveMeasurement& m) {
    return nlohmann::json::parse(to_json(entries_of(m), curve_entries_of(m)));
  }

  SurfaceMesh mesh_ = SurfaceMesh::open(test::grid(10, 10));
};

TEST_F(MeasuredSheet, OneCurveIsReportedWithoutOthers) {
  const SurfaceCurve line = row(2);
  const CurveMeasurement m = measure_curves(mesh_, {&line, 1});
  EXPECT_FALSE(m.others);
  const nlohmann::json json = report(m);
  EXPECT_EQ(json["faces"], 200);
  EXPECT_EQ(json["vertices"], 121);
  EXPECT_EQ(json["points"], 5);
  EXPECT_EQ(json["length"], 4);
  EXPECT_EQ(json["curvature"], 0);
  EXPECT_EQ(json["self_contacts_at"], nlohmann::json::array());
  for (const char* absent : {"curves", "other", "deviation_at"})
    EXPECT_FALSE(json.contains(absent));
}

TEST_F(MeasuredSheet, ContactsAreListedByPlace) {
  const SurfaceCurve crossing =
      curve({59, 60, 61, 72, 71, 60, 49});  // around a square, over (5, 5)
  const nlohmann::json json = report(measure_curves(mesh_, {&crossing, 1}));
  EXPECT_EQ(json["self_contacts"], 1);
  EXPECT_EQ(json["self_contact_stretches"], 0);
  EXPECT_EQ(json["self_contacts_at"], nlohmann::json({{5, 5, 0}}));
}

TEST_F(MeasuredSheet, AsManyAreComparedOneByOne) {
  const std::vector<SurfaceCurve> curves = {row(1), row(5)}, others = {row(2), row(8)};
  const CurveMeasurement m = measure_curves(mesh_, curves, others);
  ASSERT_EQ(m.deviations.size(), 2U);
  EXPECT_TRUE(m.warnings.empty());
  const nlohmann::json json = report(m);
  EXPECT_EQ(json["length"], 8);
  EXPECT_NEAR(json["deviation_to_other_max"], 3, 0.01);  // within 1e-3 of a segment or of itself
  EXPECT_NEAR(json["deviation_to_other_mean"], 2, 0.01);
  ASSERT_EQ(json["curves"].size(), 2U);
  EXPECT_NEAR(json["curves"][0]["deviation_from_other_max"], 1, 0.01);
  EXPECT_NEAR(json["curves"][1]["deviation_from_other_max"], 3, 0.01);
  EXPECT_EQ(json["curves"][1]["points"], 5);
  EXPECT_EQ(json["other"]["length"], 8);
  ASSERT_EQ(json["other"]["curves"].size(), 2U);
  EXPECT_EQ(json["other"]["curves"][1]["curvature_max_at"], nlohmann::json({2, 8, 0}));
}

TEST_F(MeasuredSheet, MoreOrFewerAreComparedTogether) {
  const std::vector<SurfaceCurve> curves = {row(1), row(3)};
  const SurfaceCurve other = row(2);
  const CurveMeasurement m = measure_curves(mesh_, curves, {&other, 1});
  EXPECT_TRUE(m.deviations.empty());
  ASSERT_EQ(m.warnings.size(), 1U);
  EXPECT_EQ(m.warnings[0],
            "2 curves are compared with 1: all together, because the numbers of curves differ.");
  const nlohmann::json json = report(m);
  EXPECT_NEAR(json["deviation_to_other_max"], 1, 0.01);
  EXPECT_FALSE(json["curves"][0].contains("deviation_to_other_max"));
  EXPECT_FALSE(json["other"].contains("curves"));
}

TEST_F(MeasuredSheet, TheWindowsMayBeGiven) {
  const SurfaceCurve line = row(2);
  EXPECT_EQ(report(measure_curves(mesh_, {&line, 1}, {}, {0.5}))["edge_length_near"], 0.5);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(measure_curves(mesh_, {&line, 1}, {}, {bad}), Error) << bad;
  }
  EXPECT_THROW(measure_curves(mesh_, {}), Error);
}

TEST(CurveMeasurement, PartsThatAreNotConnectedAreInfinitelyFarApart) {
  const SurfaceMesh mesh =
      SurfaceMesh::open(test::together(test::grid(4, 4), test::grid(4, 4), 100));
  const SurfaceCurve here = test::vertex_curve(mesh.surface(), test::ids({6, 7, 8}), false);
  const SurfaceCurve there = test::vertex_curve(mesh.surface(), test::ids({31, 32}), false);
  const CurveMeasurement m = measure_curves(mesh, {&here, 1}, {&there, 1});
  ASSERT_EQ(m.warnings.size(), 1U);
  EXPECT_NE(m.warnings[0].find("not connected"), std::string::npos);
  const auto json = nlohmann::json::parse(to_json(entries_of(m), {}));
  EXPECT_TRUE(json["deviation_to_other_max"].is_null());
}

}  // namespace
}  // namespace talweg
