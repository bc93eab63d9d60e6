// Chain parts are stretches of a chain, to be faired again while the rest of it stays.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "talweg/core/fairing/sample_chain.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// The samples of a chain from one to another, both included, first < last.
struct ChainRange {
  std::size_t first = 0, last = 0;
};

/// A chain's samples before and after a part of it that is faired again. They stay, as do the joins
/// to them, so that the part leaves and comes back in their direction.
struct ChainFrame {
  const SampleChain* chain;
  ChainRange range;  ///< the part with these samples; at an end of the chain there is none

  [[nodiscard]] bool has_first() const { return chain->closed || range.first > 0; }
  [[nodiscard]] bool has_last() const { return chain->closed || range.last + 1 < chain->size(); }
  /// The samples between those that stay: the part's own.
  [[nodiscard]] ChainRange inside() const {
    return {range.first + (has_first() ? 1 : 0), range.last - (has_last() ? 1 : 0)};
  }
};

/// Ranges (ascending, apart from each other) with so many samples about each of these, which
/// ascend, or fewer at the ends; of a loop none goes across its start. O(samples).
std::vector<ChainRange> ranges_about(std::span<const std::size_t> samples, std::size_t beside,
                                     std::size_t size);

/// Whether they have less than a quarter of so many samples.
bool is_little(std::span<const ChainRange> ranges, std::size_t size);

/// These samples as an open chain, whose ends are fixed. O(chain).
SampleChain part_of(const Surface& surface, const SampleChain& chain, ChainRange range);

/// A part that begins and ends where the inside of the frame does, with the samples of the frame
/// about it; none where the faces at its ends are others. Its turns are to be set. O(part).
std::optional<SampleChain> framed(const Surface& surface, SampleChain part,
                                  const ChainFrame& frame);

/// The chain with these ranges (ascending, apart from each other) replaced by framed parts.
/// O(chain + parts).
SampleChain with_parts(const SampleChain& chain, std::span<const ChainRange> ranges,
                       std::span<const SampleChain> parts);

}  // namespace talweg
