// Plane filling divides a polygon in a plane, with holes, into triangles.
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

/// A loop counts as plane if its points lie within this part of its extent of a plane.
inline constexpr double kPlaneTolerance = 1e-5;

/// The largest distance of a loop's points from the plane normal to its vector area (M. E. Newell),
/// relative to the loop's extent; infinite where that is zero.
double distance_from_plane(const std::vector<Point>& points, const Loop& loop);

/// Groups the plane loops: each outer loop with its holes. Holes are the loops in the same plane
/// that turn the other way and lie inside the outer one, with no other loop in between and no point
/// in common. Every plane loop is in one group; groups are in the order of their first loops, which
/// are the outer ones. O(points + loops log loops), and their points again for each two whose boxes
/// overlap.
std::vector<std::vector<std::size_t>> plane_groups(const std::vector<Point>& points,
                                                   std::span<const Loop> loops);

/// Triangles between a plane loop and the holes in it, without further points: constrained
/// Delaunay, decided exactly on a lattice of 2^-37 of the loop's extent. They have the orientation
/// of the first loop. Nothing where the loops touch or cross each other or themselves. O(n log n)
/// as a rule: see FaceTriangulation.
std::optional<std::vector<Triangle>> fill_plane(const std::vector<Point>& points,
                                                std::span<const Loop> loops);

}  // namespace talweg
