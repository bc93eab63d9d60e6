#include "talweg/core/lifting/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kGain = 10;    // a, as in the paper
constexpr double kCut = 1e100;  // limit of φ; its square is still finite

}  // namespace

void Corridor::check_slack(const std::vector<double>& values, std::size_t curve,
                           std::size_t points) {
  if (values.size() != points) {
    throw Error(ErrorCode::kBadUsage,
                fmt::format("slack_at has {} values for the {} points of curve {}.", values.size(),
                            points, curve));
  }
  for (std::size_t i = 0; i < points; ++i) {
    if (values[i] >= 0 && std::isfinite(values[i])) continue;
    throw Error(
        ErrorCode::kBadUsage,
        fmt::format("The slack of curve {} at its point {} must be finite and >= 0.", curve, i));
  }
}

Corridor::Corridor(PolylineDistance& distance, const std::vector<double>& taus,
                   const std::vector<Valley>& valleys)
    : distance_(&distance) {
  profiles_.reserve(valleys.size());
  for (std::size_t c = 0; c < valleys.size(); ++c) {
    const Valley& valley = valleys[c];
    Profile& profile = profiles_.emplace_back();
    profile.slack = valley.slack;
    profile.steepness = kGain * taus[c] * (kGain * taus[c] / valley.length);
    const double loop = valley.closed ? distance.curve_length(c) : valley.loop_length;
    if (loop > 0) profile.phase_per_arc = 2 * std::numbers::pi * valley.turns / loop;
    profile.phase = profile.phase_per_arc * valley.arc_start;
    if (!valley.slack_at.empty()) set_field(profile, valley, c);
    least_slack_ = std::min(least_slack_, valley.slack);
    for (const double slack : profile.slacks) least_slack_ = std::min(least_slack_, slack);
  }
}

void Corridor::set_field(Profile& profile, const Valley& valley, std::size_t curve) const {
  const auto arcs = distance_->point_arcs(curve);
  check_slack(valley.slack_at, curve, arcs.size());
  profile.arcs.assign(arcs.begin(), arcs.end());
  profile.slacks = valley.slack_at;
  if (!valley.closed) return;
  profile.arcs.push_back(distance_->curve_length(curve));
  profile.slacks.push_back(profile.slacks.front());
}

Corridor::Varying Corridor::slack(const Profile& profile, double arc) {
  const std::vector<double>&arcs = profile.arcs, &values = profile.slacks;
  if (arcs.empty()) return {profile.slack, 0};
  const auto after = std::upper_bound(arcs.begin(), arcs.end(), arc);
  if (after == arcs.begin()) return {values.front(), 0};
  if (after == arcs.end()) return {values.back(), 0};
  const auto i = static_cast<std::size_t>(after - arcs.begin()) - 1;
  const double change = values[i + 1] - values[i], width = arcs[i + 1] - arcs[i];
  return {values[i] + change * ((arc - arcs[i]) / width), change / width};
}

std::array<double, 2> Corridor::lifted(const PolylineDistance::Nearest& nearest) const {
  if (!std::isfinite(nearest.distance)) return {0, 0};
  const Profile& profile = profiles_[nearest.curve];
  const double beyond = nearest.distance - slack(profile, nearest.arc_length).value;
  if (!(beyond > 0)) return {0, 0};
  const double phi = std::min(profile.steepness * beyond * beyond, kCut);
  const double theta = profile.phase + profile.phase_per_arc * nearest.arc_length;
  if (theta == 0) return {phi, 0};
  return {phi * std::cos(theta), phi * std::sin(theta)};
}

std::array<double, 2> Corridor::at_vertex(VertexId v) const {
  return lifted(distance_->at_vertex(v));
}

std::array<double, 2> Corridor::at_vertex_bounded(VertexId v, double exact,
                                                  const std::vector<bool>& exactly) const {
  const PolylineDistance::Nearest nearest = distance_->at_vertex_bounded(v, exact);
  return exactly[nearest.curve] ? at_vertex(v) : lifted(nearest);
}

std::array<double, 2> Corridor::at(const SurfacePoint& point) const {
  return lifted(distance_->at(point));
}

/// For a single open curve with one slack, φ is a function of δ, and δ changes along an edge by at
/// most its length. Otherwise the nearest point may jump between the ends of an edge, and φ may
/// change by any amount.
double Corridor::largest_lengthening(double distance, double length) const {
  const bool by_distance_alone = profiles_.size() == 1 && profiles_.front().arcs.empty() &&
                                 profiles_.front().phase_per_arc == 0;
  double largest = 0;
  for (const Profile& profile : profiles_) {
    const double beyond = std::max(0.0, distance - least_slack_);
    const double slope = by_distance_alone ? 2 * profile.steepness * beyond
                                           : 2 * profile.steepness * beyond * (beyond / length);
    largest = std::max(largest, slope * slope / 2);
  }
  return std::isnan(largest) ? HUGE_VAL : largest;
}

}  // namespace talweg
