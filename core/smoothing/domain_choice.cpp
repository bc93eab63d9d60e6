#include "talweg/core/smoothing/domain_choice.hpp"

#include <utility>

#include "talweg/core/mesh/smooth_ground.hpp"
#include "talweg/core/smoothing/ground_domain.hpp"
#include "talweg/core/smoothing/refined_domain.hpp"
#include "talweg/core/smoothing/undivided_domain.hpp"

namespace talweg {

std::unique_ptr<SmoothingDomain> domain_for(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                            const CurveOptions& options,
                                            std::optional<std::vector<double>> distance,
                                            double roughness, const Progress& progress) {
  if (options.method == Method::kCorridor && roughness > kLeastRoughness) {
    return std::make_unique<GroundDomain>(memory, drawing, options, progress);
  }
  return domain_on(memory, drawing, options, std::move(distance), progress);
}

std::unique_ptr<SmoothingDomain> domain_on(SmoothingMemory& memory, const OrderedDrawing& drawing,
                                           const CurveOptions& options,
                                           std::optional<std::vector<double>> distance,
                                           const Progress& progress) {
  // The paper's method uses the vertices of the mesh only.
  if (options.method == Method::kCorridor &&
      !faces_to_divide(memory.mesh(), drawing, options).empty()) {
    return std::make_unique<RefinedDomain>(memory.mesh(), drawing, options, progress);
  }
  return undivided_domain_for(memory, drawing, options, nullptr, std::move(distance), progress);
}

}  // namespace talweg
