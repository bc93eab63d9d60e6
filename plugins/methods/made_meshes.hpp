// Made meshes are the meshes that a run makes from a host's mesh, with attributes and origins
// (talweg_meshes.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "host_attributes.hpp"
#include "host_mesh.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/mesh_parts.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

struct MadeMesh {
  std::size_t vertices = 0;
  std::function<PartOrigins()> origins;  ///< computed when a host asks for it
  CarryOver carry_over;
  /// Gives the attributes that the plugin adds; may be null.
  std::function<void(const plugin::TakeAttribute& take)> own;
};

class MadeMeshes {
 public:
  /// `vertices` and `faces` are the numbers of the host's mesh. Throws as HostAttributes::set().
  void set_attributes(std::span<const talweg_attribute* const> attributes, std::size_t vertices,
                      std::size_t faces);
  void forget_attributes();

  /// Whether attributes of corners were set.
  [[nodiscard]] bool at_corners() const { return attributes_.at_corners(); }

  void clear() { meshes_.clear(); }
  MadeMesh& add(MadeMesh mesh) { return meshes_.emplace_back(std::move(mesh)); }
  [[nodiscard]] MadeMesh& last() { return meshes_.back(); }

  // For talweg_meshes.h; they throw plugin::Failure(TALWEG_BAD_USAGE) if there is no such mesh.
  void give_attributes(std::uint64_t mesh, const plugin::TakeAttribute& take) const;
  void give_origin(std::uint64_t mesh, const plugin::TakeOrigin& take) const;

 private:
  [[nodiscard]] const MadeMesh& at(std::uint64_t mesh) const;

  HostAttributes attributes_;
  std::vector<MadeMesh> meshes_;
};

/// A part of the host's mesh after a cut; the host's mesh must outlive the part. The cut may lack
/// its lists if there are no attributes of corners.
MadeMesh made_by_cut(const HostMesh& mesh, std::shared_ptr<const CutMesh> cut, MeshPart part);

/// Gives the geometry of a mesh.
void give(const plugin::Outputs& outputs, const MeshLists& lists);

/// Base of the plugin classes that make meshes: a workspace that offers talweg_meshes.h.
template <class Base>
class MakesMeshes : public Base {
 public:
  using Base::Base;

  static constexpr std::uint32_t kTakes = TALWEG_TAKES_ATTRIBUTES;
  void set_attributes(std::span<const talweg_attribute* const> attributes) {
    made_.set_attributes(attributes, this->host_mesh().vertex_count(),
                         this->host_mesh().face_count());
  }
  void give_attributes(std::uint64_t mesh, const plugin::TakeAttribute& take) const {
    made_.give_attributes(mesh, take);
  }
  void give_origin(std::uint64_t mesh, const plugin::TakeOrigin& take) const {
    made_.give_origin(mesh, take);
  }

 protected:
  ~MakesMeshes() = default;

  void forget() override {
    Base::forget();
    made_.forget_attributes();
  }

  /// Splits a cut into its parts. Its lists are copied only for attributes of corners.
  [[nodiscard]] MeshParts taken_apart(CutMesh& cut, const PartOptions& options) const {
    return Base::cancellable([&] {
      const SurfaceMesh& mesh = this->mesh();
      const Progress progress = this->progress();
      return made_.at_corners() ? take_apart(mesh, std::as_const(cut), {}, options, progress)
                                : take_apart(mesh, std::move(cut), {}, options, progress);
    });
  }
  /// Gives the parts, and keeps them for talweg_meshes.h.
  void give_parts(const plugin::Outputs& outputs, std::vector<MeshPart> parts,
                  const std::shared_ptr<const CutMesh>& cut) {
    for (const MeshPart& part : parts) give(outputs, part.lists);
    for (MeshPart& part : parts) {
      made_.add(made_by_cut(this->host_mesh(), cut, std::move(part)));
    }
  }

  MadeMeshes made_;  // by the last run
};

}  // namespace talweg::plugins
