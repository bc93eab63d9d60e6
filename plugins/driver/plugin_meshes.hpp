// Plugin meshes are the meshes that a run of a plugin made, with their attributes and origins, to
// be written.
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
  /// Takes the meshes of the instance's last run. `attributes`: of the mesh that went in; `single`:
  /// whether its file stores coordinates as 32-bit floats.
  PluginMeshes(const host::Instance& instance, const host::Results& results,
               const MeshAttributes& attributes, bool single, PatientSpace space);

  [[nodiscard]] bool empty() const { return meshes_.empty(); }
  /// One is written to this file; of several "out.ply" becomes "out-0.ply", "out-1.ply", ...
  /// `tag`: with the curves' edges.
  void write(const std::string& path, bool tag) const;
  /// Where they come from (docs/cutting.md); `path`: the file of the meshes, or empty.
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
