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
  std::array<std::int64_t, 2> labels{};  ///< left and right of the curve; the smaller one is left
  SurfaceCurve curve;
  std::vector<SurfacePoint> fixed;  ///< the junction at which a closed curve begins and ends
};

/// The borders between labels, which are given one per face or one per vertex. With labels of
/// faces, borders run along the edges between faces of different labels. With labels of vertices,
/// they run through the midpoints of edges between different labels, and through the centroid of a
/// face where three labels meet in it. A border ends where three or more borders meet, where the
/// same two labels meet again at a point, and at the mesh's boundary, so borders have at most their
/// ends in common. The order is always the same: first borders with ends, then loops. O(faces).
///
/// Throws Error(kBadCurve) when the number of labels is neither that of the faces nor that of the
/// vertices, or when no two neighbours differ.
std::vector<LabelBorder> label_borders(const Surface& surface,
                                       std::span<const std::int64_t> labels);

/// The number of points away from the mesh's boundary where borders end.
std::size_t count_junctions(const Surface& surface, std::span<const LabelBorder> borders);

}  // namespace talweg
