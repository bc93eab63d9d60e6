// Made meshes are those that a run makes of a host's mesh, with its attributes and where they come
// from (talweg_meshes.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "host_attributes.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

struct MadeMesh {
  std::size_t vertices = 0;
  PartOrigins origins;
  CarryOver carry_over;
  /// Gives attributes that the plugin makes; may be null.
  std::function<void(const plugin::TakeAttribute& take)> own;
};

class MadeMeshes {
 public:
  /// `vertices`, `faces`: of the mesh that came in. Throws as HostAttributes::set().
  void set_attributes(std::span<const talweg_attribute* const> attributes, std::size_t vertices,
                      std::size_t faces);
  void forget_attributes();

  void clear() { meshes_.clear(); }
  [[nodiscard]] MadeMesh& add() { return meshes_.emplace_back(); }

  // For talweg_meshes.h; they throw plugin::Failure(TALWEG_BAD_USAGE) if there is no such mesh.
  void give_attributes(std::uint64_t mesh, const plugin::TakeAttribute& take) const;
  void give_origin(std::uint64_t mesh, const plugin::TakeOrigin& take) const;

 private:
  [[nodiscard]] const MadeMesh& at(std::uint64_t mesh) const;

  HostAttributes attributes_;
  std::vector<MadeMesh> meshes_;
};

/// Gives the geometry of a mesh.
void give(const plugin::Outputs& outputs, const MeshLists& lists);

}  // namespace talweg::plugins
