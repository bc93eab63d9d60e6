// Gmsh's MSH files, following the examples of its manual.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/format_bytes.hpp"

namespace talweg::test::msh_meshes {
namespace {

using Faces = std::vector<Triangle>;

const std::string kNames =
    "$PhysicalNames\n2\n1 5 \"rim\"\n2 7 \"skin of \"it\"\"\n$EndPhysicalNames\n";

// Six nodes with unordered numbers; a point, a line, a triangle and a quadrangle.
const std::string kText2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nby hand $Nodes\n$EndComments\n" + kNames +
    "$Nodes\n6\n10 0 0 0\n3 1 0 0\n7 1 1 0\n8 0 1 0\n90 2 0 0\n91 5 5 5\n$EndNodes\n"
    "$Elements\n4\n1 15 2 0 1 10\n2 1 2 5 1 10 3\n3 2 2 7 1 3 90 7\n4 3 3 0 1 0 10 3 7 8\n"
    "$EndElements\n$NodeData\nwhatever\n$EndNodeData\n";
const Faces kFaces{{1, 4, 2}, {0, 1, 2}, {0, 2, 3}};

TEST(MshMesh, TextOfVersion2) {
  MeshAttributes attributes;
  const MeshLists lists = read_mesh("a.msh", kText2, attributes);
  EXPECT_EQ(lists.triangles, kFaces);
  ASSERT_EQ(lists.points.size(), 6U);
  EXPECT_EQ(lists.points[4], Point(2, 0, 0));
  EXPECT_EQ(lists.polygon_count, 1U);
  EXPECT_EQ(lists.notes, std::vector<std::string>{"2 points and lines of the file were left out."});
  ASSERT_EQ(attributes.faces.size(), 1U);
  EXPECT_EQ(attributes.faces[0].name, "physical");
  EXPECT_EQ(attributes.faces[0].values, (std::vector<double>{7, 0, 0}));
  ASSERT_EQ(attributes.names.size(), 1U);
  EXPECT_EQ(attributes.names[0].names, (std::vector<std::string>{"", "skin of \"it\""}));
  EXPECT_EQ(attributes.names[0].of_face, (std::vector<std::uint32_t>{1, 0, 0}));
}

/// The same mesh in binary, in either byte order.
std::string binary2(bool big) {
  std::string bytes = "$MeshFormat\n2.2 1 8\n";
  put_number(bytes, std::int32_t{1}, big);
  bytes += "\n$EndMeshFormat\n" + kNames + "$Nodes\n5\n";
  const double xy[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}};
  const std::int32_t tags[5] = {10, 3, 7, 8, 90};
  for (int k = 0; k < 5; ++k) {
    put_number(bytes, tags[k], big);
    for (const double x : {xy[k][0], xy[k][1], 0.0}) put_number(bytes, x, big);
  }
  bytes += "\n$EndNodes\n$Elements\n2\n";
  for (const std::int32_t x : {2, 1, 2, 3, 7, 1, 3, 90, 7}) put_number(bytes, x, big);
  for (const std::int32_t x : {3, 1, 2, 4, 0, 1, 10, 3, 7, 8}) put_number(bytes, x, big);
  return bytes + "\n$EndElements\n";
}

TEST(MshMesh, BinaryOfVersion2) {
  for (const bool big : {false, true}) {
    MeshAttributes attributes;
    const MeshLists lists = read_mesh("a.msh", binary2(big), attributes);
    EXPECT_EQ(lists.triangles, kFaces);
    EXPECT_EQ(lists.points[4], Point(2, 0, 0));
    EXPECT_EQ(attributes.faces[0].values, (std::vector<double>{7, 0, 0}));
  }
}

// Two surfaces, one of them in a physical group; a parametric node; triangles of second order.
const std::string kText4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + kNames +
    "$Entities\n1 1 2 0\n1 0 0 0 0\n1 0 0 0 1 0 0 1 5 2 1 -1\n"
    "1 0 0 0 1 1 0 1 7 1 1\n2 0 0 0 1 1 0 0 0\n$EndEntities\n"
    "$Nodes\n2 6 1 90\n0 1 0 1\n10\n0 0 0\n2 1 1 5\n3\n7\n8\n90\n2\n"
    "1 0 0 .1 .2\n1 1 0 .1 .2\n0 1 0 .1 .2\n2 0 0 .1 .2\n9 9 9 .1 .2\n$EndNodes\n"
    "$Elements\n2 2 1 2\n2 1 9 1\n1 3 90 7 2 2 2\n2 2 3 1\n2 10 3 7 8\n$EndElements\n"
    "$Periodic\n0\n$EndPeriodic\n";

TEST(MshMesh, TextOfVersion4) {
  MeshAttributes attributes;
  const MeshLists lists = read_mesh("a.msh", kText4, attributes);
  EXPECT_EQ(lists.triangles, kFaces);
  EXPECT_EQ(lists.points.size(), 6U);
  EXPECT_EQ(lists.points[4], Point(2, 0, 0));
  EXPECT_EQ(attributes.faces[0].values, (std::vector<double>{7, 0, 0}));
  EXPECT_EQ(lists.notes,
            std::vector<std::string>{"Of elements of higher order only the corners were taken."});
}

TEST(MshMesh, BinaryOfVersion4) {
  for (const bool big : {false, true}) {
    std::string bytes = "$MeshFormat\n4.1 1 8\n";
    const auto ints = [&](std::initializer_list<std::int32_t> all) {
      for (const std::int32_t x : all) put_number(bytes, x, big);
    };
    const auto sizes = [&](std::initializer_list<std::int64_t> all) {
      for (const std::int64_t x : all) put_number(bytes, x, big);
    };
    ints({1});
    bytes += "\n$EndMeshFormat\n$Entities\n";
    sizes({0, 0, 1, 0});
    ints({4});
    for (int k = 0; k < 6; ++k) put_number(bytes, 0.0, big);
    sizes({1});
    ints({7});
    sizes({0});
    bytes += "\n$EndEntities\n$Nodes\n";
    sizes({1, 3, 1, 3});
    ints({2, 4, 0});
    sizes({3, 1, 2, 3});
    for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 0.}) put_number(bytes, x, big);
    bytes += "\n$EndNodes\n$Elements\n";
    sizes({1, 1, 1, 1});
    ints({2, 4, 2});
    sizes({1, 1, 1, 2, 3});
    bytes += "\n$EndElements\n";
    MeshAttributes attributes;
    EXPECT_EQ(read_mesh("a.msh", bytes, attributes).triangles, (Faces{{0, 1, 2}}));
    EXPECT_EQ(attributes.faces[0].values, (std::vector<double>{7}));
    EXPECT_NE(refusal_of("a.msh", bytes.substr(0, bytes.size() - 30)).find("byte "),
              std::string::npos);
  }
}

