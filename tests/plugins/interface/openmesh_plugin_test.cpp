// Plugins written with talweg_plugin_openmesh.hpp: meshes, curves and fields agree with OpenMesh
// itself and with numbers worked out by hand.
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "plugins/openmesh_probe.hpp"
#include "talweg/core/mesh/closest_point.hpp"

namespace talweg::test {
namespace {

TEST_F(OpenMeshPlugin, HandlesAreTheHostsNumbers) {
  std::size_t looked = 0;
  Probe::look = [&](const Probe& probe) {
    const auto& mesh = probe.seen();
    ASSERT_EQ(mesh.n_vertices(), lists.points.size());
    ASSERT_EQ(mesh.n_faces(), lists.triangles.size());
    for (const auto v : mesh.vertices()) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(mesh.point(v)[i], lists.points[static_cast<std::size_t>(v.idx())][i]);
      }
    }
    for (const auto f : mesh.faces()) {
      const auto corners = openmesh::corners_of(mesh, f);
      for (std::size_t k = 0; k < 3; ++k, ++looked) {
        EXPECT_EQ(corners[k].idx(), static_cast<int>(lists.triangles[f.idx()][k]));
      }
    }
  };
  run("copy");
  EXPECT_EQ(looked, 3 * lists.triangles.size());
}

TEST_F(OpenMeshPlugin, FieldsAreProperties) {
  std::vector<double> weights, marks;
  for (std::size_t v = 0; v < lists.points.size(); ++v) weights.push_back(0.25 + double(v));
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) marks.push_back(double(f % 5));
  instance.set("weight", weights);
  instance.set("mark", marks);
  instance.set("seeds", std::vector<std::uint32_t>{3});
  const host::Results results = run("copy");
  ASSERT_EQ(results.fields.size(), 2U);
  weights[3] *= 2;
  EXPECT_EQ(results.fields[0].values, weights);
  EXPECT_EQ(results.fields[1].values, marks);
  instance.set("seeds", std::vector<std::uint32_t>{999});
  EXPECT_EQ(sentence_of([&] { run("copy"); }), "seeds has vertex 999, and the mesh has 49.");
  instance.set("weight", std::vector<double>{1, 2});
  EXPECT_EQ(sentence_of([&] { run("copy"); }),
            "weight has 2 values, but the mesh has 49 vertices.");
}

TEST_F(OpenMeshPlugin, MeshesThatOpenMeshCannotHoldAreRefused) {
  EXPECT_EQ(refusal({}), "The mesh has no faces.");
  EXPECT_EQ(refusal({{0, 1, 2}, {0, 2, 8}}), "Face 1 has vertex 8, and the mesh has 8 vertices.");
  EXPECT_EQ(refusal({{0, 1, 2}, {3, 4, 3}}), "Face 1 has vertex 3 twice.");
  EXPECT_EQ(refusal({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
            "Face 2 has the edge from vertex 0 to 1, and so has face 0: more than two faces share "
            "the edge, or one of the two has the opposite orientation.");
  // Two tetrahedra that share vertex 0: OpenMesh has no vertex with two closed fans.
  EXPECT_EQ(
      refusal(
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}}),
      "Face 4 meets other faces at vertex 0 without a common edge, and one of the fans of faces "
      "there is closed.");
  // OpenMesh can hold two triangles that share a vertex.
  EXPECT_EQ(refusal({{0, 1, 2}, {0, 3, 4}}), "no error");
  std::vector<double> xyz(9, 0);
  xyz[4] = std::nan("");
  const std::array<std::uint32_t, 3> one = {0, 1, 2};
  EXPECT_EQ(sentence_of([&] {
              instance.set_mesh(host::view(xyz.data(), 3, 3), host::view(one.data(), 1, 3));
            }),
            "Vertex 1 has a coordinate that is not a finite number.");
}

/// OpenMesh itself decides which lists of faces are expected to be refused.
TEST(OpenMeshFaces, AreRefusedWhereOpenMeshRefusesThem) {
  std::mt19937 random(1);
  int taken = 0, refused = 0;
  omerr().disable();
  for (int round = 0; round < 4000; ++round) {
    const auto vertices = 4 + random() % 5;
    std::vector<std::uint32_t> corners;
    for (auto faces = 1 + random() % 7; faces > 0; --faces) {
      std::array<std::uint32_t, 3> t{};
      do {
        for (auto& v : t) v = static_cast<std::uint32_t>(random() % vertices);
      } while (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]);
      corners.insert(corners.end(), t.begin(), t.end());
    }
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    for (std::size_t v = 0; v < vertices; ++v) mesh.add_vertex({0, 0, 0});
    bool all = true;
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      const auto v = [&](std::size_t i) { return VertexHandle(static_cast<int>(corners[k + i])); };
      all = all && mesh.add_face(v(0), v(1), v(2)).is_valid();
    }
    // OpenMesh accepts some orders of faces after which it misses faces around a vertex.
    std::size_t found = 0;
    for (const auto v : mesh.vertices()) {
      for ([[maybe_unused]] const auto f : mesh.vf_range(v)) ++found;
    }
    const bool sound = all && found == corners.size();
    bool ours = true;
    try {
      openmesh::check_faces(corners, vertices);
    } catch (const plugin::Failure&) {
      ours = false;
    }
    EXPECT_EQ(ours, sound) << "round " << round;
    (ours ? taken : refused) += 1;
  }
  omerr().enable();
  EXPECT_GT(taken, 100);
  EXPECT_GT(refused, 100);
}

