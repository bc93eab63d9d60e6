// The curve components are the connected components of a surface that have a curve.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/intrinsic/exact_distance/window_front.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Tells when a front marches in vain. The surface must outlive the object.
class CurveComponents {
 public:
  explicit CurveComponents(const Surface& surface) : surface_(&surface) {}

  /// To be called when the front has new curves.
  void clear() { with_curve_.clear(); }

  /// Whether it is known that the front will never reach v. Components are computed only after so
  /// many windows that this costs little in comparison; until then, false.
  bool keep_out(const WindowFront& front, VertexId v);

 private:
  const Surface* surface_;
  std::vector<std::uint32_t> component_;   // per vertex; made when first needed
  std::vector<std::uint32_t> with_curve_;  // components, in order; made when first needed
};

}  // namespace talweg
