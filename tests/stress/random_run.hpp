// A random run goes from mesh to result, and checks everything that must hold whatever comes in.
#pragma once

#include <cstdint>
#include <string>

namespace talweg::stress {

struct RunOutcome {
  enum class End { kSmoothed, kMeshRefused, kCurveRefused };
  End end = End::kSmoothed;
  std::string what;     ///< mesh, defects, curves and options in short
  std::string refusal;  ///< the sentence, where something was refused
  std::string broken;   ///< what did not hold; empty where everything did
  /// What there was to do: faces of the mesh and faces, flips and points that smoothing met, summed
  /// over the smoothings. A search within a bound counts as kSearch of them.
  double work = 0;
  static constexpr double kSearch = 20;
  /// What the run may take: for each smoothing 10 s of processor time for every 100,000 faces and
  /// 1,000 points.
  double most_seconds = 0;
  /// Of the runs that cut along the result and close the pieces: those that were, rims that got
  /// lids, and pieces that were refused.
  std::size_t pieces = 0, lids = 0, lids_refused = 0;
  bool had_budget = false;
  std::size_t borders = 0;  ///< of labels; none in runs without them
  std::uint64_t bytes = 0;  ///< a hash of the results: curves and reports but for their times
};

/// A random mesh, defects, repair, a drawing and options, all from the seed; smooths twice (tau
/// moved), in every fourth run cuts along the result and caps the pieces, in every fifth smooths
/// with a budget, in every fourth smooths the borders of labels, too, and checks. Never throws but
/// for what it is there to find: an exception that is no Error. `threads` must not matter.
RunOutcome random_run(std::uint64_t seed, unsigned threads = 1);

}  // namespace talweg::stress
