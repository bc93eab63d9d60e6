// A sunk lid goes around what is in its way, by points inside it.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>

#include "talweg/core/cutting/lid_clearance.hpp"

namespace talweg {

/// The lid with a point in the middle of each of these chords; of a triangle alone in its middle.
/// Without chords: of all that are no edges of the rims, so that every triangle has a point inside
/// and every new edge has one as an end.
Lid with_inner_points(const LidClearance& clearance, const Lid& lid, std::span<const Loop> rims,
                      std::span<const Chord> chords = {});

/// Moves the points inside a lid along a direction, or without one to the inner side of the faces
/// that each triangle meets, only as far as they must: faces are left behind by a thousandth of
/// `extent` at these points, and by as much less as it is nearer to the rim. At most by `extent`,
/// in 64 rounds; it may still meet something then. Returns how far the farthest point has moved.
double sink(Lid& lid, const LidClearance& clearance, const std::set<std::uint32_t>& parts,
            const std::optional<Point>& direction, double extent);

}  // namespace talweg
