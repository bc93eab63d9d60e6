// Label regions are the connected parts into which borders divide a mesh, in the drawing and after
// smoothing.
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

/// The connected parts of all regions, for labels per face or per vertex, and the parts on both
/// sides of each border.
struct RegionParts {
  struct Part {
    std::int64_t label = 0;
    double area = 0;  ///< squared mesh units; faces are divided as in label_borders()
  };
  bool by_face = true;      ///< whether labels are per face; otherwise per vertex
  std::vector<Part> parts;  ///< in the order of their first face or vertex
  /// Per face or vertex (see by_face), the part; UINT32_MAX for a vertex without a face.
  std::vector<std::uint32_t> of_element;
  std::vector<std::array<std::uint32_t, 2>> beside;  ///< per border: the parts left and right
};

/// Finds the parts. `borders` is the result of label_borders() for these labels. O(faces).
RegionParts parts_of_regions(const SurfaceMesh& mesh, std::span<const std::int64_t> labels,
                             std::span<const LabelBorder> borders);

/// The parts in the mesh that was cut along the borders.
struct CutRegions {
  std::vector<std::uint32_t> part_of_face;  ///< per face of the cut mesh
  std::vector<double> area;                 ///< per part, squared mesh units
  std::vector<std::size_t> pieces;          ///< per part: its number of connected pieces
  /// Borders (ascending) that fail a check: borders that cross or touch another border or
  /// themselves except at ends, that have another part beside them than in the drawing, or that
  /// bound a piece separated from the rest of its part. If the list is empty, each part exists in
  /// one piece beside the same borders as in the drawing.
  std::vector<std::size_t> wrong;
};

/// Assigns the faces of the cut mesh to the parts. The chains of `cut` must be `borders`, in their
/// order. Faces are joined across edges without a chain; each connected component belongs to the
/// part that borders most of its boundary. O(faces log faces).
CutRegions regions_of_cut(const CutMesh& cut, const RegionParts& drawn,
                          std::span<const LabelBorder> borders);

/// Per face of the mesh before cutting, the label with the largest share of its area; of equal
/// shares the smallest label.
std::vector<std::int64_t> majority_labels(const CutMesh& cut, const RegionParts& drawn,
                                          const CutRegions& regions, std::size_t face_count);

}  // namespace talweg
