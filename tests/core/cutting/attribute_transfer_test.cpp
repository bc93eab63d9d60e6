// Normals, colours, texture coordinates, labels and names, from file to file through a cut.
#include "talweg/core/cutting/attribute_transfer.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/temporary_folder.hpp"
#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/core/cutting/tagged_edges.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

const AttributeColumn& column(const std::vector<AttributeColumn>& columns, const char* name) {
  for (const AttributeColumn& c : columns) {
    if (c.name == name) return c;
  }
  ADD_FAILURE() << "no column " << name;
  return columns.front();
}

/// A square of two triangles as text, with all kinds of PLY attributes.
const char* const kPly = R"(ply
format ascii 1.0
comment TextureFile skin.png
element vertex 4
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property double quality
property int label
property list uchar float weights
element face 2
property list uchar int vertex_indices
property short region
property list uchar float texcoord
property uchar red
element edge 1
property int vertex1
property int vertex2
end_header
0 0 0 0 0 1 0 0 255 0.5 -7 0
1 0 0 0 0.6 0.8 255 0 255 nan 8 1 3
1 1 0 0 0 1 255 100 255 2.5 9 0
0 1 0 0 0 1 0 100 255 1.5 10 0
3 0 1 2 -4 6 0 0 1 0 1 1 77
3 0 2 3 5 6 0 0 1 1 0 1 78
0 1
)";

TEST(MeshAttributes, OfAPlyFileAreReadInTheirTypes) {
  MeshAttributes a;
  const MeshLists lists = read_mesh("square.ply", kPly, a);
  EXPECT_EQ(lists.triangles.size(), 2U);
  ASSERT_EQ(a.vertices.size(), 8U);
  EXPECT_EQ(column(a.vertices, "red").type, NumberType::kUint8);
  EXPECT_EQ(column(a.vertices, "red").values, (std::vector<double>{0, 255, 255, 0}));
  EXPECT_EQ(column(a.vertices, "label").type, NumberType::kInt32);
  EXPECT_EQ(column(a.vertices, "label").values, (std::vector<double>{-7, 8, 9, 10}));
  EXPECT_TRUE(std::isnan(column(a.vertices, "quality").values[1]));
  EXPECT_EQ(column(a.faces, "region").values, (std::vector<double>{-4, 5}));
  EXPECT_EQ(column(a.faces, "red").values, (std::vector<double>{77, 78}));
  ASSERT_EQ(a.texture.corners.size(), 2U);
  EXPECT_EQ(a.texture.values[2 * a.texture.corners[1][2] + 1], 1);
  EXPECT_EQ(a.references, std::vector<std::string>{"comment TextureFile skin.png"});
  EXPECT_EQ(a.left_out,
            (std::vector<std::string>{"list 'weights' of element 'vertex'", "element 'edge'"}));
}

TEST(MeshAttributes, OfAPolygonAreThoseOfItsTriangles) {
  MeshAttributes a;
  const MeshLists lists = read_mesh("quad.ply",
                                    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                    "property float y\nproperty float z\nelement face 1\n"
                                    "property int label\nproperty list uchar int vertex_indices\n"
                                    "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n17 4 0 1 2 3\n",
                                    a);
  EXPECT_EQ(lists.triangles.size(), 2U);
  EXPECT_EQ(column(a.faces, "label").values, (std::vector<double>{17, 17}));
}

