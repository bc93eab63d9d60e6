// The strip curvature is the curvature of the surface at the vertices next to the joins of a chain.
#pragma once

#include <unordered_map>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Caches the angle defects and areas of vertices, for all curves that come near them. Refers to
/// the surface.
class StripCurvature {
 public:
  explicit StripCurvature(const Surface& surface) : surface_(&surface) {}

  [[nodiscard]] const Surface& surface() const { return *surface_; }

  /// Per sample: Gaussian curvature, 1 / mesh units², as the angle defects over the areas of the
  /// vertices of the faces that its joins pass. O(crossings).
  std::vector<double> along(const SampleChain& chain);

 private:
  struct Sum {
    double defect = 0, area = 0;
  };
  const Sum& of(VertexId v);
  Sum of(const SampleChain& chain, const ChainJoin& join);

  const Surface* surface_;
  std::unordered_map<std::uint32_t, Sum> known_;
};

}  // namespace talweg
