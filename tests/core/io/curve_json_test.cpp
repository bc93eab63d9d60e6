// Curves in Talweg's JSON and in 3D Slicer's markups.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/curve_files.hpp"

namespace talweg {
namespace {

using CurveJson = test::CurveFiles;
using CurveSlicer = test::CurveFiles;

std::string ours(const std::string& points) {
  return "{\"format\": \"talweg-curves\", \"version\": 1, \"curves\": [{\"closed\": false, "
         "\"points\": [" +
         points + "]}]}";
}

TEST_F(CurveJson, ReadsTheDocumentedForm) {
  const auto curves =
      read("a.json", ours("{\"face\": 12, \"barycentric\": [0.25, 0.25, 0.5], \"xyz\": [1, 2, 3]},"
                          "{\"face\": 0, \"barycentric\": [1, 0, 0], \"more\": {\"x\": [1]}}"));
  ASSERT_EQ(curves.size(), 1U);
  const auto& points = std::get<std::vector<FaceCoordinates>>(curves[0].points);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].face, FaceId{12});
  EXPECT_EQ(points[0].barycentric, (std::array<double, 3>{0.25, 0.25, 0.5}));
  EXPECT_EQ(points[1].barycentric, (std::array<double, 3>{1, 0, 0}));
}

TEST_F(CurveJson, IsWrittenInTheDocumentedForm) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::grid(1, 1));
  const std::vector<SurfaceCurve> curves{test::vertex_walk(mesh, 0, 2)};
  write_curves(path("a.json"), mesh, curves);
  const auto root = nlohmann::json::parse(bytes_of(path("a.json")));
  EXPECT_EQ(root.at("format"), "talweg-curves");
  EXPECT_EQ(root.at("version"), 1);
  const auto& point = root.at("curves").at(0).at("points").at(0);
  EXPECT_EQ(point.at("face"), 0);
  EXPECT_EQ(point.at("barycentric"), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(point.at("xyz"), (std::vector<double>{0, 0, 0}));
}

TEST_F(CurveJson, RefusesInvalidJson) {
  expect_refused("a.json", "{", {"line 1", "not valid JSON"});
  expect_refused("a.json", "{\n \"format\": ,\n}", {"line 2, column 12"});
  expect_refused("a.json", "{\"format\": NaN}", {"line 1"});
  expect_refused("a.json", std::string("\xFF\xFE\0a", 4), {"UTF-16"});
  expect_refused("a.json", "[1e999]", {"too large"});
  expect_refused("a.json", std::string(100000, '['), {"64 levels"});
  std::string nested;
  for (int k = 0; k < 50000; ++k) nested += "{\"a\":";
  expect_refused("a.json", nested, {"64 levels"});
}

TEST_F(CurveJson, NamesThePlaceOfWrongTypes) {
  const std::string good = "{\"face\": 1, \"barycentric\": [1, 0, 0]}";
  expect_refused("a.json", "[]", {"top level", "format"});
  expect_refused("a.json", "{\"format\": \"other\"}", {"format", "\"other\""});
  expect_refused("a.json", "{\"format\": \"talweg-curves\", \"version\": 2, \"curves\": []}",
                 {"version", "2"});
  expect_refused("a.json", "{\"format\": \"talweg-curves\", \"version\": 1}",
                 {"'curves' is missing"});
  expect_refused("a.json", "{\"format\": \"talweg-curves\", \"version\": 1, \"curves\": []}",
                 {"curves", "at least one"});
  expect_refused("a.json", "{\"format\": \"talweg-curves\", \"version\": 1, \"curves\": [3]}",
                 {"curves[0]", "closed"});
  expect_refused("a.json", ours(""), {"curves[0].points", "at least one"});
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"{\"face\": -1, \"barycentric\": [1, 0, 0]}", "points[1].face"},
      {"{\"face\": 1.5, \"barycentric\": [1, 0, 0]}", "points[1].face"},
      {"{\"face\": \"1\", \"barycentric\": [1, 0, 0]}", "points[1].face"},
      {"{\"face\": 4294967295, \"barycentric\": [1, 0, 0]}", "points[1].face"},
      {"{\"face\": 99999999999999999999, \"barycentric\": [1, 0, 0]}", "points[1].face"},
      {"{\"barycentric\": [1, 0, 0]}", "'face' is missing"},
      {"{\"face\": 1}", "'barycentric' is missing"},
      {"{\"face\": 1, \"barycentric\": [1, 0]}", "points[1].barycentric: expected three"},
      {"{\"face\": 1, \"barycentric\": [1, 0, null]}", "points[1].barycentric[2]"},
      {"{\"face\": 1, \"barycentric\": {}}", "points[1].barycentric: expected an array"},
      {"{\"face\": 1, \"barycentric\": [1, 0, 0], \"xyz\": [1, 2]}", "points[1].xyz"},
      {"[]", "curves[0].points[1]"}};
  for (const auto& [point, place] : wrong) {
    expect_refused("a.json", ours(good + "," + point), {place});
  }
}

