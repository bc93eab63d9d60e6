// Measures results of strokes by hands, sampled by devices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// A stroke of a hand, sampled by a device, at τ = 1. Lengths in h₀, the mean edge near the stroke.
struct HandRun {
  std::string mesh, sampling;
  std::size_t hand = 0, samples = 0;
  double slack = 0;
  double bending = 0;       ///< of the result
  double largest_turn = 0;  ///< of the result at one point, radians
  double off_way = 0;   ///< largest distance of the result from the intended path, without the ends
  double apart = 0;     ///< largest distance from the result of ten samples per edge, without the
                        ///< ends
  double ratio = 1;     ///< ratio of its bending and the bending of that result, at least 1
  double ms = 0;        ///< time of a new drawing and its result
  bool warned = false;  ///< whether there was a warning other than about points left out
};

/// This many hands (scenes/hands.hpp), each sampled in ten ways.
std::vector<HandRun> hand_runs(const Subject& subject, std::size_t hands, std::uint64_t seed);

/// A table in Markdown with a row for each way of sampling.
std::string tables(std::span<const HandRun> runs);
std::string csv(std::span<const HandRun> runs);

}  // namespace talweg::quality
