// The mesh domain is the mesh itself.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "talweg/core/smoothing/corridor_method.hpp"
#include "talweg/core/smoothing/embedded_drawing.hpp"
#include "talweg/core/smoothing/paper_method.hpp"
#include "talweg/core/smoothing/smoothing_domain.hpp"

namespace talweg {

/// Smooths a drawing on the mesh itself. Cost: its method, and measuring of the deviation.
class MeshDomain final : public SmoothingDomain {
 public:
  /// Embeds the drawing; solve() or set_distance() must be called next.
  MeshDomain(SmoothingMemory& memory, const OrderedDrawing& drawing, const CurveOptions& options,
             EmbeddedDrawing::Ground ground, const Progress& progress);

  /// EmbeddedDrawing::let_legs_cross(); false for the paper's method.
  bool let_cross(std::size_t crossings, const Progress& progress);
  /// Computes the corridor's distance and valleys, or the paper's distance if distance_at_once is
  /// set.
  void solve(const Progress& progress);
  /// Sets a distance for the paper's method, checked by PaperLift::check().
  void set_distance(std::vector<double> distance);

  DomainResult smooth(const SmoothingOptions& options, const GivenPotential* given,
                      const Progress& progress) override;
  /// The two parts of smooth(): the curves, and their deviation.
  DomainResult curves(const SmoothingOptions& options, const GivenPotential* given,
                      const Progress& progress);
  void measure(const SmoothingOptions& options, DomainResult& smoothed, const Progress& progress);

  void set_pins(std::span<const SurfacePoint> pins, const Progress& progress) override;
  [[nodiscard]] std::vector<double> slack() const override;
  [[nodiscard]] std::span<const double> distance() const override;
  void need_distance(const Progress& progress) override;
  [[nodiscard]] const std::vector<Corridor::Valley>* valleys() const override {
    return corridor_ ? &corridor_->valleys() : nullptr;
  }

 private:
  void count_crossings(DomainResult& result, const Progress& progress);
  void warn_of_upper_bounds(DomainResult& result) const;

  SmoothingMemory* memory_;
  EmbeddedDrawing drawing_;
  std::optional<CorridorMethod> corridor_;  // one of corridor_ and paper_
  std::optional<PaperMethod> paper_;
  std::vector<std::size_t> crossings_;  // per drawn curve, if legs may cross
  double solve_ms_ = 0;
};

}  // namespace talweg
