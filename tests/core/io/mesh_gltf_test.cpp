// glTF 2.0 as .gltf with data inside or beside it, and as .glb.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/format_bytes.hpp"
#include "core/temporary_folder.hpp"

namespace talweg::test::gltf_meshes {
namespace {

using Faces = std::vector<Triangle>;

std::string base64(std::string_view bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      bits = bits << 8U | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += k + i <= bytes.size() ? digits[bits >> (18 - 6 * i) & 63U] : '=';
    }
  }
  return text;
}

/// 0: four positions (48 bytes), 48: indices of two triangles in bytes (6), 56: in 32 bits (24),
/// 80: a strip in 16 bits (8), 88: one new position and its index (12 + 2).
std::string buffer() {
  std::string bytes;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) {
    put_number(bytes, x);
  }
  for (const std::uint8_t v : std::initializer_list<std::uint8_t>{0, 1, 2, 0, 2, 3})
    put_number(bytes, v);
  bytes += std::string(2, '\0');
  for (const std::uint32_t v : {0U, 1U, 2U, 0U, 2U, 3U}) put_number(bytes, v);
  for (const std::uint16_t v : std::initializer_list<std::uint16_t>{0, 1, 3, 2})
    put_number(bytes, v);
  for (const float x : {5.F, 6.F, 7.F}) put_number(bytes, x);
  put_number(bytes, std::uint16_t{3});
  return bytes;
}

/// Accessors: 0 positions, 1 indices u8, 2 u32, 3 the strip, 4 positions with the last replaced.
std::string gltf(const std::string& nodes, const std::string& primitives,
                 const std::string& uri = "data:application/octet-stream;base64," +
                                          base64(buffer()),
                 const std::string& more = "") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         R"(],"meshes":[{"name":"sheet","primitives":[)" + primitives +
         R"(]}],"buffers":[{"byteLength":102)" + (uri.empty() ? "" : R"(,"uri":")" + uri + "\"") +
         R"(}],"bufferViews":[{"buffer":0,"byteLength":48},
         {"buffer":0,"byteOffset":48,"byteLength":54}],"accessors":[
         {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
         {"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"},
         {"bufferView":1,"byteOffset":8,"componentType":5125,"count":6,"type":"SCALAR"},
         {"bufferView":1,"byteOffset":32,"componentType":5123,"count":4,"type":"SCALAR"},
         {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,
          "indices":{"bufferView":1,"byteOffset":52,"componentType":5123},
          "values":{"bufferView":1,"byteOffset":40}}}])" +
         more + "}";
}
std::string primitive(const std::string& rest, int position = 0) {
  return R"({"attributes":{"POSITION":)" + std::to_string(position) + "}" + rest + "}";
}
const Faces kTwo{{0, 1, 2}, {0, 2, 3}};

TEST(GltfMesh, IndicesOfAllSizesStripsAndFans) {
  const std::string node = R"({"mesh":0})";
  for (const char* indices : {R"(,"indices":1)", R"(,"indices":2)", R"(,"mode":6)"}) {
    const MeshLists lists = read_mesh("a.gltf", gltf(node, primitive(indices)));
    EXPECT_EQ(lists.unit.value().code(), "m");
    EXPECT_EQ(lists.triangles, kTwo) << indices;
    EXPECT_EQ(lists.points[2], Point(1, 1, 0));
    EXPECT_TRUE(lists.single_precision);
    EXPECT_TRUE(lists.notes.empty());
  }
  EXPECT_EQ(read_mesh("a.gltf", gltf(node, primitive(R"(,"indices":3,"mode":5)"))).triangles,
            (Faces{{0, 1, 3}, {3, 1, 2}}));
  const MeshLists sparse = read_mesh("a.gltf", gltf(node, primitive(R"(,"indices":1)", 4)));
  EXPECT_EQ(sparse.points[3], Point(5, 6, 7));
  EXPECT_EQ(sparse.points[2], Point(1, 1, 0));
}

