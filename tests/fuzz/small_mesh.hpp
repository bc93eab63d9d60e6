// Small meshes from bytes: sheets, tubes, closed surfaces, soups, with damage.
#pragma once

#include "fuzz_bytes.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"

namespace talweg::fuzz {

/// At most 64 vertices and 128 faces. `damage` from 0 to 255 is the amount of defects: at 0 only
/// the shape is bad (flat faces, needles, vertices at one position), at 255 everything may be
/// wrong.
MeshLists small_mesh(Bytes& bytes, std::uint8_t damage);

}  // namespace talweg::fuzz
