#include "talweg/core/io/mesh_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/temporary_folder.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

using Triangles = std::vector<Triangle>;

class MeshReader : public TemporaryFolder {
 protected:
  /// The error message of reading, without the folder; empty if reading succeeds.
  std::string refusal(std::string_view name, std::string_view bytes) const {
    try {
      read_mesh(write(name, bytes));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      const std::string what = error.what();
      const std::string path = file(name).string();
      const std::size_t at = what.find(path);
      EXPECT_NE(at, std::string::npos) << what;
      return at == std::string::npos ? what : what.substr(at + path.size());
    }
    return "";
  }
  MeshLists read(std::string_view name, std::string_view bytes) const {
    return read_mesh(write(name, bytes));
  }
};

template <class T>
void put(std::string& bytes, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// A pentagon and a triangle, with elements and properties in between that readers skip.
std::string binary_ply(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\ncomment made\nelement material 1\nproperty list uchar float a\n"
                      "element vertex 5\nproperty uchar red\nproperty double x\nproperty double y\n"
                      "property double z\nelement face 2\nproperty list uchar uint vertex_index\n"
                      "property short flag\nend_header\n";
  put(bytes, std::uint8_t{2}, big);
  put(bytes, 1.0F, big);
  put(bytes, 2.0F, big);
  for (int v = 0; v < 5; ++v) {
    put(bytes, std::uint8_t{255}, big);
    put(bytes, 5e6 + 0.1 * v, big);
    put(bytes, -0.25 * v, big);
    put(bytes, 1e-300, big);
  }
  put(bytes, std::uint8_t{5}, big);
  for (std::uint32_t v = 0; v < 5; ++v) put(bytes, v, big);
  put(bytes, std::int16_t{-1}, big);
  put(bytes, std::uint8_t{3}, big);
  for (const std::uint32_t v : {4U, 1U, 0U}) put(bytes, v, big);
  put(bytes, std::int16_t{-1}, big);
  return bytes;
}
const Triangles kPentagonAndTriangle{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {4, 1, 0}};

TEST_F(MeshReader, BinaryPlyOfBothByteOrdersInFullPrecision) {
  for (const bool big : {false, true}) {
    const MeshLists lists = read("a.ply", binary_ply(big));
    ASSERT_EQ(lists.points.size(), 5U);
    for (int v = 0; v < 5; ++v) {
      EXPECT_EQ(lists.points[static_cast<std::size_t>(v)], Point(5e6 + 0.1 * v, -0.25 * v, 1e-300));
    }
    EXPECT_EQ(lists.triangles, kPentagonAndTriangle);
    EXPECT_EQ(lists.polygon_count, 1U);
    EXPECT_FALSE(lists.single_precision);
  }
}

TEST_F(MeshReader, TextPly) {
  const std::string head =
      "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\n"
      "property float z\r\nproperty float quality\r\nelement face 2\r\n"
      "property list uchar int vertex_indices\r\nend_header\r\n";
  const std::string points = "0 0 0 9\r\n1 0 0 9\r\n1 1 0 9\r\n0 +1e0 -.5 nan\r\n";
  const MeshLists lists = read("a.ply", head + points + "3 0 1 2\r\n3 0 2 3\r\n");
  EXPECT_EQ(lists.points[3], Point(0, 1, -0.5));
  EXPECT_EQ(lists.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(lists.single_precision);

  EXPECT_EQ(refusal("a.ply", head + points + "3 0 1 2\r\n"),
            ": the file ends where face 1 of 2 should follow.");
  EXPECT_EQ(refusal("a.ply", head + points + "3 0 1 2\r\n3 0 2 3\r\n3 1 2 3\r\n"),
            ", line 17: the file goes on after all that its header announces.");
  EXPECT_EQ(refusal("a.ply", head + points + "3 0 1 4\r\n3 0 2 3\r\n"),
            ": face 0 refers to vertex 4, but the file has 4 vertices.");
  EXPECT_EQ(refusal("a.ply", head + points + "3 0 1\r\n3 0 2 3\r\n"),
            ", line 15: expected the index of a vertex, found the end of the line.");
  EXPECT_EQ(refusal("a.ply", head + points + "2 0 1\r\n3 0 2 3\r\n"),
            ": face 0 has 2 corners, but a face needs three or more.");
  EXPECT_EQ(refusal("a.ply", head + "0 inf 0 9\r\n"),
            ": the file ends where vertex 1 of 4 should follow.");
}

TEST_F(MeshReader, BinaryPlyCutOffAnywhereIsRefused) {
  const std::string whole = binary_ply(false);
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const std::string part = whole.substr(0, size);
    EXPECT_THROW(read_ply({"a.ply", part}), Error) << size;
  }
  EXPECT_EQ(refusal("a.ply", whole.substr(0, whole.size() - 3)), ": the file ends in face 1 of 2.");
  EXPECT_EQ(refusal("a.ply", whole + "abc"),
            ": the file goes on for 3 bytes after all that its header announces.");
  EXPECT_EQ(refusal("a.ply", whole + "\n"), "");
}

TEST_F(MeshReader, PlyTriangleStrips) {
  const auto head = [](const std::string& format, const std::string& elements) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n" +
           elements + "end_header\n";
  };
  const std::string strips = "element tristrips 2\nproperty list int int vertex_indices\n";
  const std::string faces = "element face 0\nproperty list uchar int vertex_indices\n";
  const std::string points = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";
  // The first strip continues after -1 as another strip; the second strip turns at a repeated
  // vertex.
  const std::string indices = "8 0 2 1 3 -1 2 4 3\n6 3 4 5 5 1 0\n";
  const Triangles expected{{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}, {1, 5, 0}};
  for (const std::string& elements : {strips, faces + strips, strips + faces}) {
    EXPECT_EQ(read("a.ply", head("ascii", elements) + points + indices).triangles, expected);
    MeshAttributes attributes;
    read_mesh(file("a.ply"), attributes);
    EXPECT_TRUE(attributes.left_out.empty());
    EXPECT_TRUE(attributes.faces.empty());
  }

  std::string binary = head("binary_big_endian", strips);
  for (int k = 0; k < 18; ++k) put(binary, static_cast<float>(k % 7), true);
  for (const std::int32_t k : {8, 0, 2, 1, 3, -1, 2, 4, 3, 6, 3, 4, 5, 5, 1, 0}) {
    put(binary, k, true);
  }
  EXPECT_EQ(read("b.ply", binary).triangles, expected);
  EXPECT_EQ(refusal("b.ply", binary.substr(0, binary.size() - 1)),
            ": the file ends in tristrips 1 of 2.");

  EXPECT_EQ(refusal("a.ply", head("ascii", strips) + points + "3 0 1 6\n3 0 1 2\n"),
            ": a triangle strip refers to vertex 6, but the file has 6 vertices.");
  EXPECT_EQ(refusal("a.ply", head("ascii", strips) + points + "3 0 1 -2\n3 0 1 2\n"),
            ": a triangle strip refers to vertex -2, but the file has 6 vertices.");
  EXPECT_EQ(refusal("a.ply", head("ascii", strips) + points + "-3 0 1 2\n3 0 1 2\n"),
            ", line 16: a list has a negative length.");
  EXPECT_EQ(refusal("a.ply", head("ascii", "element tristrips 1\nproperty int a\n") + points),
            ": the triangle strips have no list vertex_indices.");
  EXPECT_EQ(refusal("a.ply", head("ascii",
                                  "element face 1\nproperty list uchar int "
                                  "vertex_indices\n" +
                                      strips)),
            ": the PLY header must announce either faces or triangle strips, and once.");
}

