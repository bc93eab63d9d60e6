// A vertex origin says in numbers where a vertex of a cut mesh lies on the old one.
#pragma once

#include <array>
#include <cstdint>

#include "talweg/core/repair/repair_map.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

// The numbers that stand for no element, as the origin of what lies in lids.
inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;
inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;

/// Where a vertex lies on the mesh that came in: at a vertex of weight 1, on an edge or in a face.
struct VertexOrigin {
  std::array<std::uint32_t, 3> vertices{kNoVertex, kNoVertex, kNoVertex};  ///< the first so many
  std::array<double, 3> weights{};  ///< on an edge exactly 1 - t and t
};

/// `map`: if the mesh was repaired before it was cut; origins are then in the numbers before.
VertexOrigin origin_of(const SurfacePoint& point, const Surface& surface,
                       const RepairMap* map = nullptr);

}  // namespace talweg
