// Way-points and painted points in curve files.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/curve_files.hpp"
#include "talweg/core/drawing/point_marks.hpp"

namespace talweg {
namespace {

using CurveMarks = test::CurveFiles;
using Marks = std::vector<double>;

constexpr double kTolerance = 0.1 + 0.2;  // has no short decimal form

/// A loop and an open curve with marks, and a curve without marks.
std::vector<PlacedCurve> marked_curves(const SurfaceMesh& mesh) {
  std::vector<PlacedCurve> curves{place(mesh, test::ring(mesh)), place(mesh, test::walk(mesh)),
                                  place(mesh, test::vertex_walk(mesh, 40, 3))};
  curves[0].exact.assign(curves[0].positions.size(), 0);
  curves[1].exact = {0, kNotSaid, kPainted, kTolerance};
  return curves;
}

std::vector<Marks> marks_of_all(const std::vector<CurveInput>& curves) {
  std::vector<Marks> marks;
  for (const CurveInput& curve : curves) marks.push_back(marks_of(curve));
  return marks;
}

TEST_F(CurveMarks, ComeBackFromFilesThatHoldThem) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<PlacedCurve> curves = marked_curves(mesh);
  for (const char* name : {"a.json", "a.vtp", "a.vtk"}) {
    EXPECT_TRUE(holds_way_points(name));
    write_curves(path(name), curves);
    const std::vector<CurveInput> back = read_curves(path(name));
    EXPECT_EQ(marks_of_all(back), (std::vector<Marks>{curves[0].exact, curves[1].exact, {}}))
        << name;
    EXPECT_EQ(back.at(1).way_points.at(1).point, 3U);
    EXPECT_EQ(back.at(1).way_points.at(1).tolerance, kTolerance);
    EXPECT_EQ(back.at(1).painted, std::vector<std::size_t>{2});
  }
}

TEST_F(CurveMarks, AreLeftOutInOtherFormats) {
  const SurfaceMesh mesh = test::odd_sphere();
  std::vector<PlacedCurve> plain = marked_curves(mesh), marked = plain;
  for (PlacedCurve& curve : plain) curve.exact.clear();
  for (const char* name : {"a.obj", "a.ply", "a.mrk.json"}) {
    EXPECT_FALSE(holds_way_points(name));
    EXPECT_EQ(curve_bytes(name, marked), curve_bytes(name, plain)) << name;
  }
  EXPECT_FALSE(holds_way_points("a.txt"));
}

TEST_F(CurveMarks, UnmarkedCurvesGiveFilesWithoutMarks) {
  const SurfaceMesh mesh = test::odd_sphere();
  std::vector<PlacedCurve> plain = marked_curves(mesh);
  for (PlacedCurve& curve : plain) curve.exact.clear();
  std::vector<PlacedCurve> unsaid = plain;
  for (PlacedCurve& curve : unsaid) curve.exact.assign(curve.positions.size(), kNotSaid);
  for (const char* name : {"a.json", "a.vtp", "a.vtk"}) {
    const std::string bytes = curve_bytes(name, plain);
    EXPECT_EQ(bytes.find("exact"), std::string::npos) << name;
    EXPECT_EQ(curve_bytes(name, unsaid), bytes) << name;
  }
}

TEST_F(CurveMarks, AreInJsonAsDocumented) {
  const SurfaceMesh mesh = test::odd_sphere();
  write_curves(path("a.json"), marked_curves(mesh));
  const auto root = nlohmann::json::parse(bytes_of(path("a.json")));
  EXPECT_EQ(root.at("version"), 1);
  const auto& points = root.at("curves").at(1).at("points");
  EXPECT_EQ(points.at(0).at("exact"), true);
  EXPECT_FALSE(points.at(1).contains("exact"));
  EXPECT_EQ(points.at(2).at("exact"), false);
  EXPECT_EQ(points.at(3).at("exact"), kTolerance);
}

std::string json_with(const std::string& exact) {
  return R"({"format": "talweg-curves", "version": 1, "author": {"name": "A"}, "curves": [
  {"closed": false, "colour": [1, 0, 0], "points": [
    {"face": 0, "barycentric": [1, 0, 0], "exact": )" +
         exact + R"(, "note": "a click"}, {"face": 0, "barycentric": [0, 1, 0]}]}]})";
}

TEST_F(CurveMarks, UnknownMembersAreIgnored) {
  const auto curves = read("a.json", json_with("true"));
  EXPECT_EQ(marks_of_all(curves), (std::vector<Marks>{{0, kNotSaid}}));
  EXPECT_EQ(marks_of_all(read("a.json", json_with("0"))), marks_of_all(curves));
}

TEST_F(CurveMarks, InvalidMarksAreRefusedWithTheirPlace) {
  for (const char* bad : {"-1", "-0.5", "null", "\"yes\"", "[0]", "{}"}) {
    expect_refused("a.json", json_with(bad),
                   {"curves[0].points[0].exact", "true, false or a tolerance of 0 or more"});
  }
}

std::string vtk_with(const std::string& data) {
  return "# vtk DataFile Version 3.0\na title\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
         "0 0 0 1 0 0 1 1 0\nLINES 1 4\n3 0 1 2\n" +
         data;
}

TEST_F(CurveMarks, AreReadBesideOtherDataOfVtk) {
  const std::string cells = "CELL_DATA 1\nSCALARS exact float\nLOOKUP_TABLE default\n7\n";
  const std::string normals = "NORMALS n float\n0 0 1 0 0 1 0 0 1\n";
  for (const char* exact : {"SCALARS exact double 1\nLOOKUP_TABLE default\n0 -1 0.5\n",
                            "FIELD FieldData 1\nexact 1 3 double\n0 -1 0.5\n"}) {
    const auto curves = read("a.vtk", vtk_with(cells + "POINT_DATA 3\n" + normals + exact));
    EXPECT_EQ(marks_of_all(curves), (std::vector<Marks>{{0, kNotSaid, 0.5}})) << exact;
  }
  EXPECT_EQ(marks_of_all(read("a.vtk", vtk_with(cells))), (std::vector<Marks>{{}}));
}

TEST_F(CurveMarks, AMarkOfTheRepeatedPointOfALoopCounts) {
  // VTK repeats the first point of a loop, and other programs may repeat its coordinates.
  const std::string file =
      "# vtk DataFile Version 3.0\na title\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
      "0 0 0 1 0 0 1 1 0 0 0 0\nLINES 1 5\n4 0 1 2 3\n"
      "POINT_DATA 4\nFIELD FieldData 1\nexact 1 4 double\n-1 0 -2 0\n";
  const auto curves = read("a.vtk", file);
  EXPECT_TRUE(curves.at(0).closed);
  EXPECT_EQ(marks_of_all(curves), (std::vector<Marks>{{0, 0, kPainted}}));
}

TEST_F(CurveMarks, InvalidOrMissingMarksAreRefusedInVtk) {
  const auto refuse = [&](const std::string& values, const std::vector<std::string>& parts) {
    const auto n = std::to_string(std::count(values.begin(), values.end(), ' ') + 1);
    expect_refused(
        "a.vtk",
        vtk_with("POINT_DATA 3\nFIELD FieldData 1\nexact 1 " + n + " double\n" + values + "\n"),
        parts);
  };
  refuse("0 -3 0", {"exact of point 1 is -3", "a tolerance of 0 or more (a way-point)"});
  refuse("0 0 -0.5", {"exact of point 2 is -0.5"});
  refuse("0 nan 0", {"line 12", "expected a finite number, found 'nan'"});
  refuse("0 inf 0", {"line 12", "expected a finite number, found 'inf'"});
  refuse("0 0", {"one number exact for each of 3 points, found 2"});
}

TEST_F(CurveMarks, InvalidOrMissingMarksAreRefusedInVtp) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::string good = curve_bytes("a.vtp", marked_curves(mesh));
  const std::size_t from = good.find("Name=\"exact\""), to = good.find("</DataArray>", from);
  ASSERT_NE(from, std::string::npos);
  const auto with = [&](const std::string& values) {
    return good.substr(0, good.find('>', from) + 1) + "\n" + values + good.substr(to);
  };
  std::size_t points = 0;
  for (const PlacedCurve& curve : marked_curves(mesh)) points += curve.positions.size();
  std::string values;
  for (std::size_t k = 0; k < points; ++k) values += k == 2 ? "-7\n" : "0\n";
  expect_refused("a.vtp", with(values), {"exact of point 2 is -7"});
  expect_refused("a.vtp", with("0 0\n"), {"one number exact for each of", "found 2"});
}

TEST_F(CurveMarks, SlicersControlPointsAreRecognized) {
  const auto curves = read("a.mrk.json",
                           R"({"markups": [{"type": "Curve", "controlPoints": [
      {"position": [1, 2, 3]}, {"position": [4, 5, 6]}]}]})");
  EXPECT_TRUE(curves.at(0).control_points);
  EXPECT_EQ(marks_of_all(curves), (std::vector<Marks>{{kControl, kControl}}));
}

TEST_F(CurveMarks, SurviveDamage) {
  const SurfaceMesh mesh = test::odd_sphere();
  for (const char* name : {"a.json", "a.vtp", "a.vtk"}) {
    try_damaged(name, curve_bytes(name, marked_curves(mesh)), 300);
  }
}

}  // namespace
}  // namespace talweg
