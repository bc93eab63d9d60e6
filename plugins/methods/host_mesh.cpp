#include "host_mesh.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "talweg/plugin/talweg_arrays.hpp"

namespace talweg::plugins {

MeshLists lists_of(const talweg_mesh& mesh) {
  MeshLists lists;
  try {
    plugin::check_array(mesh.positions, 3, "The mesh's positions");
    plugin::check_array(mesh.triangles, 3, "The mesh's triangles");
    lists.points.resize(mesh.positions.rows);
    lists.triangles.resize(mesh.triangles.rows);
    lists.single_precision = mesh.positions.type == TALWEG_FLOAT32;
    if (!lists.points.empty()) {
      plugin::copy_numbers(mesh.positions, 3, "The mesh's positions", lists.points.front().data());
    }
    if (!lists.triangles.empty()) {
      plugin::copy_indices(mesh.triangles, 3, "The mesh's triangles",
                           lists.triangles.front().data());
    }
  } catch (const plugin::Failure& failure) {
    throw plugin::Failure(TALWEG_BAD_MESH, failure.what());
  }
  return lists;
}

std::vector<talweg_parameter> with_repair(std::vector<talweg_parameter> parameters,
                                          bool by_default) {
  const auto step = [&](const char* id, const char* label, const char* doc) {
    parameters.push_back(plugin::boolean(id, label, true, doc, TALWEG_STAGE_MESH, TALWEG_ADVANCED));
  };
  parameters.push_back(
      plugin::boolean("repair", "Repair the mesh", by_default,
                      "Repair the mesh to a surface first; results keep the vertex and triangle "
                      "numbers of the given mesh. Set this before a mesh that is not a surface.",
                      TALWEG_STAGE_MESH));
  step("repair_weld", "Repair: weld", "Vertices at the same place become one.");
  step("repair_drop", "Repair: drop", "Faces without area and repeated faces are dropped.");
  step("repair_orient", "Repair: orient", "Faces are turned to agree with their neighbours.");
  step("repair_split", "Repair: split",
       "Edges with more than two faces and bow-ties are cut apart into sheets.");
  parameters.push_back(plugin::number(
      "repair_weld_tolerance", "Repair: weld within", "mesh units", 0, {0, HUGE_VAL, 0, 1},
      "Vertices within this distance of others are welded, too, but never both ends of an edge; 0: "
      "only vertices at the same place.",
      TALWEG_STAGE_MESH, TALWEG_ADVANCED));
  return parameters;
}

std::optional<RepairSteps> repair_of(const plugin::Parameters& parameters) {
  if (!parameters.flag("repair")) return std::nullopt;
  return RepairSteps{parameters.flag("repair_weld"), parameters.flag("repair_drop"),
                     parameters.flag("repair_orient"), parameters.flag("repair_split"),
                     parameters.number("repair_weld_tolerance")};
}

namespace {

/// The mesh that a plugin opened last. Plugins linked into one program get the same mesh one after
/// another; while one plugin has the mesh, the next need not open it again.
class LastOpened {
 public:
  std::shared_ptr<const HostMesh> get() {
    const std::scoped_lock lock(mutex_);
    return closed_ ? nullptr : mesh_.lock();
  }
  void put(const std::shared_ptr<const HostMesh>& mesh) {
    const std::scoped_lock lock(mutex_);
    if (!closed_) mesh_ = mesh;
  }
  /// Must be called at the program's end. A detached thread may still call get() and put() later.
  void close() {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    mesh_.reset();
  }