TEST_F(OpenMeshPlugin, CurvesAreHandles) {
  host::Curve inside;
  inside.closed = true;
  inside.faces = {0, 5, 7};
  inside.barycentrics = {{0.25, 0.25, 0.5}, {0, 1, 0}, {0.5, 0.5, 0}};
  inside.pins = {2};
  inside.exact = {0, -1, -2};
  host::Curve above;
  for (const std::uint32_t v : lists.triangles[20]) {
    const Point& p = lists.points[v];
    above.positions.push_back({p.x(), p.y(), p.z()});
  }
  instance.set_curves({at({4, 2}), inside, above});
  Probe::look = [&](const Probe& probe) {
    const auto& curves = probe.drawn();
    ASSERT_EQ(curves.size(), 3U);
    EXPECT_EQ(curves[0].points[1].vertex.idx(), 2);
    EXPECT_FALSE(curves[0].points[1].face.is_valid());
    EXPECT_TRUE(curves[1].closed);
    EXPECT_EQ(curves[1].points[0].face.idx(), 0);
    EXPECT_FALSE(curves[1].points[0].vertex.is_valid());
    EXPECT_EQ(curves[1].points[1].vertex.idx(), static_cast<int>(lists.triangles[5][1]));
    EXPECT_EQ(curves[1].pins, inside.pins);
    EXPECT_EQ(curves[1].exact, inside.exact);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(curves[2].points[k].vertex.idx(), static_cast<int>(lists.triangles[20][k]));
    }
  };
  run("copy");
}

TEST_F(OpenMeshPlugin, BadCurvesAreRefused) {
  const auto refusal_of = [&](const host::Curve& curve) {
    return sentence_of([&] { instance.set_curves({at({0, 1}), curve}); });
  };
  EXPECT_EQ(refusal_of(at({0, 49})), "Curve 1 has vertex 49 at point 1, and the mesh has 49.");
  EXPECT_EQ(refusal_of({}), "Curve 1 has no points.");
  host::Curve curve;
  curve.faces = {3, 72};
  curve.barycentrics = {{1, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(refusal_of(curve), "Curve 1 has face 72 at point 1, and the mesh has 72.");
  curve.faces = {3, 4};
  curve.barycentrics[1] = {0.5, 0.6, -0.1};
  EXPECT_EQ(refusal_of(curve),
            "Curve 1 has barycentrics at point 1 that are below 0 or do not add up to 1.");
  curve.barycentrics.pop_back();
  EXPECT_EQ(refusal_of(curve), "Curve 1 has 2 faces and 1 rows of barycentrics.");
  curve = at({0, 1});
  curve.pins = {2};
  EXPECT_EQ(refusal_of(curve), "Curve 1 has the pin 2, and 2 points.");
  curve = at({0, 1});
  curve.exact = {0};
  EXPECT_EQ(refusal_of(curve), "Curve 1 has 2 points, and 1 marks in the field exact.");
  curve = {};
  curve.positions = {{0, 0, INFINITY}};
  EXPECT_EQ(refusal_of(curve), "Curve 1 has a coordinate at point 0 that is not a finite number.");
  host::Instance without(*tp::Adapter<Silent>::plugin(), services);
  set_mesh(without, lists);
  EXPECT_EQ(sentence_of([&] { without.set_curves({at({0, 1})}); }), "This plugin takes no curves.");
}

TEST_F(OpenMeshPlugin, PositionsMoveToTheNearestPoints) {
  const SurfaceMesh surface = SurfaceMesh::open(lists);
  const ClosestPoint closest(surface);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-1, 8);
  host::Curve curve;
  for (int k = 0; k < 200; ++k)
    curve.positions.push_back({place(random), place(random), place(random)});
  instance.set_curves({curve});
  Probe::look = [&](const Probe& probe) {
    const auto& mesh = probe.seen();
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      const auto& point = probe.drawn()[0].points[k];
      const auto corners = openmesh::corners_of(mesh, point.face);
      auto found = mesh.point(corners[0]) * point.barycentric[0];
      for (std::size_t i = 1; i < 3; ++i) found += mesh.point(corners[i]) * point.barycentric[i];
      const Point p(curve.positions[k].data());
      EXPECT_NEAR((Point(found.data()) - p).norm(), closest.nearest(p).distance, 1e-12);
    }
  };
  run("copy");
}

}  // namespace
}  // namespace talweg::test