TEST_F(MeshReader, PlyHeadersThatMakeNoSense) {
  EXPECT_EQ(refusal("a.ply", "plx\n"),
            ", line 1: expected the word ply at the beginning of the file.");
  EXPECT_EQ(
      refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty number x\nend_header\n"),
      ", line 4: 'number' is not a PLY number type.");
  EXPECT_EQ(refusal("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int "
                    "y\nend_header\n0 0\n"),
            ": the vertices have no coordinate z.");
  EXPECT_EQ(refusal("a.ply",
                    "ply\nformat ascii 1.0\nelement face 0\nproperty list int int "
                    "vertex_indices\nend_header\n"),
            ": the PLY header must announce vertices once and faces at most once.");
  EXPECT_NE(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex -3\n"), "");
  // A small file announces far more elements than it can hold: an error at once, without the
  // memory.
  EXPECT_NE(refusal("a.ply",
                    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000000\n"
                    "property float x\nproperty float y\nproperty float z\nend_header\n1234"),
            "");
}

TEST_F(MeshReader, ObjWithAllItsHabits) {
  const MeshLists lists =
      read("A.OBJ",
           "# made by hand\nmtllib a.mtl\no thing\nv 0 0 0 1\nv 1 0 0  # corner\n"
           "v 1 1 0 0.5 0.5 0.5\n\tv 0 1 0\nvt 0 0\nvn 0 0 1\ng part\ns off\n"
           "f 1/1 2/1/1 3//1\nf -4 -2 \\\n -1\nl 1 2\nf 1 2 3 4\n");
  EXPECT_EQ(lists.points.size(), 4U);
  EXPECT_EQ(lists.points[2], Point(1, 1, 0));
  EXPECT_EQ(lists.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(lists.polygon_count, 1U);
}

TEST_F(MeshReader, ObjErrorsNameTheLine) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(refusal("a.obj", points + "f 1 2 x\n"),
            ", line 4: expected the number of a vertex, counted from 1, found 'x'.");
  EXPECT_EQ(refusal("a.obj", points + "f 0 1 2\n"),
            ", line 4: expected the number of a vertex, counted from 1, found '0'.");
  EXPECT_EQ(refusal("a.obj", points + "f 1 2 -4\n"),
            ", line 4: a corner refers to vertex -4, but there are 3 vertices so far.");
  EXPECT_EQ(refusal("a.obj", points + "f 1 2 4\nf 1 2 3\n"),
            ", line 4: a face refers to vertex 4 (counted from 1), but the file has 3 vertices.");
  EXPECT_EQ(refusal("a.obj", "f 1 2 3\n" + points), "");
  EXPECT_EQ(refusal("a.obj", points + "f 1 2\n"),
            ", line 4: a face needs three corners or more, this one has 2.");
  EXPECT_EQ(refusal("a.obj", "v 0 nan 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\n"),
            ", line 1: a coordinate is 'nan', which is not a finite number, and face 0 uses this "
            "vertex (0).");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 0 1e999 0\nv 1 0 0\nf 1 2 3\n"),
            ", line 2: a coordinate is '1e999', which is not a finite number, and face 0 uses this "
            "vertex (1).");
  EXPECT_EQ(refusal("a.obj", "v 0 1,5 0\n"), ", line 1: expected a coordinate, found '1,5'.");
  EXPECT_EQ(refusal("a.obj", "v 0 +-5 0\n"), ", line 1: expected a coordinate, found '+-5'.");
  EXPECT_EQ(refusal("a.obj", "v 0 1\n"),
            ", line 1: expected a coordinate, found the end of the line.");
  EXPECT_EQ(refusal("a.obj", "hello\n"), ": the file contains no vertices.");
}

