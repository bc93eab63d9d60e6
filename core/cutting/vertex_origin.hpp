// A vertex origin is the place of a cut mesh's vertex on the old mesh, as a weighted mean of old
// vertices.
#pragma once

#include <array>
#include <cstdint>

#include "talweg/core/repair/repair_map.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

// The numbers that stand for no element; elements of lids have them as their origins.
inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFU;
inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFU;

/// The place of a vertex on the old mesh: at one vertex (weight 1), on an edge (two) or in a face
/// (three).
struct VertexOrigin {
  std::array<std::uint32_t, 3> vertices{kNoVertex, kNoVertex,
                                        kNoVertex};  ///< one, two or three, then kNoVertex
  std::array<double, 3> weights{};                   ///< on an edge exactly 1 - t and t
};

/// The origin of a point. `map`: given if the mesh was repaired before the cut; the origin then
/// refers to the file.
VertexOrigin origin_of(const SurfacePoint& point, const Surface& surface,
                       const RepairMap* map = nullptr);

}  // namespace talweg
