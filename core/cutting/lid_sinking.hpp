// A sunk lid goes around what is in its way, by points inside it.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>

#include "talweg/core/cutting/lid_clearance.hpp"

namespace talweg {

/// The lid with a point in the middle of each of these chords; a lid of one triangle gets a point
/// in its middle. Without chords: of all chords that are not edges of the rims, so that every
/// triangle has a point inside and every new edge ends at one. O(triangles log triangles).
Lid with_inner_points(const LidClearance& clearance, const Lid& lid, std::span<const Loop> rims,
                      std::span<const Chord> chords = {});

/// Moves the points inside a lid along a direction, or if there is none to the inner side of the
/// faces that each triangle meets, only as far as needed. At these points the lid clears the faces
/// by a thousandth of `extent`, and by proportionally less nearer to the rim. Moves by at most
/// `extent`, in at most 64 rounds; the lid may still meet something afterwards. Returns how far the
/// farthest point has moved. Cost of a round: LidClearance::contacts_with_piece(), and what it
/// finds; none begins after 4 million faces that were looked at.
double sink(Lid& lid, const LidClearance& clearance, const std::set<std::uint32_t>& parts,
            const std::optional<Point>& direction, double extent);

}  // namespace talweg
