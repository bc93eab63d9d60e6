// Chain parts are ranges of a chain that are faired again while the rest of the chain stays.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A range of samples of a chain, both ends included, first < last.
struct ChainRange {
  std::size_t first = 0, last = 0;
};

/// The samples of a chain before and after a part that is faired again. These two samples and their
/// joins to the part stay, so that the part continues the chain without a kink.
struct ChainFrame {
  const SampleChain* chain;
  ChainRange range;  ///< the part with these samples; a chain's end has no sample beyond it

  [[nodiscard]] bool has_first() const { return chain->closed || range.first > 0; }
  [[nodiscard]] bool has_last() const { return chain->closed || range.last + 1 < chain->size(); }
  /// The samples of the part itself, between the samples that stay.
  [[nodiscard]] ChainRange inside() const {
    return {range.first + (has_first() ? 1 : 0), range.last - (has_last() ? 1 : 0)};
  }
};

/// Ranges (ascending, disjoint) that cover `beside` samples on either side of each of `samples`
/// (ascending), fewer at the ends of a chain of `size` samples. No range crosses the start of a
/// loop. O(samples).
std::vector<ChainRange> ranges_about(std::span<const std::size_t> samples, std::size_t beside,
                                     std::size_t size);

/// Whether the ranges cover less than a quarter of `size` samples.
bool is_small_part(std::span<const ChainRange> ranges, std::size_t size);

/// The samples of a range as an open chain with fixed ends. O(chain).
SampleChain part_of(const Surface& surface, const SampleChain& chain, ChainRange range);

/// A part with the samples of the frame before and after it, and their joins to the part. `part`
/// must begin and end at the first and last samples of frame.inside(). None if these samples lie in
/// other faces than in the chain. The caller must set the turns. O(part).
std::optional<SampleChain> framed(const Surface& surface, SampleChain part,
                                  const ChainFrame& frame);

/// The chain with the ranges (ascending, disjoint) replaced by framed parts. O(chain + parts).
SampleChain with_parts(const SampleChain& chain, std::span<const ChainRange> ranges,
                       std::span<const SampleChain> parts);

}  // namespace talweg
