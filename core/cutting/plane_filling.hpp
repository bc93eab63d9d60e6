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

/// A closed polygon in space, by the numbers of its points.
using Loop = std::vector<std::uint32_t>;

/// How far from a plane the points of a loop lie that is called plane, of its extent.
inline constexpr double kPlaneTolerance = 1e-5;

/// The largest distance of a loop's points from the plane across its vector area (M. E. Newell),
/// of the loop's extent; infinite where that is zero.
double distance_from_plane(const std::vector<Point>& points, const Loop& loop);

/// The plane loops, an outer one and the holes in it together: those in the same plane that turn
/// the other way and lie inside, with nothing in between and no point in common. Every plane loop
/// is in one group; groups are in the order of their first loops, which are the outer ones.
std::vector<std::vector<std::size_t>> plane_groups(const std::vector<Point>& points,
                                                   std::span<const Loop> loops);

/// Triangles between a plane loop and holes in it, without further points: constrained Delaunay,
/// decided exactly on a lattice of 2^-37 of the loop's extent. They turn as the first loop does.
/// Nothing where the loops touch or cross each other or themselves there. O(n²).
std::optional<std::vector<Triangle>> fill_plane(const std::vector<Point>& points,
                                                std::span<const Loop> loops);

}  // namespace talweg
