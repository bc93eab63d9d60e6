// A mesh workspace is the common base of plugins that work on a surface: it holds the host's mesh.
#pragma once

#include <exception>
#include <memory>
#include <optional>

#include "host_mesh.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// The status for an exception of the library.
talweg_status status_of(const std::exception& error);

/// Base of the plugin classes (talweg_plugin.hpp); they must have the parameters of with_repair().
class MeshWorkspace {
 public:
  explicit MeshWorkspace(const plugin::Services& services) : services_(&services) {}

  void set_mesh(const talweg_mesh& mesh, const plugin::Parameters& parameters);
  void share_mesh(const MeshWorkspace& other);
  /// Opens the mesh again if the repair parameters have changed.
  void prepare(const plugin::Parameters& parameters);

  static talweg_status status_of(const std::exception& error) { return plugins::status_of(error); }

 protected:
  ~MeshWorkspace() = default;

  /// Called when a new mesh is set, to drop results for the last one.
  virtual void forget() {}
  /// Called when the mesh was opened again, after forget(), to put the drawing on it again.
  virtual void put_again() {}

  [[nodiscard]] const HostMesh& host_mesh() const { return *mesh_; }
  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_->mesh(); }
  [[nodiscard]] const std::shared_ptr<const OpenedMesh>& opened_mesh() const {
    return mesh_->opened();
  }
  [[nodiscard]] const plugin::Services& services() const { return *services_; }
  /// Throws plugin::Services::cancelled() when the user has cancelled.
  void go_on(const char* stage, double fraction) const;
  /// The Progress for calls of the library; refers to the services.
  [[nodiscard]] Progress progress() const;
  /// Runs library work and turns its Cancelled into plugin::Services::cancelled().
  template <class Work>
  static auto cancellable(const Work& work) {
    try {
      return work();
    } catch (const Cancelled&) {
      throw plugin::Services::cancelled();
    }
  }

 private:
  const plugin::Services* services_;
  std::shared_ptr<const HostMesh> mesh_;
  std::optional<RepairSteps> steps_;  // of the opened mesh
};

}  // namespace talweg::plugins