TEST(MshMesh, VolumesAreReportedAndAreNoSurface) {
  const std::string start =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
      "$EndNodes\n$Elements\n";
  const MeshLists lists =
      read_mesh("a.msh", start + "2\n1 4 0 1 2 3 4\n2 2 0 1 2 3\n$EndElements\n");
  EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}}));
  ASSERT_EQ(lists.notes.size(), 1U);
  EXPECT_NE(lists.notes[0].find("1 volumes of the file were left out"), std::string::npos);
  EXPECT_NE(refusal_of("a.msh", start + "1\n1 4 0 1 2 3 4\n$EndElements\n")
                .find("it has volumes but no triangles or quadrangles"),
            std::string::npos);
}

TEST(MshMesh, Errors) {
  const std::string format = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const auto says = [](const std::string& text, const char* words) {
    EXPECT_NE(refusal_of("a.msh", text).find(words), std::string::npos)
        << refusal_of("a.msh", text);
  };
  says("$MeshFormat\n4 0 8\n$EndMeshFormat\n", "line 2: version '4' is not read; save it as");
  says("$Nodes\n0\n", "expected $MeshFormat before");
  says("hello\n", "line 1: expected a section");
  says(format + "$Nodes\n999999999999\n1 0 0 0\n", "999999999999 nodes are announced");
  says(format + "$Nodes\n-1\n", "there are -1 nodes");
  says(format + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n", "node 1 comes twice");
  says(format + "$Nodes\n1\n1 0 0 x\n$EndNodes\n", "line 6: expected a coordinate, found 'x'");
  says(format + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n5 2 0 1 1 2\n",
       "element 5 refers to node 2, which is not there");
  says(format + "$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n5 99 0 1\n",
       "elements of type 99 are not known");
  says(format + "$Nodes\n1\n1 0 0 0\nmore\n", "expected $EndNodes, found 'more'");
  says(format + "$Odd\n1\n", "the file ends in $Odd");
  says(format, "no vertices");
}

}  // namespace
}  // namespace talweg::test::msh_meshes