TEST(GltfMesh, PrimitivesShareTheirVerticesAndLinesAreTold) {
  const MeshLists lists =
      read_mesh("a.gltf", gltf(R"({"mesh":0})", primitive(R"(,"indices":1)") + "," +
                                                    primitive(R"(,"indices":2)") + "," +
                                                    primitive(R"(,"mode":1)")));
  EXPECT_EQ(lists.points.size(), 4U);
  EXPECT_EQ(lists.triangles.size(), 4U);
  EXPECT_EQ(lists.notes,
            std::vector<std::string>{"1 sets of points or lines of the file were left out."});
}

TEST(GltfMesh, NodesArePlacedAndMirroredOnesTurned) {
  // A node scaled by 2, rotated by 90 degrees about z and moved; its child, mirrored in x.
  const MeshLists lists = read_mesh(
      "a.gltf",
      gltf(R"({"translation":[10,0,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476],
              "scale":[2,2,2],"mesh":0,"children":[1]},
              {"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,3,0,0,1]})",
           primitive(R"(,"indices":1)")));
  ASSERT_EQ(lists.points.size(), 8U);
  EXPECT_LT((lists.points[1] - Point(10, 2, 0)).norm(), 1e-14);
  EXPECT_LT((lists.points[3] - Point(8, 0, 0)).norm(), 1e-14);
  EXPECT_LT((lists.points[5] - Point(10, 4, 0)).norm(), 1e-14);  // (1,0,0) -> (2,0,0) -> (10,4,0)
  EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}}));
}

