// A random run goes from mesh to result and checks all invariants.
#pragma once

#include <cstdint>
#include <string>

namespace talweg::stress {

struct RunOutcome {
  enum class End { kSmoothed, kMeshRefused, kCurveRefused };
  End end = End::kSmoothed;
  std::string what;     ///< mesh, defects, curves and options in short
  std::string refusal;  ///< the error message if the input was refused
  std::string broken;   ///< the first check that failed, or empty
  /// The amount of work: faces of the mesh, and faces, flips and points of each smoothing. A search
  /// within a bound counts kSearch times.
  double work = 0;
  static constexpr double kSearch = 20;
  /// The time limit: for each smoothing 10 s of processor time per 100,000 faces and 1,000 points.
  double most_seconds = 0;
  /// Numbers of pieces, of rims that got lids, and of pieces whose lids were refused, in runs that
  /// cut along the result.
  std::size_t pieces = 0, lids = 0, lids_refused = 0;
  bool had_budget = false;
  std::size_t borders = 0;  ///< number of borders between labels; 0 in runs without labels
  std::uint64_t bytes = 0;  ///< a hash of the results: curves, and reports without times
};

/// Makes a random mesh, defects, a repair, a drawing and options, all from the seed. Smooths twice
/// with different tau. Every fourth run cuts along the result and caps the pieces, every fifth
/// smooths with a budget, every fourth smooths borders of labels. Checks all results. Throws only
/// exceptions other than Error, which are faults. `threads` must not change the outcome.
RunOutcome random_run(std::uint64_t seed, unsigned threads = 1);

}  // namespace talweg::stress
