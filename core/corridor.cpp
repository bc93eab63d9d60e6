#include "talweg/core/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/measures.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kGain = 10;       // a, as in the paper
constexpr double kCut = 1e100;     // of φ / L; its square is still a number
constexpr double kStraight = 0.1;  // rad

/// Segments of a curve when points that hardly turn are not counted.
std::size_t count_segments(const Surface& surface, const SurfaceCurve& curve) {
  const std::size_t n = curve.points.size();
  std::size_t corners = 0;
  for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
    const double turn = turning_angle(surface, curve.points[(i + n - 1) % n], curve.points[i],
                                      curve.points[(i + 1) % n]);
    if (turn > kStraight) ++corners;
  }
  return curve.closed ? std::max<std::size_t>(corners, 1) : corners + 1;
}

void check_slack(const std::vector<double>& values, std::size_t curve, std::size_t points) {
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

}  // namespace

double default_slack(const Surface& surface, std::span<const SurfaceCurve> drawn) {
  double length = 0, bound = HUGE_VAL;
  std::size_t segments = 0;
  for (const SurfaceCurve& curve : drawn) {
    const double own = curve_length(surface, curve);
    length += own;
    segments += count_segments(surface, curve);
    if (curve.closed) bound = std::min(bound, own / 24);
  }
  // A drawing without corners is exact; nothing is gained by leaving it.
  return std::min(length / static_cast<double>(std::max<std::size_t>(segments, 1)), bound);
}

double drawing_radius(const SurfaceMesh& mesh, std::span<const SurfaceCurve> drawn) {
  double largest = 0;
  for (const SurfaceCurve& curve : drawn) {
    const std::vector<Point> points = positions_of(mesh, curve);
    const std::size_t n = points.size();
    Point centre = Point::Zero();
    double length = 0;
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
      const Point &p = points[i], &q = points[(i + 1) % n];
      centre += (q - p).norm() * ((p + q) / 2 - points[0]);
      length += (q - p).norm();
    }
    if (length > 0) centre /= length;
    centre += points[0];
    for (const Point& p : points) largest = std::max(largest, (p - centre).norm());
  }
  return largest;
}

Corridor::Corridor(PolylineDistance& distance, std::vector<bool> closed, const Options& options)
    : distance_(&distance),
      closed_(std::move(closed)),
      slack_(options.slack),
      steepness_(kGain * options.tau * (kGain * options.tau / options.length)),
      turns_(options.turns) {
  if (!options.slack_at.empty()) set_field(options.slack_at);
}

void Corridor::set_field(const std::vector<std::vector<double>>& slack_at) {
  if (slack_at.size() != closed_.size()) {
    throw Error(ErrorCode::kBadUsage, fmt::format("slack_at has values for {} curves, not for {}.",
                                                  slack_at.size(), closed_.size()));
  }
  for (std::size_t c = 0; c < slack_at.size(); ++c) {
    const auto arcs = distance_->point_arcs(c);
    check_slack(slack_at[c], c, arcs.size());
    Field& field = field_.emplace_back();
    field.arcs.assign(arcs.begin(), arcs.end());
    field.values = slack_at[c];
    if (!closed_[c]) continue;
    field.arcs.push_back(distance_->curve_length(c));
    field.values.push_back(field.values.front());
  }
}

Corridor::Varying Corridor::slack(std::uint32_t curve, double arc) const {
  if (field_.empty()) return {slack_, 0};
  const auto& [arcs, values] = field_[curve];
  const auto after = std::upper_bound(arcs.begin(), arcs.end(), arc);
  if (after == arcs.begin()) return {values.front(), 0};
  if (after == arcs.end()) return {values.back(), 0};
  const auto i = static_cast<std::size_t>(after - arcs.begin()) - 1;
  const double change = values[i + 1] - values[i], width = arcs[i + 1] - arcs[i];
  return {values[i] + change * ((arc - arcs[i]) / width), change / width};
}

double Corridor::phase_per_arc(std::uint32_t curve) const {
  const double length = distance_->curve_length(curve);
  return closed_[curve] && length > 0 ? 2 * std::numbers::pi * turns_ / length : 0.0;
}

std::array<double, 2> Corridor::lifted(const PolylineDistance::Nearest& nearest) const {
  if (!std::isfinite(nearest.distance)) return {0, 0};
  const double beyond = nearest.distance - slack(nearest.curve, nearest.arc_length).value;
  if (!(beyond > 0)) return {0, 0};
  const double phi = std::min(steepness_ * beyond * beyond, kCut);
  const double theta = phase_per_arc(nearest.curve) * nearest.arc_length;
  if (theta == 0) return {phi, 0};
  return {phi * std::cos(theta), phi * std::sin(theta)};
}

std::array<double, 2> Corridor::at_vertex(VertexId v) const {
  return lifted(distance_->at_vertex(v));
}

std::array<double, 2> Corridor::at(const SurfacePoint& point) const {
  return lifted(distance_->at(point));
}

PotentialOnEdge Corridor::on_edge(EdgeId e, double t) const {
  PotentialOnEdge result;
  const PolylineDistance::EdgeValue d = distance_->at_edge(e, t);
  if (!std::isfinite(d.value)) return result;
  const Varying slack_here = slack(d.curve, d.arc_length);
  const double beyond = d.value - slack_here.value;
  if (!(beyond > 0)) return result;
  const double slope = d.first - slack_here.slope * d.arc_first;
  const double phi = steepness_ * beyond * beyond;
  const double first = 2 * steepness_ * beyond * slope;
  const double second = 2 * steepness_ * (slope * slope + beyond * d.second);
  const double turn = phase_per_arc(d.curve);
  if (turn == 0) return {{phi, 0}, {first, 0}, {second, 0}};
  const double theta = turn * d.arc_length, dtheta = turn * d.arc_first;
  const double c = std::cos(theta), s = std::sin(theta);
  result.value = {phi * c, phi * s};
  result.first = {first * c - phi * s * dtheta, first * s + phi * c * dtheta};
  const double radial = second - phi * dtheta * dtheta, around = 2 * first * dtheta;
  result.second = {radial * c - around * s, radial * s + around * c};
  return result;
}

}  // namespace talweg
