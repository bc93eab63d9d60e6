// Binary OFF, unusual STL, vertices without a finite position, and formats that are not read.
#include <cmath>
#include <string>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>

#include "core/io/format_bytes.hpp"
#include "core/temporary_folder.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::test::odd_meshes {
namespace {

using Faces = std::vector<Triangle>;
const Faces kQuadAndTriangle{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};

/// A square and a triangle as binary OFF, with `more_floats` numbers per vertex after the
/// coordinates.
std::string binary_off(const std::string& first_line, int more_floats, bool big, bool colours) {
  std::string bytes = first_line + "\n";
  for (const int n : {5, 2, 0}) put_number(bytes, n, big);
  const float xy[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}};
  for (const auto& p : xy) {
    for (const float x : {p[0], p[1], 0.5F}) put_number(bytes, x, big);
    for (int k = 0; k < more_floats; ++k) put_number(bytes, 0.25F, big);
  }
  for (const int v : {4, 0, 1, 2, 3}) put_number(bytes, v, big);
  if (colours) {
    put_number(bytes, 3, big);
    for (int k = 0; k < 3; ++k) put_number(bytes, 1.0F, big);
  }
  for (const int v : {3, 1, 4, 2}) put_number(bytes, v, big);
  if (colours) put_number(bytes, 0, big);
  return bytes;
}

TEST(OddMeshes, BinaryOff) {
  MeshAttributes attributes;
  const MeshLists plain = read_mesh("a.off", binary_off("OFF BINARY", 0, true, true), attributes);
  EXPECT_EQ(plain.triangles, kQuadAndTriangle);
  EXPECT_EQ(plain.polygon_count, 1U);
  EXPECT_EQ(plain.points[4], Point(2, 0, 0.5));
  EXPECT_TRUE(plain.single_precision);
  EXPECT_TRUE(plain.notes.empty());
  EXPECT_EQ(attributes.left_out, std::vector<std::string>{"colours of faces (OFF)"});
  const MeshLists rich = read_mesh("a.off", binary_off("CNOFF BINARY", 7, true, true), attributes);
  EXPECT_EQ(rich.triangles, kQuadAndTriangle);
  EXPECT_EQ(rich.points[3], Point(0, 1, 0.5));
  EXPECT_EQ(attributes.left_out.size(), 2U);
}

TEST(OddMeshes, BinaryOffAsOpenMeshWritesIt) {
  const MeshLists lists = read_mesh("a.off", binary_off("OFF BINARY", 0, false, false));
  EXPECT_EQ(lists.triangles, kQuadAndTriangle);
  ASSERT_EQ(lists.notes.size(), 1U);
  EXPECT_NE(lists.notes[0].find("little-endian"), std::string::npos);
}

class OddFiles : public TemporaryFolder {};

TEST_F(OddFiles, OpenMeshsOwnBinaryOff) {
  OpenMesh::PolyMesh_ArrayKernelT<> mesh;
  std::vector<OpenMesh::VertexHandle> v;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}}) {
    v.push_back(mesh.add_vertex({static_cast<float>(x), static_cast<float>(y), 0.5F}));
  }
  mesh.add_face(v[0], v[1], v[2], v[3]);
  mesh.add_face(v[1], v[4], v[2]);
  ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, file("a.off").string(),
                                       OpenMesh::IO::Options(OpenMesh::IO::Options::Binary)));
  const MeshLists lists = read_mesh(file("a.off"));
  EXPECT_EQ(lists.triangles, kQuadAndTriangle);
  EXPECT_EQ(lists.points[4], Point(2, 0, 0.5));
}

TEST(OddMeshes, BinaryOffErrors) {
  const std::string whole = binary_off("OFF BINARY", 0, true, true);
  EXPECT_EQ(refusal_of("a.off", whole.substr(0, 11 + 12 + 30)),
            ": the file ends in vertex 2 of 5.");
  EXPECT_EQ(refusal_of("a.off", whole.substr(0, whole.size() - 8)),
            ": the file ends in face 1 of 2.");
  EXPECT_EQ(refusal_of("a.off", whole + "more"),
            ": the file goes on for 4 bytes after all that its header announces.");
  EXPECT_EQ(refusal_of("a.off", whole + "\n"), "");
  std::string wrong = whole;
  wrong[11 + 12 + 60 + 4 + 3] = 7;  // the first corner of the first face
  EXPECT_EQ(refusal_of("a.off", wrong),
            ": face 0 refers to vertex 7, but the file has 5 vertices.");
  EXPECT_EQ(refusal_of("a.off", "4OFF BINARY\n"),
            ", line 1: expected the word OFF at the beginning of the file.");
}