TEST_F(MeshReader, OffWithPolygons) {
  const MeshLists lists =
      read("a.off",
           "# sheet\nCOFF 5 2 0\n\n0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0\n0 1 0\n# last\n2 0.5 0\n"
           "4 0 1 2 3 0.5 0.5 0.5\n3 1 4 2\n");
  EXPECT_EQ(lists.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}));
  EXPECT_EQ(lists.polygon_count, 1U);
  EXPECT_EQ(lists.points[4], Point(2, 0.5, 0));
}

TEST_F(MeshReader, OffErrors) {
  const std::string body = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(refusal("a.off", body + "3 0 1 2\n"), "");
  EXPECT_EQ(refusal("a.off", body), ": the file ends where face 0 of 1 should follow.");
  EXPECT_EQ(refusal("a.off", body + "3 0 1 3\n"),
            ", line 6: face 0 refers to vertex 3, but the file has 3 vertices.");
  EXPECT_EQ(refusal("a.off", body + "3 0 1 -1\n"),
            ", line 6: face 0 refers to vertex -1, but the file has 3 vertices.");
  EXPECT_EQ(
      refusal("a.off", body + "3 0 1 2\n3 0 1 2\n"),
      ", line 7: the file goes on after the 3 vertices and 1 faces that its header announces.");
  EXPECT_EQ(refusal("a.off", body + "1 0\n"),
            ", line 6: face 0 has 1 corners, but a face needs three or more.");
  EXPECT_EQ(refusal("a.off", "3 1 0\n"),
            ", line 1: expected the word OFF at the beginning of the file.");
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 NaN\n0 1 0\n3 0 1 2\n"),
            ", line 4: a coordinate is 'NaN', which is not a finite number, and face 0 uses this "
            "vertex (1).");
  EXPECT_EQ(refusal("a.off", "OFF\n999999999999 1 0\n0 0 0\n"),
            ": the file ends where vertex 1 of 999999999999 should follow.");
}

