#include "talweg/core/opened_mesh.hpp"

#include <optional>
#include <utility>

#include "talweg/core/stopwatch.hpp"

namespace talweg {

std::shared_ptr<const OpenedMesh> OpenedMesh::open(const MeshLists& lists) {
  const Stopwatch watch;
  std::shared_ptr<OpenedMesh> opened(new OpenedMesh(SurfaceMesh::open(lists)));
  opened->open_ms_ = watch.ms();
  return opened;
}

std::shared_ptr<const OpenedMesh> OpenedMesh::open(MeshLists&& lists) {
  const Stopwatch watch;
  std::shared_ptr<OpenedMesh> opened(new OpenedMesh(SurfaceMesh::open(std::move(lists))));
  opened->open_ms_ = watch.ms();
  return opened;
}

std::shared_ptr<const OpenedMesh> OpenedMesh::open(SurfaceMesh mesh) {
  return std::shared_ptr<OpenedMesh>(new OpenedMesh(std::move(mesh)));
}

const HeatDistance* OpenedMesh::heat(double time_scale, const Progress& progress,
                                     unsigned threads) const {
  const std::lock_guard lock(mutex_);
  if (const auto known = heat_.find(time_scale); known != heat_.end()) return &known->second;
  HeatOptions options;
  options.time_scale = time_scale;
  options.threads = threads;
  std::optional<HeatDistance> made = HeatDistance::open(surface(), options, progress);
  if (!made) return nullptr;
  return &heat_.emplace(time_scale, std::move(*made)).first->second;
}

}  // namespace talweg
