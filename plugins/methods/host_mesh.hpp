// A host mesh is a mesh as a host gave it, opened, and repaired first where that was asked for;
// what comes in has the host's numbers, and so has what is given back.
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

/// `parameters`, followed by those that say how a mesh is repaired, which every plugin has that
/// opens one.
std::vector<talweg_parameter> with_repair(std::vector<talweg_parameter> parameters,
                                          bool by_default = false);
/// The steps that these parameters ask for; none: no repair.
std::optional<RepairSteps> repair_of(const plugin::Parameters& parameters);

class HostMesh {
 public:
  /// Throws Error(kBadMesh) as OpenedMesh::open() and repair_to_surface() do. The mesh that was
  /// opened last is given again for the same lists, while somebody has it.
  static std::shared_ptr<const HostMesh> open(MeshLists lists,
                                              const std::optional<RepairSteps>& steps);

  [[nodiscard]] const std::shared_ptr<const OpenedMesh>& opened() const { return opened_; }
  [[nodiscard]] const SurfaceMesh& mesh() const { return opened_->mesh(); }
  /// Null if nothing was repaired.
  [[nodiscard]] const RepairMap* map() const { return map_.get(); }
  /// Sentences on what was repaired.
  [[nodiscard]] const std::vector<std::string>& changes() const { return changes_; }
  /// As it came in.
  [[nodiscard]] MeshLists lists() const;
  [[nodiscard]] std::size_t vertex_count() const;  ///< as it came in
  [[nodiscard]] std::size_t face_count() const;    ///< as it came in

  // From the host's numbers.
  [[nodiscard]] CurveInput taken(const CurveInput& curve) const;
  [[nodiscard]] std::vector<SurfacePoint> taken_vertices(std::span<const std::uint32_t> ids) const;
  /// Throws plugin::Failure(TALWEG_BAD_USAGE), with `what` in the sentence, for another number of
  /// values.
  [[nodiscard]] std::vector<double> taken_per_vertex(const std::vector<double>& values,
                                                     const std::string& what) const;
  [[nodiscard]] std::vector<double> taken_per_face(const std::vector<double>& values,
                                                   const std::string& what) const;

  // To them.
  [[nodiscard]] PlacedCurve given(PlacedCurve curve) const;
  /// A vertex that was split has the value of its first copy.
  [[nodiscard]] std::vector<double> given_per_vertex(const std::vector<double>& values) const;

 private:
  static std::shared_ptr<const HostMesh> open_anew(MeshLists lists,
                                                   const std::optional<RepairSteps>& steps);
  [[nodiscard]] bool is_of(const MeshLists& lists, const std::optional<RepairSteps>& steps) const;

  std::shared_ptr<const OpenedMesh> opened_;
  std::optional<RepairSteps> steps_;
  std::optional<MeshLists> came_in_;  // if repaired
  std::shared_ptr<const RepairMap> map_;
  std::vector<std::string> changes_;
};

}  // namespace talweg::plugins
