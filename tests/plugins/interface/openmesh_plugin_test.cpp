// Plugins written with talweg_plugin_openmesh.hpp, against OpenMesh itself and numbers by hand.
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <OpenMesh/Core/System/omstream.hh>
#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/mesh/closest_point.hpp"
#include "talweg/plugin/talweg_plugin_openmesh.hpp"

namespace talweg {
namespace {

namespace tp = plugin;
using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

constexpr const char* kTasks[] = {"copy", "delete", "own", "scratch", "between"};

/// Does with its mesh what the parameter says.
class Probe : public tp::OpenMeshWorker<OpenMesh::DefaultTraitsDouble> {
 public:
  using OpenMeshWorker::OpenMeshWorker;
  static inline std::function<void(const Probe&)> look;  // at what it has

  static talweg_plugin about() {
    talweg_plugin about = {};
    about.id = "test.probe";
    about.label = about.doc = about.version = "Probe";
    about.flags = TALWEG_TAKES_CURVES;
    return about;
  }
  static std::vector<talweg_parameter> parameters() {
    return {tp::choice("task", "Task", "copy", kTasks, kTasks, ""),
            tp::array(TALWEG_FIELD, "weight", "Weight", "", ""),
            tp::array(TALWEG_TRIANGLE_FIELD, "mark", "Mark", "", ""),
            tp::array(TALWEG_VERTICES, "seeds", "Seeds", "", "")};
  }
  static std::vector<talweg_output> outputs() {
    return {tp::output(TALWEG_OUTPUT_VERTEX_FIELD, "double", "Double", "", ""),
            tp::output(TALWEG_OUTPUT_TRIANGLE_FIELD, "mark", "Mark", "", ""),
            tp::output(TALWEG_OUTPUT_MESH, "mesh", "Mesh", "", "")};
  }

  void run(const tp::Parameters& parameters, const tp::Outputs& outputs) {
    if (look) look(*this);
    Mesh made = mesh();
    OpenMesh::VProp<double> twice(0.0, made, "twice");
    if (take_field(parameters, "weight", twice)) {
      for (const VertexHandle v : vertices(parameters, "seeds")) twice[v] *= 2;
      give_field(outputs, "double", "", twice);
    }
    OpenMesh::FProp<int> mark(0, made, "marked");
    if (take_field(parameters, "mark", mark)) give_field(outputs, "mark", "", mark);
    const std::string& task = parameters.choice("task");
    if (task == "copy") made = mesh();
    if (task == "delete") delete_some(made);
    if (task == "own") OpenMesh::VProp<std::string>("text", made, "name");
    if (task == "scratch") made = from_scratch();
    if (task == "between") split_first_edge(made);
    give_mesh(outputs, made);
  }
  [[nodiscard]] const Mesh& seen() const { return mesh(); }
  [[nodiscard]] const std::vector<Curve>& drawn() const { return curves(); }

 private:
  /// Face 0 and vertex 0 with all its faces.
  static void delete_some(Mesh& made) {
    made = Mesh(made);
    made.request_vertex_status();
    made.request_edge_status();
    made.request_face_status();
    made.delete_face(FaceHandle(0), false);
    made.delete_vertex(VertexHandle(0), false);
  }
  static Mesh from_scratch() {
    Mesh made;
    const VertexHandle a = made.add_vertex({0, 0, 0}), b = made.add_vertex({1, 0, 0});
    made.add_face(a, b, made.add_vertex({0, 1, 0}));
    return made;
  }
  static void split_first_edge(Mesh& made) {
    const auto e = OpenMesh::EdgeHandle(0);
    const VertexHandle from = made.from_vertex_handle(made.halfedge_handle(e, 0));
    const VertexHandle to = made.to_vertex_handle(made.halfedge_handle(e, 0));
    const VertexHandle v = made.split_copy(e, (made.point(from) + made.point(to)) / 2);
    OpenMesh::VProp<int>(made, openmesh::kVertexNumber)[v] = -1;
    OpenMesh::VProp<openmesh::Between> between({}, made, openmesh::kBetween);
    between[v] = {{static_cast<std::uint32_t>(from.idx()), static_cast<std::uint32_t>(to.idx()),
                   TALWEG_NO_VERTEX},
                  {0.5, 0.5, 0}};
  }
};

class Silent : public Probe {
 public:
  using Probe::Probe;
  static talweg_plugin about() {
    talweg_plugin about = Probe::about();
    about.flags = 0;
    return about;
  }
};

std::string sentence_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const host::Error& error) {
    return error.what();
  }
  return "no error";
}

host::Curve at(std::vector<std::uint32_t> vertices) {
  host::Curve curve;
  curve.vertices = std::move(vertices);
  return curve;
}

struct OpenMeshPlugin : testing::Test {
  OpenMeshPlugin() {
    test::set_mesh(instance, lists);
    instance.set_curves({at({0, 1, 2})});
  }
  ~OpenMeshPlugin() override { Probe::look = {}; }