TEST_F(MeshReader, StlJoinsEqualPositions) {
  const std::string text =
      "solid a\nfacet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 1 1 0\n"
      " endloop\nendfacet\nfacet normal 0 0 1\n outer loop\n vertex -0 0 0\n vertex 1 1 0\n"
      " vertex 0 1 0\n endloop\nendfacet\nendsolid a\n";
  const MeshLists lists = read("a.stl", text);
  EXPECT_EQ(lists.points.size(), 4U);
  EXPECT_EQ(lists.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(refusal("a.stl", text.substr(0, text.find("endsolid"))),
            ": the file ends where 'facet' or 'endsolid' should follow.");
  EXPECT_EQ(refusal("a.stl", text.substr(0, text.find("vertex 1 1"))),
            ": the file ends where 'vertex' of facet 0 should follow.");

  write_mesh(file("b.stl"), sphere(2));
  const MeshLists back = read_mesh(file("b.stl"));
  EXPECT_EQ(back.points.size(), 66U);
  EXPECT_EQ(back.triangles.size(), 128U);
  EXPECT_TRUE(back.single_precision);
  const std::string bytes = bytes_of(file("b.stl"));
  EXPECT_EQ(refusal("c.stl", bytes.substr(0, bytes.size() - 1)),
            ": its STL header announces 128 triangles, which take 6484 bytes, but it has 6483.");
  EXPECT_EQ(refusal("c.stl", bytes.substr(0, 50)), ": the file ends in the STL header.");
}

struct DoublePoints : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};

template <class Traits>
void write_om(const std::filesystem::path& path) {
  OpenMesh::PolyMesh_ArrayKernelT<Traits> mesh;
  using P = typename OpenMesh::PolyMesh_ArrayKernelT<Traits>::Point;
  std::vector<OpenMesh::VertexHandle> v;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}}) {
    using S = typename P::value_type;
    v.push_back(mesh.add_vertex(P(S(x), S(y), S(0.1))));
  }
  mesh.add_face(v[0], v[1], v[2], v[3]);
  mesh.add_face(v[1], v[4], v[2]);
  ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, path.string()));
}

TEST_F(MeshReader, OmKeepsIdsCornersAndPrecision) {
  write_om<DoublePoints>(file("a.om"));
  const MeshLists wide = read_mesh(file("a.om"));
  EXPECT_EQ(wide.points.size(), 5U);
  EXPECT_EQ(wide.points[2], Point(1, 1, 0.1));
  EXPECT_EQ(wide.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}));
  EXPECT_EQ(wide.polygon_count, 1U);
  EXPECT_FALSE(wide.single_precision);
  write_om<OpenMesh::DefaultTraits>(file("b.om"));
  EXPECT_TRUE(read_mesh(file("b.om")).single_precision);
  EXPECT_EQ(read_mesh(file("b.om")).triangles, wide.triangles);
  EXPECT_EQ(refusal("c.om", "PM and more of it"),
            ": this is not an OM file: it does not begin with the letters OM.");
}

TEST_F(MeshReader, FilesThatAreNoMeshes) {
  EXPECT_THROW(read_mesh(file("absent.ply")), Error);
  EXPECT_THROW(read_mesh(file("absent")), Error);
  std::filesystem::create_directory(file("folder.ply"));
  for (const char* name : {"folder.ply", "absent.ply"}) {
    try {
      read_mesh(file(name));
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
    }
  }
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.om"}) {
    EXPECT_NE(refusal(name, ""), "");
    EXPECT_NE(refusal(name, "\n\n"), "");
    EXPECT_NE(refusal(name, std::string(200, '\0')), "");
  }
  EXPECT_EQ(
      refusal("a.xyz", "0 0 0\n"),
      ": '.xyz' is not a mesh format that Talweg reads: it is a cloud of points; make a surface "
      "of it first (with MeshLab or CloudCompare); expected " +
          readable_meshes() + ".");
}

