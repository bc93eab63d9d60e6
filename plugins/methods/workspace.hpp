// A workspace is what every plugin on curves begins with: a mesh, opened, and a drawing on it.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <span>

#include "host_curves.hpp"
#include "talweg/core/drawing/straight_lines.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// Copies the host's arrays and opens them. Throws plugin::Failure(TALWEG_BAD_MESH) for arrays that
/// cannot be read, Error(kBadMesh) as OpenedMesh::open() does.
std::shared_ptr<const OpenedMesh> opened(const talweg_mesh& mesh);

/// The description of a plugin on curves; its strings must be constants.
talweg_plugin about_curves(const char* id, const char* label, const char* doc);

/// Base of the plugin classes (talweg_plugin.hpp).
class Workspace {
 public:
  explicit Workspace(const plugin::Services& services) : services_(&services) {}

  void set_mesh(const talweg_mesh& mesh) { use(opened(mesh)); }
  void share_mesh(const Workspace& other) { use(other.mesh_); }
  void set_curves(std::span<const talweg_curve* const> curves) { draw(curves, {}); }

  static talweg_status status_of(const std::exception& error);

 protected:
  ~Workspace() = default;

  /// Called when a new mesh is set, to drop results for the last one.
  virtual void forget() {}

  void draw(std::span<const talweg_curve* const> curves, const SnapOptions& options);

  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_->mesh(); }
  [[nodiscard]] const std::shared_ptr<const OpenedMesh>& opened_mesh() const { return mesh_; }
  [[nodiscard]] StraightLines& lines();
  [[nodiscard]] const SnappedDrawing& drawing() const { return drawing_; }
  /// Counts the drawings and meshes that were set; a change of pins alone does not count.
  [[nodiscard]] std::uint64_t drawings() const { return drawings_; }
  [[nodiscard]] const plugin::Services& services() const { return *services_; }
  /// The Progress for calls of the library; refers to the services.
  [[nodiscard]] Progress progress() const;
  /// Does work of the library that throws Cancelled, and throws plugin::Services::cancelled()
  /// instead.
  template <class Work>
  static auto cancellable(const Work& work) {
    try {
      return work();
    } catch (const Cancelled&) {
      throw plugin::Services::cancelled();
    }
  }

 private:
  void use(std::shared_ptr<const OpenedMesh> mesh);

  const plugin::Services* services_;
  std::shared_ptr<const OpenedMesh> mesh_;
  std::optional<StraightLines> lines_;  // made when first needed
  SnappedDrawing drawing_;
  std::uint64_t drawings_ = 0;
};

}  // namespace talweg::plugins
