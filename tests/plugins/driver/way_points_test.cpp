// Way-points from draw to smooth: the commands that make them, the options that replace them, and
// the options that do not apply to them.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

using nlohmann::json;

class DriverWayPoints : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("hills.ply"), hills_);
    succeed("draw hills.ply --through 130,760,1500 -o d.json -o d.vtp -o d.vtk -o d.obj -o d.txt");
    succeed("draw hills.ply --through 130,760,1500 --points rough -o r.json -o r.vtp -o r.vtk");
  }

  void succeed(const std::string& arguments) const {
    const Outcome outcome = run("-q " + arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "") << arguments;
  }
  [[nodiscard]] json read(const std::string& name) const {
    return json::parse(bytes_of(file(name)));
  }
  /// The bytes of the result.
  std::string smoothed(const std::string& arguments) const {
    succeed("smooth hills.ply -o out.json --report report.json --curve " + arguments);
    return bytes_of(file("out.json"));
  }
  [[nodiscard]] json warnings() const { return read("report.json").at("warnings"); }
  /// Whether the last result has a point at the vertex.
  [[nodiscard]] bool passes(std::size_t vertex) const {
    const Point& p = hills_.points[vertex];
    const json points = read("out.json").at("curves").at(0).at("points");
    return std::any_of(points.begin(), points.end(), [&](const json& point) {
      return point.at("xyz") == std::vector<double>{p.x(), p.y(), p.z()};
    });
  }
  /// How far the vertex is from the last result.
  [[nodiscard]] double away(std::size_t vertex) const {
    const json points = read("out.json").at("curves").at(0).at("points");
    double least = 1e9;
    for (const json& point : points) {
      const auto xyz = point.at("xyz").get<std::vector<double>>();
      least = std::min(least, (hills_.points[vertex] - Point(xyz[0], xyz[1], xyz[2])).norm());
    }
    return least;
  }

  const MeshLists hills_ = test::hills(40);
};

TEST_F(DriverWayPoints, DrawWritesThoseThatAreGiven) {
  std::vector<std::size_t> exact;
  const json points = read("d.json").at("curves").at(0).at("points");
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points[k].contains("exact")) continue;
    EXPECT_EQ(points[k]["exact"], true);
    exact.push_back(k);
  }
  ASSERT_EQ(exact.size(), 3U);
  EXPECT_EQ(exact.front(), 0U);
  EXPECT_EQ(exact.back(), points.size() - 1);
  const Point& middle = hills_.points[760];
  EXPECT_EQ(points[exact[1]]["xyz"], (std::vector<double>{middle.x(), middle.y(), middle.z()}));
  for (const char* name : {"d.json", "d.vtp", "d.vtk"}) {
    const std::vector<CurveInput> curves = read_curves(file(name));
    ASSERT_EQ(curves.at(0).way_points.size(), 3U) << name;
    EXPECT_EQ(curves[0].way_points[1].point, exact[1]) << name;
    EXPECT_EQ(curves[0].way_points[1].tolerance, 0) << name;
  }
}

/// Two planes that meet in a crease at y = 15.
MeshLists roof() {
  MeshLists lists = test::grid(40, 30);
  for (Point& p : lists.points) p.z() = -0.6 * std::abs(p.y() - 15);
  return lists;
}

TEST_F(DriverWayPoints, RidgesMoveDrawingsAndTheirClicks) {
  write_mesh(file("roof.ply"), roof());
  // The vertices (5, 13), (20, 16) and (35, 13).
  const std::string through = "draw roof.ply --through 538,676,568 ";
  succeed(through + "-o as_drawn.json");
  succeed(through + "--ridges 0 -o nothing.json");
  EXPECT_EQ(bytes_of(file("as_drawn.json")), bytes_of(file("nothing.json")));
  const Outcome told = run(through + "--ridges 1 -o ridge.json");
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_NE(told.out.find("100 % of curve 0 were moved onto ridges"), std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("3 of its clicks moved, too"), std::string::npos) << told.out;
  const json moved = read("ridge.json");
  for (const json& point : moved.at("curves").at(0).at("points")) {
    EXPECT_EQ(point.at("xyz").at(1), 15);
  }
  const CurveInput curve = read_curves(file("ridge.json")).at(0);
  EXPECT_EQ(curve.way_points.size(), 3U);
  EXPECT_FALSE(curve.painted.empty());
}

