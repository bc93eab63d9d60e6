#include "talweg/core/strokes/hand_trembling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "talweg/core/strokes/compass_walk.hpp"
#include "talweg/core/strokes/even_stroke.hpp"
#include "talweg/core/strokes/turning_points.hpp"

namespace talweg {
namespace {

constexpr double kFinest = 1.0 / 4000;    // the step, as part of the stroke's length
constexpr double kSamplesInBall = 8;      // diameter of the smallest ball, in distances of samples
constexpr double kLargestBall = 1.0 / 6;  // diameter, as part of the length
constexpr double kPlateauOfStroke = 1.0 / 3;
constexpr double kMostOfStroke = 0.6, kLargestInEdges = 24, kWithoutPlateauInEdges = 12,
                 kFewestEdges = 12;
constexpr std::size_t kBalls = 128, kPointsInBall = 48, kFewestInBall = 8, kFewestBalls = 5;
constexpr double kPlateau = 0.8, kRise = 1.2, kSteep = 2.2, kKnee = 1.8, kSmooth = 2.9;  // slopes
constexpr std::size_t kFewestTurns = 6;
constexpr std::size_t kParts = 8;  // the most parts of a stroke with amplitudes of their own
constexpr double kLeastPart = 6;   // length of a part, in diameters of balls
constexpr double kChance = 2;      // the least ratio of two different amplitudes

/// The median distance between successive points at which the stroke turns. Points nearer than a
/// step to the last counted point do not count. None if too few points count for a trembling.
std::optional<double> sample_distance(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                      std::span<const Point> positions, double step) {
  std::vector<double> distances;
  Point last = positions[0];
  for (const std::size_t k : turning_points(mesh.surface(), stroke)) {
    const double distance = (positions[k] - last).norm();
    if (distance < step) continue;
    distances.push_back(distance);
    last = positions[k];
  }
  if (distances.size() < kFewestTurns) return std::nullopt;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/// The connected part of a stroke in a ball around a place: a range of indices, which in a closed
/// stroke may be negative or exceed the number of points.
struct InBall {
  std::ptrdiff_t first = 0, last = 0;
  bool whole = true;  ///< whether the stroke leaves the ball on both sides
};

InBall in_ball(const EvenStroke& stroke, std::size_t centre, double radius) {
  const auto n = static_cast<std::ptrdiff_t>(stroke.at.size());
  const auto is_in = [&](std::ptrdiff_t k) {
    return (stroke.at[static_cast<std::size_t>((k % n + n) % n)] - stroke.at[centre]).norm() <=
           radius;
  };
  const auto c = static_cast<std::ptrdiff_t>(centre);
  InBall ball{c, c};
  const std::ptrdiff_t low = stroke.closed ? c - n / 2 : 0;
  const std::ptrdiff_t high = stroke.closed ? c + n / 2 : n - 1;
  while (ball.first > low && is_in(ball.first - 1)) --ball.first;
  while (ball.last < high && is_in(ball.last + 1)) ++ball.last;
  ball.whole = ball.first > low && ball.last < high;
  return ball;
}

/// The root mean square distance to the best cubic, across the stroke in its mean tangent plane.
double residual_in(const EvenStroke& stroke, const InBall& ball) {
  const auto n = static_cast<std::ptrdiff_t>(stroke.at.size());
  const auto count = static_cast<std::size_t>(ball.last - ball.first + 1);
  const std::size_t stride = std::max<std::size_t>(1, count / kPointsInBall);
  std::vector<Point> points;
  Point mean = Point::Zero(), normal = Point::Zero();
  for (std::size_t k = 0; k < count; k += stride) {
    const auto i =
        static_cast<std::size_t>(((ball.first + static_cast<std::ptrdiff_t>(k)) % n + n) % n);
    points.push_back(stroke.at[i]);
    mean += stroke.at[i];
    normal += stroke.normal[i];
  }
  mean /= static_cast<double>(points.size());
  normal.normalize();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (Point& p : points) {
    p -= mean;
    p -= normal * normal.dot(p);
    spread += p * p.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Point along = axes.eigenvectors().col(2), across = normal.cross(along);
  const double size = std::sqrt(axes.eigenvalues()[2] / static_cast<double>(points.size()));
  Eigen::MatrixX4d powers(points.size(), 4);
  Eigen::VectorXd offsets(points.size());
  for (Eigen::Index k = 0; k < offsets.size(); ++k) {
    const double x = points[static_cast<std::size_t>(k)].dot(along) / size;
    powers.row(k) << 1, x, x * x, x * x * x;
    offsets[k] = points[static_cast<std::size_t>(k)].dot(across);
  }
  const Eigen::Matrix4d normal_matrix = powers.transpose() * powers;
  const Eigen::Vector4d cubic = normal_matrix.ldlt().solve(powers.transpose() * offsets);
  return (offsets - powers * cubic).norm() / std::sqrt(static_cast<double>(points.size()));
}

/// The correction of a residual for the four degrees of freedom of the cubic. `samples`: samples in
/// the ball.
double of_freedom(double samples) { return std::sqrt(samples / (samples - 4)); }

/// The residuals of balls at places evenly spread over the stroke, for each scale.
struct Residuals {
  std::vector<double> scales;
  double largest_plateau = 0;          ///< the largest scale at which a plateau of r(s) counts
  double largest_without_plateau = 0;  ///< the largest scale at which r(s) counts without a plateau
  std::vector<std::vector<double>> balls;  ///< per scale; NaN for a ball at an end of the stroke

  /// r(s) of the balls [first, last), one per scale, up to the first scale with too few residuals.
  [[nodiscard]] std::vector<double> medians(std::size_t first, std::size_t last) const;
};

std::vector<double> Residuals::medians(std::size_t first, std::size_t last) const {
  std::vector<double> medians;
  for (const std::vector<double>& all : balls) {
    std::vector<double> known;
    for (std::size_t k = first; k < last; ++k) {
      if (std::isfinite(all[k])) known.push_back(all[k]);
    }
    if (known.size() < kFewestBalls) break;
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::nth_element(known.begin(), middle, known.end());
    medians.push_back(*middle);
  }
  return medians;
}

std::vector<double> residuals_at(const EvenStroke& stroke, double diameter, double of_samples) {
  std::vector<double> residuals;
  const std::size_t n = stroke.at.size();
  for (std::size_t k = 0; k < kBalls; ++k) {
    const InBall ball = in_ball(stroke, (2 * k + 1) * n / (2 * kBalls), diameter / 2);
    const bool counts =
        ball.whole && static_cast<std::size_t>(ball.last - ball.first) >= kFewestInBall;
    residuals.push_back(counts ? of_samples * residual_in(stroke, ball) : std::nan(""));
  }
  return residuals;
}

double compass_length(const EvenStroke& stroke, double step) {
  const auto places = compass_walk(stroke.at, stroke.closed, step);
  return step * static_cast<double>(places.size() - (stroke.closed ? 0 : 1));
}

Residuals residuals_of(const EvenStroke& stroke, double apart, double edge) {
  Residuals result;
  const double smallest = std::max(kSamplesInBall * apart, 2 * kFewestInBall * stroke.step);
  // The length without detail smaller than the smallest balls.
  const double length = compass_length(stroke, smallest / 2);
  result.largest_without_plateau = kWithoutPlateauInEdges * edge;
  result.largest_plateau = std::max(kPlateauOfStroke * length, kWithoutPlateauInEdges * edge);
  // A short stroke is finer than the mesh, so edges say nothing about its trembling.
  const bool is_fine = length < kFewestEdges * edge;
  const double largest =
      std::max(kLargestBall * length,
               is_fine ? 0 : std::min(kMostOfStroke * length, kLargestInEdges * edge));
  for (double steps = std::ceil(2 * std::log2(smallest / edge));; ++steps) {
    const double s = edge * std::exp2(steps / 2);
    if (s > largest) break;
    result.scales.push_back(s);
    result.balls.push_back(residuals_at(stroke, s, of_freedom(s / apart)));
  }
  return result;
}

struct AtScale {
  double scale, residual;
  bool is_plateau = false;  ///< whether r(s) has a plateau at the scale, after a rise
};

/// The slope d log r / d log s from scale k to the next. Where r is far enough above the residual
/// `of_device` of the sensor's noise, the square of `of_device` is subtracted from r².
double slope_at(const Residuals& residuals, std::span<const double> r, std::size_t k,
                double of_device = 0) {
  constexpr double kFarAbove = 1.25;
  double from = r[k], to = r[k + 1];
  if (from > kFarAbove * of_device && to > from) {
    from = std::sqrt(from * from - of_device * of_device);
    to = std::sqrt(to * to - of_device * of_device);
  }
  return std::log(to / from) / std::log(residuals.scales[k + 1] / residuals.scales[k]);
}

/// The scale of the trembling, by the rules of hand_trembling().
std::optional<AtScale> scale_of_trembling(const Residuals& residuals, std::span<const double> r) {
  const std::vector<double>& scales = residuals.scales;
  std::optional<AtScale> noise, knee, last;
  double steepest = 0, steepest_of_hand = 0, of_device = 0;
  for (std::size_t k = 0; k + 1 < r.size(); ++k) {
    if (!(r[k] > 0)) continue;
    const AtScale next{scales[k + 1], r[k + 1], false};
    const double slope = slope_at(residuals, r, k),
                 slope_of_hand = slope_at(residuals, r, k, of_device);
    if (slope < kPlateau) {
      const bool counts = next.scale <= residuals.largest_plateau;
      if (steepest > kRise && counts) return AtScale{next.scale, next.residual, true};
      if (steepest <= kRise) {
        if (!noise) of_device = r[k];
        noise = next;
      }
    }
    if (!knee && steepest_of_hand > kSteep && slope_of_hand < kKnee) {
      knee = AtScale{scales[k], r[k], false};
    }
    steepest = std::max(steepest, slope);
    steepest_of_hand = std::max(steepest_of_hand, slope_of_hand);
    if (next.scale <= residuals.largest_without_plateau) {
      last = slope < kSmooth ? std::optional(next) : std::nullopt;
    }
  }
  if (knee) return knee;
  if (noise) return noise;
  return steepest < kRise ? std::nullopt : last;
}

/// Appends the amplitudes of the parts of the balls [first, last). Two halves with different
/// amplitudes are divided further; otherwise all parts have the amplitude of `whole`.
void add_parts(const Residuals& residuals, double length, std::size_t first, std::size_t last,
               const AtScale& whole, std::vector<double>& along) {
  const std::size_t middle = (first + last) / 2;
  const double half = length * static_cast<double>(middle - first) / kBalls;
  if (last - first > kBalls / 4 && half > kLeastPart * whole.scale) {
    const auto part = [&](std::size_t from, std::size_t to) {
      return scale_of_trembling(residuals, residuals.medians(from, to));
    };
    const std::optional<AtScale> left = part(first, middle), right = part(middle, last);
    if (left && right && left->is_plateau && right->is_plateau) {
      const double ratio = left->residual / right->residual;
      if (std::max(ratio, 1 / ratio) > kChance) {
        add_parts(residuals, length, first, middle, *left, along);
        add_parts(residuals, length, middle, last, *right, along);
        return;
      }
    }
  }
  const std::size_t parts = (last - first) * kParts / kBalls;
  along.insert(along.end(), parts, std::numbers::sqrt3 * whole.residual);
}

/// The amplitudes of kParts parts of the stroke; empty if all are equal.
std::vector<double> amplitudes_along(const Residuals& residuals, double length,
                                     const AtScale& whole) {
  std::vector<double> along;
  add_parts(residuals, length, 0, kBalls, whole, along);
  const bool differs =
      std::adjacent_find(along.begin(), along.end(), std::not_equal_to<>()) != along.end();
  if (!differs) along.clear();
  return along;
}

}  // namespace

std::optional<HandTrembling> hand_trembling(const SurfaceMesh& mesh, const SurfaceCurve& stroke,
                                            double edge) {
  const std::vector<Point> positions = positions_of(mesh, stroke);
  double way = 0;
  for (std::size_t k = 0; k + 1 < positions.size(); ++k) {
    way += (positions[k + 1] - positions[k]).norm();
  }
  if (positions.size() < 3 || !(way > 0) || !(edge > 0)) return std::nullopt;
  const double step = kFinest * way;
  const EvenStroke even = even_stroke(mesh, stroke, step);
  const std::optional<double> apart = sample_distance(mesh, stroke, positions, step);
  if (!apart) return std::nullopt;
  const Residuals residuals = residuals_of(even, *apart, edge);
  const std::optional<AtScale> found = scale_of_trembling(residuals, residuals.medians(0, kBalls));
  if (!found) return std::nullopt;
  return HandTrembling{std::numbers::sqrt3 * found->residual, found->scale,
                       amplitudes_along(residuals, even.length(), *found)};
}

}  // namespace talweg
