// Hosts written with talweg_host_openmesh.hpp have the same results as talweg_host.hpp with the
// same numbers.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/plugin/talweg_host_openmesh.hpp"

namespace talweg {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

struct Doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Single = OpenMesh::TriMesh_ArrayKernelT<>;
using Double = OpenMesh::TriMesh_ArrayKernelT<Doubles>;

template <class Mesh>
Mesh mesh_of(const MeshLists& lists) {
  Mesh mesh;
  using Scalar = openmesh::ScalarOf<Mesh>;
  for (const Point& p : lists.points) {
    mesh.add_vertex(
        {static_cast<Scalar>(p.x()), static_cast<Scalar>(p.y()), static_cast<Scalar>(p.z())});
  }
  for (const Triangle& t : lists.triangles) {
    const auto v = [&](std::size_t k) { return VertexHandle(static_cast<int>(t[k])); };
    mesh.add_face(v(0), v(1), v(2));
  }
  return mesh;
}

openmesh::Curve at(const std::vector<int>& vertices) {
  openmesh::Curve curve;
  for (const int v : vertices) curve.points.push_back({VertexHandle(v), FaceHandle(), {}});
  return curve;
}

/// A curve along the edges of a row of hills(40), with a step in the middle.
openmesh::Curve stairs() {
  std::vector<int> vertices;
  for (int k = 0; k <= 20; ++k) vertices.push_back(14 * 41 + k);
  for (int row = 15; row <= 20; ++row) vertices.push_back(row * 41 + 20);
  for (int k = 21; k <= 40; ++k) vertices.push_back(20 * 41 + k);
  return at(vertices);
}

std::string sentence_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const host::Error& error) {
    return error.what();
  }
  return "no error";
}

struct OpenMeshHost : testing::Test {
  MeshLists lists = test::hills(40);
  host::Services services{"test", "1"};
  const talweg_plugin& smooth = test::plugin_of_this_build("talweg.smooth");
  const talweg_plugin& cut = test::plugin_of_this_build("talweg.cut");
};

TEST_F(OpenMeshHost, PointsAreNotCopied) {
  const Single single = mesh_of<Single>(lists);
  const openmesh::MeshArrays<Single> arrays(single);
  EXPECT_EQ(arrays.positions().data, single.points());
  EXPECT_EQ(arrays.positions().type, TALWEG_FLOAT32);
  Double doubled = mesh_of<Double>(lists);
  EXPECT_EQ(openmesh::MeshArrays<Double>(doubled).positions().data, doubled.points());
  doubled.request_vertex_status();
  doubled.request_edge_status();
  doubled.request_face_status();
  EXPECT_EQ(openmesh::MeshArrays<Double>(doubled).positions().data, doubled.points());
  doubled.delete_vertex(VertexHandle(5), false);
  EXPECT_NE(openmesh::MeshArrays<Double>(doubled).positions().data, doubled.points());
}

TEST_F(OpenMeshHost, SmoothsACurveOnASinglePrecisionMesh) {
  Single mesh = mesh_of<Single>(lists);
  host::OpenMeshInstance<Single> instance(smooth, services);
  instance.set_mesh(mesh);
  instance.set_curves({stairs()});
  instance.set("tau", 2.0);
  const auto results = instance.run({.point_fields = true, .vertex_fields = true});
  instance.put_fields(results, mesh);

  host::Instance plain(smooth, services);
  std::vector<float> xyz;
  for (const Point& p : lists.points) {
    for (const double x : p) xyz.push_back(static_cast<float>(x));
  }
  plain.set_mesh({xyz.data(), lists.points.size(), 0, 3, TALWEG_FLOAT32},
                 host::view(lists.triangles.front().data(), lists.triangles.size(), 3));
  host::Curve curve;
  for (const auto& point : stairs().points) {
    curve.vertices.push_back(static_cast<std::uint32_t>(point.vertex.idx()));
  }
  plain.set_curves({curve});
  plain.set("tau", 2.0);
  const host::Results expected = plain.run({.point_fields = true, .vertex_fields = true});

  const auto& points = results.curves.at(0).points;
  ASSERT_EQ(points.size(), expected.curves.at(0).faces.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(points[k].face.idx(), static_cast<int>(expected.curves[0].faces[k]));
    EXPECT_EQ(points[k].barycentric, expected.curves[0].barycentrics[k]);
  }
  EXPECT_EQ(results.raw.curves[0].fields.size(), expected.curves[0].fields.size());
  OpenMesh::VPropHandleT<double> distance;
  ASSERT_TRUE(mesh.get_property_handle(distance, "distance"));
  for (const auto v : mesh.vertices()) {
    EXPECT_EQ(mesh.property(distance, v),
              expected.fields.at(0).values[static_cast<std::size_t>(v.idx())]);
  }
}

