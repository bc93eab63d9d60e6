// Attribute transfer carries the attributes of a file to meshes that are made from its mesh.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/core/repair/repair_map.hpp"

namespace talweg {

/// The rule of a column: its `carry`, or for Carry::kByName a rule by name and type.
Carry carry_of(const AttributeColumn& column);
/// The value of elements without a source: the column's `fill`, or white for colours and 0 for
/// other names.
double fill_of(const AttributeColumn& column);

/// The attributes of the cut mesh. A face gets the values of the old face that it is a part of. Old
/// vertices keep their values. The value of a new vertex is computed from the corners of its old
/// face, according to the column's `carry` or, for Carry::kByName:
/// - real numbers, and whole numbers that are colours (rounded), are interpolated linearly;
/// - normals (nx, ny, nz) are interpolated and normalised;
/// - other whole numbers, and columns with "label" in their name, are taken from the nearest
///   corner (the largest barycentric coordinate; the first of equal ones).
///
/// Values at corners are interpolated, and normals at corners also normalised. Throws
/// Error(kBadUsage) if the attributes do not have as many vertices and faces as the old mesh.
/// O(values of the cut mesh · log).
MeshAttributes carried_to(const CutMesh& cut, const Surface& old, const MeshAttributes& attributes);

/// Converts one value per vertex of the old mesh to one per vertex of the cut mesh, by linear
/// interpolation in the old faces. O(vertices).
std::vector<double> carried_to(const CutMesh& cut, const Surface& old,
                               std::span<const double> per_vertex);

/// The attributes of a mesh whose vertices and faces are picked from this mesh, each any number of
/// times. Elements without a source (kNoFace, kNoVertex), such as elements of lids, get fill_of()
/// their column, and no texture coordinates, normals or names. O(picked elements + values at
/// corners).
MeshAttributes picked(const MeshAttributes& attributes, std::span<const std::uint32_t> vertices,
                      std::span<const std::uint32_t> faces);

/// The attributes of a repaired mesh. `differing` receives the number of vertices that were welded
/// onto a vertex with other values; their own values are lost. O(vertices + faces) for each column.
MeshAttributes of_repaired(const MeshAttributes& attributes, const RepairMap& map,
                           std::size_t& differing);

}  // namespace talweg
