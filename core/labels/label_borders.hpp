// Label borders are the curves between the labels of a segmentation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// A border between two labels, from one junction or boundary point to the next, or a whole loop.
struct LabelBorder {
  std::array<std::int64_t, 2> labels{};  ///< left and right of the curve; the smaller label is left
  SurfaceCurve curve;
  std::vector<SurfacePoint> fixed;  ///< the junction where a closed curve begins and ends, if any
};

/// The borders between labels per face or per vertex. Borders of face labels run along the edges
/// between faces of different labels. Borders of vertex labels run through the midpoints of edges
/// between different labels, and through the centroid of a face with three labels. A border ends
/// where three or more borders meet, where the same two labels meet again at a point, and at the
/// boundary of the mesh, so two borders share at most their ends. The order is deterministic: first
/// borders with ends, then loops. O(faces).
///
/// Throws Error(kBadCurve) if the number of labels is neither the number of faces nor of vertices,
/// or if no two neighbours have different labels.
std::vector<LabelBorder> label_borders(const Surface& surface,
                                       std::span<const std::int64_t> labels);

/// The number of points where borders end, without points on the boundary of the mesh.
std::size_t count_junctions(const Surface& surface, std::span<const LabelBorder> borders);

}  // namespace talweg