TEST_F(OpenMeshHost, DeletedElementsAreSkippedAndHandlesStayValid) {
  Double mesh = mesh_of<Double>(lists);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  for (int v = 0; v < 41 * 5; v += 3) mesh.delete_vertex(VertexHandle(v), true);
  OpenMesh::VProp<double> weight(mesh, "weight");
  for (const auto v : mesh.vertices()) weight[v] = 0.5;
  host::OpenMeshInstance<Double> instance(smooth, services);
  instance.set_mesh(mesh);
  instance.set("slack_field", weight);
  instance.set_curves({stairs()});
  const auto results = instance.run({.vertex_fields = true});
  instance.put_fields(results, mesh);

  // After garbage collection, handles are numbers, and the results are the same.
  Double collected = mesh;
  std::vector<VertexHandle*> ends;
  openmesh::Curve drawn = stairs();
  for (auto& point : drawn.points) ends.push_back(&point.vertex);
  std::vector<OpenMesh::HalfedgeHandle*> no_halfedges;
  std::vector<FaceHandle*> no_faces;
  collected.garbage_collection(ends, no_halfedges, no_faces);
  host::OpenMeshInstance<Double> again(smooth, services);
  again.set_mesh(collected);
  again.set("slack_field", OpenMesh::VProp<double>(collected, "weight"));
  again.set_curves({drawn});
  const auto expected = again.run();
  const auto& a = results.curves.at(0).points;
  const auto& b = expected.curves.at(0).points;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_FALSE(mesh.status(a[k].face).deleted());
    const auto& p = results.raw.curves[0].positions[k];
    const auto& q = expected.raw.curves[0].positions[k];
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(p[i], q[i], 1e-9);
  }
  EXPECT_EQ(sentence_of([&] {
              instance.set_curves({at({3, 4})});
            }),
            "Curve 0 has the vertex handle 3, but the mesh has no such vertex, or the vertex is "
            "deleted.");
  EXPECT_EQ(sentence_of([&] {
              instance.set_curves({stairs(), at({700, 99999})});
            }),
            "Curve 1 has the vertex handle 99999, but the mesh has no such vertex, or the vertex "
            "is deleted.");
  openmesh::Curve inside;
  inside.points.push_back({VertexHandle(), FaceHandle(-1), {1, 0, 0}});
  EXPECT_EQ(
      sentence_of([&] { instance.set_curves({inside}); }),
      "Curve 0 has the face handle -1, but the mesh has no such face, or the face is deleted.");
  EXPECT_EQ(
      sentence_of([&] { instance.put_fields(results, *std::make_unique<Double>()); }).substr(0, 34),
      "The mesh has 0 vertices and 0 face");
}

