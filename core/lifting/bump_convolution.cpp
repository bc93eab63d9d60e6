#include "talweg/core/lifting/bump_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

[[noreturn]] void refuse_bump(const std::string& message) {
  throw Error(ErrorCode::kBadUsage, message);
}

// The limit of the triangles that a straight ray crosses. A ray can circle a vertex with an angle
// sum near 0 for long without progress, and winds around a surface much smaller than the radius
// without gaining information.
std::size_t most_triangles(const Surface& surface) {
  return std::min(std::size_t{1} << 16U, 1000 + 8 * surface.face_count());
}

/// One radius of the quadrature, and the weight h(r) r dr there.
struct Ring {
  double radius;
  double weight;
};

/// The n-th Legendre polynomial and its derivative, |x| < 1.
struct Legendre {
  double value;
  double slope;
};
Legendre legendre(int n, double x) {
  double previous = 1;
  double value = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
    previous = value;
    value = next;
  }
  return {value, n * (x * value - previous) / (x * x - 1)};
}

/// Gauss-Legendre nodes on [0, R], by Newton's method from Chebyshev's nodes, in ascending order.
std::vector<Ring> rings_of(double radius, int count) {
  std::vector<Ring> rings;
  for (int k = count; k >= 1; --k) {
    double x = std::cos(std::numbers::pi * (k - 0.25) / (count + 0.5));
    for (int step = 0; step < 8; ++step) x -= legendre(count, x).value / legendre(count, x).slope;
    const double slope = legendre(count, x).slope;
    const double r = (1 + x) / 2;
    const double bump = std::exp(-1 / ((1 - r) * (1 + r)));
    rings.push_back({r * radius, bump * r / ((1 - x) * (1 + x) * slope * slope)});
  }
  return rings;
}

/// A triangle at a vertex, with its angle there and the sum of the angles up to its end.
struct Corner {
  HalfedgeId halfedge;
  double angle;
  double until;
};

void corners_about(const Surface& surface, VertexId v, std::vector<Corner>& corners) {
  corners.clear();
  const HalfedgeId first = surface.halfedge(v);
  if (!first.valid()) return;
  double sum = 0;
  HalfedgeId h = first;
  do {
    const double angle =
        angle_between(surface.length(edge_of(h)), surface.length(edge_of(surface.prev(h))),
                      surface.length(edge_of(surface.next(h))));
    sum += angle;
    corners.push_back({h, angle, sum});
    h = surface.turn_ccw(h);
  } while (h != first && surface.has_face(h));
}

/// A straight ray along the positive x-axis of a plane into which the crossed triangles are
/// unfolded one after the other. The ray leaves the current triangle across the edge from `right_`
/// to `left_`. Values are relative to the value at the origin.
class Ray {
 public:
  Ray(const Surface& surface, std::span<const double> values, const Corner& corner, double angle)
      : surface_(surface), values_(values), across_(surface.next(corner.halfedge)) {
    origin_ = values[surface.tail(corner.halfedge).index()];
    const double right = surface.length(edge_of(corner.halfedge));
    const double left = surface.length(edge_of(surface.prev(corner.halfedge)));
    const double rest = corner.angle - angle;
    right_ = {right * std::cos(angle), -right * std::sin(angle)};
    left_ = {left * std::cos(rest), left * std::sin(rest)};
    find_exit();
  }

  /// Adds the rings that the ray reaches; `sum` is the sum of weight · value.
  void add(std::span<const Ring> rings, double& sum, double& weight) {
    const std::size_t most = most_triangles(surface_);
    std::size_t k = 0;
    for (std::size_t step = 0; step < most && std::isfinite(value_out_); ++step) {
      for (; k < rings.size() && rings[k].radius <= out_; ++k) {
        const double t = out_ > in_ ? (rings[k].radius - in_) / (out_ - in_) : 1.0;
        sum += rings[k].weight * (value_in_ + t * (value_out_ - value_in_));
        weight += rings[k].weight;
      }
      if (k == rings.size() || !cross()) return;
    }
  }

 private:
  [[nodiscard]] double value(VertexId v) const { return values_[v.index()] - origin_; }