/// Expects faces that refer only to existing vertices.
void expect_sound(const MeshLists& lists) {
  for (const Triangle& t : lists.triangles) {
    for (const std::uint32_t v : t) ASSERT_LT(v, lists.points.size());
  }
}

/// Expects a number for every element, and corners that refer only to existing entries.
void expect_sound(const MeshLists& lists, const MeshAttributes& a) {
  const std::size_t faces = lists.triangles.size();
  for (const auto& column : a.vertices) ASSERT_EQ(column.values.size(), lists.points.size());
  for (const auto& column : a.faces) ASSERT_EQ(column.values.size(), faces);
  for (const auto& names : a.names) ASSERT_EQ(names.of_face.size(), faces);
  for (const CornerAttribute* corners : {&a.texture, &a.normals}) {
    if (corners->dimension == 0) continue;
    ASSERT_EQ(corners->corners.size(), faces);
    for (const auto& face : corners->corners) {
      for (const std::uint32_t c : face) {
        ASSERT_TRUE(c == CornerAttribute::kNone || c < corners->values.size() / corners->dimension);
      }
    }
  }
}

/// Attributes of every kind.
MeshAttributes some_attributes(const MeshLists& lists) {
  MeshAttributes a;
  const std::size_t vertices = lists.points.size(), faces = lists.triangles.size();
  a.vertices.push_back({"red", NumberType::kUint8, std::vector<double>(vertices, 7)});
  a.vertices.push_back({"green", NumberType::kUint8, std::vector<double>(vertices, 7)});
  a.vertices.push_back({"blue", NumberType::kUint8, std::vector<double>(vertices, 7)});
  a.faces.push_back({"label", NumberType::kInt16, std::vector<double>(faces, -7)});
  a.texture = {2, {0, 0, 1, 0, 0, 1}, std::vector<Triangle>(faces, {0, 1, 2})};
  a.normals = {3, {0, 0, 1}, std::vector<Triangle>(faces, {0, 0, 0})};
  a.names.push_back({"usemtl", {"", "skin"}, std::vector<std::uint32_t>(faces, 1)});
  return a;
}

TEST_F(MeshReader, DamagedFilesGiveAnErrorOrASoundMesh) {
  const MeshLists lists = sphere(0);
  using Parser = MeshLists (*)(const MeshFile&, MeshAttributes*);
  const std::pair<const char*, Parser> formats[] = {
      {"a.obj", &read_obj}, {"a.off", &read_off},      {"a.ply", &read_ply},
      {"a.stl", &read_stl}, {"a.vtk", &read_vtk_mesh}, {"a.vtp", &read_vtp_mesh},
      {"a.om", &read_om}};
  for (const auto& [name, parse] : formats) {
    if (parse == &read_om) {
      write_om<DoublePoints>(file(name));
    } else {
      write_mesh(file(name), lists, some_attributes(lists));
    }
    const std::string whole = bytes_of(file(name));
    std::uint64_t random = 12345;
    for (std::size_t k = 0; k < 2000; ++k) {
      std::string damaged = whole;
      for (std::size_t hits = 1 + k % 3; hits > 0; --hits) {
        random = random * 6364136223846793005ULL + 1442695040888963407ULL;
        damaged[(random >> 33U) % damaged.size()] = static_cast<char>(random >> 20U);
      }
      if (k % 5 == 0) damaged.resize((random >> 40U) % damaged.size());
      try {
        // Files are read from memory; thousands of files would wear the disk.
        MeshAttributes attributes;
        const MeshLists read = parse({name, damaged}, k % 2 == 0 ? &attributes : nullptr);
        expect_sound(read);
        if (k % 2 == 0) expect_sound(read, attributes);
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      }
    }
  }
}

}  // namespace
}  // namespace talweg::test
