// The curve of a chain has few points: crossings of edges, and samples where the chain turns in
// faces.
#pragma once

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Keeps the chain's crossings of edges, and further samples beside turns of more than 4.5 degrees
/// inside faces, and beside turns of more than 1 degree if the next point lies farther than about
/// `edge` / 2 (`edge` in mesh units). Corners are exempt. The curve bends by about
/// as much as the chain. O(n log n) for n samples and crossings as a rule: each round halves the
/// parts that turn too much.
SurfaceCurve curve_of(const Surface& surface, ChainMaker& maker, const SampleChain& chain,
                      double edge);

}  // namespace talweg
