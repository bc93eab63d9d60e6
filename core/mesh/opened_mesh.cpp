#include "talweg/core/mesh/opened_mesh.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "talweg/core/mesh/smooth_ground.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

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

std::shared_ptr<const OpenedMesh> OpenedMesh::ground(const Progress& progress) const {
  const std::scoped_lock lock(ground_mutex_);
  if (!ground_) ground_ = open(smooth_ground(mesh_, progress));
  return ground_;
}

std::shared_ptr<const HeatDistance> OpenedMesh::heat(double time_scale, const Progress& progress,
                                                     unsigned threads) const {
  constexpr std::size_t kKept = 2;
  std::unique_lock lock(mutex_, std::try_to_lock);
  while (!lock.owns_lock()) {  // another thread is factoring
    if (!go_on(progress, "factor", 0)) return nullptr;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    lock.try_lock();
  }
  const auto known = std::find_if(heat_.begin(), heat_.end(),
                                  [&](const Heat& heat) { return heat.first == time_scale; });
  if (known != heat_.end()) {
    std::rotate(heat_.begin(), known, known + 1);
    return heat_.front().second;
  }
  HeatOptions options;
  options.time_scale = time_scale;
  options.threads = threads;
  if (heat_.size() == kKept)
    heat_.pop_back();  // before making the new one, so that at most two exist
  std::optional<HeatDistance> made = HeatDistance::open(surface(), options, progress);
  if (!made) return nullptr;
  auto heat = std::make_shared<const HeatDistance>(std::move(*made));
  heat_.insert(heat_.begin(), {time_scale, heat});
  return heat;
}

}  // namespace talweg