TEST_F(CurveJson, SurvivesDamage) {
  const std::string bytes = ours("{\"face\": 12, \"barycentric\": [0.25, 0.25, 0.5]}");
  try_every_prefix("a.json", bytes);
  try_damaged("a.json", bytes, 600);
}

std::string markups(const std::string& type, const std::string& system, const std::string& points) {
  return "{\"@schema\": \"https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/"
         "Markups/Resources/Schema/markups-schema-v1.0.3.json#\", \"markups\": [{\"type\": \"" +
         type + "\", " + system + "\"coordinateUnits\": \"mm\", \"controlPoints\": [" + points +
         "]}]}";
}

const std::string kTwo =
    "{\"id\": \"1\", \"position\": [1, 2, 3], \"locked\": true, \"positionStatus\": \"defined\"},"
    "{\"id\": \"2\", \"position\": [4.5, 5, 6], \"locked\": false}";

TEST_F(CurveSlicer, LpsIsTheMeshesOwnFrame) {
  for (const char* system : {"", "\"coordinateSystem\": \"LPS\", "}) {
    const auto curves = read("a.mrk.json", markups("Curve", system, kTwo));
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_FALSE(curves[0].closed);
    EXPECT_EQ(test::positions(curves[0]), (std::vector<Point>{{1, 2, 3}, {4.5, 5, 6}}));
    EXPECT_EQ(curves[0].pins, (std::vector<std::size_t>{0}));
  }
}

// RAS and LPS differ by a half turn about the third axis.
TEST_F(CurveSlicer, RasIsConvertedToLps) {
  const auto curves =
      read("a.mrk.json", markups("ClosedCurve", "\"coordinateSystem\": \"RAS\", ", kTwo));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(test::positions(curves[0]), (std::vector<Point>{{-1, -2, 3}, {-4.5, -5, 6}}));
}

TEST_F(CurveSlicer, PointsWithoutPositionAreLeftOut) {
  const auto curves =
      read("a.mrk.json",
           markups("Curve", "", "{\"positionStatus\": \"undefined\", \"locked\": true}," + kTwo));
  EXPECT_EQ(test::positions(curves.at(0)).size(), 2U);
  EXPECT_EQ(curves[0].pins, (std::vector<std::size_t>{0}));
}

/// Reads the markup of kTwo with these units ("" for none) in the unit `mesh`.
std::vector<Point> in_units(const std::filesystem::path& path, const std::string& units,
                            const char* mesh) {
  std::string text = markups("Curve", "\"coordinateSystem\": \"RAS\", ", kTwo);
  const std::string mm = "\"coordinateUnits\": \"mm\", ";
  const std::string member = units.empty() ? "" : "\"coordinateUnits\": " + units + ", ";
  text.replace(text.find(mm), mm.size(), member);
  return test::positions(read_curves(path, text, LengthUnit::named(mesh)).at(0));
}

TEST_F(CurveSlicer, PositionsAreConvertedToTheUnitOfTheMesh) {
  const auto expect = [&](const char* units, const char* mesh, double scale) {
    const std::vector<Point> found = in_units("a.mrk.json", units, mesh);
    ASSERT_EQ(found.size(), 2U);
    const Point p = scale * Point(-1, -2, 3), q = scale * Point(-4.5, -5, 6);
    EXPECT_LT((found[0] - p).norm(), 1e-15 * p.norm()) << units << " to " << mesh;
    EXPECT_LT((found[1] - q).norm(), 1e-15 * q.norm()) << units << " to " << mesh;
  };
  expect("", "mm", 1);
  expect("", "m", 1e-3);
  expect("\"mm\"", "mm", 1);
  expect("\"cm\"", "mm", 10);
  expect("\"m\"", "mm", 1000);
  expect("\"um\"", "mm", 1e-3);
  expect("\"\u00b5m\"", "mm", 1e-3);
  expect("\"nm\"", "um", 1e-3);
  expect("\"cm\"", "cm", 1);
  expect("\"m\"", "km", 1e-3);
  expect("\"[in_i]\"", "cm", 2.54);
  expect("[\"um\", \"UCUM\", \"micrometer\"]", "mm", 1e-3);
  // Equal units leave the numbers unchanged.
  EXPECT_EQ(in_units("a.mrk.json", "\"um\"", "um"),
            (std::vector<Point>{{-1, -2, 3}, {-4.5, -5, 6}}));
}

