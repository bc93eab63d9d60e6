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
  std::vector<SurfacePoint> fixed;  ///< the junction that a closed curve hangs on
};

/// The borders between labels, one per face or one per vertex. Of faces they run along the edges
/// between faces of different labels; of vertices through the midpoints of edges between different
/// labels, and where three labels meet in a face through its centroid. A border ends where three or
/// more meet, where the same two labels meet again at a point, and at the mesh's boundary, so
/// borders have at most their ends in common. Always in the same order, first those with ends, then
/// loops. O(faces).
///
/// Throws Error(kBadCurve) when there are as many labels as neither faces nor vertices, or when no
/// two neighbours differ.
std::vector<LabelBorder> label_borders(const Surface& surface,
                                       std::span<const std::int64_t> labels);

/// How many points there are where borders end, away from the mesh's boundary.
std::size_t count_junctions(const Surface& surface, std::span<const LabelBorder> borders);

}  // namespace talweg