TEST_F(OpenMeshHost, PropertiesAreCarriedToMadeMeshes) {
  Double mesh = mesh_of<Double>(lists);
  mesh.request_vertex_normals();
  OpenMesh::VProp<OpenMesh::Vec3d> place(mesh, "place");
  OpenMesh::FProp<int> face(mesh, "number");
  OpenMesh::FProp<bool> even(mesh, "even");
  OpenMesh::HProp<OpenMesh::Vec2f> uv(mesh, "uv");
  OpenMesh::VProp<std::string> name(mesh, "name");
  OpenMesh::EProp<double> crease(mesh, "crease");
  OpenMesh::VProp<std::vector<int>> uneven(mesh, "uneven");
  uneven[VertexHandle(1)] = {1, 2};
  for (const auto v : mesh.vertices()) {
    mesh.set_normal(v, {0, 0, 1});
    place[v] = mesh.point(v);
  }
  for (const auto f : mesh.faces()) {
    face[f] = f.idx();
    even[f] = f.idx() % 2 == 0;
  }
  for (const auto h : mesh.halfedges()) {
    const auto& p = mesh.point(h.to());
    uv[h] = {static_cast<float>(p[0]), static_cast<float>(p[1])};
  }
  host::OpenMeshInstance<Double> instance(cut, services);
  instance.set_mesh(mesh);
  const std::vector<std::string> left_out = instance.set_attributes(mesh);
  ASSERT_EQ(left_out.size(), 3U);
  EXPECT_EQ(left_out[0].find("The vertex property \"name\" holds "), 0U);
  EXPECT_EQ(left_out[1], "The vertex property \"uneven\" has lists of different lengths.");
  EXPECT_EQ(left_out[2], "The edge property \"crease\" has no counterpart in the interface.");
  host::OpenMeshInstance<Double> smoother(smooth, services);
  smoother.set_mesh(mesh);
  smoother.set_curves({stairs()});
  instance.set_curves(smoother.run().curves);
  instance.set("open", 1.0);
  const auto results = instance.run({.meshes = true});
  const auto made = instance.made(results, 0);

  const Double& there = made.mesh;
  ASSERT_GT(there.n_faces(), mesh.n_faces());
  OpenMesh::VPropHandleT<OpenMesh::Vec3d> placed;
  OpenMesh::VPropHandleT<OpenMesh::Vec3f> normals;  // the type of normals in DefaultTraits
  OpenMesh::FPropHandleT<int> number, from;
  OpenMesh::FPropHandleT<std::uint8_t> is_even;
  OpenMesh::HPropHandleT<OpenMesh::Vec2f> corner;
  OpenMesh::VPropHandleT<int> vertex;
  ASSERT_TRUE(there.get_property_handle(placed, "place"));
  ASSERT_TRUE(there.get_property_handle(normals, "v:normals"));
  ASSERT_TRUE(there.get_property_handle(number, "number"));
  ASSERT_TRUE(there.get_property_handle(is_even, "even"));
  ASSERT_TRUE(there.get_property_handle(corner, "uv"));
  ASSERT_TRUE(there.get_property_handle(vertex, openmesh::kVertexNumber));
  ASSERT_TRUE(there.get_property_handle(from, openmesh::kFaceNumber));
  std::size_t new_vertices = 0;
  for (const auto v : there.vertices()) {
    EXPECT_LT((there.property(placed, v) - there.point(v)).norm(), 1e-12);
    EXPECT_EQ(there.property(normals, v), OpenMesh::Vec3f(0, 0, 1));
    const int old = there.property(vertex, v);
    new_vertices += old < 0 ? 1 : 0;
    if (old < 0) continue;
    EXPECT_EQ(there.point(v), mesh.point(VertexHandle(old)));
  }
  EXPECT_GT(new_vertices, 40U);
  for (const auto f : there.faces()) {
    EXPECT_EQ(there.property(number, f), there.property(from, f));
    EXPECT_EQ(there.property(is_even, f), there.property(from, f) % 2 == 0 ? 1 : 0);
    for (const auto h : openmesh::corner_halfedges(there, f)) {
      const auto& p = there.point(there.to_vertex_handle(h));
      EXPECT_NEAR(there.property(corner, h)[0], p[0], 1e-4);
    }
  }
  // The seam is open: each place of the chain has a vertex on both sides.
  ASSERT_EQ(made.chains.size(), 1U);
  EXPECT_FALSE(made.chains[0].closed);
  for (const auto& place_on_it : made.chains[0].places) EXPECT_EQ(place_on_it.size(), 2U);
}

TEST_F(OpenMeshHost, FieldsOfTrianglesAreFaceProperties) {
  Single mesh = mesh_of<Single>(lists);
  OpenMesh::FProp<int> label(mesh, "label");
  for (const auto f : mesh.faces()) label[f] = mesh.point(*mesh.fv_begin(f))[0] > 15 ? 2 : 1;
  host::OpenMeshInstance<Single> instance(test::plugin_of_this_build("talweg.labels"), services);
  instance.set_mesh(mesh);
  instance.set("triangle_labels", label);
  const auto results = instance.run({.vertex_fields = true});
  instance.put_fields(results, mesh);
  OpenMesh::FPropHandleT<double> labels;
  ASSERT_TRUE(mesh.get_property_handle(labels, "labels"));
  std::size_t same = 0;
  for (const auto f : mesh.faces()) same += mesh.property(labels, f) == label[f] ? 1 : 0;
  EXPECT_GT(same, mesh.n_faces() * 9 / 10);
}

TEST_F(OpenMeshHost, ErrorsHaveTheSentenceOfThePlugin) {
  Single mesh = mesh_of<Single>(lists);
  host::OpenMeshInstance<Single> instance(smooth, services);
  EXPECT_EQ(sentence_of([&] { instance.set_mesh(Single()); }).find("no error"), std::string::npos);
  instance.set_mesh(mesh);
  EXPECT_EQ(sentence_of([&] { instance.set("tau", -1.0); }), "Tau (tau) must be >= 0, not -1.");
  EXPECT_EQ(sentence_of([&] { static_cast<void>(instance.set_attributes(mesh)); }),
            "talweg.smooth gives no meshes.");
}

}  // namespace
}  // namespace talweg