TEST_F(DriverWayPoints, RidgesMoveADrawingASecondTime) {
  write_mesh(file("roof.ply"), roof());
  succeed("draw roof.ply --through 538,676,568 --ridges 1 --ridge-band 2 -o once.json");
  succeed("smooth roof.ply --curve once.json --ridges 1 --ridge-band 6 -o twice.json");
  const json twice = read("twice.json");
  for (const json& point : twice.at("curves").at(0).at("points")) {
    const double x = point.at("xyz").at(0), y = point.at("xyz").at(1);
    EXPECT_NEAR(y, 15, x < 30 ? 0.3 : 1.2) << x;  // docs/ridges.md: ends may lie beside it
  }
}

TEST_F(DriverWayPoints, SmoothReportsWhatRidgesMoved) {
  write_mesh(file("roof.ply"), roof());
  succeed("draw roof.ply --through 538,676,568 --points rough -o stroke.json");
  succeed("smooth roof.ply --curve stroke.json --ridges 1 -o out.json --report report.json");
  const json report = read("report.json");
  EXPECT_EQ(report.at("ridge_strength"), 1);
  EXPECT_GT(report.at("ridge_moved"), 0.75);
  EXPECT_GT(report.at("ridge_moved_max"), 1);
  EXPECT_NE(warnings().dump().find("were moved onto ridges"), std::string::npos);
  const json smoothed = read("out.json");
  for (const json& point : smoothed.at("curves").at(0).at("points")) {
    const double x = point.at("xyz").at(0), y = point.at("xyz").at(1);
    EXPECT_NEAR(y, 15, x < 30 ? 0.2 : 1.2) << x;  // docs/ridges.md: ends may lie beside it
  }
  succeed(
      "smooth roof.ply --curve stroke.json --ridges 1 --ridge-kind concave -o out.json "
      "--report report.json");
  EXPECT_EQ(read("report.json").at("ridge_moved"), 0);
  succeed("smooth roof.ply --curve stroke.json --report report.json");
  EXPECT_FALSE(read("report.json").contains("ridge_moved"));
  EXPECT_EQ(run("smooth roof.ply --curve stroke.json --ridges 2").code, 1);
  EXPECT_EQ(run("smooth roof.ply --curve stroke.json --ridges 1 --ridge-band 0").code, 1);
}

TEST_F(DriverWayPoints, DrawOfALoopOrStraightMarksEachGivenPointOnce) {
  for (const char* options : {"--closed", "--straight", "--closed --straight"}) {
    succeed(std::string("draw hills.ply --through 400,430,1200,1180 -o o.json ") + options);
    EXPECT_EQ(read_curves(file("o.json")).at(0).way_points.size(), 4U) << options;
  }
}

TEST_F(DriverWayPoints, RoughDrawingsAreThePathAlone) {
  for (const char* name : {"r.json", "r.vtp", "r.vtk"}) {
    EXPECT_EQ(bytes_of(file(name)).find("exact"), std::string::npos) << name;
  }
  json path = read("d.json");
  for (json& point : path["curves"][0]["points"]) point.erase("exact");
  EXPECT_EQ(read("r.json"), path);
}

TEST_F(DriverWayPoints, DrawTellsWhichFilesAreStrokes) {
  const std::string draw = "draw hills.ply --through 130,760 ";
  EXPECT_EQ(run(draw + "-o a.obj -o a.json -o a.txt").out,
            "a.obj, a.txt: written as a stroke, because only .json, .vtp and .vtk files hold "
            "way-points.\n");
  EXPECT_EQ(run(draw + "-o a.json -o a.vtp -o a.vtk").out, "");
  EXPECT_EQ(run(draw + "-o a.obj --points rough").out, "");
  EXPECT_EQ(run("-q " + draw + "-o a.obj").out, "");
  const Outcome piped = run(draw + "-o -.obj");
  EXPECT_EQ(piped.out.substr(0, 2), "v ");
  EXPECT_EQ(std::count(piped.err.begin(), piped.err.end(), '\n'), 1) << piped.err;
}

TEST_F(DriverWayPoints, SmoothTakesThemFromEveryFormatThatHoldsThem) {
  const std::string exact = smoothed("d.json");
  for (const std::size_t v : {130U, 760U, 1500U}) EXPECT_TRUE(passes(v)) << v;
  EXPECT_EQ(smoothed("d.vtp"), exact);
  EXPECT_EQ(smoothed("d.vtk"), exact);
  const std::string rough = smoothed("d.obj");
  EXPECT_FALSE(passes(760));
  for (const char* name : {"d.txt", "r.json", "r.vtp", "d.json --points rough"}) {
    EXPECT_EQ(smoothed(name), rough) << name;
  }
  EXPECT_NE(exact, rough);
}

