#include "talweg/core/drawing/better_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::size_t kMostSamples = 32;
constexpr double kNearInEdges = 0.25;  ///< a mean distance up to which no better fit is sought
constexpr double kOnInEdges = 1;       ///< the largest mean distance of a better fit
constexpr double kTimesBetter = 10;    ///< the least improvement of a better fit
constexpr double kMostTimes = 1000;    ///< larger improvements are not told exactly
/// The mean distance, as part of the mesh's diagonal, beyond which moves are tried; as in snap().
constexpr double kAwayOfSize = 0.125;
/// The least step of a round move, as part of the mesh's diagonal.
constexpr double kLeastStepOfSize = 0.05;
constexpr int kMostSteps = 8;

struct Box {
  Point low, high;
  [[nodiscard]] Point centre() const { return 0.5 * (low + high); }
  [[nodiscard]] double diagonal() const { return (high - low).norm(); }
};

Box box_of(std::span<const Point> points) {
  Box box{points.front(), points.front()};
  for (const Point& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

/// A change of positions: a turn or a scaling, then a shift.
struct Change {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Point shift = Point::Zero();
  std::string words;
  double scale = 1;  ///< the factor by which `turn` scales
};

std::string numbers(const Point& p) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
}

Change moved_by(const Point& shift, const char* what) {
  return {Eigen::Matrix3d::Identity(), shift, fmt::format("moved by {}{}", numbers(shift), what)};
}

/// Adds moves by round numbers that bring the centre of the positions near the mesh's centre.
void add_round_moves(const Point& way, double size, std::vector<Change>& changes) {
  double step = std::pow(10, std::floor(std::log10(way.cwiseAbs().maxCoeff())));
  for (int k = 0; k < kMostSteps && step >= kLeastStepOfSize * size; ++k, step /= 10) {
    const Point shift = step * (way / step).array().round().matrix();
    changes.push_back(moved_by(shift, ""));
  }
}

/// Turns between the axes of programs: RAS and LPS; z up (Blender) and y up (glTF, and the OBJ
/// files that Blender exports).
std::vector<Change> turns() {
  Eigen::Matrix3d patient = Eigen::Matrix3d::Identity(), up;
  patient(0, 0) = patient(1, 1) = -1;
  up << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return {{patient, Point::Zero(), "with x and y negated, as between RAS and LPS"},
          {up, Point::Zero(), "as (x, z, -y), as if z were up in the drawing and y in the mesh"},
          {up.transpose(), Point::Zero(),
           "as (x, -z, y), as if y were up in the drawing and z in the mesh"}};
}

std::vector<Change> changes_for(const Box& mesh, const Box& drawing, double mean, double edge) {
  std::vector<Change> changes = turns();
  for (const double factor : {10.0, 100.0, 1000.0, 25.4, 0.1, 0.01, 1e-3, 1 / 25.4}) {
    changes.push_back({factor * Eigen::Matrix3d::Identity(), Point::Zero(),
                       fmt::format("scaled by {:.6g}, as in another unit", factor), factor});
  }
  const Point centre = mesh.centre();
  if (centre.norm() > edge) {
    for (const double sign : {1.0, -1.0}) {
      changes.push_back(moved_by(sign * centre, ", the centre of the mesh's box"));
    }
  }
  if (mean > kAwayOfSize * mesh.diagonal()) {
    add_round_moves(centre - drawing.centre(), mesh.diagonal(), changes);
  }
  return changes;
}

/// The mean distance to the mesh; infinite if a position is too far away to be measured.
double mean_distance(const ClosestPoint& closest, const std::vector<Point>& positions) {
  double sum = 0;
  try {
    for (const Point& p : positions) sum += closest.nearest(p).distance;
  } catch (const Error&) {
    return HUGE_VAL;
  }
  return sum / static_cast<double>(positions.size());
}

std::vector<Point> samples_of(std::span<const Point> positions) {
  const std::size_t n = std::min(positions.size(), kMostSamples);
  std::vector<Point> samples;
  for (std::size_t k = 0; k < n; ++k) samples.push_back(positions[k * positions.size() / n]);
  return samples;
}

}  // namespace

std::string better_fit(const SurfaceMesh& mesh, const ClosestPoint& closest,
                       std::span<const Point> positions) {
  const std::vector<Point> samples = samples_of(positions);
  if (samples.empty()) return {};
  const double edge = mesh.mean_edge_length();
  const double mean = mean_distance(closest, samples);
  if (!(mean > kNearInEdges * edge)) return {};
  const Box box = box_of(mesh.points());
  const Box drawing = box_of(samples);
  double best = kTimesBetter;
  std::string words;
  for (const Change& change : changes_for(box, drawing, mean, edge)) {
    std::vector<Point> changed;
    changed.reserve(samples.size());
    for (const Point& p : samples) changed.push_back(change.turn * p + change.shift);
    const double now = mean_distance(closest, changed);
    if (!(now <= kOnInEdges * edge)) continue;
    const double times = now > 0 ? mean * change.scale / now : HUGE_VAL;
    if (!(times > best)) continue;
    best = times;
    words = change.words;
  }
  if (words.empty()) return {};
  return best > kMostTimes
             ? fmt::format("{}more than {} times better {}", kWouldFit, kMostTimes, words)
             : fmt::format("{}{:.0f} times better {}", kWouldFit, best, words);
}

}  // namespace talweg
