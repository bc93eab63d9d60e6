// Plugins written with talweg_plugin_openmesh.hpp: attributes become properties and return, also on
// made meshes.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "plugins/openmesh_probe.hpp"

namespace talweg::test {
namespace {

host::Attribute attribute(const char* name, std::uint32_t element, std::uint32_t columns,
                          std::vector<double> values) {
  host::Attribute result;
  result.name = name;
  result.element = element;
  result.columns = columns;
  result.values = std::move(values);
  return result;
}

std::vector<double> counted(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k) values[k] = double(k % 100);
  return values;
}

TEST_F(OpenMeshPlugin, AttributesAreProperties) {
  const std::size_t n = lists.points.size(), m = lists.triangles.size();
  std::vector<float> colours(4 * n, 0.5F);
  std::vector<std::uint8_t> bytes(m, 7);
  std::vector<double> corners = counted(3 * m * 2);
  talweg_attribute colour = {sizeof colour,
                             TALWEG_OF_VERTICES,
                             TALWEG_CARRY_LINEAR,
                             0,
                             "colour",
                             1,
                             {colours.data(), n, 0, 4, TALWEG_FLOAT32},
                             plugin::kNoArray};
  talweg_attribute kind = {sizeof kind,
                           TALWEG_OF_TRIANGLES,
                           TALWEG_CARRY_NEAREST,
                           0,
                           "kind",
                           0,
                           {bytes.data(), m, 0, 1, TALWEG_UINT8},
                           plugin::kNoArray};
  talweg_attribute uv = {sizeof uv,
                         TALWEG_OF_CORNERS,
                         TALWEG_CARRY_LINEAR,
                         0,
                         "uv",
                         0,
                         {corners.data(), 3 * m, 0, 2, TALWEG_FLOAT64},
                         plugin::kNoArray};
  const talweg_attribute* all[] = {&colour, &kind, &uv};
  instance.set_attributes(std::span<const talweg_attribute* const>(all));
  Probe::look = [&](const Probe& probe) {
    const auto& mesh = probe.seen();
    OpenMesh::VPropHandleT<OpenMesh::Vec4f> v;
    ASSERT_TRUE(mesh.get_property_handle(v, "colour"));
    EXPECT_EQ(mesh.property(v, VertexHandle(3))[2], 0.5F);
    OpenMesh::FPropHandleT<std::uint8_t> f;
    ASSERT_TRUE(mesh.get_property_handle(f, "kind"));
    EXPECT_EQ(mesh.property(f, FaceHandle(3)), 7);
    OpenMesh::HPropHandleT<OpenMesh::Vec2d> h;
    ASSERT_TRUE(mesh.get_property_handle(h, "uv"));
    const auto corner = openmesh::corner_halfedges(mesh, FaceHandle(2))[1];
    EXPECT_EQ(mesh.property(h, corner), OpenMesh::Vec2d(corners[14], corners[15]));
    EXPECT_EQ(mesh.to_vertex_handle(corner).idx(), static_cast<int>(lists.triangles[2][1]));
  };
  run("copy");
  const std::vector<host::Attribute> back = instance.attributes(0);
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back[0].type, TALWEG_FLOAT32);
  EXPECT_EQ(back[0].values, std::vector<double>(4 * n, 0.5));
  EXPECT_EQ(back[1].type, TALWEG_UINT8);
  EXPECT_EQ(back[2].values, corners);
  EXPECT_TRUE(back[2].corners.empty());
  EXPECT_TRUE(said.empty());
}

