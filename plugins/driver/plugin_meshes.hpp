// Plugin meshes are the meshes that a run of a plugin made, ready to be written with their
// attributes and origins.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::driver {

/// The extension talweg.meshes/1 of a plugin; null if it has none.
const talweg_meshes* meshes_of(const talweg_plugin& plugin);

/// Throws Error(kBadUsage), which names --tag, if meshes in files of this name hold no edges.
void check_tag(const std::string& path);

class PluginMeshes {
 public:
  PluginMeshes() = default;
  /// Takes the meshes of the instance's last run. `attributes` are the input mesh's; `single` says
  /// whether the input file stores coordinates as 32-bit floats.
  PluginMeshes(const host::Instance& instance, const host::Results& results,
               const MeshAttributes& attributes, bool single, PatientSpace space);

  [[nodiscard]] bool empty() const { return meshes_.empty(); }
  /// Writes one mesh to this file; several meshes to "out-0.ply", "out-1.ply", ... for "out.ply".
  /// `tag`: with the curves' edges.
  void write(const std::string& path, bool tag) const;
  /// Writes the meshes' origins (docs/cutting.md); `path` is the file of the meshes, or empty.
  void write_map(const std::string& map, const std::string& path) const;

 private:
  struct Made {
    MeshLists lists;
    MeshAttributes attributes;
    PartOrigins origins;
  };
  [[nodiscard]] std::string path_of(const std::string& path, std::size_t mesh) const;

  std::vector<Made> meshes_;
};

}  // namespace talweg::driver
