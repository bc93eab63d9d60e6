// An opened mesh has everything that curves need and that depends on the mesh alone.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/heat/heat_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// The first stage, shared by any number of smoothers and threads. Only the heat factors, which
/// take most of the time of opening, are made later, when they are first needed.
class OpenedMesh {
 public:
  /// Throws Error(kBadMesh) as SurfaceMesh::open does.
  static std::shared_ptr<const OpenedMesh> open(const MeshLists& lists);
  static std::shared_ptr<const OpenedMesh> open(MeshLists&& lists);
  static std::shared_ptr<const OpenedMesh> open(SurfaceMesh mesh);

  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Surface& surface() const { return mesh_.surface(); }
  /// Time to check the mesh and build the surface, in ms.
  [[nodiscard]] double open_ms() const { return open_ms_; }

  /// The mesh's smooth_ground(), made on first use; safe to call from any thread. O(mesh), once.
  /// Throws Cancelled; then nothing is made.
  [[nodiscard]] std::shared_ptr<const OpenedMesh> ground(const Progress& progress = {}) const;

  /// The heat solver for this time scale (in units of h²), factored on first use; safe to call from
  /// any thread. The two most recently used solvers are kept, so a slider of the time scale costs
  /// the memory of two; others are freed when nobody holds them any more. nullptr when cancelled,
  /// also while another thread is factoring. Throws as HeatDistance does. At most `threads` threads
  /// are used; their number does not change the result.
  [[nodiscard]] std::shared_ptr<const HeatDistance> heat(double time_scale,
                                                         const Progress& progress = {},
                                                         unsigned threads = 2) const;

 private:
  explicit OpenedMesh(SurfaceMesh mesh) : mesh_(std::move(mesh)) {}

  SurfaceMesh mesh_;
  double open_ms_ = 0;
  using Heat = std::pair<double, std::shared_ptr<const HeatDistance>>;
  mutable std::mutex mutex_;
  mutable std::mutex ground_mutex_;
  mutable std::shared_ptr<const OpenedMesh> ground_;
  mutable std::vector<Heat> heat_;  // by time scale, the most recently used one first
};

}  // namespace talweg
