// What a CurveSmoother hands drawings to that are finer than its mesh.
#pragma once

#include <memory>

#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/core/smoothing/refined_mesh.hpp"

namespace talweg {

struct CurveSmoother::Refined {
  RefinedMesh mesh;
  std::unique_ptr<CurveSmoother> smoother;  ///< on the mesh that was opened from that
};

}  // namespace talweg
