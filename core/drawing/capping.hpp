// Capping takes the corners off an edge path (Mancinelli & Puppo, section 4).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Caps corners as in section 4 of the paper: where two consecutive segments a-b, b-c run along one
/// triangle abc, its third edge a-c replaces them, that is, vertex b is dropped. The path is capped
/// from front to back, with one step back after each cap, until no corner is left. Earlier caps
/// decide which corners remain, so the result of the reversed path can differ.
///
/// The ends of an open path and the `pinned` vertices stay, and a closed path (which does not
/// repeat its first vertex) keeps at least three vertices. Returns the number of dropped vertices.
/// O(path length · degree). Throws Error(kBadCurve) when a vertex of the path does not exist.
std::size_t cap_corners(const Surface& surface, std::vector<VertexId>& path, bool closed,
                        std::span<const VertexId> pinned = {});

}  // namespace talweg
