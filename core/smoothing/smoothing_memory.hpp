// The smoothing memory holds the arrays of the mesh's size, which are allocated once for all runs.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "talweg/core/fairing/strip_curvature.hpp"
#include "talweg/core/lifting/straight_legs.hpp"
#include "talweg/core/lifting/straightening.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg {

/// One thread at a time.
class SmoothingMemory {
 public:
  /// O(mesh).
  explicit SmoothingMemory(std::shared_ptr<const OpenedMesh> mesh)
      : mesh_(std::move(mesh)), straightening_(mesh_->surface()), curvature_(mesh_->surface()) {}

  [[nodiscard]] const OpenedMesh& opened() const { return *mesh_; }
  [[nodiscard]] const std::shared_ptr<const OpenedMesh>& shared() const { return mesh_; }
  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_->mesh(); }
  [[nodiscard]] const Surface& surface() const { return mesh_->surface(); }
  [[nodiscard]] Straightening& straightening() { return straightening_; }
  [[nodiscard]] const Straightening& straightening() const { return straightening_; }
  StraightLegs& straight_legs() { return straight_legs_; }
  StripCurvature& curvature() { return curvature_; }
  /// distance(), meter() and ground() are made on first use. O(mesh).
  PolylineDistance& distance() {
    if (!distance_) distance_.emplace(surface());
    return *distance_;
  }
  DeviationMeter& meter() {
    if (!meter_) meter_.emplace(mesh());
    return *meter_;
  }
  /// The memory for smoothing on the mesh's smooth ground. Throws Cancelled.
  SmoothingMemory& ground(const Progress& progress) {
    if (!ground_) ground_ = std::make_unique<SmoothingMemory>(mesh_->ground(progress));
    return *ground_;
  }

 private:
  std::shared_ptr<const OpenedMesh> mesh_;
  Straightening straightening_;
  StraightLegs straight_legs_;
  StripCurvature curvature_;
  std::optional<PolylineDistance> distance_;
  std::optional<DeviationMeter> meter_;
  std::unique_ptr<SmoothingMemory> ground_;
};

}  // namespace talweg
