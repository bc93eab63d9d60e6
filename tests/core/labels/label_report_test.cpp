#include "talweg/core/labels/label_report.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace talweg {
namespace {

using nlohmann::json;

LabelNetwork two_regions() {
  LabelNetwork network;
  network.regions = {{-1, 1, 1, 2.5, 2.25, false}, {7, 2, 2, 0.5, 0.75, true}};
  SmoothedBorder border;
  border.border.labels = {-1, 7};
  border.border.curve.closed = true;
  border.as_drawn = true;
  border.report.tau = 4;
  border.report.after.length = 12;
  network.borders = {border};
  network.junctions = 3;
  network.imbalance_before = 0.5;
  network.total.warnings = {"not this one"};
  return network;
}

TEST(LabelReport, HasNetworkRegionsAndBorders) {
  const LabelNetwork network = two_regions();
  const json report = json::parse(to_json(entries_of(network, {"A warning."}, {{7, "tooth"}}), {}));
  EXPECT_EQ(report["warnings"], json({"A warning."}));
  EXPECT_EQ(report["network"]["borders"], 1);
  EXPECT_EQ(report["network"]["junctions"], 3);
  EXPECT_EQ(report["network"]["imbalance_before"], 0.5);
  ASSERT_EQ(report["regions"].size(), 2U);
  EXPECT_EQ(report["regions"][0]["label"], -1);
  EXPECT_EQ(report["regions"][0]["area_after"], 2.25);
  EXPECT_FALSE(report["regions"][0].contains("name"));
  EXPECT_EQ(report["regions"][1]["name"], "tooth");
  EXPECT_EQ(report["regions"][1]["held"], true);
  EXPECT_EQ(report["regions"][1]["parts_before"], 2);
  ASSERT_EQ(report["borders"].size(), 1U);
  EXPECT_EQ(report["borders"][0]["left"], -1);
  EXPECT_EQ(report["borders"][0]["right"], 7);
  EXPECT_EQ(report["borders"][0]["closed"], true);
  EXPECT_EQ(report["borders"][0]["tau"], 4);
  EXPECT_EQ(report["borders"][0]["length"], 12);
}

TEST(LabelReport, EachBorderHasItsOwn) {
  LabelNetwork network = two_regions();
  network.borders.push_back(network.borders[0]);
  network.borders[1].report.tau = 1;
  const json report = json::parse(to_json(entries_of(network, {}), curve_entries_of(network)));
  ASSERT_EQ(report["curves"].size(), 2U);
  EXPECT_EQ(report["curves"][0]["tau"], 4);
  EXPECT_EQ(report["curves"][1]["tau"], 1);
}

TEST(LabelReport, EmptyListsAreThere) {
  const json report = json::parse(to_json(entries_of(LabelNetwork{}, {}), {}));
  for (const char* list : {"regions", "borders", "warnings"}) {
    EXPECT_EQ(report[list], json::array()) << list;
  }
}

TEST(LabelReport, WarnsOfRegionsThatAreHeld) {
  const LabelNetwork network = two_regions();
  const auto plain = warnings_of(network);
  ASSERT_EQ(plain.size(), 1U);
  EXPECT_EQ(plain[0].find("Region 7 is too small"), 0U) << plain[0];
  EXPECT_EQ(warnings_of(network, {{7, "tooth"}})[0].find("Region 7 (tooth) is"), 0U);
}

TEST(LabelReport, LabelsAreAColumnOfWholeNumbersIfTheyFit) {
  const AttributeColumn small = label_column(std::vector<std::int64_t>{3, -2});
  EXPECT_EQ(small.name, "label");
  EXPECT_EQ(small.type, NumberType::kInt32);
  EXPECT_EQ(small.values, (std::vector<double>{3, -2}));
  EXPECT_EQ(label_column(std::vector<std::int64_t>{3000000000}).type, NumberType::kFloat64);
}

}  // namespace
}  // namespace talweg
