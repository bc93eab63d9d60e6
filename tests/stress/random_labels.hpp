// Random labels make networks of borders, which are smoothed and checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "stress/random.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"

namespace talweg::stress {

struct LabelRun {
  std::string what;                      ///< labels and options in short
  std::string broken;                    ///< what did not hold; empty where everything did
  std::size_t borders = 0, points = 0;   ///< of the drawing; none where no two labels meet
  std::vector<std::int64_t> cut_labels;  ///< of the result
};

/// Labels per face or per vertex: random regions, stripes, islands, noise. Smooths their borders
/// with random options, now and then with a budget. Every region stays, in as many parts, with the
/// borders it had; borders cross nowhere and lie within the bound; the cut mesh opens.
LabelRun random_label_run(const std::shared_ptr<const OpenedMesh>& mesh, Random& random);

}  // namespace talweg::stress
