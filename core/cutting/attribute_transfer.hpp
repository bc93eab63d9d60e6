// An attribute transfer gives the meshes that are made from a mesh the values that its file has.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/repair/repair_map.hpp"

namespace talweg {

/// The attributes of the cut mesh. Faces have what the old face has that they are part of. Old
/// vertices keep their numbers; a new one has, of its old face's corners,
/// - the linear interpolation, of real numbers and of whole ones that are colours (rounded);
/// - that, made as long as one, of normals (nx, ny, nz);
/// - what the nearest corner has (in barycentrics; the first of equals), of other whole numbers and
///   of columns with "label" in their name.
/// Corners are interpolated in the same way. Throws Error(kBadUsage) where the attributes are not
/// of as many vertices and faces as the old mesh has.
MeshAttributes carried_to(const CutMesh& cut, const Surface& old, const MeshAttributes& attributes);

/// The attributes of a mesh of other vertices and faces of this one, any number of times each.
/// Faces and vertices from none (kNoFace, kNoVertex), such as those of lids, have 0 in every column
/// but white in those of colours, and neither texture coordinates nor normals nor names.
MeshAttributes picked(const MeshAttributes& attributes, std::span<const std::uint32_t> vertices,
                      std::span<const std::uint32_t> faces);

/// The attributes of a repaired mesh. `differing`: how many vertices were welded onto one whose
/// numbers are others; those are lost.
MeshAttributes of_repaired(const MeshAttributes& attributes, const RepairMap& map,
                           std::size_t& differing);

}  // namespace talweg