 private:
  std::mutex mutex_;
  bool closed_ = false;
  std::weak_ptr<const HostMesh> mesh_;
};

/// The object is never destroyed, so detached threads can use it to the end.
LastOpened& last_opened() {
  alignas(LastOpened) static std::byte place[sizeof(LastOpened)];
  static LastOpened& made = *new (place) LastOpened;
  return made;
}

/// The object is made before a host gets the plugin's table, so it is destroyed after the objects
/// that the host destroys at its exit, such as a thread that opens a mesh.
struct CloseLastOpened {
  CloseLastOpened() { last_opened(); }
  ~CloseLastOpened() { last_opened().close(); }
  CloseLastOpened(const CloseLastOpened&) = delete;
  CloseLastOpened& operator=(const CloseLastOpened&) = delete;
};
const CloseLastOpened close_last_opened;

/// Whether two lists are equal bit for bit: 0 and -0 differ.
bool same_bits(std::span<const Point> a, std::span<const Point> b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

}  // namespace

std::shared_ptr<const HostMesh> HostMesh::open(MeshLists lists,
                                               const std::optional<RepairSteps>& steps) {
  if (auto last = last_opened().get(); last && last->is_of(lists, steps)) return last;
  auto mesh = open_anew(std::move(lists), steps);
  last_opened().put(mesh);
  return mesh;
}

bool HostMesh::is_of(const MeshLists& lists, const std::optional<RepairSteps>& steps) const {
  if (steps != steps_) return false;
  if (unrepaired_)
    return same_bits(unrepaired_->points, lists.points) &&
           unrepaired_->triangles == lists.triangles;
  const Surface& surface = mesh().surface();
  if (surface.face_count() != lists.triangles.size()) return false;
  if (!same_bits(mesh().points(), lists.points)) return false;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto corners = surface.corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k) {
      if (lists.triangles[f][k] != corners[k].index()) return false;
    }
  }
  return true;
}

std::shared_ptr<const HostMesh> HostMesh::open_anew(MeshLists lists,
                                                    const std::optional<RepairSteps>& steps) {
  auto mesh = std::make_shared<HostMesh>();
  mesh->steps_ = steps;
  if (!steps) {
    mesh->opened_ = OpenedMesh::open(std::move(lists));
    return mesh;
  }
  RepairedMesh repaired = repair_to_surface(lists, *steps);
  mesh->opened_ = OpenedMesh::open(std::move(repaired.lists));
  if (!repaired.changes.any()) return mesh;
  mesh->unrepaired_ = std::move(lists);
  mesh->map_ = std::make_shared<const RepairMap>(std::move(repaired.map));
  mesh->changes_ = sentences(repaired.changes);
  return mesh;
}

MeshLists HostMesh::lists() const {
  if (unrepaired_) return *unrepaired_;
  MeshLists lists;
  lists.points.assign(mesh().points().begin(), mesh().points().end());
  const Surface& surface = mesh().surface();
  lists.triangles.reserve(surface.face_count());
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto corners = surface.corners(FaceId{f});
    Triangle& triangle = lists.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = static_cast<std::uint32_t>(corners[k].index());
    }
  }
  return lists;
}

std::size_t HostMesh::vertex_count() const {
  return map_ ? map_->file_vertex_count() : mesh().surface().vertex_count();
}

std::size_t HostMesh::face_count() const {
  return map_ ? map_->file_face_count() : mesh().surface().face_count();
}

CurveInput HostMesh::from_host(const CurveInput& curve) const {
  return map_ ? map_->to_repaired(curve, mesh().surface()) : curve;
}

std::vector<SurfacePoint> HostMesh::vertices_from_host(std::span<const std::uint32_t> ids) const {
  std::vector<SurfacePoint> points;
  points.reserve(ids.size());
  const Surface& surface = mesh().surface();
  for (const std::uint32_t v : ids) {
    const bool known = map_ && v < map_->file_vertex_count();
    points.push_back(
        SurfacePoint::at_vertex(surface, VertexId{known ? map_->images(VertexId{v}).front() : v}));
  }
  return points;
}

namespace {

void check_count(const std::vector<double>& values, std::size_t expected, const char* of,
                 const std::string& what) {
  if (values.size() == expected) return;
  throw plugin::Failure(TALWEG_BAD_USAGE, fmt::format("{} has {} values, but the mesh has {} {}.",
                                                      what, values.size(), expected, of));
}

}  // namespace

std::vector<double> HostMesh::per_vertex_from_host(const std::vector<double>& values,
                                                   const std::string& what) const {
  check_count(values, vertex_count(), "vertices", what);
  return map_ ? map_->of_vertices(values) : values;
}

std::vector<double> HostMesh::per_face_from_host(const std::vector<double>& values,
                                                 const std::string& what) const {
  check_count(values, face_count(), "triangles", what);
  return map_ ? map_->of_faces(values) : values;
}

PlacedCurve HostMesh::to_host(PlacedCurve curve) const {
  return map_ ? map_->to_file(std::move(curve)) : curve;
}

std::vector<double> HostMesh::per_vertex_to_host(const std::vector<double>& values) const {
  return map_ ? map_->to_file_vertices(values) : values;
}

}  // namespace talweg::plugins
