// Capping takes the corners off an edge path, as the paper does.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Caps corners as in section 4 of the paper: where two consecutive segments a-b, b-c run along
/// one triangle abc, they are replaced by its third edge a-c, that is, vertex b is dropped. Goes
/// from front to back, steps back after each cap, and ends when no corner is left; what is capped
/// first decides what is left to cap, so the result of the reversed path can differ.
///
/// The ends of an open path and the `pinned` vertices stay, and a closed path (which does not
/// repeat its first vertex) keeps at least three vertices. Returns the number of dropped vertices.
/// O(path length · degree). Throws Error(kBadCurve) when a vertex of the path does not exist.
std::size_t cap_corners(const Surface& surface, std::vector<VertexId>& path, bool closed,
                        std::span<const VertexId> pinned = {});

}  // namespace talweg