  host::Results run(const char* task) {
    instance.set("task", task);
    host::Wanted wanted;
    wanted.meshes = wanted.vertex_fields = true;
    return instance.run(wanted);
  }
  std::string refusal(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                      std::size_t points = 8) {
    std::vector<double> xyz(3 * points, 0.5);
    return sentence_of([&] {
      instance.set_mesh(
          host::view(xyz.data(), points, 3),
          host::view(triangles.empty() ? nullptr : triangles.front().data(), triangles.size(), 3));
    });
  }

  MeshLists lists = test::hills(6);
  std::vector<std::string> said;
  host::Services services{"test", "1", {}, [this](std::uint32_t severity, const char* message) {
                            if (severity == TALWEG_LOG_WARNING) said.emplace_back(message);
                          }};
  host::Instance instance{*tp::Adapter<Probe>::plugin(), services};
};

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
  EXPECT_EQ(sentence_of([&] { run("copy"); }), "weight has 2 values, and the mesh 49.");
}

TEST_F(OpenMeshPlugin, RefusesWhatOpenMeshCannotHave) {
  EXPECT_EQ(refusal({}), "The mesh has no faces.");
  EXPECT_EQ(refusal({{0, 1, 2}, {0, 2, 8}}), "Face 1 has vertex 8, and the mesh has 8 vertices.");
  EXPECT_EQ(refusal({{0, 1, 2}, {3, 4, 3}}), "Face 1 has vertex 3 twice.");
  EXPECT_EQ(refusal({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
            "Face 2 has the edge from vertex 0 to 1, and so has face 0: more than two faces meet "
            "there, or one is turned over.");
  // Two tetrahedra that share vertex 0: OpenMesh has no vertex with two closed fans.
  EXPECT_EQ(
      refusal(
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}}),
      "Face 4 meets other faces at vertex 0 without an edge between them, and a side is closed "
      "there.");
  // Two triangles that share a vertex: it can have those.
  EXPECT_EQ(refusal({{0, 1, 2}, {0, 3, 4}}), "no error");
  std::vector<double> xyz(9, 0);
  xyz[4] = std::nan("");
  const std::array<std::uint32_t, 3> one = {0, 1, 2};
  EXPECT_EQ(sentence_of([&] {
              instance.set_mesh(host::view(xyz.data(), 3, 3), host::view(one.data(), 1, 3));
            }),
            "Vertex 1 has a coordinate that is no finite number.");
}

/// OpenMesh says which lists it can take.
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
    // It takes some orders of faces with which it does not find all faces around a vertex.
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
  EXPECT_EQ(refusal_of(curve), "Curve 1 has a coordinate at point 0 that is no finite number.");
  host::Instance without(*tp::Adapter<Silent>::plugin(), services);
  test::set_mesh(without, lists);
  EXPECT_EQ(sentence_of([&] { without.set_curves({at({0, 1})}); }), "This plugin takes no curves.");
}

TEST_F(OpenMeshPlugin, MovesPositionsToTheNearestPoints) {
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

TEST_F(OpenMeshPlugin, EveryTypeAndNumberOfColumnsGoesThereAndBack) {
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

TEST_F(OpenMeshPlugin, CornersShareEntriesAsTheyDid) {
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
            "The attribute \"x\" is there twice.");
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
            "The attribute \"uv\" has the entry 2 at triangle 0, and 2 entries.");
  instance.set_attributes({good});  // and all is as it was
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
  // Of the curves one is still a chain of edges.
  EXPECT_EQ(origin.lengths, (std::vector<std::uint32_t>{3, 0}));
  EXPECT_EQ(origin.chains.at(1), (std::array<std::uint32_t, 3>{0, 1, 8}));
}

TEST_F(OpenMeshPlugin, SaysWhatDoesNotGoOver) {
  instance.set_attributes({attribute("x", TALWEG_OF_VERTICES, 1, counted(49))});
  run("own");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].substr(0, 33), "The vertex property \"name\" holds ");
  EXPECT_NE(said[0].find("string"), std::string::npos);
  const std::vector<host::Attribute> back = instance.attributes(0);
  ASSERT_EQ(back.size(), 3U);  // the host's, then the plugin's
  EXPECT_EQ(back[0].name, "x");
  EXPECT_EQ(back[1].name, "twice");
  EXPECT_EQ(back[2].name, "marked");
  said.clear();
  run("scratch");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].substr(0, 57), "The mesh that was made does not have the property \"x\"; it");
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
            "There is no mesh 1: 1 are there of a run that gave meshes.");
  instance.set_curves({at({0, 1})});
  EXPECT_EQ(sentence_of([&] { static_cast<void>(instance.origin(0)); }),
            "There is no mesh 0: 0 are there of a run that gave meshes.");
}

}  // namespace
}  // namespace talweg
