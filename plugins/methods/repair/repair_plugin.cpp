// talweg.repair: finds the defects of raw lists of vertices and triangles, and repairs them to a
// surface.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh_files.hpp"
#include "methods/host_mesh.hpp"
#include "methods/made_meshes.hpp"
#include "methods/mesh_workspace.hpp"
#include "methods/plugins.hpp"
#include "methods/results.hpp"
#include "talweg/core/cutting/attribute_transfer.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/repair/inspection_report.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/repair/vertex_welding.hpp"
#include "talweg/core/version.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg::plugins {
namespace {

class Repair {
 public:
  explicit Repair(const plugin::Services& services) : services_(&services) {}

  static constexpr std::uint32_t kTakes = TALWEG_TAKES_ATTRIBUTES | TALWEG_TAKES_ANY_MESH;
  static talweg_plugin about() {
    talweg_plugin about = {};
    about.id = "talweg.repair";
    about.label = "Inspect and repair";
    about.version = version();
    about.doc =
        "Inspects a mesh, reports its defects, and repairs it to a surface that curves can be "
        "drawn on. Takes any lists of vertices and triangles. Only welding moves vertices.";
    about.get_extension = extension;
    return about;
  }
  static const void* extension(const char* id) {
    return std::string_view(id) == TALWEG_MESH_FILES ? mesh_files() : nullptr;
  }
  static std::vector<talweg_parameter> parameters() { return with_repair({}, true); }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {
        output(TALWEG_OUTPUT_MESH, "mesh", "Repaired mesh", "",
               "With attributes and origin (talweg_meshes.h). None without repair, or if the mesh "
               "cannot be repaired."),
        output(TALWEG_OUTPUT_VERTEX_FIELD, "became", "Became vertex", "",
               "The vertex of the repaired mesh that each vertex became, the first if several."),
        output(TALWEG_OUTPUT_TRIANGLE_FIELD, "became_triangle", "Became triangle", "",
               "The triangle of the repaired mesh that each became; -1: it was dropped."),
        output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
               "The inspection, the changes of the repair, and the verdict before and after.")};
  }
  static talweg_status status_of(const std::exception& error) { return plugins::status_of(error); }

  void set_mesh(const talweg_mesh& mesh) {
    auto lists = std::make_shared<MeshLists>(lists_of(mesh));
    forget();
    lists_ = std::move(lists);
  }
  void share_mesh(const Repair& other) {
    auto lists = other.lists_;
    const Inspected inspected = other.inspected_;
    forget();
    lists_ = std::move(lists);
    inspected_ = inspected;
  }
  void set_attributes(std::span<const talweg_attribute* const> attributes) {
    made_.set_attributes(attributes, lists_->points.size(), lists_->triangles.size());
  }
  void give_attributes(std::uint64_t mesh, const plugin::TakeAttribute& take) const {
    made_.give_attributes(mesh, take);
  }
  void give_origin(std::uint64_t mesh, const plugin::TakeOrigin& take) const {
    made_.give_origin(mesh, take);
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    made_.clear();
    if (outputs.wants_report()) inspect_lists();
    go_on("repair", 0);
    std::shared_ptr<const RepairedMesh> repaired = repaired_by(parameters);
    std::vector<ReportEntry> entries;
    if (outputs.wants_report()) entries = report_on(repaired.get());
    give(outputs, -1, entries);
    if (!repaired) return;
    give_fields(outputs, repaired->map);
    if (!outputs.wants_meshes()) return;
    give(outputs, repaired->lists);
    remember(std::move(repaired));
  }

 private:
  /// Results that depend only on the lists.
  struct Inspected {
    std::shared_ptr<const MeshInspection> inspection;
    std::optional<WeldedMesh> welded;
    NearVertices near;
    double inspect_ms = 0;
    std::optional<double> open_ms;
  };

  void forget() {
    made_.forget_attributes();
    inspected_ = {};
  }
  void go_on(const char* stage, double fraction) const {
    if (!services_->go_on(stage, fraction)) throw plugin::Services::cancelled();
  }

  void inspect_lists() {
    if (inspected_.inspection) return;
    go_on("inspect", 0);
    Inspected result;
    const Stopwatch watch;
    auto inspection = std::make_shared<MeshInspection>(inspect(*lists_));
    go_on("inspect", 0.3);
    try_repair(*lists_, *inspection);
    result.inspect_ms = watch.ms();
    go_on("inspect", 0.6);
    result.near = near_vertices(*lists_, *inspection);
    result.welded = try_weld(*lists_, *inspection, result.near);
    if (inspection->verdict == MeshVerdict::kUsable) {
      result.open_ms = OpenedMesh::open(*lists_)->open_ms();
    }
    result.inspection = std::move(inspection);
    inspected_ = std::move(result);
  }

  /// Null if no repair was asked for, or if the mesh cannot be repaired; the verdict then says why.
  [[nodiscard]] std::shared_ptr<const RepairedMesh> repaired_by(
      const plugin::Parameters& parameters) const {
    const std::optional<RepairSteps> steps = repair_of(parameters);
    if (!steps) return nullptr;
    try {
      return std::make_shared<const RepairedMesh>(repair(*lists_, *steps));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kBadMesh) throw;
      return nullptr;
    }
  }

  [[nodiscard]] std::vector<ReportEntry> report_on(const RepairedMesh* repaired) const {
    std::vector<ReportEntry> entries = entries_of(*inspected_.inspection);
    entries.push_back({"time_ms.load", 0.0});
    entries.push_back({"time_ms.inspect", inspected_.inspect_ms});
    entries.push_back({"time_ms.open", inspected_.open_ms.value_or(HUGE_VAL)});
    const auto add = [&](std::vector<ReportEntry> more) {
      entries.insert(entries.end(), more.begin(), more.end());
    };
    add(entries_of(inspected_.near));
    add(entries_of(inspected_.welded, *inspected_.inspection));
    if (repaired == nullptr) return entries;
    add(entries_of(repaired->changes, inspect(repaired->lists)));
    return entries;
  }

  static void give_fields(const plugin::Outputs& outputs, const RepairMap& map) {
    if (!outputs.wants_fields()) return;
    std::vector<double> vertices, faces;
    for (std::size_t v = 0; v < map.file_vertex_count(); ++v) {
      vertices.push_back(map.images(VertexId{v}).front());
    }
    for (std::size_t f = 0; f < map.file_face_count(); ++f) {
      const std::uint32_t face = map.image(FaceId{f}).face;
      faces.push_back(face == RepairMap::kDropped ? -1.0 : face);
    }
    give(outputs, "became", "", vertices);
    give(outputs, "became_triangle", "", faces);
  }

  static PartOrigins origins_of(const RepairMap& map) {
    PartOrigins origins;
    origins.vertices.resize(map.vertex_count());
    for (std::size_t v = 0; v < map.vertex_count(); ++v) {
      VertexOrigin& origin = origins.vertices[v];
      origin.vertices[0] = static_cast<std::uint32_t>(map.file_vertex(VertexId{v}).index());
      origin.weights[0] = 1;
    }
    for (std::size_t f = 0; f < map.face_count(); ++f) {
      origins.faces.push_back(static_cast<std::uint32_t>(map.file_face(FaceId{f}).index()));
    }
    return origins;
  }

  void remember(std::shared_ptr<const RepairedMesh> repaired) {
    MadeMesh& made = made_.add({});
    made.vertices = repaired->lists.points.size();
    made.origins = [repaired] { return origins_of(repaired->map); };
    made.carry_over = [repaired = std::move(repaired)](const MeshAttributes& attributes) {
      std::size_t differing = 0;
      return of_repaired(attributes, repaired->map, differing);
    };
  }

  const plugin::Services* services_;
  std::shared_ptr<const MeshLists> lists_;
  Inspected inspected_;
  MadeMeshes made_;
};

}  // namespace

const talweg_plugin* repair_plugin() { return plugin::Adapter<Repair>::plugin(); }

}  // namespace talweg::plugins
