#include "mesh_workspace.hpp"

#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg::plugins {

talweg_status status_of(const std::exception& error) {
  const auto* own = dynamic_cast<const Error*>(&error);
  if (own == nullptr) return TALWEG_INTERNAL;
  switch (own->code()) {
    case ErrorCode::kBadUsage:
      return TALWEG_BAD_USAGE;
    case ErrorCode::kBadMesh:
      return TALWEG_BAD_MESH;
    case ErrorCode::kBadCurve:
      return TALWEG_BAD_CURVE;
    case ErrorCode::kBadFile:
      return TALWEG_BAD_FILE;
    case ErrorCode::kNumerical:
      return TALWEG_NUMERICAL;
    case ErrorCode::kOutOfMemory:
      return TALWEG_OUT_OF_MEMORY;
  }
  return TALWEG_INTERNAL;
}

void MeshWorkspace::go_on(const char* stage, double fraction) const {
  if (!services_->go_on(stage, fraction)) throw plugin::Services::cancelled();
}

void MeshWorkspace::set_mesh(const talweg_mesh& mesh, const plugin::Parameters& parameters) {
  const std::optional<RepairSteps> steps = repair_of(parameters);
  std::shared_ptr<const HostMesh> opened = HostMesh::open(lists_of(mesh), steps);
  forget();  // drops all that refers to the last mesh
  mesh_ = std::move(opened);
  steps_ = steps;
}

void MeshWorkspace::share_mesh(const MeshWorkspace& other) {
  std::shared_ptr<const HostMesh> shared = other.mesh_;
  forget();
  mesh_ = std::move(shared);
  steps_ = other.steps_;
}

void MeshWorkspace::prepare(const plugin::Parameters& parameters) {
  const std::optional<RepairSteps> steps = repair_of(parameters);
  if (!mesh_ || steps == steps_) return;
  std::shared_ptr<const HostMesh> opened = HostMesh::open(mesh_->lists(), steps);
  forget();
  mesh_ = std::move(opened);
  steps_ = steps;
  put_again();
}

Progress MeshWorkspace::progress() const {
  return [services = services_](const char* stage, double fraction) {
    return services->go_on(stage, fraction);
  };
}

}  // namespace talweg::plugins
