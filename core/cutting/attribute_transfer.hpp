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

/// How a column is carried where its `carry` does not say it: by its name and type.
Carry carry_of(const AttributeColumn& column);
/// The value of elements that come from nowhere: the column's `fill`, else by its name.
double fill_of(const AttributeColumn& column);

/// The attributes of the cut mesh. Faces have those of the old face that they are part of. Old
/// vertices keep their values. The value of a new vertex follows from the corners of its old face,
/// as the column's `carry` says or, by its name:
/// - real numbers, and whole numbers that are colours (rounded), are interpolated linearly;
/// - normals (nx, ny, nz) are interpolated and made as long as one;
/// - other whole numbers, and columns with "label" in their name, are taken from the nearest corner
///   (in barycentrics; the first of equals).
/// Values at corners are interpolated, and normals among them made as long as one. Throws
/// Error(kBadUsage) where the attributes do not have as many vertices and faces as the old mesh.
/// O(values of the cut mesh), log for those at new corners.
MeshAttributes carried_to(const CutMesh& cut, const Surface& old, const MeshAttributes& attributes);

/// Converts one value per vertex of the old mesh to one per vertex of the new, linear in each old
/// face. O(vertices).
std::vector<double> carried_to(const CutMesh& cut, const Surface& old,
                               std::span<const double> per_vertex);

/// The attributes of a mesh whose vertices and faces are picked from this one, each any number of
/// times. Faces and vertices from none (kNoFace, kNoVertex), such as those of lids, have the
/// column's `fill`, or else 0, and white in columns of colours; they have no texture coordinates,
/// normals or names. O(what is picked), but all values at corners are looked through.
MeshAttributes picked(const MeshAttributes& attributes, std::span<const std::uint32_t> vertices,
                      std::span<const std::uint32_t> faces);

/// The attributes of a repaired mesh. `differing`: how many vertices were welded onto one with
/// other values; their own values are lost. O(vertices + faces) for each column.
MeshAttributes of_repaired(const MeshAttributes& attributes, const RepairMap& map,
                           std::size_t& differing);

}  // namespace talweg
