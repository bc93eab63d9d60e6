#include "talweg/core/smoothing/slack_field.hpp"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {

std::vector<double> slack_along(const Surface& surface, const SurfaceCurve& drawn,
                                std::span<const double> per_vertex) {
  if (per_vertex.size() != surface.vertex_count()) {
    throw Error(ErrorCode::kBadUsage, fmt::format("There are {} slacks for {} vertices.",
                                                  per_vertex.size(), surface.vertex_count()));
  }
  std::vector<double> along;
  for (const SurfacePoint& point : drawn.points) {
    const FaceCoordinates at = coordinates_in(surface, point, any_face(surface, point));
    const auto corners = surface.corners(at.face);
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (at.barycentric[k] == 0) continue;
      const double here = per_vertex[corners[k].index()];
      if (!(here >= 0 && std::isfinite(here))) {
        throw Error(
            ErrorCode::kBadUsage,
            fmt::format("The slack of vertex {} must be finite and >= 0.", corners[k].index()));
      }
      value += at.barycentric[k] * here;
    }
    along.push_back(value);
  }
  return along;
}

}  // namespace talweg