TEST(MeshAttributes, OfAnObjFileAreReadWithItsNames) {
  MeshAttributes a;
  read_mesh(
      "square.obj",
      "mtllib skin.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0\nv 0 1 0 0 0 1\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\ng left side\nusemtl skin\nf 1/1/1 2/2/1 3/3/1\n"
      "usemtl bone\nf -4/-4/-1 -2/-2/-1 -1/-1/-1\nl 1 2\n",
      a);
  EXPECT_EQ(column(a.vertices, "green").values, (std::vector<double>{0, 1, 1, 0}));
  EXPECT_EQ(a.texture.values.size(), 8U);
  EXPECT_EQ(a.texture.corners[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(a.normals.corners[1], (std::array<std::uint32_t, 3>{0, 0, 0}));
  ASSERT_EQ(a.names.size(), 2U);
  EXPECT_EQ(a.names[0].names[a.names[0].of_face[1]], "left side");
  EXPECT_EQ(a.names[1].names[a.names[1].of_face[0]], "skin");
  EXPECT_EQ(a.names[1].names[a.names[1].of_face[1]], "bone");
  EXPECT_EQ(a.left_out, std::vector<std::string>{"statement 'l'"});
}

TEST(MeshAttributes, OfOtherFormatsAreNamedOnly) {
  MeshAttributes a;
  read_mesh("colours.off", "COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2 1 0 0\n",
            a);
  EXPECT_EQ(a.left_out.size(), 2U);
  read_mesh("plain.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", a);
  EXPECT_TRUE(a.left_out.empty());
}

TEST(MeshAttributes, InvalidAttributesAreRefused) {
  const auto expect_refused = [](const char* name, std::string text, const char* what) {
    MeshAttributes a;
    try {
      read_mesh(name, text, a);
      ADD_FAILURE() << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  std::string ply = kPly;
  ply.replace(ply.find("0.5 -7"), 3, "red");
  expect_refused("bad.ply", ply, "line 26: expected a number for 'quality', found 'red'");
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
  expect_refused("bad.obj", triangle + "f 1/1 2/1 3/2\n", "texture coordinate 2");
  expect_refused("bad.obj", triangle + "f 1/1 2/1 3/0\n", "line 5");
  expect_refused("bad.obj", triangle + "f 1//1 2//1 3//1\n", "normal 1");
  expect_refused("bad.obj", triangle + "vn 0 1\nf 1 2 3\n", "a normal");
  expect_refused("bad.obj", "v 0 0 0 x\n", "after the coordinates");
}

TEST(MeshAttributes, ManyPropertiesTakeNoMoreMemoryThanFitsTheFile) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n";
  for (int k = 0; k < 200; ++k) text += "property uchar p" + std::to_string(k) + "\n";
  text += "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  for (int k = 0; k < 200; ++k) text += " 1";
  MeshAttributes a;
  read_mesh("many.ply", text + "\n", a);
  EXPECT_EQ(a.faces.size(), 64U);
  EXPECT_FALSE(a.left_out.empty());
}

class AttributeTransfer : public test::TemporaryFolder {
 protected:
  AttributeTransfer() : lists_(read_mesh("square.ply", kPly, attributes_)) {}

  /// Along the middle, from the edge 0-3 to 1-2: crosses the diagonal.
  CutMesh cut_in_the_middle(const SurfaceMesh& mesh) {
    const Surface& s = mesh.surface();
    const auto on = [&](std::uint32_t a, std::uint32_t b, double t) {
      const HalfedgeId h = s.find_halfedge(VertexId{a}, VertexId{b});
      const bool along = h == halfedge_of(edge_of(h));
      return SurfacePoint::on_edge(s, edge_of(h), along ? t : 1 - t);
    };
    SurfaceCurve curve;
    curve.points = {on(0, 3, 0.25), on(0, 2, 0.25), on(1, 2, 0.25)};
    return cut_along(mesh, std::span(&curve, 1));
  }

  MeshAttributes attributes_;
  MeshLists lists_;
};

TEST_F(AttributeTransfer, InterpolatesRoundsNormalisesAndTakesTheNearest) {
  const SurfaceMesh mesh = SurfaceMesh::open(lists_);
  const CutMesh cut = cut_in_the_middle(mesh);
  ASSERT_EQ(cut.lists.points.size(), 7U);
  const MeshAttributes now = carried_to(cut, mesh.surface(), attributes_);
  for (std::size_t v = 4; v < 7; ++v) {
    const Point& p = cut.lists.points[v];
    const auto at = [&](const char* name) { return column(now.vertices, name).values[v]; };
    // Colours are linear over the square: red 255 x, green 100 y.
    EXPECT_EQ(at("red"), std::round(255 * p.x()));
    EXPECT_EQ(at("green"), 25);
    EXPECT_EQ(at("blue"), 255);
    EXPECT_NEAR(std::hypot(at("nx"), at("ny"), at("nz")), 1, 1e-15);
    EXPECT_EQ(at("label"), p.x() == 1 ? 8 : -7);  // nearest are 0, 0 and 1
    if (p.x() == 1) {
      EXPECT_TRUE(std::isnan(at("quality")));  // vertex 1 has no value
      // (0, 0.6, 0.8) and (0, 0, 1) at a quarter.
      EXPECT_NEAR(at("ny") / at("nz"), 0.45 / 0.85, 1e-15);
    } else {
      EXPECT_NEAR(at("quality"), p.x() == 0 ? 0.75 : 1.0, 1e-15);
    }
  }
  for (std::size_t f = 0; f < cut.face_from.size(); ++f) {
    EXPECT_EQ(column(now.faces, "region").values[f], cut.face_from[f] == 0 ? -4 : 5);
    for (std::size_t k = 0; k < 3; ++k) {  // (u, v) is (x, y)
      const Point& p = cut.lists.points[cut.lists.triangles[f][k]];
      const std::size_t c = now.texture.corners[f][k];
      EXPECT_NEAR(now.texture.values[2 * c], p.x(), 1e-15);
      EXPECT_NEAR(now.texture.values[2 * c + 1], p.y(), 1e-15);
    }
  }
}

TEST_F(AttributeTransfer, LidsAreWhiteAndZero) {
  const std::uint32_t vertices[] = {3, 1, kNoVertex}, faces[] = {1, kNoFace};
  const MeshAttributes part = picked(attributes_, vertices, faces);
  EXPECT_EQ(column(part.vertices, "label").values, (std::vector<double>{10, 8, 0}));
  EXPECT_EQ(column(part.faces, "region").values, (std::vector<double>{5, 0}));
  EXPECT_EQ(column(part.faces, "red").values, (std::vector<double>{78, 255}));
  EXPECT_EQ(part.texture.corners[1][0], CornerAttribute::kNone);
  EXPECT_EQ(part.texture.values.size(), 6U);  // no face uses the other values
}

TEST_F(AttributeTransfer, GoesThroughPlyFilesUnchanged) {
  const TaggedEdge edges[] = {{0, 2, 3}};
  const auto left = write_mesh(file("out.ply"), lists_, attributes_, edges);
  EXPECT_TRUE(left.empty());
  MeshAttributes again;
  const MeshLists lists = read_mesh(file("out.ply"), again);
  EXPECT_EQ(lists.points, lists_.points);
  EXPECT_EQ(lists.triangles, lists_.triangles);
  ASSERT_EQ(again.vertices.size(), attributes_.vertices.size());
  for (std::size_t c = 0; c < again.vertices.size(); ++c) {
    EXPECT_EQ(again.vertices[c].name, attributes_.vertices[c].name);
    EXPECT_EQ(again.vertices[c].type, attributes_.vertices[c].type);
    if (again.vertices[c].name == "quality") continue;  // has a nan
    for (std::size_t v = 0; v < 4; ++v) {
      EXPECT_FLOAT_EQ(static_cast<float>(again.vertices[c].values[v]),
                      static_cast<float>(attributes_.vertices[c].values[v]));
    }
  }
  EXPECT_EQ(column(again.faces, "region").values, column(attributes_.faces, "region").values);
  EXPECT_EQ(again.references, attributes_.references);
  EXPECT_EQ(again.texture.corners.size(), 2U);
}

TEST_F(AttributeTransfer, GoesToObjAndSaysWhatDoesNot) {
  const auto left = write_mesh(file("out.obj"), lists_, attributes_);
  EXPECT_EQ(left, (std::vector<std::string>{"'quality' of vertices", "'label' of vertices",
                                            "'region' of faces", "'red' of faces",
                                            "'comment TextureFile skin.png'"}));
  MeshAttributes again;
  read_mesh(file("out.obj"), again);
  EXPECT_EQ(column(again.vertices, "red").values, (std::vector<double>{0, 1, 1, 0}));
  EXPECT_NEAR(column(again.vertices, "green").values[2], 100.0 / 255, 1e-12);
  EXPECT_EQ(again.normals.values.size(), 12U);
  EXPECT_EQ(again.texture.corners, attributes_.texture.corners);
  EXPECT_EQ(again.texture.values, attributes_.texture.values);
  const auto none = write_mesh(file("out.stl"), lists_, attributes_);
  EXPECT_EQ(none.size(), 8U + 2 + 1 + 1);
}

TEST_F(AttributeTransfer, ObjNamesGoThroughACut) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 1\nusemtl skin\nf 1//1 2//1 3//1\n"
      "usemtl bone\nf 1//2 3//2 4//2\n";
  MeshAttributes a;
  const SurfaceMesh mesh = SurfaceMesh::open(read_mesh("square.obj", text, a));
  const CutMesh cut = cut_in_the_middle(mesh);
  const MeshAttributes now = carried_to(cut, mesh.surface(), a);
  // The new vertex on the diagonal has a separate normal on either side of the crease.
  EXPECT_EQ(now.normals.values.size(), 3U * (2 + 4));
  EXPECT_TRUE(write_mesh(file("cut.obj"), cut.lists, now).empty());
  const std::string written = bytes_of(file("cut.obj"));
  EXPECT_LT(written.find("usemtl skin"), written.find("usemtl bone"));
  EXPECT_EQ(written.find("usemtl skin"), written.rfind("usemtl skin"));
  // In PLY a vertex has one normal.
  EXPECT_EQ(
      write_mesh(file("cut.ply"), cut.lists, now),
      (std::vector<std::string>{"normals that differ between corners", "names of faces (usemtl)"}));
}

TEST_F(AttributeTransfer, FollowsARepair) {
  // A third face beside, on copies of vertices 1 and 2, of which one has another colour.
  MeshLists lists = lists_;
  MeshAttributes a = attributes_;
  lists.points.insert(lists.points.end(), {{1, 0, 0}, {1, 1, 0}, {2, 0, 0}});
  lists.triangles.push_back({4, 5, 6});  // turned the wrong way
  for (AttributeColumn& c : a.vertices) {
    for (const std::size_t v : {1U, 2U, 0U}) c.values.push_back(c.values[v]);
    if (c.name == "red") c.values[5] = 3;
  }
  for (AttributeColumn& c : a.faces) c.values.push_back(99);
  const auto first = static_cast<std::uint32_t>(a.texture.values.size() / 2);
  a.texture.values.insert(a.texture.values.end(), {1, 0, 1, 1, 2, 0});
  a.texture.corners.push_back({first, first + 1, first + 2});
  const RepairedMesh repaired = repair(lists);
  std::size_t differing = 0;
  const MeshAttributes now = of_repaired(a, repaired.map, differing);
  EXPECT_EQ(differing, 1U);
  ASSERT_EQ(repaired.lists.triangles.size(), 3U);
  EXPECT_EQ(column(now.faces, "red").values[2], 99);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& p = repaired.lists.points[repaired.lists.triangles[2][k]];
    EXPECT_EQ(now.texture.values[2 * now.texture.corners[2][k]], p.x());
    EXPECT_EQ(now.texture.values[2 * now.texture.corners[2][k] + 1], p.y());
  }
}

TEST_F(AttributeTransfer, RefusesOtherNumbersOfThings) {
  const SurfaceMesh mesh = SurfaceMesh::open(lists_);
  const CutMesh cut = cut_in_the_middle(mesh);
  attributes_.vertices[0].values.pop_back();
  EXPECT_THROW(carried_to(cut, mesh.surface(), attributes_), Error);
  EXPECT_THROW(write_mesh(file("bad.ply"), lists_, attributes_), Error);
}

TEST(TaggedEdges, AreThoseOfTheChainsOnBothSidesOfASeam) {
  const MeshLists lists = test::grid(10, 10);
  const CutMesh::Chain chains[] = {{false, {44, 45, 46}}, {false, {46, 57}}};
  // Origins of a mesh whose vertices are copies of the vertices `vertex_from` of the chains' mesh.
  const auto curves_of = [&](const std::vector<std::uint32_t>& vertex_from) {
    std::vector<PartOrigins::Curve> curves;
    for (const CutMesh::Chain& chain : chains) {
      PartOrigins::Curve& curve = curves.emplace_back();
      for (const std::uint32_t at : chain.vertices) {
        auto& place = curve.vertices.emplace_back();
        for (std::uint32_t v = 0; v < vertex_from.size(); ++v) {
          if (vertex_from[v] == at) place.push_back(v);
        }
      }
    }
    return curves;
  };
  std::vector<std::uint32_t> itself(lists.points.size());
  for (std::uint32_t v = 0; v < itself.size(); ++v) itself[v] = v;
  const auto whole = tagged_edges(lists.triangles, curves_of(itself));
  ASSERT_EQ(whole.size(), 3U);
  EXPECT_EQ(whole[1].from, 45U);
  EXPECT_EQ(whole[1].to, 46U);
  EXPECT_EQ(whole[2].curve, 1U);
  const OpenedSeams open = open_seams(lists, chains);
  EXPECT_EQ(tagged_edges(open.lists.triangles, curves_of(open.vertex_from)).size(), 6U);
}

}  // namespace
}  // namespace talweg