TEST_F(OpenMeshPlugin, AttributesOfEveryTypeAndWidthComeBackUnchanged) {
  const std::size_t n = lists.points.size();
  for (std::uint32_t type = TALWEG_FLOAT64; type <= TALWEG_UINT16; ++type) {
    for (const std::uint32_t columns : {1, 2, 3, 4, 5, 64}) {
      const openmesh::OwnedAttribute given = [&] {
        openmesh::OwnedAttribute made{
            "x", TALWEG_OF_VERTICES, TALWEG_CARRY_NEAREST, 0, columns, type, {}, {}};
        for (const double value : counted(n * columns)) {
          openmesh::detail::append_number(value, type, made.values);
        }
        return made;
      }();
      const talweg_attribute view = given.view();
      const talweg_attribute* all[] = {&view};
      instance.set_attributes(std::span<const talweg_attribute* const>(all));
      run("copy");
      const host::Attribute back = instance.attributes(0).at(0);
      EXPECT_EQ(back.type, type);
      EXPECT_EQ(back.columns, columns);
      EXPECT_EQ(back.values, counted(n * columns)) << type << " " << columns;
    }
  }
}

TEST_F(OpenMeshPlugin, CornersKeepTheirSharedEntries) {
  host::Attribute uv = attribute("uv", TALWEG_OF_CORNERS, 2, {0, 0, 1, 0, 0, 1});
  uv.corners.assign(lists.triangles.size(), {0, 1, 2});
  uv.corners[4] = {2, TALWEG_NO_ENTRY, 0};
  instance.set_attributes({uv});
  run("copy");
  const host::Attribute back = instance.attributes(0).at(0);
  ASSERT_EQ(back.corners.size(), uv.corners.size());
  for (std::size_t f = 0; f < uv.corners.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t then = uv.corners[f][k], now = back.corners[f][k];
      ASSERT_EQ(now == TALWEG_NO_ENTRY, then == TALWEG_NO_ENTRY);
      if (then == TALWEG_NO_ENTRY) continue;
      EXPECT_EQ(back.values[2 * now], uv.values[2 * then]);
      EXPECT_EQ(back.values[2 * now + 1], uv.values[2 * then + 1]);
    }
  }
  EXPECT_LT(back.values.size() / 2, 3 * lists.points.size() + 1);  // at most three at a vertex
}

TEST_F(OpenMeshPlugin, BadAttributesAreRefused) {
  const std::size_t n = lists.points.size();
  const auto refusal_of = [&](const host::Attribute& wrong) {
    return sentence_of([&] { instance.set_attributes({wrong}); });
  };
  const host::Attribute good = attribute("x", TALWEG_OF_VERTICES, 1, counted(n));
  EXPECT_EQ(sentence_of([&] {
              instance.set_attributes({good, good});
            }),
            "The attribute \"x\" is given twice.");
  EXPECT_EQ(refusal_of(attribute("x", TALWEG_OF_VERTICES, 1, {1, 2})),
            "The attribute \"x\" has 2 rows, not 49.");
  EXPECT_EQ(refusal_of(attribute("x", 9, 1, counted(n))),
            "The attribute \"x\" is of the unknown element 9.");
  EXPECT_EQ(refusal_of(attribute("", TALWEG_OF_VERTICES, 1, counted(n))),
            "An attribute has no name.");
  EXPECT_EQ(refusal_of(attribute("v:points", TALWEG_OF_VERTICES, 3, counted(3 * n))),
            "The attribute \"v:points\" has the name of OpenMesh's points.");
  host::Attribute corners = attribute("uv", TALWEG_OF_CORNERS, 1, {0, 1});
  corners.corners.assign(lists.triangles.size(), {0, 1, 2});
  EXPECT_EQ(refusal_of(corners),
            "The attribute \"uv\" has the entry 2 at triangle 0, but only 2 entries.");
  instance.set_attributes({good});  // the refused attributes left no trace
  EXPECT_EQ(sentence_of([&] { run("copy"); }), "no error");
}

