#include "talweg/core/lifting/paper_lift.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/drawn_curves.hpp"
#include "talweg/core/lifting/bump_convolution.hpp"
#include "talweg/core/lifting/lifted_lengths.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/stopwatch.hpp"

namespace talweg {

void PaperLift::clear() {
  distance_.clear();
  at_inserted_.clear();
  mollification_ = open_ms_ = solve_ms_ = 0;
  warnings_.clear();
}

void PaperLift::check(const Surface& surface, std::span<const double> distance) {
  if (distance.size() != surface.vertex_count()) {
    throw Error(ErrorCode::kBadUsage, fmt::format("There are {} distances for {} vertices.",
                                                  distance.size(), surface.vertex_count()));
  }
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (std::isnan(distance[v]) || distance[v] == -HUGE_VAL) {
      throw Error(ErrorCode::kBadUsage,
                  fmt::format("The distance of vertex {} is not a number.", v));
    }
  }
}

void PaperLift::set(std::vector<double> distance, bool several) {
  distance_ = std::move(distance);
  at_inserted_ = curves_->at_inserted(distance_, 1);
  find_largest(several);
}

void PaperLift::solve(std::span<const SurfaceCurve> curves, const HeatSettings& settings,
                      const Progress& progress) {
  const Surface& surface = mesh_->surface();
  Stopwatch watch;
  const auto heat = mesh_->heat(settings.time, progress, settings.threads);
  if (heat == nullptr) throw Cancelled();
  open_ms_ = watch.lap();
  std::vector<double> solved =
      heat->solve(sources_of(surface, curves), DistanceOptions{}, progress);
  if (settings.bump_radius) {
    BumpOptions bump;
    bump.radius = *settings.bump_radius;
    distance_ = convolve_with_bump(surface, solved, bump, progress);
    at_inserted_ = curves_->at_inserted(distance_, 1);
  } else {
    distance_ = std::move(solved);
    // Inserted vertices lie on the drawing, so their distance is 0 even if interpolation in their
    // face gives another value.
    at_inserted_.assign(curves_->triangulation().inserted_count(), 0.0);
  }
  find_largest(curves.size() > 1);
  const auto& mollified = heat->report().mollification;
  mollification_ = mollified.empty() ? 0 : *std::max_element(mollified.begin(), mollified.end());
  if (mollification_ > 0) {
    warnings_.push_back(fmt::format(
        "The mesh has needle triangles: to compute the distance, and for nothing else, "
        "edges were lengthened by up to {}, {:.3g} mean edge lengths.",
        mesh_units_text(mollification_), mollification_ / mesh_->mesh().mean_edge_length()));
  }
  solve_ms_ = watch.ms();
}

/// Finds the largest distance in each component, so that L depends on the curve's own component
/// only. With a single curve the other components have no finite distance, and all count as one.
void PaperLift::find_largest(bool several) {
  if (several && !components_) components_ = components_of(mesh_->surface());
  largest_.assign(several ? components_->count : 1, 0.0);
  for (std::size_t v = 0; v < distance_.size(); ++v) {
    double& largest = largest_[several ? components_->of_vertex[v] : 0];
    if (std::isfinite(distance_[v])) largest = std::max(largest, distance_[v]);
  }
}

std::size_t PaperLift::component_of(VertexId v) const {
  if (largest_.size() == 1) return 0;
  const Surface& surface = mesh_->surface();
  if (v.index() >= surface.vertex_count()) {
    v = surface.corners(any_face(surface, curves_->triangulation().location(v)))[0];
  }
  return components_->of_vertex[v.index()];
}

double PaperLift::length_of(const PotentialOptions& options, double drawn_length,
                            std::size_t component) const {
  if (options.length == PotentialOptions::Length::kGiven) return options.given_length;
  if (options.length == PotentialOptions::Length::kCurveLength) return drawn_length;
  const double largest = largest_[component];
  return largest > 0 ? largest : drawn_length;  // 0 if a curve passes every vertex
}

double PaperLift::characteristic_length(const PotentialOptions& options, double drawn_length,
                                        VertexId vertex) const {
  return length_of(options, drawn_length, component_of(vertex));
}

SignpostTriangulation::Metric PaperLift::metric(const PotentialOptions& options, double tau,
                                                double drawn_length) const {
  std::vector<Potential> potentials;  // by component
  for (std::size_t k = 0; k < largest_.size(); ++k) {
    potentials.emplace_back(options, tau, length_of(options, drawn_length, k));
  }
  const std::size_t own = mesh_->surface().vertex_count();
  return [this, potentials, own](VertexId p, VertexId q, double length) {
    const Potential& potential = potentials[component_of(p)];
    const auto at = [&](VertexId v) {
      return potential(v.index() < own ? distance_[v.index()] : at_inserted_[v.index() - own]);
    };
    return lifted_length(length, at(p), at(q));
  };
}

}  // namespace talweg
