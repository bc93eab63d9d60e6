#include "talweg/core/smoothing/smoothing_domain.hpp"

#include <algorithm>

namespace talweg {

bool may_leave(const std::vector<bool>& at_cut, const Surface& part, const DomainResult& result) {
  const auto cut = [&](VertexId v) { return at_cut[v.index()]; };
  const auto touches = [&](const SurfacePoint& point) {
    const auto corners = part.corners(any_face(part, point));
    return std::any_of(corners.begin(), corners.end(), cut);
  };
  return result.at_fence ||
         std::any_of(result.curves.begin(), result.curves.end(), [&](const CurveResult& c) {
           return std::any_of(c.curve.points.begin(), c.curve.points.end(), touches);
         });
}

}  // namespace talweg
