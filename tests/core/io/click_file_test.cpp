// Lists of points of 3D Slicer, as clicks and as curves.
#include "talweg/core/io/click_file.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/curve_files.hpp"

namespace talweg {
namespace {

const CoordinateFrame kInRas{LengthUnit(), PatientSpace::kRas};
const std::string kColumns =
    "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
const std::string kPoints =
    "vtkMRMLMarkupsFiducialNode_0,1,2,3,0,0,0,1,1,1,0,F-1,,vtkMRMLScalarVolumeNode1\n"
    "vtkMRMLMarkupsFiducialNode_1,4,5,6,0,0,0,1,1,1,1,\"left, \"\"upper\"\" rim\",\"a, b\",\n"
    "\n"
    "2,-7.5,8e1,+9,0,0,0,1,1,1,0,F-3,,\n";

class ClickFiles : public test::CurveFiles {
 protected:
  [[nodiscard]] std::vector<Point> clicks(const std::string& name, const std::string& bytes,
                                          const CoordinateFrame& frame = {}) const {
    return test::positions(read_clicks(path(name), bytes, frame));
  }
  void expect_no_clicks(const std::string& name, const std::string& bytes,
                        const std::vector<std::string>& parts) const {
    try {
      read_clicks(path(name), bytes);
      ADD_FAILURE() << "not refused: " << bytes;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      for (const std::string& part : parts) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      }
    }
  }
};

TEST_F(ClickFiles, FcsvOfBothHeadersIsRead) {
  const std::string version = "# Markups fiducial file version = 4.11\n";
  const std::vector<Point> as_is{{1, 2, 3}, {4, 5, 6}, {-7.5, 80, 9}};
  const std::vector<Point> turned{{-1, -2, 3}, {-4, -5, 6}, {7.5, -80, 9}};
  for (const char* lps : {"LPS", "1"}) {
    const std::string bytes = version + "# CoordinateSystem = " + lps + "\r\n" + kColumns + kPoints;
    EXPECT_EQ(clicks("a.fcsv", bytes), as_is) << lps;
    EXPECT_EQ(clicks("a.fcsv", bytes, kInRas), turned) << lps;
  }
  for (const char* ras : {"# CoordinateSystem = RAS\n", "# CoordinateSystem = 0\n", ""}) {
    const std::string bytes = version + ras + kColumns + kPoints;
    EXPECT_EQ(clicks("a.fcsv", bytes), turned) << ras;
    EXPECT_EQ(clicks("a.fcsv", bytes, kInRas), as_is) << ras;
  }
  EXPECT_EQ(clicks("a.fcsv", "# CoordinateSystem = LPS\n" + kPoints, LengthUnit::named("cm"))[2],
            Point(-0.75, 8, 0.9));
}

TEST_F(ClickFiles, FcsvOfSlicer3IsRead) {
  const std::string bytes =
      "# Fiducial List file /tmp/F.fcsv\n# version = 2\n# name = F\n# numPoints = 2\n# "
      "symbolScale = 5\n# visibility = 1\n# textScale = 4.5\n# color = 0.4,1,1\n# selectedColor = "
      "1,0.5,0.5\n# columns = label,x,y,z,sel,vis\nF1,10,20,30,1,1\nF2,40,50,60,1,1\n";
  EXPECT_EQ(clicks("a.fcsv", bytes, kInRas), (std::vector<Point>{{10, 20, 30}, {40, 50, 60}}));
}

TEST_F(ClickFiles, ColumnsAreFoundByTheirNames) {
  EXPECT_EQ(clicks("a.fcsv", "# columns = z,lock,y,x\n3,1,2,1\n6,0,5,4\n", kInRas),
            (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  const CurveInput read = read_clicks(path("a.fcsv"), "# columns = z,lock,y,x\n3,0,2,1\n6,1,5,4\n");
  EXPECT_EQ(read.pins, (std::vector<std::size_t>{1}));
  EXPECT_TRUE(read.control_points);
  EXPECT_FALSE(read.closed);
}

TEST_F(ClickFiles, FcsvIsAlsoReadAsACurve) {
  const auto curves = read("a.fcsv", "# CoordinateSystem = LPS\n" + kPoints);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(test::positions(curves[0]).size(), 3U);
  EXPECT_EQ(curves[0].pins, std::vector<std::size_t>{});  // no column is named lock
}

TEST_F(ClickFiles, RefusesMalformedFcsv) {
  expect_refused("a.fcsv", "# CoordinateSystem = IJK\n" + kPoints, {"line 1", "LPS", "IJK"});
  expect_refused("a.fcsv", "# CoordinateSystem = 2\n" + kPoints, {"line 1", "LPS"});
  expect_refused("a.fcsv", kColumns, {"no points"});
  expect_refused("a.fcsv", "1,2,3\n", {"line 1", "x, y and z"});
  expect_refused("a.fcsv", "1,2,3,x\n", {"line 1", "coordinate"});
  expect_refused("a.fcsv", "a,1,2,3\nb,1,,3\n", {"line 2", "coordinate"});
  expect_refused("a.fcsv", "a,1,2,nan\n", {"line 1"});
  expect_refused("a.fcsv", "# columns = id,x,y\na,1,2,3\n", {"line 1", "columns"});
  expect_refused("a.fcsv", "\"a,1,2,3\n", {"line 1"});
  expect_refused("a.fcsv", std::string("a,1,2,3\0\n", 9), {"NUL"});
  const std::string whole = "# CoordinateSystem = LPS\n" + kColumns + kPoints;
  try_every_prefix("a.fcsv", whole);
  try_damaged("a.fcsv", whole, 500);
}

std::string list(const std::string& type, const std::string& points) {
  return "{\"markups\": [{\"type\": \"" + type + "\", \"controlPoints\": [" + points + "]}]}";
}

const std::string kThree =
    R"({"position": [1, 2, 3], "positionStatus": "defined"}, {"positionStatus": "undefined"},
       {"position": [4, 5, 6]}, {"position": [0, 0, 0], "positionStatus": "missing"})";

TEST_F(ClickFiles, PointListsOfMarkupsAreRead) {
  for (const char* type : {"Fiducial", "PointList", "Line", "Curve", "ClosedCurve"}) {
    const CurveInput read = read_clicks(path("a.mrk.json"), list(type, kThree));
    EXPECT_EQ(test::positions(read), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}})) << type;
    EXPECT_EQ(read.closed, std::string(type) == "ClosedCurve");
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_EQ(read.notes[0], "2 of 4 points of a.mrk.json have no position and were left out.");
  }
  EXPECT_EQ(clicks("a.mrk.json", list("Fiducial", kThree), kInRas).at(0), Point(-1, -2, 3));
}