TEST_F(DriverWayPoints, OptionPointsSetsTheWayPointsOfAnyFile) {
  const std::string exact = smoothed("d.json");
  EXPECT_EQ(smoothed("d.json --points given"), exact);
  EXPECT_EQ(smoothed("d.json --points exact"), exact);  // they stay those that it names
  for (const char* name : {"d.obj", "d.txt", "r.json", "d.json"}) {
    EXPECT_EQ(smoothed(std::string(name) + " --points exact=130,760,1500"), exact) << name;
  }
  // All points of a drawing that names none.
  smoothed("r.json --points exact");
  for (const CurveInput& curve : read_curves(file("d.txt"))) {
    for (const VertexId v : std::get<std::vector<VertexId>>(curve.points)) {
      EXPECT_TRUE(passes(v.index())) << v.index();
    }
  }
}

TEST_F(DriverWayPoints, TauZeroGoesStraightFromOneToTheNext) {
  smoothed("d.json --tau 0");
  const double legs = read("report.json").at("length_after");
  double straight = 0;
  for (const char* through : {"130,760", "760,1500"}) {
    succeed(std::string("draw hills.ply -o leg.obj --through ") + through);
    smoothed("leg.obj --tau 0");
    straight += read("report.json").at("length_after").get<double>();
  }
  EXPECT_NEAR(legs, straight, 1e-9 * straight);
}

TEST_F(DriverWayPoints, ATolerancePutsThemAside) {
  const std::string exact = smoothed("d.json");
  EXPECT_EQ(smoothed("d.json --tolerance 0"), exact);
  EXPECT_NE(smoothed("d.json --tolerance 0.5"), exact);
  EXPECT_FALSE(passes(760));
  EXPECT_LE(away(760), 0.5 + 0.25);  // the nearest point of the result, not of its segments
  EXPECT_TRUE(passes(130));          // ends stay
  // One in the file counts before it.
  json drawing = read("d.json");
  for (json& point : drawing["curves"][0]["points"]) {
    if (point.contains("exact")) point["exact"] = 0.5;
  }
  write("near.json", drawing.dump());
  EXPECT_EQ(smoothed("near.json"), smoothed("d.json --tolerance 0.5"));
  EXPECT_EQ(smoothed("near.json --tolerance 0.1"), smoothed("near.json"));
}

TEST_F(DriverWayPoints, SlackAndDeviationDoNotApplyAndTheReportSaysSo) {
  const std::string exact = smoothed("d.json");
  EXPECT_EQ(warnings(), json::array());
  EXPECT_EQ(smoothed("d.json --max-deviation 0.1"), exact);
  EXPECT_EQ(warnings(),
            json({"The largest deviation does not apply: the drawing has only way-points, between "
                  "which the result is free."}));
  EXPECT_EQ(smoothed("d.json --slack 0.1"), exact);
  EXPECT_EQ(warnings(), json({"The slack does not apply: the drawing has only way-points, between "
                              "which the result is free."}));
  EXPECT_EQ(smoothed("d.json --slack 0.1 --max-deviation 3"), exact);
  EXPECT_NE(
      warnings().at(0).get<std::string>().find("The slack and the largest deviation do not apply"),
      std::string::npos);
  smoothed("d.json --points rough --max-deviation 0.5");
  EXPECT_EQ(warnings(), json::array());
  EXPECT_LE(read("report.json").at("deviation_to_drawn_max"), 0.5);
  // They hold for the stroke of a drawing that has both.
  succeed("draw hills.ply --through 205,240 -o stroke.txt");
  succeed("smooth hills.ply --curve d.json --curve stroke.txt --slack 0.3 --report report.json");
  EXPECT_EQ(warnings(), json::array());
}

TEST_F(DriverWayPoints, RefusesInvalidPoints) {
  for (const char* points : {"sharp", "exact=", "exact=1,,2", "exact=760,", "exact=a", "exact=-1",
                             "exact=1.5", "exact=99999999999", "EXACT", "rough=1"}) {
    expect_failure(std::string("smooth hills.ply --curve d.json --points ") + points, 1,
                   {"--points must be given, exact, rough, or exact= and vertex numbers", points});
  }
  expect_failure("smooth hills.ply --curve d.json --points exact=5", 1, {"vertex 5"});
  expect_failure("smooth hills.ply --curve d.json --points exact=9999", 2, {"9999", "1681"});
  expect_failure("smooth hills.ply --curve d.json --points=", 1, {"--points", "empty"});
  for (const char* tolerance : {"-1", "nan", "inf"}) {
    expect_failure(std::string("smooth hills.ply --curve d.json --tolerance ") + tolerance, 1,
                   {"--tolerance must be 0 or more"});
  }
  expect_failure("smooth hills.ply --curve d.json --tolerance wide", 1, {"--tolerance", "wide"});
  expect_failure("draw hills.ply --through 1,2 -o a.json --points sharp", 1, {"--points", "sharp"});
  write("faces.txt", "1 2 3");
  expect_failure("smooth hills.ply --labels faces.txt --points exact -o a.json", 1,
                 {"borders of --labels are strokes"});
}

