#include "talweg/core/measure/report_entry.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

TEST(ReportEntries, ADotBeginsAGroup) {
  EXPECT_EQ(
      to_json({{"tau", 1.5}, {"time_ms.open", 2.0}, {"time_ms.solve", HUGE_VAL}}, {}),
      "{\n  \"tau\": 1.5,\n  \"time_ms\": {\n    \"open\": 2.0,\n    \"solve\": null\n  }\n}\n");
}

TEST(ReportEntries, EveryKindOfValueHasItsForm) {
  EXPECT_EQ(to_json({{"count", std::uint64_t{18446744073709551615U}},
                     {"label", std::int64_t{-3}},
                     {"closed", true},
                     {"name", std::string("a \"b\"")},
                     {"at", std::vector<double>{1, HUGE_VAL}},
                     {"vertices", std::vector<std::int64_t>{7, -1}},
                     {"warnings", std::vector<std::string>{"One."}}},
                    {}),
            "{\n  \"count\": 18446744073709551615,\n  \"label\": -3,\n  \"closed\": true,\n"
            "  \"name\": \"a \\\"b\\\"\",\n  \"at\": [\n    1.0,\n    null\n  ],\n"
            "  \"vertices\": [\n    7,\n    -1\n  ],\n  \"warnings\": [\n    \"One.\"\n  ]\n}\n");
}

TEST(ReportEntries, AWholeNumberInAKeyIsAnIndex) {
  EXPECT_EQ(to_json({{"regions.0.label", std::int64_t{4}},
                     {"regions.0.held", false},
                     {"regions.1.label", std::int64_t{5}},
                     {"places.0", std::vector<double>{}},
                     {"other.curves.0.points", std::uint64_t{2}}},
                    {}),
            "{\n  \"regions\": [\n    {\n      \"label\": 4,\n      \"held\": false\n    },\n"
            "    {\n      \"label\": 5\n    }\n  ],\n  \"places\": [\n    []\n  ],\n"
            "  \"other\": {\n    \"curves\": [\n      {\n        \"points\": 2\n      }\n    ]\n"
            "  }\n}\n");
}

TEST(ReportEntries, AnEmptyListIsAnArrayThatElementsMayFollow) {
  EXPECT_EQ(to_json({{"first", std::vector<double>{}}}, {}), "{\n  \"first\": []\n}\n");
  EXPECT_EQ(to_json({{"first", std::vector<double>{}}, {"first.0", std::uint64_t{3}}}, {}),
            "{\n  \"first\": [\n    3\n  ]\n}\n");
}

// Keys like years, or that begin with a digit, are names and not indices of arrays.
TEST(ReportEntries, ANumberThatIsNotTheNextIndexIsAName) {
  EXPECT_EQ(to_json({{"0", 1.0}, {"by_year.2026", 1.0}, {"by_code.01", 1.0}, {"in.2_h", 1.0}}, {}),
            "{\n  \"0\": 1.0,\n  \"by_year\": {\n    \"2026\": 1.0\n  },\n"
            "  \"by_code\": {\n    \"01\": 1.0\n  },\n  \"in\": {\n    \"2_h\": 1.0\n  }\n}\n");
}

TEST(ReportEntries, CurvesAreAnArrayFromTwoOn) {
  const std::vector<ReportEntry> one = {{"points", std::uint64_t{1}}};
  EXPECT_EQ(to_json(one, {one}), "{\n  \"points\": 1\n}\n");
  EXPECT_EQ(
      to_json(one, {one, {}}),
      "{\n  \"points\": 1,\n  \"curves\": [\n    {\n      \"points\": 1\n    },\n    {}\n  ]\n}\n");
}

TEST(ReportEntries, AKeyThatDoesNotFitIsNamed) {
  const std::vector<ReportEntry> number_first = {{"a", 1.0}, {"a.b", 1.0}};
  const std::vector<ReportEntry> gap = {{"list.0", 1.0}, {"list.2", 1.0}};
  const std::vector<ReportEntry> name = {{"list.0", 1.0}, {"list.huge", 1.0}};
  for (const auto& entries : {number_first, gap, name}) {
    try {
      to_json(entries, {});
      ADD_FAILURE() << entries[1].key;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("\"" + entries[1].key + "\""), std::string::npos);
    }
  }
}

TEST(ReportEntries, AppendedOnesAreInTheirGroup) {
  std::vector<ReportEntry> all = {{"points", 1.0}};
  append(all, "other.", {{"points", 2.0}, {"at.x", 3.0}});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].key, "other.points");
  EXPECT_EQ(all[2].key, "other.at.x");
}

}  // namespace
}  // namespace talweg