TEST(GltfMesh, AttributesAndNames) {
  std::string bytes;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) put_number(bytes, x);
  for (const std::uint8_t c :
       std::initializer_list<std::uint8_t>{255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 255}) {
    put_number(bytes, c);
  }
  for (int k = 0; k < 3; ++k) {
    for (const std::int8_t n : std::initializer_list<std::int8_t>{0, 0, 127, 0})
      put_number(bytes, n);
  }
  MeshAttributes attributes;
  const std::string text =
      R"({"asset":{"version":"2.1"},"nodes":[{"mesh":0,"name":"part"}],"materials":[{"name":"skin"}],
      "extensionsRequired":["KHR_mesh_quantization"],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1,"NORMAL":2},"material":0}]}],
      "buffers":[{"byteLength":60,"uri":"data:;base64,)" +
      base64(bytes) + R"("}],"bufferViews":[{"buffer":0,"byteLength":36},
      {"buffer":0,"byteOffset":36,"byteLength":12},
      {"buffer":0,"byteOffset":48,"byteLength":12,"byteStride":4}],"accessors":[
      {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
      {"bufferView":1,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"},
      {"bufferView":2,"componentType":5120,"normalized":true,"count":3,"type":"VEC3"}]})";
  const MeshLists lists = read_mesh("a.gltf", text, attributes);
  EXPECT_EQ(lists.triangles, (Faces{{0, 1, 2}}));
  ASSERT_EQ(attributes.vertices.size(), 7U);
  EXPECT_EQ(attributes.vertices[2].name, "nz");
  EXPECT_EQ(attributes.vertices[2].values, (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(attributes.vertices[5].name, "blue");
  EXPECT_EQ(attributes.vertices[5].values, (std::vector<double>{51, 51, 51}));
  ASSERT_EQ(attributes.names.size(), 2U);
  EXPECT_EQ(attributes.names[0].names[1], "part");
  EXPECT_EQ(attributes.names[1].names[1], "skin");
}

std::string glb(std::string text, const std::string& data) {
  while (text.size() % 4 != 0) text += ' ';
  std::string bytes = "glTF";
  put_number(bytes, 2U);
  put_number(bytes, static_cast<std::uint32_t>(28 + text.size() + data.size()));
  put_number(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += "JSON" + text;
  put_number(bytes, static_cast<std::uint32_t>(data.size()));
  bytes += "BIN";
  bytes += '\0';
  return bytes + data;
}

TEST(GltfMesh, Glb) {
  const std::string bytes = glb(gltf(R"({"mesh":0})", primitive(R"(,"indices":1)"), ""), buffer());
  EXPECT_EQ(read_mesh("a.glb", bytes).triangles, kTwo);
  EXPECT_NE(refusal_of("a.glb", bytes.substr(0, 200)).find("a chunk at byte 12 has"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.glb", bytes.substr(0, bytes.size() - 110)).find("it has no uri"),
            std::string::npos);
  EXPECT_NE(refusal_of("a.glb", bytes.substr(0, 10)).find("header"), std::string::npos);
}

class GltfFiles : public TemporaryFolder {};

TEST_F(GltfFiles, BuffersBesideTheFile) {
  write("some data.bin", buffer());
  const std::string node = R"({"mesh":0})", what = primitive(R"(,"indices":1)");
  write("a.gltf", gltf(node, what, "some%20data.bin"));
  EXPECT_EQ(read_mesh(file("a.gltf")).triangles, kTwo);
  for (const char* away : {"../a.bin", "/etc/passwd", "x/../../a.bin", "file:///a.bin", "C:/a.bin",
                           "%2e%2e/a.bin", "http://a.org/a.bin", ""}) {
    const std::string name = std::string("b.gltf");
    write(name, gltf(node, what, away));
    if (std::string_view(away).empty()) continue;  // the node then has no uri
    try {
      read_mesh(file(name));
      ADD_FAILURE() << away;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("outside the folder of the file"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_NE(refusal_of("a.gltf", gltf(node, what, "absent.bin"))
                .find("'absent.bin', which should lie beside this one, cannot be read"),
            std::string::npos);
}

TEST(GltfMesh, Errors) {
  const std::string node = R"({"mesh":0})", good = primitive(R"(,"indices":1)");
  const auto says = [](const std::string& text, const char* words) {
    EXPECT_NE(refusal_of("a.gltf", text).find(words), std::string::npos)
        << refusal_of("a.gltf", text);
  };
  EXPECT_EQ(refusal_of("a.gltf", gltf(node, good)), "");
  says(gltf(R"({"mesh":1})", good), "meshes: there is no mesh 1");
  says(gltf(R"({"mesh":0,"children":[0]})", good), "nodes[0]: the node occurs twice");
  says(gltf(R"({"children":[9]})", good), "there is no node 9");
  says(gltf(R"({"name":"empty"})", good), "no triangles");
  says(gltf(node, primitive(R"(,"indices":7)")), "accessors: there is no accessor 7");
  says(gltf(node, primitive(R"(,"indices":0)")), "expected the type SCALAR, found 'VEC3'");
  says(gltf(node, primitive(R"(,"indices":3)")), "4 corners are not a multiple of 3");
  says(gltf(node, primitive(R"(,"extensions":{"KHR_draco_mesh_compression":{}})")),
       "KHR_draco_mesh_compression, which is not read; export it without compression");
  says(gltf(node, good, "data:;base64,####"), "buffers[0].uri: its data are not base64");
  says(gltf(node, good, "data:;base64,AAAA"), "it should have 102 bytes, but has 3");
  says(gltf(node, good, "data:,x", R"(,"extensionsRequired":["EXT_unknown"])"),
       "it needs the extension EXT_unknown");
  says(R"({"asset":{"version":"1.0"}})", "it is glTF 1.0; only version 2 is read");
  says("{", "line 1");
  std::string lies = gltf(node, good);
  lies.replace(lies.find(R"("count":4)"), 9, R"("count":4000000000)");
  says(lies, "its 4000000000 elements are more than the buffer view has");
  lies = gltf(node, good);
  lies.replace(lies.find(R"("bufferView":0,"componentType":5126,"count":4)"), 45,
               R"("componentType":5126,"count":4000000000)");
  says(lies, "its 4000000000 elements have no data");
}

}  // namespace
}  // namespace talweg::test::gltf_meshes
