// Border files of connectome-workbench: files of its own writer, round trips, and malformed files.
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/io/border_file.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

using Corners = std::vector<CornerCoordinates>;

/// A square of two triangles, 0 1 2 and 0 2 3.
SurfaceMesh square() {
  MeshLists lists;
  lists.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  lists.triangles = {{0, 1, 2}, {0, 2, 3}};
  return SurfaceMesh::open(lists);
}

std::string border(const std::string& parts, const std::string& head = "Version=\"3\"") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<BorderFile " + head +
         " Structure=\"CORTEX_LEFT\" SurfaceNumberOfVertices=\"4\">\n<MetaData/>\n"
         "<Class Name=\"???\" Red=\"1\" Green=\"1\" Blue=\"1\"><Border Name=\"V1\" Red=\"0\" "
         "Green=\"0\" Blue=\"0\">\n" +
         parts + "</Border></Class></BorderFile>\n";
}
std::string part(const std::string& vertices, const std::string& weights,
                 const std::string& closed = "False") {
  return "<BorderPart Closed=\"" + closed + "\"><Vertices>" + vertices + "</Vertices><Weights>" +
         weights + "</Weights></BorderPart>\n";
}

TEST(WorkbenchBorders, AreReadAsPointsBetweenVertices) {
  const auto curves = read_curves(
      "a.border", border(part("2 1 0\n0 2 1\n3 3 3\n", "0.5 0.25 0.25\n0.5 0.5 0\n1 0 0\n") +
                         part("0 1 2 0 2 3 0 2 1", "1 0 0 0 1 0 0 0 1", "True")));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_TRUE(curves[1].closed);
  const SurfaceMesh mesh = square();
  const auto snapped = snap(mesh, curves);
  const std::vector<Point> expected = {{0.75, 0.5, 0}, {0.5, 0.5, 0}, {0, 1, 0}};
  const auto found = positions_of(mesh, {false, snapped[0].points});
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_LE((found[k] - expected[k]).norm(), 1e-15) << k;
  }
  EXPECT_TRUE(std::holds_alternative<OnEdge>(snapped[0].points[1].where()));
  const VertexId loop[] = {VertexId{0}, VertexId{2}, VertexId{1}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(snapped[1].points[k], SurfacePoint::at_vertex(mesh.surface(), loop[k]));
  }
}

TEST(WorkbenchBorders, WeightsOfSixDigitsAreNormalized) {
  const auto curves =
      read_curves("a.border", border(part("0 1 2 0 2 3", "0.333333 0.333333 0.333333 0 0 1")));
  const SurfaceMesh mesh = square();
  const auto points = positions_of(mesh, {false, snap(mesh, curves)[0].points});
  EXPECT_LE((points[0] - Point(2.0 / 3, 1.0 / 3, 0)).norm(), 1e-15);
}

TEST(WorkbenchBorders, AreWrittenAndReadAgain) {
  const SurfaceMesh mesh = square();
  const Surface& surface = mesh.surface();
  const SurfaceCurve curve{false,
                           {SurfacePoint::at_vertex(surface, VertexId{1}),
                            SurfacePoint::in_face(surface, FaceId{0}, {0.5, 0.25, 0.25}),
                            SurfacePoint::at_vertex(surface, VertexId{2}),
                            SurfacePoint::at_vertex(surface, VertexId{3})}};
  const std::vector<PlacedCurve> placed = {place(mesh, curve), place(mesh, curve)};
  const std::string bytes = curve_bytes("sub.L.border", placed);
  EXPECT_NE(bytes.find("Structure=\"CORTEX_LEFT\" SurfaceNumberOfVertices=\"4\""), bytes.npos);
  EXPECT_NE(bytes.find("<Border Name=\"curve_1\""), bytes.npos);
  const auto curves = read_curves("sub.L.border", bytes);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(snap(mesh, curves)[1].points, curve.points);
  // Names are unique within a class, so borders between the same labels are parts of one border.
  const std::vector<SideLabels> sides = {{3, 7}, {3, 7}};
  const std::string of_labels = border_bytes("rh.border", placed, sides);
  EXPECT_NE(of_labels.find("CORTEX_RIGHT"), of_labels.npos);
  EXPECT_EQ(of_labels.find("<Border Name=\"3_7\""), of_labels.rfind("<Border Name="));
  EXPECT_EQ(read_curves("rh.border", of_labels).size(), 2U);
  EXPECT_NE(curve_bytes("a.border", placed).find("\"CORTEX\""), std::string::npos);
}

