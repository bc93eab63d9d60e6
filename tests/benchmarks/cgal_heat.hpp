// CGAL's heat method is a peer to compare with.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::benchmarks {

/// CGAL::Heat_method_3 on the intrinsic Delaunay triangulation, its default.
class CgalHeat {
 public:
  explicit CgalHeat(const MeshLists& lists);  ///< copies the mesh; not what is timed
  ~CgalHeat();
  CgalHeat(const CgalHeat&) = delete;
  CgalHeat& operator=(const CgalHeat&) = delete;

  void open();  ///< triangulation, matrices and factors
  /// One distance per vertex, to a set of vertices.
  std::vector<double> solve(std::span<const std::uint32_t> sources);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talweg::benchmarks
