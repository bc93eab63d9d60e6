// Plane filling triangulates a plane polygon with holes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/space/point.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A closed polygon in space, given by the numbers of its points.
using Loop = std::vector<std::uint32_t>;

/// A loop counts as plane if its points lie within this fraction of its extent from a plane.
inline constexpr double kPlaneTolerance = 1e-5;

/// The largest distance of a loop's points from the plane perpendicular to its vector area (M. E.
/// Newell), as a fraction of the loop's extent; infinite if the vector area is zero.
double distance_from_plane(const std::vector<Point>& points, const Loop& loop);

/// Groups the plane loops: each outer loop with its holes. A hole is a loop in the same plane with
/// the opposite orientation inside the outer loop, with no other loop between and no common point.
/// Every plane loop is in one group; the outer loop is first in its group, and groups are in the
/// order of outer loops. O(points + loops log loops), plus the points of each two loops whose boxes
/// overlap.
std::vector<std::vector<std::size_t>> plane_groups(const std::vector<Point>& points,
                                                   std::span<const Loop> loops);

/// The triangles between a plane loop and its holes, without further points: constrained Delaunay,
/// exact on a lattice of 2^-37 of the loop's extent. The triangles have the orientation of the
/// first loop. Empty if the loops touch or cross each other or themselves. O(n log n) expected
/// (FaceTriangulation).
std::optional<std::vector<Triangle>> fill_plane(const std::vector<Point>& points,
                                                std::span<const Loop> loops);

}  // namespace talweg
