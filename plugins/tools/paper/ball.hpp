// A bumpy ball, a test mesh of any size.
#pragma once

#include <cstdint>

#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::paper {

/// The unit sphere as an icosahedron whose faces are divided into frequency² each: 20 frequency²
/// faces, closed, edge lengths within a factor of about 1.3. frequency >= 1.
MeshLists sphere(std::uint32_t frequency);

/// Moves the points of the unit sphere along their rays: hills of about a fifth of the radius, with
/// smaller and smaller hills on them.
void make_bumpy(MeshLists& sphere, std::uint64_t seed);

/// A sphere, made bumpy.
MeshLists bumpy_ball(std::uint32_t frequency, std::uint64_t seed);

}  // namespace talweg::paper
