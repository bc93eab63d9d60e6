// VTK's files as meshes: legacy and XML, read and written.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/io/format_bytes.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::test::vtk_meshes {
namespace {

using Faces = std::vector<Triangle>;

const std::string kHead = "# vtk DataFile Version 3.0\nsurface\nASCII\nDATASET POLYDATA\n";
const std::string kPoints = "POINTS 5 float\n0 0 0 1 0 0 1 1 0\n0 1 0 2 0 0\n";
// Two vertex cells, a line, a square and a triangle, and a strip of two triangles: six cells.
const std::string kCells =
    "VERTICES 2 4\n1 0 1 1\nLINES 1 3\n2 0 1\nPOLYGONS 2 9\n4 0 1 2 3\n3 1 4 2\n"
    "TRIANGLE_STRIPS 1 5\n4 0 1 2 4\n";
const Faces kFaces{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {0, 1, 2}, {2, 1, 4}};

const AttributeColumn* column(const std::vector<AttributeColumn>& all, const std::string& name) {
  for (const AttributeColumn& c : all) {
    if (c.name == name) return &c;
  }
  return nullptr;
}

TEST(VtkMesh, LegacyTextWithAllKindsOfCells) {
  MeshAttributes attributes;
  const MeshLists lists =
      read_mesh("a.vtk",
                kHead + kPoints + kCells +
                    "CELL_DATA 6\nSCALARS label int 1\nLOOKUP_TABLE default\n1 2 3 4 5 6\n"
                    "POINT_DATA 5\nNORMALS Normals float\n0 0 1 0 0 1 0 0 1 0 0 1 0 0 nan\n"
                    "FIELD FieldData 2\nheat%20flow 2 5 double\n1 2 3 4 5 6 7 8 9 10\nMETADATA\n"
                    "INFORMATION 0\n\nlast 1 5 unsigned_char\n1 2 3 4 5\n",
                attributes);
  EXPECT_EQ(lists.triangles, kFaces);
  EXPECT_EQ(lists.points[4], Point(2, 0, 0));
  EXPECT_EQ(lists.polygon_count, 1U);
  EXPECT_TRUE(lists.single_precision);
  EXPECT_EQ(lists.notes, (std::vector<std::string>{"2 vertex cells of the file were left out.",
                                                   "1 lines of the file were left out."}));
  ASSERT_EQ(attributes.faces.size(), 1U);
  EXPECT_EQ(attributes.faces[0].values, (std::vector<double>{4, 4, 5, 6, 6}));
  EXPECT_EQ(attributes.faces[0].type, NumberType::kInt32);
  EXPECT_NE(column(attributes.vertices, "nz"), nullptr);
  ASSERT_NE(column(attributes.vertices, "heat_flow_1"), nullptr);
  EXPECT_EQ(column(attributes.vertices, "heat_flow_1")->values,
            (std::vector<double>{2, 4, 6, 8, 10}));
  EXPECT_EQ(column(attributes.vertices, "last")->type, NumberType::kUint8);
}

TEST(VtkMesh, LegacyBinaryOfVersion5) {
  std::string bytes = "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 double\n";
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0.}) put_number(bytes, x, true);
  bytes += "\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n";
  for (const std::int64_t x : {0, 3}) put_number(bytes, x, true);
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const std::int64_t x : {0, 1, 2}) put_number(bytes, x, true);
  const MeshLists lists = read_mesh("a.vtk", bytes + "\n");
  EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}}));
  EXPECT_FALSE(lists.single_precision);
}

TEST(VtkMesh, FacesOfAnUnstructuredGrid) {
  const std::string grid =
      "# vtk DataFile Version 2.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      "POINTS 6 double\n0 0 0 1 0 0 1 1 0 0 1 0 .5 0 0 0 0 1\n";
  MeshAttributes attributes;
  // A line, a pixel, a quadratic triangle and a tetrahedron.
  const MeshLists lists =
      read_mesh("a.vtk",
                grid +
                    "CELLS 4 20\n2 0 1\n4 0 1 3 2\n6 0 1 2 4 4 4\n4 0 1 2 5\n"
                    "CELL_TYPES 4\n3 8 22 10\nCELL_DATA 4\nSCALARS region vtktypeint32\n"
                    "LOOKUP_TABLE default\n7 8 9 10\n",
                attributes);
  EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(attributes.faces[0].values, (std::vector<double>{8, 8, 9}));
  EXPECT_EQ(lists.notes.size(), 3U);
  EXPECT_NE(refusal_of("a.vtk", grid + "CELLS 1 5\n4 0 1 2 5\nCELL_TYPES 1\n10\n")
                .find("its grid has volumes but no faces; extract its surface"),
            std::string::npos);
}

TEST(VtkMesh, LegacyErrors) {
  EXPECT_NE(refusal_of("a.vtk", kHead + kPoints + "POLYGONS 1 4\n3 0 1 5\n")
                .find("face 0 refers to point 5, but there are 5 points."),
            std::string::npos);
  EXPECT_NE(refusal_of("a.vtk", kHead + kPoints + "POLYGONS 1 3\n2 0 1\n").find("2 corners"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.vtk", kHead + kPoints + "LINES 1 3\n2 0 1\n").find("no surface"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n")
                .find("line 4: the dataset is STRUCTURED_POINTS, no surface; extract one"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.vtk", kHead + kPoints + "POLYGONS 2 4\n3 0 1 2\n").find("missing"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.vtk", kHead + "POINTS 4000000000 float\n0 0\n").find("12000000000"),
            std::string::npos);
}