TEST_F(DriverWayPoints, CurvesAloneKeepTheirOwn) {
  succeed("draw hills.ply --through 205,240 -o e.json");
  smoothed("d.json");
  const json first = read("out.json").at("curves").at(0);
  smoothed("e.json");
  const json second = read("out.json").at("curves").at(0);
  for (const char* jobs : {"1", "2"}) {
    smoothed(std::string("d.json --curve e.json --independent --jobs ") + jobs);
    EXPECT_EQ(read("out.json").at("curves"), json({first, second})) << jobs;
  }
}

TEST_F(DriverWayPoints, AListSaysItPerLine) {
  write("list.csv",
        "mesh,curve,points,tolerance,name\n"
        "hills.ply,d.json,,,given\n"
        "hills.ply,d.json,rough,,rough\n"
        "hills.ply,d.obj,\"exact=130,760,1500\",,exact\n"
        "hills.ply,d.json,,0.5,near\n");
  succeed("smooth --batch list.csv -o 'out/{name}.json'");
  const auto result = [&](const char* name) {
    return bytes_of(file(std::string("out/") + name + ".json"));
  };
  EXPECT_EQ(result("given"), smoothed("d.json"));
  EXPECT_EQ(result("exact"), result("given"));
  EXPECT_EQ(result("rough"), smoothed("d.obj"));
  EXPECT_EQ(result("near"), smoothed("d.json --tolerance 0.5"));
  write("list.csv", "mesh,curve,points\nhills.ply,d.json,sharp\n");
  expect_failure("smooth --batch list.csv -o a.json", 2, {"line 2", "--points", "sharp"});
}

TEST_F(DriverWayPoints, FollowARepairedMesh) {
  MeshLists lists = test::with_turned_face(hills_, 300);
  lists.triangles.insert(lists.triangles.begin() + 3, {7, 7, 8});
  write_mesh(file("broken.ply"), lists);
  succeed("draw broken.ply --repair --through 130,760,1500 -o b.json");
  EXPECT_EQ(read_curves(file("b.json")).at(0).way_points.size(), 3U);
  for (const char* curve : {"b.json", "d.txt --points exact=130,760,1500"}) {
    succeed(std::string("smooth broken.ply --repair -o out.json --curve ") + curve);
    for (const std::size_t v : {130U, 760U, 1500U}) EXPECT_TRUE(passes(v)) << curve << v;
  }
}

std::string markups_of(const std::vector<Point>& points) {
  json controls = json::array();
  for (const Point& p : points) controls.push_back({{"position", {p.x(), p.y(), p.z()}}});
  return json{{"markups", {{{"type", "Curve"}, {"controlPoints", controls}}}}}.dump();
}

TEST_F(DriverWayPoints, FewControlPointsOfSlicerAreWayPointsAndManyAStroke) {
  std::vector<Point> few, dense;
  for (const std::size_t v : {130U, 760U, 1500U}) few.push_back(hills_.points[v]);
  for (const CurveInput& curve : read_curves(file("d.txt"))) {
    for (const VertexId v : std::get<std::vector<VertexId>>(curve.points)) {
      dense.push_back(hills_.points[v.index()]);
    }
  }
  write("few.mrk.json", markups_of(few));
  write("dense.mrk.json", markups_of(dense));
  smoothed("few.mrk.json");
  EXPECT_EQ(warnings().dump().find("stroke"), std::string::npos) << warnings();
  for (const std::size_t v : {130U, 760U, 1500U}) EXPECT_TRUE(passes(v)) << v;
  EXPECT_EQ(smoothed("dense.mrk.json"), smoothed("d.obj"));
  smoothed("dense.mrk.json");
  EXPECT_NE(warnings().dump().find("closer than 2 they are taken as a stroke"), std::string::npos)
      << warnings();
  smoothed("dense.mrk.json --points rough");
  EXPECT_EQ(warnings(), json::array());
}

}  // namespace
}  // namespace talweg
