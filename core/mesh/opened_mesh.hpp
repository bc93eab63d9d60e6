// An opened mesh holds the data for smoothing that depends on the mesh only, not on curves.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/heat/heat_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// Any number of smoothers and threads can share an opened mesh. The Cholesky factors of the heat
/// method, which take most of the time, are made on first use.
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
  /// Throws Cancelled; the next call then starts anew.
  [[nodiscard]] std::shared_ptr<const OpenedMesh> ground(const Progress& progress = {}) const;

  /// The heat solver for a time scale (in units of h²), factored on first use; safe to call from
  /// any thread. The mesh keeps the two most recently used solvers; older solvers are freed when
  /// the last caller releases them. nullptr when cancelled, also while another thread is factoring.
  /// Throws as HeatDistance does. At most `threads` threads are used; their number does not change
  /// the result.
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
  mutable std::vector<Heat> heat_;  // with its time scale; the most recently used first
};

}  // namespace talweg
