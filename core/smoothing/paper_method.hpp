// The paper's method straightens curves in a potential on the mesh's vertices, and relaxes them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "talweg/core/lifting/paper_lift.hpp"
#include "talweg/core/smoothing/domain_result.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/smoothing_options.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// A given potential: row by row `components` values per mesh vertex, mesh units.
struct GivenPotential {
  std::span<const double> values;
  std::size_t components = 1;
};

/// Straightens the curves in a given potential, and relaxes them. Throws Cancelled.
DomainResult smooth_in(EmbeddedDrawing& drawing, const GivenPotential& potential,
                       const SmoothingOptions& options, const Progress& progress);

/// The method of Pawellek, Rössl & Lawonn, sections 3.3 and 4, with the distance of the heat method
/// or a given distance. Refers to the constructor's arguments. Cost: PaperLift once per drawing,
/// then a run of Straightening and relax() for each tau.
class PaperMethod {
 public:
  PaperMethod(const OpenedMesh& mesh, EmbeddedDrawing& drawing)
      : drawing_(&drawing), lift_(mesh, drawing.straightening()) {}

  /// Computes the distance if it is not known. Throws Cancelled.
  void need_distance(const Progress& progress);
  /// Sets a distance that was checked with PaperLift::check().
  void set_distance(std::vector<double> distance);
  [[nodiscard]] const PaperLift& lift() const { return lift_; }

  /// Smooths the curves; needs no distance at tau = 0. Throws Cancelled.
  DomainResult smooth(const SmoothingOptions& options, const Progress& progress);

 private:
  EmbeddedDrawing* drawing_;
  PaperLift lift_;
};

}  // namespace talweg
