// Label regions are what a network of borders divides a mesh into, as drawn and after smoothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/labels/label_borders.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg {

/// The connected parts of all regions, for labels per face or per vertex, and the parts that lie on
/// the two sides of each border.
struct RegionParts {
  struct Part {
    std::int64_t label = 0;
    double area = 0;  ///< squared mesh units, with faces divided as label_borders() does
  };
  bool by_face = true;      ///< whether labels are per face; otherwise per vertex
  std::vector<Part> parts;  ///< in the order of their first face or vertex
  /// Per face or vertex, according to by_face; vertices without faces are of no part (UINT32_MAX).
  std::vector<std::uint32_t> of_element;
  std::vector<std::array<std::uint32_t, 2>> beside;  ///< per border: left and right of it
};

/// O(faces). `borders` are those that label_borders() found; throws Error as that does for a wrong
/// number of labels.
RegionParts parts_of_regions(const SurfaceMesh& mesh, std::span<const std::int64_t> labels,
                             std::span<const LabelBorder> borders);

/// The parts on the mesh that was cut along the borders; its chains are the borders, in their
/// order.
struct CutRegions {
  std::vector<std::uint32_t> part_of_face;  ///< per face of the cut mesh
  std::vector<double> area;                 ///< per part, squared mesh units
  std::vector<std::size_t> pieces;  ///< per part: the number of connected pieces it consists of now
  /// Borders (ascending) whose parts have changed: a border that crosses or touches another or
  /// itself away from its ends, that has another part beside it than before, or that lies along a
  /// piece that was separated from its part. If this is empty, each part is there, in one piece,
  /// and lies beside the same borders as before, and every junction has its borders.
  std::vector<std::size_t> wrong;
};

/// Follows the parts through the cut mesh: its faces are joined across all edges that are on no
/// chain, and each such heap belongs to the part that most of the border around it indicates.
/// O(faces).
CutRegions regions_of_cut(const CutMesh& cut, const RegionParts& drawn,
                          std::span<const LabelBorder> borders);

/// For each face of the mesh that was cut, the label with the largest share; the smallest one of
/// equals.
std::vector<std::int64_t> majority_labels(const CutMesh& cut, const RegionParts& drawn,
                                          const CutRegions& regions, std::size_t face_count);

}  // namespace talweg
