// A plugin written with talweg_plugin_openmesh.hpp, and a host of it in C++.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/plugin/talweg_plugin_openmesh.hpp"

namespace talweg::test {

namespace tp = plugin;
using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

inline constexpr const char* kTasks[] = {"copy", "delete", "own", "scratch", "between"};

/// Does with its mesh what the parameter says.
class Probe : public tp::OpenMeshWorker<OpenMesh::DefaultTraitsDouble> {
 public:
  using OpenMeshWorker::OpenMeshWorker;
  static inline std::function<void(const Probe&)> look;  // looks at the inputs

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

inline std::string sentence_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const host::Error& error) {
    return error.what();
  }
  return "no error";
}

inline host::Curve at(std::vector<std::uint32_t> vertices) {
  host::Curve curve;
  curve.vertices = std::move(vertices);
  return curve;
}

struct OpenMeshPlugin : testing::Test {
  OpenMeshPlugin() {
    set_mesh(instance, lists);
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

  MeshLists lists = hills(6);
  std::vector<std::string> said;
  host::Services services{"test", "1", {}, [this](std::uint32_t severity, const char* message) {
                            if (severity == TALWEG_LOG_WARNING) said.emplace_back(message);
                          }};
  host::Instance instance{*tp::Adapter<Probe>::plugin(), services};
};

}  // namespace talweg::test