TEST_F(CurveSlicer, UnitsThatAreUnknownAreRefused) {
  const auto refuse = [&](const char* units, std::vector<const char*> words) {
    try {
      in_units("a.mrk.json", units, "mm");
      FAIL() << units;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      for (const char* word : words) {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
      }
    }
  };
  refuse("\"furlong\"", {"a.mrk.json", "coordinateUnits", "furlong"});
  refuse("\"\"", {"coordinateUnits"});
  refuse("3", {"coordinateUnits", "string"});
  refuse("[\"mm\"]", {"coordinateUnits"});
  refuse("[\"mm\", \"DCM\", \"\"]", {"coordinateUnits", "DCM"});
  EXPECT_THROW(LengthUnit::named(""), Error);
  EXPECT_THROW(LengthUnit::named("MM"), Error);
}

TEST_F(CurveSlicer, IsAlsoRecognizedByContent) {
  EXPECT_EQ(read("a.json", markups("Curve", "", kTwo)).size(), 1U);
}

TEST_F(CurveSlicer, IsWrittenAsTheSchemaAsks) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh), test::walk(mesh)};
  write_curves(path("a.mrk.json"), mesh, curves);
  const auto root = nlohmann::json::parse(bytes_of(path("a.mrk.json")));
  EXPECT_NE(root.at("@schema").get<std::string>().find("markups-schema-v1.0.3.json"),
            std::string::npos);
  const auto& first = root.at("markups").at(0);
  EXPECT_EQ(first.at("type"), "ClosedCurve");
  EXPECT_EQ(root.at("markups").at(1).at("type"), "Curve");
  EXPECT_EQ(first.at("coordinateSystem"), "LPS");
  EXPECT_EQ(first.at("coordinateUnits"), "mm");
  EXPECT_EQ(first.at("controlPoints").size(), curves[0].points.size());
  EXPECT_TRUE(first.at("controlPoints").at(0).at("position").is_array());
  EXPECT_EQ(first.at("controlPoints").at(0).at("locked"), false);
  write_curves(path("a.mrk.json"), mesh, curves, LengthUnit::named("um"));
  const auto again = nlohmann::json::parse(bytes_of(path("a.mrk.json")));
  EXPECT_EQ(again.at("markups").at(0).at("coordinateUnits"), "um");
  EXPECT_EQ(again.at("markups").at(0).at("controlPoints"), first.at("controlPoints"));
}

TEST_F(CurveSlicer, RefusesMalformedFiles) {
  expect_refused("a.mrk.json", markups("Fiducial", "", kTwo), {"markups", "Curve", "Fiducial"});
  expect_refused("a.mrk.json", "{\"markups\": {}}", {"markups", "array"});
  expect_refused("a.mrk.json", "{\"markups\": [{}]}", {"markups[0]", "'type'"});
  expect_refused("a.mrk.json", markups("Curve", "", ""), {"controlPoints", "at least one"});
  expect_refused("a.mrk.json", markups("Curve", "\"coordinateSystem\": \"XYZ\", ", kTwo),
                 {"coordinateSystem", "\"XYZ\""});
  expect_refused("a.mrk.json", markups("Curve", "\"coordinateSystem\": 1, ", kTwo),
                 {"coordinateSystem", "string"});
  expect_refused("a.mrk.json", markups("Curve", "", kTwo + ", {\"position\": [1, 2]}"),
                 {"controlPoints[2].position", "three"});
  expect_refused("a.mrk.json", markups("Curve", "", kTwo + ", {}"),
                 {"controlPoints[2]", "position"});
  expect_refused("a.mrk.json",
                 markups("Curve", "", "{\"position\": [1, 2, 3], \"locked\": \"yes\"}"),
                 {"controlPoints[0].locked", "true or false"});
}

}  // namespace
}  // namespace talweg
