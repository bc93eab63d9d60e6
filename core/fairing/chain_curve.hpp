// The curve of a chain has few points: where it crosses edges, and where it turns inside faces.
#pragma once

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Keeps the chain's crossings of edges, and as many of its samples as it takes that no turn
/// exceeds 5 degrees (where samples that close allow it) and that turns of more than 1 degree are
/// no farther than `edge` / 2 apart (`edge` in mesh units), corners left aside. The curve bends by
/// about as much as the chain. O(n log n) for n samples and crossings as a rule: rounds halve
/// stretches that turn too much.
SurfaceCurve curve_of(const Surface& surface, ChainMaker& maker, const SampleChain& chain,
                      double edge);

}  // namespace talweg
