// Hand runs measure what strokes become that hands draw and devices sample.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tools/quality/runs.hpp"

namespace talweg::quality {

/// One stroke of one hand, as one device gives it, at τ = 1. Lengths in h₀, the mean edge near the
/// stroke.
struct HandRun {
  std::string mesh, sampling;
  std::size_t hand = 0, samples = 0;
  double slack = 0;
  double bending = 0;       ///< of the result
  double largest_turn = 0;  ///< of the result at one point, radians
  double off_way =
      0;  ///< farthest point of the result from the way that was meant, the ends left aside
  double apart = 0;     ///< farthest from the result of ten samples per edge, the ends left aside
  double ratio = 1;     ///< its bending over that result's, or under: at least 1
  double ms = 0;        ///< a new drawing and its result
  bool warned = false;  ///< of more than what was left out
};

/// So many hands (scenes/hands.hpp), each sampled in ten ways.
std::vector<HandRun> hand_runs(const Subject& subject, std::size_t hands, std::uint64_t seed);

/// As Markdown: a row for each way of sampling.
std::string tables(std::span<const HandRun> runs);
std::string csv(std::span<const HandRun> runs);

}  // namespace talweg::quality
