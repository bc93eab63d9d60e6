// A host mesh is a host's mesh, opened, and repaired first on request. Input and results have the
// host's numbers of vertices and faces.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/plugin/talweg_parameters.hpp"
#include "talweg/plugin/talweg_plugin.h"

namespace talweg::plugins {

/// Copies the host's arrays. Throws plugin::Failure(TALWEG_BAD_MESH) for arrays that cannot be
/// read.
MeshLists lists_of(const talweg_mesh& mesh);

/// `parameters`, followed by the repair parameters, which every plugin that opens a mesh has.
std::vector<talweg_parameter> with_repair(std::vector<talweg_parameter> parameters,
                                          bool by_default = false);
/// The repair steps chosen by these parameters; none: no repair.
std::optional<RepairSteps> repair_of(const plugin::Parameters& parameters);

class HostMesh {
 public:
  /// Throws Error(kBadMesh) as OpenedMesh::open() and repair_to_surface() do. The last opened mesh
  /// is returned again for the same lists, as long as it has another owner.
  static std::shared_ptr<const HostMesh> open(MeshLists lists,
                                              const std::optional<RepairSteps>& steps);

  [[nodiscard]] const std::shared_ptr<const OpenedMesh>& opened() const { return opened_; }
  [[nodiscard]] const SurfaceMesh& mesh() const { return opened_->mesh(); }
  /// Null if nothing was repaired.
  [[nodiscard]] const RepairMap* map() const { return map_.get(); }
  /// Sentences on the changes of the repair.
  [[nodiscard]] const std::vector<std::string>& changes() const { return changes_; }
  /// The mesh before the repair.
  [[nodiscard]] MeshLists lists() const;
  [[nodiscard]] std::size_t vertex_count() const;  ///< before the repair
  [[nodiscard]] std::size_t face_count() const;    ///< before the repair

  // From the host's numbers to the opened mesh's.
  [[nodiscard]] CurveInput from_host(const CurveInput& curve) const;
  [[nodiscard]] std::vector<SurfacePoint> vertices_from_host(
      std::span<const std::uint32_t> ids) const;
  /// Throws plugin::Failure(TALWEG_BAD_USAGE), with `what` in the sentence, for a wrong number of
  /// values.
  [[nodiscard]] std::vector<double> per_vertex_from_host(const std::vector<double>& values,
                                                         const std::string& what) const;
  [[nodiscard]] std::vector<double> per_face_from_host(const std::vector<double>& values,
                                                       const std::string& what) const;

  // From the opened mesh's numbers to the host's.
  [[nodiscard]] PlacedCurve to_host(PlacedCurve curve) const;
  /// A split vertex has the value of its first copy.
  [[nodiscard]] std::vector<double> per_vertex_to_host(const std::vector<double>& values) const;

 private:
  static std::shared_ptr<const HostMesh> open_anew(MeshLists lists,
                                                   const std::optional<RepairSteps>& steps);
  [[nodiscard]] bool is_of(const MeshLists& lists, const std::optional<RepairSteps>& steps) const;

  std::shared_ptr<const OpenedMesh> opened_;
  std::optional<RepairSteps> steps_;
  std::optional<MeshLists> unrepaired_;  // the given lists, if they were repaired
  std::shared_ptr<const RepairMap> map_;
  std::vector<std::string> changes_;
};

}  // namespace talweg::plugins