std::string vtp(const std::string& pieces) {
  return "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData>" + pieces +
         "</PolyData></VTKFile>";
}
std::string piece(const std::string& inside) {
  return "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float64\" "
         "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points>" +
         inside + "</Piece>";
}
std::string polys(const std::string& corners, const std::string& ends) {
  return "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" + corners +
         "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + ends +
         "</DataArray></Polys>";
}

TEST(VtkMesh, XmlWithTwoPieces) {
  const std::string data =
      "<CellData><DataArray type=\"Int32\" Name=\"label\" format=\"ascii\">5</DataArray></CellData>"
      "<PointData><DataArray type=\"UInt8\" Name=\"RGB\" NumberOfComponents=\"3\" "
      "format=\"ascii\">1 2 3 4 5 6 7 8 9 10 11 12</DataArray>";
  MeshAttributes attributes;
  const MeshLists lists = read_mesh(
      "a.vtp",
      vtp(piece(polys("0 1 2 3", "4") + data + "</PointData>") +
          piece(polys("0 1 2", "3") + data +
                "<DataArray type=\"String\" Name=\"words\" format=\"ascii\"/></PointData>")),
      attributes);
  EXPECT_EQ(lists.points.size(), 8U);
  EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(attributes.faces[0].values, (std::vector<double>{5, 5, 5}));
  ASSERT_EQ(attributes.vertices.size(), 3U);
  EXPECT_EQ(attributes.vertices[1].name, "green");
  EXPECT_EQ(attributes.vertices[1].values, (std::vector<double>{2, 5, 8, 11, 2, 5, 8, 11}));
  EXPECT_EQ(attributes.left_out, std::vector<std::string>{"array 'words', which has no numbers"});
}

TEST(VtkMesh, XmlErrors) {
  EXPECT_NE(refusal_of("a.vtp", vtp(piece(polys("0 1 4", "3")))).find("<Polys>: face 0 refers"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.vtp", vtp(piece(polys("0 1 2", "7")))).find("more corners"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.vtp", vtp(piece(""))).find("no surface"), std::string::npos);
  EXPECT_NE(refusal_of("a.vtp", "<VTKFile type=\"UnstructuredGrid\"/>").find("PolyData"),
            std::string::npos);
}

TEST(VtkMesh, TheSpaceIsRead) {
  const std::string faces = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";
  const auto with_title = [&](const std::string& title) {
    return "# vtk DataFile Version 4.2\n" + title + "\nASCII\nDATASET POLYDATA\n" + faces;
  };
  EXPECT_EQ(read_mesh("a.vtk", with_title("3D Slicer output. SPACE=RAS")).space,
            PatientSpace::kRas);
  EXPECT_EQ(read_mesh("a.vtk", with_title("vtk output")).space, PatientSpace::kNotSaid);
  MeshLists lists = grid(2, 2);
  for (const PatientSpace space :
       {PatientSpace::kNotSaid, PatientSpace::kLps, PatientSpace::kRas}) {
    lists.space = space;
    for (const char* name : {"a.vtk", "a.vtp"}) {
      EXPECT_EQ(read_mesh(name, mesh_bytes(name, lists, {}).bytes).space, space) << name;
    }
  }
}

TEST(VtkMesh, WrittenFilesComeBackWithAttributesAndEdges) {
  MeshLists lists = box();
  lists.points[0] = Point(0.1, 1e-300, -7e5);
  MeshAttributes attributes;
  const std::vector<double> per_vertex(lists.points.size(), 0.25);
  const std::vector<double> per_face(lists.triangles.size(), -3);
  for (const char* name : {"nx", "ny", "nz", "a_0", "a_1", "quality"}) {
    attributes.vertices.push_back({name, NumberType::kFloat32, per_vertex});
  }
  for (const char* name : {"red", "green", "blue"}) {
    attributes.vertices.push_back(
        {name, NumberType::kUint8, std::vector<double>(lists.points.size(), 200)});
  }
  attributes.faces.push_back({"label", NumberType::kInt16, per_face});
  attributes.faces.push_back({"wide", NumberType::kInt64, per_face});
  const std::vector<TaggedEdge> edges{{0, 1, 4}, {1, 2, 4}};
  for (const char* name : {"a.vtk", "a.vtp"}) {
    const MeshBytes file = mesh_bytes(name, lists, attributes, edges);
    EXPECT_TRUE(file.left_out.empty());
    MeshAttributes back;
    const MeshLists again = read_mesh(name, file.bytes, back);
    EXPECT_EQ(again.points, lists.points) << name;
    EXPECT_EQ(again.triangles, lists.triangles);
    EXPECT_EQ(again.notes, std::vector<std::string>{"2 lines of the file were left out."});
    ASSERT_EQ(back.vertices.size(), attributes.vertices.size()) << name;
    for (std::size_t c = 0; c < back.vertices.size(); ++c) {
      EXPECT_EQ(back.vertices[c].name, attributes.vertices[c].name);
      EXPECT_EQ(back.vertices[c].type, attributes.vertices[c].type);
      EXPECT_EQ(back.vertices[c].values, attributes.vertices[c].values);
    }
    ASSERT_EQ(back.faces.size(), 3U);
    EXPECT_EQ(back.faces[0].values, per_face);
    EXPECT_EQ(back.faces[1].type, NumberType::kInt64);
    EXPECT_EQ(back.faces[2].name, "curve");
    EXPECT_EQ(back.faces[2].values, std::vector<double>(lists.triangles.size(), -1));
    EXPECT_TRUE(mesh_bytes(name, lists).bytes.size() < file.bytes.size());
  }
}

}  // namespace
}  // namespace talweg::test::vtk_meshes