void expect_refused(const std::string& bytes, std::initializer_list<const char*> words) {
  try {
    read_curves("a.border", bytes);
    ADD_FAILURE() << "taken, not refused for " << *words.begin();
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(error.code(), ErrorCode::kBadFile) << what;
    EXPECT_NE(what.find("a.border"), what.npos) << what;
    for (const char* word : words) EXPECT_NE(what.find(word), what.npos) << what << "\n" << word;
    EXPECT_LT(what.size(), 300U);
  }
}

TEST(WorkbenchBorders, MalformedFilesAreRefused) {
  expect_refused("no xml", {"XML"});
  expect_refused("<VTKFile/>", {"<BorderFile>"});
  expect_refused(border("", "Version=\"1\""), {"version '1'", "-border-version-convert"});
  expect_refused(border(""), {"no <BorderPart>"});
  expect_refused(border(part("", "")), {"line 5", "no points"});
  expect_refused(border(part("0 1 2", "1 0 0", "Perhaps")), {"Closed"});
  expect_refused(border(part("0 1 2 0", "1 0 0 1")), {"three", "found 4 and 4"});
  expect_refused(border(part("0 1 2", "1 0")), {"found 3 and 2"});
  expect_refused(border(part("0 1 4", "1 0 0")), {"point 0", "no vertex 4", "has 4"});
  expect_refused(border(part("0 1 1.5", "1 0 0")), {"vertex 1.5"});
  expect_refused(border(part("0 1 2", "1 0 -0.5")), {"weight", "-0.5"});
  expect_refused(border(part("0 1 2", "1 0 nan")), {"weight", "nan"});
  expect_refused(border(part("0 1 x", "1 0 0")), {"'x'"});
  expect_refused(border("<BorderPart Closed=\"True\"><Vertices>0 1 2</Vertices></BorderPart>"),
                 {"<Weights>"});
}

TEST(WorkbenchBorders, OfAnotherMeshAreRefused) {
  const SurfaceMesh mesh = square();
  const auto refused = [&](const Corners& points, const char* word) {
    CurveInput curve;
    curve.points = points;
    try {
      snap(mesh, curve);
      ADD_FAILURE() << "taken, not refused for " << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadCurve);
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  const auto corners = [](std::size_t a, std::size_t b, std::size_t c) {
    return std::array{VertexId{a}, VertexId{b}, VertexId{c}};
  };
  refused({{corners(0, 1, 2), {1, 0, 0}}, {corners(0, 1, 3), {0.5, 0.25, 0.25}}}, "position 1");
  refused({{corners(0, 1, 2), {1, 0, 0}}, {corners(1, 3, 3), {0.5, 0.5, 0}}}, "1, 3 and 3");
  refused({{corners(0, 1, 4), {1, 0, 0}}}, "no vertex 4");
  refused({{corners(0, 1, 2), {0, 0, 0}}}, "weights 0, 0 and 0");
}

TEST(WorkbenchBorders, KeepTheFilesNumbersWhereAMeshIsRepaired) {
  // Repair drops a face that uses a vertex twice and reverses another face.
  MeshLists lists;
  lists.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  lists.triangles = {{0, 0, 1}, {0, 1, 2}, {0, 3, 2}};
  const RepairedMesh repaired = repair(lists);
  const SurfaceMesh mesh = SurfaceMesh::open(repaired.lists);
  const std::string bytes = border(part("0 1 2 0 2 3", "0.25 0.5 0.25 0.25 0.25 0.5"));
  const CurveInput input = read_curves("a.border", bytes)[0];
  const CurveInput moved = repaired.map.to_repaired(input, mesh.surface());
  const SurfaceCurve curve{false, snap(mesh, moved).points};
  const auto at = positions_of(mesh, curve);
  EXPECT_LE((at[0] - Point(0.75, 0.25, 0)).norm(), 1e-15);
  EXPECT_LE((at[1] - Point(0.25, 0.75, 0)).norm(), 1e-15);
}

}  // namespace
}  // namespace talweg::test
