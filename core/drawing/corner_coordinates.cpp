#include "talweg/core/drawing/corner_coordinates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

[[noreturn]] void bad_point(std::size_t k, const std::string& what) {
  throw Error(ErrorCode::kBadCurve, fmt::format("At position {} of the curve: {}.", k, what));
}

/// Whether all vertices with a weight are corners of the face.
bool has_all(const Surface& surface, FaceId face, const CornerCoordinates& at) {
  const auto corners = surface.corners(face);
  for (std::size_t c = 0; c < 3; ++c) {
    if (at.weights[c] != 0 &&
        std::find(corners.begin(), corners.end(), at.corners[c]) == corners.end()) {
      return false;
    }
  }
  return true;
}

void check(const Surface& surface, const CornerCoordinates& at, std::size_t k) {
  for (const VertexId v : at.corners) {
    if (v.index() >= surface.vertex_count()) {
      bad_point(k, fmt::format("there is no vertex {}; the mesh has {}, counted from 0", v.index(),
                               surface.vertex_count()));
    }
  }
  const auto& w = at.weights;
  const bool fine = std::all_of(w.begin(), w.end(), [](double x) { return x >= 0; });
  if (!fine || !(w[0] + w[1] + w[2] > 0) || !std::isfinite(w[0] + w[1] + w[2])) {
    bad_point(k, fmt::format("the weights {}, {} and {} are not those of a point between vertices",
                             w[0], w[1], w[2]));
  }
}

}  // namespace

FaceId any_face(const Surface& surface, const CornerCoordinates& at) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (at.weights[c] == 0) continue;
    FaceId best;
    if (!surface.halfedge(at.corners[c]).valid()) return best;
    for (const FaceId face : faces_at(surface, SurfacePoint::at_vertex(surface, at.corners[c]))) {
      if ((!best.valid() || face.index() < best.index()) && has_all(surface, face, at)) best = face;
    }
    return best;
  }
  return {};
}

std::vector<FaceCoordinates> in_faces(const Surface& surface,
                                      const std::vector<CornerCoordinates>& points) {
  std::vector<FaceCoordinates> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CornerCoordinates& at = points[k];
    check(surface, at, k);
    const FaceId face = any_face(surface, at);
    if (!face.valid()) {
      bad_point(k,
                fmt::format("no face of the mesh has the vertices {}, {} and {}; is the curve "
                            "of this mesh?",
                            at.corners[0].index(), at.corners[1].index(), at.corners[2].index()));
    }
    const double sum = at.weights[0] + at.weights[1] + at.weights[2];
    const bool exact = std::abs(sum - 1) < 1e-15;
    const auto corners = surface.corners(face);
    FaceCoordinates& found = result.emplace_back(FaceCoordinates{face});
    for (std::size_t c = 0; c < 3; ++c) {
      const auto to = std::find(corners.begin(), corners.end(), at.corners[c]);
      if (to == corners.end()) continue;  // its weight is 0
      found.barycentric[static_cast<std::size_t>(to - corners.begin())] +=
          exact ? at.weights[c] : at.weights[c] / sum;
    }
  }
  return result;
}

}  // namespace talweg
