// The refined domain smooths on the part of a mesh around a drawing, with faces as fine as the
// drawing.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "talweg/core/smoothing/refined_mesh.hpp"
#include "talweg/core/smoothing/smoothing_domain.hpp"

namespace talweg {

/// The faces that are too large for one of the curves: too_large_faces() with the curve's slack.
std::vector<FaceId> faces_to_divide(const SurfaceMesh& mesh, const OrderedDrawing& drawing,
                                    const CurveOptions& options);

/// For tau < 1/8 a result may be anywhere. The result is then computed on larger and larger parts
/// of the mesh, always starting with the first part, until it does not touch the boundary where its
/// part was cut off. The cost is that of the touched part, and the result equals that on the whole
/// mesh.
class RefinedDomain final : public SmoothingDomain {
 public:
  /// Divides the faces, and embeds the drawing in the refined part.
  RefinedDomain(const SurfaceMesh& mesh, const OrderedDrawing& drawing, CurveOptions options,
                const Progress& progress);

  DomainResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                      const Progress& progress) override;
  void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) override;
  [[nodiscard]] std::vector<double> slack() const override;

 private:
  /// A divided part of the mesh, and the drawing on it.
  struct Part {
    RefinedMesh mesh;
    std::unique_ptr<SmoothingMemory> memory;
    OrderedDrawing drawing;
    std::unique_ptr<SmoothingDomain> domain;
  };
  [[nodiscard]] double reach() const;
  std::unique_ptr<Part> part_within(double reach, const Progress& progress);
  [[nodiscard]] PointCopies copies_on(const RefinedMesh& mesh,
                                      std::span<const SurfaceCurve> curves) const;
  [[nodiscard]] std::vector<double> slack_on(const Part& part, std::size_t curve,
                                             const std::vector<double>& drawn) const;
  DomainResult smooth_on(const Part& part, const SmoothingOptions& options,
                         const GivenPotential* given, const Progress& progress);
  [[nodiscard]] DomainResult coarse(const Part& part, DomainResult smoothed) const;

  const SurfaceMesh* mesh_;
  const OrderedDrawing* drawing_;
  CurveOptions options_;
  std::vector<std::unique_ptr<Part>> parts_;  // each with twice the reach of the previous
  double solve_ms_ = 0;
};

}  // namespace talweg
