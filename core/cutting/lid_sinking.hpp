// Lid sinking moves the inner points of a lid to avoid faces of the piece.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>

#include "talweg/core/cutting/lid_clearance.hpp"

namespace talweg {

/// The lid with a point at the middle of each of the given chords; a lid of one triangle gets a
/// point at its centroid. If no chords are given, all chords except edges of rims get a point;
/// every triangle then has an inner point, and every new edge ends at one. O(triangles log
/// triangles).
Lid with_inner_points(const LidClearance& clearance, const Lid& lid, std::span<const Loop> rims,
                      std::span<const Chord> chords = {});

/// Moves the inner points of a lid along `direction`, or if empty to the inner side of the faces
/// that each triangle meets, only as far as needed. At inner points the lid clears the faces by a
/// thousandth of `extent`, and by proportionally less towards the rim. The rounds end after a move
/// of `extent`, after 64 rounds, or after 4 million visited faces; the lid may then still have
/// contacts. Returns the largest move, mesh units. A round costs one
/// LidClearance::contacts_with_piece() and O(contacts).
double sink(Lid& lid, const LidClearance& clearance, const std::set<std::uint32_t>& parts,
            const std::optional<Point>& direction, double extent);

}  // namespace talweg
