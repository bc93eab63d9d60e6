// What a CurveSmoother hands its tangled drawings to.
#pragma once

#include <memory>
#include <vector>

#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/unrolled_mesh.hpp"

namespace talweg {

struct CurveSmoother::Unrolled {
  UnrolledMesh mesh;
  std::unique_ptr<CurveSmoother> smoother;  ///< on the mesh that was opened from that
  std::vector<std::size_t> crossings;       ///< of the drawing, per drawn curve
};

}  // namespace talweg
