// The unrolled domain has strips of surface for crossing curves; on the strips the curves do not
// cross.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/lifting/paper_lift.hpp"
#include "talweg/core/smoothing/mesh_domain.hpp"
#include "talweg/core/smoothing/smoothing_domain.hpp"
#include "talweg/core/smoothing/unrolled_mesh.hpp"

namespace talweg {

/// Curves are smoothed separately. The corridor's distance is to the curve's own part on its strip;
/// the paper's distance is the distance on the mesh. In the corridor, an open curve that ends at
/// its first point (a ring) is smoothed as a closed curve that is pinned there, so that it closes
/// without a kink. Cost: MeshDomain on strips of doubled reach, until the result does not leave the
/// strips. Lost pins are compared with all points of the results.
class UnrolledDomain final : public SmoothingDomain {
 public:
  /// Clears the memory's straightening, in which the drawing must be embedded. `alone`: per curve,
  /// whether it needs a separate strip. `distance`: for the paper's method, if given.
  UnrolledDomain(SmoothingMemory& memory, const OrderedDrawing& drawing, CurveOptions options,
                 const std::vector<bool>& alone, std::optional<std::vector<double>> distance,
                 const Progress& progress);

  DomainResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                      const Progress& progress) override;
  void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) override;
  [[nodiscard]] std::vector<double> slack() const override;
  [[nodiscard]] std::span<const double> distance() const override { return lift_.distance(); }

 private:
  /// Strips of one reach, and the curves on them.
  struct Strips {
    std::vector<SurfaceCurve> drawn;  ///< the curves that are unrolled; rings are closed
    std::vector<bool> is_ring;        ///< per curve, whether it is a ring
    UnrolledMesh mesh;
    std::unique_ptr<SmoothingMemory> memory;
    OrderedDrawing drawing;
    std::unique_ptr<MeshDomain> domain;
  };
  void close_rings();
  [[nodiscard]] std::unique_ptr<Strips> laid_strips(const std::vector<SurfaceCurve>& drawn,
                                                    const std::vector<bool>& is_ring,
                                                    const Progress& progress) const;
  bool open_lost_rings(Strips& strips) const;
  void set_reach();
  void add_strips(const Progress& progress);
  [[nodiscard]] CurveOptions options_on(const Strips& strips,
                                        std::span<const SurfaceCurve> curves) const;
  [[nodiscard]] SmoothingOptions options_on(const Strips& strips, SmoothingOptions options) const;
  static DomainResult curves_on(const Strips& strips, const SmoothingOptions& options,
                                const GivenPotential* given, const Progress& progress);
  static bool bound_deviation(const Strips& strips, DomainResult& result);
  [[nodiscard]] static std::vector<double> copies_of(const Strips& strips,
                                                     const GivenPotential& given);
  [[nodiscard]] static DomainResult opened(const Strips& strips, DomainResult smoothed);
  [[nodiscard]] static PointCopies copies_on(const Strips& strips,
                                             std::span<const SurfaceCurve> curves);
  [[nodiscard]] SmoothingOptions with_length_of_mesh(const SmoothingOptions& options) const;
  [[nodiscard]] std::vector<std::string> lost_pins(const DomainResult& smoothed) const;
  DomainResult folded(const Strips& strips, DomainResult smoothed, const Progress& progress);

  SmoothingMemory* memory_;
  const OrderedDrawing* drawing_;
  CurveOptions options_;
  std::vector<bool> alone_;  // per curve, whether it needs a separate strip
  PaperLift lift_;
  std::vector<SurfaceCurve> curves_;    // the drawing with rings closed
  std::vector<bool> is_ring_;           // per curve, whether it is a ring
  std::vector<std::size_t> crossings_;  // of the drawing, per curve in drawn order
  double reach_ = 0;                    // of the next strips, mesh units
  std::size_t most_faces_ = 0;          // larger strips are made only up to this number
  std::vector<std::unique_ptr<Strips>> strips_;
  double solve_ms_ = 0;
};

}  // namespace talweg
