// Small meshes are made of bytes: sheets, tubes, closed surfaces, soups, with damage.
#pragma once

#include "fuzz_bytes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::fuzz {

/// At most 64 vertices and 128 faces. `damage` is how much may be wrong: 0 nothing but the shape
/// (flat faces, needles, vertices in one place), 255 anything.
MeshLists small_mesh(Bytes& bytes, std::uint8_t damage);

}  // namespace talweg::fuzz