  void find_exit() {
    const double height = left_.y - right_.y;
    const double s = height > 0 ? std::clamp(-right_.y / height, 0.0, 1.0) : 0.0;
    const double from = value(surface_.tail(across_));
    const double to = value(surface_.head(across_));
    out_ = std::max(in_, right_.x + s * (left_.x - right_.x));
    value_out_ = std::isfinite(from) && std::isfinite(to) ? from + s * (to - from)
                                                          : std::numeric_limits<double>::infinity();
  }

  /// Continues into the next triangle; false at the boundary.
  bool cross() {
    const HalfedgeId entry = twin(across_);  // from left_ to right_
    if (!surface_.has_face(entry)) return false;
    const HalfedgeId next = surface_.next(entry);
    const HalfedgeId prev = surface_.prev(entry);
    const double base = surface_.length(edge_of(entry));
    const PlanePoint top =
        apex(base, surface_.length(edge_of(prev)), surface_.length(edge_of(next)));
    const PlanePoint u = base > 0
                             ? PlanePoint{(right_.x - left_.x) / base, (right_.y - left_.y) / base}
                             : PlanePoint{0, -1};
    const PlanePoint far{left_.x + top.x * u.x - top.y * u.y, left_.y + top.x * u.y + top.y * u.x};
    if (far.y >= 0) {
      left_ = far;
      across_ = next;
    } else {
      right_ = far;
      across_ = prev;
    }
    in_ = out_;
    value_in_ = value_out_;
    find_exit();
    return true;
  }

  const Surface& surface_;
  std::span<const double> values_;
  HalfedgeId across_;
  double origin_ = 0;
  PlanePoint right_;
  PlanePoint left_;
  double in_ = 0;
  double out_ = 0;
  double value_in_ = 0;
  double value_out_ = 0;
};

void check(const Surface& surface, std::span<const double> values) {
  if (values.size() != surface.vertex_count()) {
    refuse_bump("There are " + std::to_string(values.size()) + " values for " +
                std::to_string(surface.vertex_count()) + " vertices.");
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!(values[v] > -std::numeric_limits<double>::infinity())) {
      refuse_bump("The value of vertex " + std::to_string(v) + " is not a number or -infinity.");
    }
  }
}

/// The weighted mean of value - value(v) about a vertex.
double mean_change(const Surface& surface, std::span<const double> values,
                   std::span<const Corner> corners, std::span<const Ring> rings, int rays) {
  const double cone = corners.back().until;
  double sum = 0;
  double weight = 0;
  std::size_t c = 0;
  for (int k = 0; k < rays; ++k) {
    const double angle = cone * (k + 0.5) / rays;
    while (c + 1 < corners.size() && corners[c].until <= angle) ++c;
    const double within = angle - (corners[c].until - corners[c].angle);
    Ray ray(surface, values, corners[c], std::clamp(within, 0.0, corners[c].angle));
    ray.add(rings, sum, weight);
  }
  return weight > 0 ? sum / weight : 0.0;
}

}  // namespace

void BumpOptions::validate() const {
  if (!(std::isfinite(radius) && radius >= 0)) {
    refuse_bump("radius must be finite and at least 0, not " + std::to_string(radius) + ".");
  }
  if (rays < 4 || rays > 1024 || rays % 2 != 0) {
    refuse_bump("rays must be even and from 4 to 1024, not " + std::to_string(rays) + ".");
  }
  if (samples < 2 || samples > 64) {
    refuse_bump("samples must be from 2 to 64, not " + std::to_string(samples) + ".");
  }
}

std::vector<double> convolve_with_bump(const Surface& surface, std::span<const double> values,
                                       const BumpOptions& options, const Progress& progress) {
  options.validate();
  check(surface, values);
  std::vector<double> result(values.begin(), values.end());
  if (options.radius == 0) return result;

  const std::vector<Ring> rings = rings_of(options.radius, options.samples);
  std::vector<Corner> corners;
  ProgressPoller poller(progress, "solve");
  const auto rays = static_cast<std::size_t>(options.rays);
  for (std::size_t v = 0; v < result.size(); ++v) {
    poller.set_fraction(static_cast<double>(v) / static_cast<double>(result.size()));
    poller.add_work(rays * rings.size());
    corners_about(surface, VertexId{v}, corners);
    if (corners.empty() || std::isinf(values[v])) continue;
    result[v] += mean_change(surface, values, corners, rings, options.rays);
  }
  return result;
}

}  // namespace talweg
