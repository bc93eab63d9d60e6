// The ground domain is a rough mesh as it is seen at the scale of its roughness.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "talweg/core/drawing/drawn_legs.hpp"
#include "talweg/core/smoothing/sheet.hpp"

namespace talweg {

/// On a rough mesh a fair curve would see every bump. So it is made fair on the mesh's ground
/// (smooth_ground()), which has the same faces: the same points of these are the result. What is
/// taut, and what has a potential of the caller's, is smoothed on the mesh as it is. Deviations are
/// those on the mesh. Only for the corridor.
class GroundDomain final : public SmoothingDomain {
 public:
  GroundDomain(SmoothingMemory& memory, const OrderedDrawing& drawing, CurveOptions options,
               const Progress& progress);

  DomainResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                      const Progress& progress) override;
  void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) override;
  [[nodiscard]] std::vector<double> slack() const override;

 private:
  [[nodiscard]] bool is_fair(const SmoothingOptions& options) const;
  [[nodiscard]] std::vector<DrawnLegs> legs() const;
  SmoothingDomain& as_it_is(const Progress& progress);

  SmoothingMemory* memory_;
  const OrderedDrawing* drawing_;
  CurveOptions options_;
  OrderedDrawing there_;                       // the drawing on the ground
  std::unique_ptr<SmoothingDomain> ground_;    // on the ground
  std::unique_ptr<SmoothingDomain> as_it_is_;  // made when first needed
  double solve_ms_ = 0;
};

}  // namespace talweg
