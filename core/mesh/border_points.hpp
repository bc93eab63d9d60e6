// Border points lie on the boundary of a mesh, at a boundary vertex or on a boundary edge.
#pragma once

#include <variant>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

inline bool is_on_boundary(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return surface.on_boundary(v->vertex);
  if (const auto* e = std::get_if<OnEdge>(&point.where())) return surface.on_boundary(e->edge);
  return false;
}

}  // namespace talweg
