#include "talweg/core/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "talweg/core/measures.hpp"

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
      turns_(options.turns) {}

double Corridor::phase(const PolylineDistance::Nearest& nearest) const {
  if (!closed_[nearest.curve]) return 0;
  return 2 * std::numbers::pi * turns_ * nearest.arc_length /
         distance_->curve_length(nearest.curve);
}

std::array<double, 2> Corridor::lifted(const PolylineDistance::Nearest& nearest) const {
  if (!std::isfinite(nearest.distance) || nearest.distance <= slack_) return {0, 0};
  const double beyond = nearest.distance - slack_;
  const double phi = std::min(steepness_ * beyond * beyond, kCut);
  const double theta = phase(nearest);
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
  const double beyond = d.value - slack_;
  if (!(beyond > 0) || !std::isfinite(d.value)) return result;
  const double phi = steepness_ * beyond * beyond;
  const double first = 2 * steepness_ * beyond * d.first;
  const double second = 2 * steepness_ * (d.first * d.first + beyond * d.second);
  const PolylineDistance::Nearest here = distance_->on_edge(e, t);
  const double theta = phase(here);
  double dtheta = 0;
  if (closed_[here.curve] && turns_ > 0) {
    constexpr double kStep = 1e-4;
    const double a = std::max(0.0, t - kStep), b = std::min(1.0, t + kStep);
    const double turn = phase(distance_->on_edge(e, b)) - phase(distance_->on_edge(e, a));
    // Over a seam of nearest points the phase jumps; there it has no derivative.
    if (std::abs(turn) < 0.1) dtheta = turn / (b - a);
  }
  const double c = std::cos(theta), s = std::sin(theta);
  result.value = {phi * c, phi * s};
  result.first = {first * c - phi * s * dtheta, first * s + phi * c * dtheta};
  const double radial = second - phi * dtheta * dtheta, around = 2 * first * dtheta;
  result.second = {radial * c - around * s, radial * s + around * c};
  return result;
}

}  // namespace talweg
