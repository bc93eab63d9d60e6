// The curve components are the connected components of a surface that contain a curve.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/intrinsic/exact_distance/window_front.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Detects vertices that a front never reaches. The surface must outlive the object.
class CurveComponents {
 public:
  explicit CurveComponents(const Surface& surface) : surface_(&surface) {}

  /// Must be called when the front gets new curves.
  void clear() { with_curve_.clear(); }

  /// Whether v is known to be out of the front's reach. Components are computed only when the
  /// windows have cost much more than the components will cost; the answer is false until then.
  bool keep_out(const WindowFront& front, VertexId v);

 private:
  const Surface* surface_;
  std::vector<std::uint32_t> component_;   // per vertex; made when first needed
  std::vector<std::uint32_t> with_curve_;  // component numbers, sorted; made when first needed
};

}  // namespace talweg
