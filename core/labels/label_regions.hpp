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

/// The connected parts of all regions of labels per face or per vertex, and which of them lie on
/// the two sides of each border.
struct RegionParts {
  struct Part {
    std::int64_t label = 0;
    double area = 0;  ///< squared mesh units; as label_borders() divides the faces
  };
  bool by_face = true;                               ///< or by vertex
  std::vector<Part> parts;                           ///< in the order of their first face or vertex
  std::vector<std::uint32_t> of_element;             ///< per face or vertex, as the labels are
  std::vector<std::array<std::uint32_t, 2>> beside;  ///< per border: left and right of it
};

/// O(faces). `borders` are those that label_borders() found; throws Error as that does for a wrong
/// number of labels.
RegionParts parts_of_regions(const SurfaceMesh& mesh, std::span<const std::int64_t> labels,
                             std::span<const LabelBorder> borders);

/// The parts on the mesh that was cut along the borders, which are its chains, in their order.
struct CutRegions {
  std::vector<std::uint32_t> part_of_face;  ///< per face of the cut mesh
  std::vector<double> area;                 ///< per part, squared mesh units
  std::vector<std::size_t> heaps;           ///< per part: how many connected ones it is in now
  /// Borders (ascending) where the parts are not as they were: a border that crosses or touches
  /// another or itself away from its ends, that has another part beside it than it had, or that
  /// lies along a piece that came off its part. Empty: each part is there, in one piece, and lies
  /// beside the same borders as before; every junction has its borders.
  std::vector<std::size_t> wrong;
};

/// Follows the parts through the cut mesh: its faces are put together across all edges that are on
/// no chain, and each heap belongs to the part that most of the borders around it say. O(faces).
CutRegions regions_of_cut(const CutMesh& cut, const RegionParts& drawn,
                          std::span<const LabelBorder> borders);

/// The label with the largest share of each face of the mesh that was cut; of equals the smallest.
std::vector<std::int64_t> majority_labels(const CutMesh& cut, const RegionParts& drawn,
                                          const CutRegions& regions, std::size_t face_count);

}  // namespace talweg
