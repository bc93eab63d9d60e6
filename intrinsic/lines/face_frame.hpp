// A face frame lays a face out in the plane, so that points and directions have two coordinates.
#pragma once

#include <array>
#include <cstddef>

#include "talweg/intrinsic/surface/plane_point.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {

/// Corner 0 of the face lies at the origin, corner 1 on the positive x axis, corner 2 above it.
/// Lengths in mesh units.
struct FaceFrame {
  std::array<HalfedgeId, 3> sides;  ///< side k runs from corner k to the next corner
  std::array<PlanePoint, 3> corners;

  FaceFrame(const Surface& surface, FaceId face) {
    sides[0] = surface.halfedge(face);
    sides[1] = surface.next(sides[0]);
    sides[2] = surface.next(sides[1]);
    const double base = surface.length(edge_of(sides[0]));
    corners[1] = {base, 0};
    corners[2] = apex(base, surface.length(edge_of(sides[2])), surface.length(edge_of(sides[1])));
  }

  [[nodiscard]] std::size_t side_of(HalfedgeId h) const {
    return h == sides[0] ? 0 : h == sides[1] ? 1 : 2;
  }
  [[nodiscard]] PlanePoint along(std::size_t side) const {
    return corners[(side + 1) % 3] - corners[side];
  }

  using Barycentric = std::array<double, 3>;
  [[nodiscard]] PlanePoint at(const Barycentric& b) const {
    return {b[1] * corners[1].x + b[2] * corners[2].x, b[2] * corners[2].y};
  }
  /// The derivatives of the barycentrics along a direction; their sum is 0. Not finite in a face
  /// without area.
  [[nodiscard]] Barycentric rates(PlanePoint direction) const {
    const double c = direction.y / corners[2].y;
    const double b = (direction.x - c * corners[2].x) / corners[1].x;
    return {-b - c, b, c};
  }
};

}  // namespace talweg