TEST_F(ClickFiles, RefusesMarkupsWithoutAPointList) {
  expect_no_clicks("a.mrk.json", list("ROI", kThree), {"markups[0]", "Fiducial", "ROI"});
  expect_no_clicks("a.mrk.json", R"({"markups": []})", {"markups", "0 markups"});
  expect_no_clicks("a.mrk.json", R"({"markups": [{"type": "Fiducial"}, {"type": "Fiducial"}]})",
                   {"2 markups"});
  expect_no_clicks("a.mrk.json", R"({"markups": [{"type": "Fiducial"}]})", {"controlPoints"});
  expect_no_clicks("a.mrk.json", list("Fiducial", R"({"positionStatus": "undefined"})"),
                   {"defined position"});
  expect_no_clicks("a.mrk.json", "", {"empty"});
  expect_no_clicks("a.mrk.json", R"({"format": "talweg-curves"})", {"markups"});
  expect_no_clicks("a.obj", "v 0 0 0\n", {".fcsv", ".mrk.json"});
}

TEST_F(ClickFiles, FcsvIsWrittenForOneCurve) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh), test::walk(mesh)};
  try {
    write_curves(path("a.fcsv"), mesh, curves);
    ADD_FAILURE() << "two curves in a list of points";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadFile);
    EXPECT_NE(std::string(error.what()).find("2 curves"), std::string::npos) << error.what();
  }
  write_curves(path("a.fcsv"), mesh, std::span(curves).first(1), LengthUnit::named("cm"));
  const std::string bytes = bytes_of(path("a.fcsv"));
  EXPECT_NE(bytes.find("# CoordinateSystem = LPS\n" + kColumns + "1,"), std::string::npos) << bytes;
  // Positions are in millimetres for any unit of the mesh.
  const Point first = test::positions(read_curves(path("a.fcsv")).at(0)).front();
  EXPECT_LT((first - 10 * mesh.position(curves[0].points[0])).norm(), 1e-13);
}

}  // namespace
}  // namespace talweg