TEST_F(OpenMeshPlugin, DeletedElementsNeedNotBeCollected) {
  instance.set_attributes({attribute("face", TALWEG_OF_TRIANGLES, 1, counted(72)),
                           attribute("vertex", TALWEG_OF_VERTICES, 1, counted(49))});
  instance.set_curves({at({8, 9, 10}), at({0, 1})});
  const host::Results results = run("delete");
  const host::Mesh& mesh = results.meshes.at(0);
  EXPECT_EQ(mesh.positions.size(), 48U);
  const host::Origin origin = instance.origin(0);
  const std::vector<host::Attribute> back = instance.attributes(0);
  ASSERT_EQ(origin.vertices.size(), 48U);
  for (std::size_t v = 0; v < 48; ++v) {
    EXPECT_EQ(origin.vertices[v][0], v + 1);
    EXPECT_EQ(origin.weights[v], (std::array<double, 3>{1, 0, 0}));
    EXPECT_EQ(back[1].values[v], double(v + 1));
    EXPECT_EQ(mesh.positions[v][0], lists.points[v + 1].x());
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& was = lists.triangles[origin.triangles[f]];
    EXPECT_EQ(back[0].values[f], double(origin.triangles[f]));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(mesh.triangles[f][k] + 1, was[k]);
  }
  // One of the curves is still a chain of edges.
  EXPECT_EQ(origin.lengths, (std::vector<std::uint32_t>{3, 0}));
  EXPECT_EQ(origin.chains.at(1), (std::array<std::uint32_t, 3>{0, 1, 8}));
}

TEST_F(OpenMeshPlugin, LostPropertiesAreReported) {
  instance.set_attributes({attribute("x", TALWEG_OF_VERTICES, 1, counted(49))});
  run("own");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].substr(0, 33), "The vertex property \"name\" holds ");
  EXPECT_NE(said[0].find("string"), std::string::npos);
  const std::vector<host::Attribute> back = instance.attributes(0);
  ASSERT_EQ(back.size(), 3U);  // the attributes of the host, then those of the plugin
  EXPECT_EQ(back[0].name, "x");
  EXPECT_EQ(back[1].name, "twice");
  EXPECT_EQ(back[2].name, "marked");
  said.clear();
  run("scratch");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(said[0].starts_with(
      "The new mesh does not have the property \"x\"; all values of this attribute are "))
      << said[0];
  EXPECT_EQ(instance.attributes(0).at(0).values, std::vector<double>(3, 0));
  const host::Origin origin = instance.origin(0);
  EXPECT_EQ(origin.vertices.at(0)[0], TALWEG_NO_VERTEX);
  EXPECT_EQ(origin.triangles.at(0), TALWEG_NO_TRIANGLE);
  EXPECT_EQ(origin.lengths, std::vector<std::uint32_t>{0});
}

TEST_F(OpenMeshPlugin, NewVerticesLieBetweenOldOnes) {
  const host::Mesh mesh = run("between").meshes.at(0);
  const host::Origin origin = instance.origin(0);
  ASSERT_EQ(origin.vertices.size(), 50U);
  EXPECT_EQ(origin.weights[49], (std::array<double, 3>{0.5, 0.5, 0}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(mesh.positions[49][i], (mesh.positions[origin.vertices[49][0]][i] +
                                      mesh.positions[origin.vertices[49][1]][i]) /
                                         2);
  }
}

TEST_F(OpenMeshPlugin, MeshesAreSharedAndAttributesAreNot) {
  host::Instance other(*tp::Adapter<Probe>::plugin(), services);
  instance.set_attributes({attribute("x", TALWEG_OF_VERTICES, 1, counted(49))});
  other.share_mesh(instance);
  other.set_curves({at({0, 1})});
  host::Wanted wanted;
  wanted.meshes = true;
  EXPECT_EQ(other.run(wanted).meshes.size(), 1U);
  EXPECT_TRUE(other.attributes(0).empty());
  run("copy");
  EXPECT_EQ(instance.attributes(0).size(), 1U);
  EXPECT_EQ(sentence_of([&] { static_cast<void>(instance.origin(1)); }),
            "There is no mesh 1: 1 were made by the last run that gave meshes.");
  instance.set_curves({at({0, 1})});
  EXPECT_EQ(sentence_of([&] { static_cast<void>(instance.origin(0)); }),
            "There is no mesh 0: 0 were made by the last run that gave meshes.");
}

}  // namespace
}  // namespace talweg::test
