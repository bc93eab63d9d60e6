// Random labels give networks of borders, which are smoothed and checked.
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
  std::string broken;                    ///< the first check that failed, or empty
  std::size_t borders = 0, points = 0;   ///< of the drawing; 0 if no two labels meet
  std::vector<std::int64_t> cut_labels;  ///< labels of the cut mesh
};

/// Makes labels per face or per vertex (random regions, stripes, islands, noise) and smooths their
/// borders with random options, sometimes with a budget. Checks that every region keeps its number
/// of parts and its borders, borders do not cross and lie within the bound, and the cut mesh opens.
LabelRun random_label_run(const std::shared_ptr<const OpenedMesh>& mesh, Random& random);

}  // namespace talweg::stress
