#include "talweg/intrinsic/exact_distance/curve_components.hpp"

#include <algorithm>
#include <cmath>

namespace talweg {

bool CurveComponents::keep_out(const WindowFront& front, VertexId v) {
  if (std::isfinite(front.vertices()[v].distance)) return false;
  if (with_curve_.empty()) {
    if (front.windows().size() < surface_->vertex_count() / 8) return false;
    if (component_.empty()) component_ = components_of(*surface_).of_vertex;
    // Every vertex reached so far is connected to a curve.
    for (const VertexId reached : front.vertices().reached()) {
      with_curve_.push_back(component_[reached.index()]);
    }
    std::sort(with_curve_.begin(), with_curve_.end());
    with_curve_.erase(std::unique(with_curve_.begin(), with_curve_.end()), with_curve_.end());
  }
  return !std::binary_search(with_curve_.begin(), with_curve_.end(), component_[v.index()]);
}

}  // namespace talweg