std::string binary_stl(const std::string& head) {
  std::string bytes = head;
  bytes.resize(80, ' ');
  put_number(bytes, 2U);
  const float corners[2][9] = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}};
  for (const auto& triangle : corners) {
    for (int k = 0; k < 3; ++k) put_number(bytes, 0.0F);
    for (const float x : triangle) put_number(bytes, x);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(OddMeshes, StlWithBytesAfterItsTriangles) {
  for (const char* head : {"x", "solid but binary", "SOLID"}) {
    const MeshLists lists = read_mesh("a.stl", binary_stl(head) + "trailing");
    EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(lists.notes.size(), 1U);
    EXPECT_EQ(lists.notes[0], "8 bytes after the 2 triangles of the STL file were ignored.");
    EXPECT_TRUE(read_mesh("a.stl", binary_stl(head)).notes.empty());
  }
}

TEST(OddMeshes, StlInUpperCase) {
  const std::string text =
      "SOLID A\nFACET NORMAL 0 0 1\n OUTER LOOP\n VERTEX 0 0 0\n Vertex 1 0 0\n VERTEX 1 1 0\n"
      " ENDLOOP\nEndFacet\nENDSOLID A\n";
  EXPECT_EQ(read_mesh("a.stl", text).triangles, (Faces{{0, 1, 2}}));
  EXPECT_EQ(read_mesh("a.stl", "\xEF\xBB\xBF" + text).triangles, (Faces{{0, 1, 2}}));
  EXPECT_EQ(refusal_of("a.stl", "SOLID A\nFACET\nOUTER\nVERTEX 0 0 nan\n"),
            ", line 4: a coordinate is 'nan', which is not a finite number.");
}

TEST(OddMeshes, NonFiniteVerticesAreKeptIfNoFaceUsesThem) {
  const std::string obj = "v nan 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -inf\n";
  const std::string off = "OFF\n5 1 0\nnan 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 -inf\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "nan 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 -inf\n";
  for (const auto& [name, text, good, bad] : {std::tuple{"a.obj", obj, "f 2 3 4\n", "f 2 3 5\n"},
                                              std::tuple{"a.off", off, "3 1 2 3\n", "3 1 2 4\n"},
                                              std::tuple{"a.ply", ply, "3 1 2 3\n", "3 1 2 4\n"}}) {
    const MeshLists lists = read_mesh(name, text + good);
    EXPECT_TRUE(std::isnan(lists.points[0].x()));
    const MeshInspection found = inspect(lists);
    EXPECT_EQ(found.verdict, MeshVerdict::kUsable) << found.reason;
    EXPECT_EQ(found.isolated_vertices.first, (std::vector<std::uint32_t>{0, 4}));
    EXPECT_EQ(found.stray_vertices.first, (std::vector<std::uint32_t>{0, 4}));
    EXPECT_EQ(found.box_max, (std::array<double, 3>{1, 1, 0}));
    EXPECT_EQ(found.coordinate_max, 1);
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    for (const Point& p : mesh.points()) EXPECT_TRUE(p.allFinite());
    EXPECT_EQ(mesh.points()[3], Point(0, 1, 0));
    const std::string what = refusal_of(name, text + bad);
    EXPECT_NE(what.find(", line "), what.npos);
    EXPECT_NE(
        what.find("a coordinate is '-inf', which is not a finite number, and face 0 uses this "
                  "vertex (4)."),
        what.npos)
        << what;
  }
  EXPECT_EQ(refusal_of("a.obj", "v 0 x 0\n"), ", line 1: expected a coordinate, found 'x'.");
}

TEST(OddMeshes, FormatsThatAreNotReadGetAdvice) {
  const auto says = [](const char* name, const char* words) {
    const std::string what = refusal_of(name, "x");
    EXPECT_NE(what.find(words), what.npos) << what;
    EXPECT_NE(what.find("expected .obj, .off, .ply, .stl, .om"), what.npos) << what;
    EXPECT_EQ(what.back(), '.');
    EXPECT_LT(what.size(), 400U);
  };
  says("a.vtu", "extract its surface (in ParaView: Extract Surface) and save it as .vtp");
  says("a.STL.gz", "unpack it first (gunzip)");
  says("a.nii.gz", "it is a volume");
  says("a.MGZ", "it is a volume");
  says("a.step", "CAD surfaces");
  says("a.dae", "export it as .glb, .obj or .ply");
  says("a.blend", "export it as .glb, .obj or .ply");
  says("a.las", "a cloud of points");
  says("a.unknown", "'.unknown' is not a mesh format that Talweg reads; expected");
  says("a", "the file name has no extension; expected");
  try {
    read_curves("a.vtu", "x");
    FAIL();
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("extract its surface"), what.npos) << what;
    EXPECT_NE(what.find("known are .obj"), what.npos) << what;
  }
}

}  // namespace
}  // namespace talweg::test::odd_meshes
