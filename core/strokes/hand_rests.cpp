#include "talweg/core/strokes/hand_rests.hpp"

#include <algorithm>
#include <span>

#include "talweg/core/strokes/compass_walk.hpp"
#include "talweg/core/strokes/turning_points.hpp"

namespace talweg {
namespace {

constexpr std::size_t kFewest = 20, kFewestOutside = 3;  // samples
constexpr double kRadii[] = {3, 1, 1.0 / 3};             // in usual distances of samples
constexpr double kMoreThanUsual = 8;                     // times the usual number of samples
constexpr double kBackAndForth = 4, kMovesOn = 1.0 / 3;  // as part of the crowd's width
constexpr double kNearer = 0.5;                          // as part of the usual distance
constexpr double kLongestStep = 1.0 / 16, kShortestStep = 1.0 / 4000;  // as part of the length

/// A sample of a stroke, or a rest, which is one sample.
struct Sample {
  Point at;
  HandRest points;
};

using Samples = std::span<const Sample>;

double way_through(Samples samples) {
  double way = 0;
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    way += (samples[k + 1].at - samples[k].at).norm();
  }
  return way;
}

std::size_t median_of_samples_passed(std::span<const Point> samples, double step) {
  const std::vector<PolylinePlace> places = compass_walk(samples, false, step);
  std::vector<std::size_t> passed;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    passed.push_back(places[k + 1].segment - places[k].segment);
  }
  if (passed.empty()) return samples.size();
  const auto middle = passed.begin() + static_cast<std::ptrdiff_t>(passed.size() / 2);
  std::nth_element(passed.begin(), middle, passed.end());
  return *middle;
}

/// The usual distance of samples while the hand moves, correct up to a third; 0 if there are too
/// few or too many samples for an estimate.
double usual_distance(Samples samples) {
  std::vector<Point> at;
  for (const Sample& sample : samples) at.push_back(sample.at);
  const double way = way_through(samples);
  double step = kLongestStep * way;
  if (median_of_samples_passed(at, step) <= 1) return 0;
  while (step > kShortestStep * way && median_of_samples_passed(at, step) > 1) step /= 2;
  return step > kShortestStep * way ? 1.5 * step : 0;  // the distance is 1 to 2 steps
}

Point mean_of(Samples samples) {
  Point sum = Point::Zero();
  for (const Sample& sample : samples) sum += sample.at;
  return sum / static_cast<double>(samples.size());
}

/// The number of samples at the start that lie around their mean: a crowd. The crowd ends before a
/// sample farther than 2 `near` from the mean, or before several successive samples farther than
/// `near`.
std::size_t crowd_at_start(Samples samples, double near) {
  Point mean = samples[0].at;
  std::size_t size = 1, count = 1, outside = 0;
  for (std::size_t k = 1; k < samples.size() && outside < kFewestOutside; ++k) {
    const double distance = (samples[k].at - mean).norm();
    if (distance > 2 * near) break;
    if (distance > near) {
      ++outside;
      continue;
    }
    outside = 0;
    size = k + 1;
    mean += (samples[k].at - mean) / static_cast<double>(++count);
  }
  return size;
}

/// Three times the median distance from the mean, within which almost all samples of a rest lie.
double radius_of(Samples samples, const Point& mean) {
  std::vector<double> distances;
  for (const Sample& sample : samples) distances.push_back((sample.at - mean).norm());
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return 3 * *middle;
}

/// The crowd without the samples at its ends on which the hand came and left.
Samples without_ways(Samples samples) {
  for (int repeat = 0; repeat < 3; ++repeat) {
    const Point mean = mean_of(samples);
    const double radius = radius_of(samples, mean);
    const auto is_outside = [&](const Sample& s) { return (s.at - mean).norm() > radius; };
    while (samples.size() > 1 && is_outside(samples.front())) samples = samples.subspan(1);
    while (samples.size() > 1 && is_outside(samples.back())) {
      samples = samples.first(samples.size() - 1);
    }
  }
  return samples;
}

/// Whether the hand rests in a crowd: the samples are nearer to each other than usual, go back and
/// forth, and have no drift.
bool stands_still(Samples samples, double usual) {
  std::vector<double> steps;
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    steps.push_back((samples[k + 1].at - samples[k].at).norm());
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  if (*middle > kNearer * usual) return false;
  const double width = 2 * radius_of(samples, mean_of(samples));
  const std::size_t third = samples.size() / 3;
  const double moved = (mean_of(samples.last(third)) - mean_of(samples.first(third))).norm();
  return way_through(samples) >= kBackAndForth * width && moved <= kMovesOn * width;
}

/// A crowd as one sample: an end of the stroke, or the sample nearest to the crowd's mean.
Sample rest_of(Samples samples, bool has_start, bool has_end) {
  const Point mean = mean_of(samples);
  const auto nearest =
      std::min_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
        return (a.at - mean).squaredNorm() < (b.at - mean).squaredNorm();
      });
  const Sample& kept = has_start ? samples.front() : has_end ? samples.back() : *nearest;
  return {kept.at, {samples.front().points.first, kept.points.kept, samples.back().points.last}};
}

/// The samples after each rest became one sample. `radius` is in usual distances of samples.
std::vector<Sample> rested_within(Samples samples, double usual, double radius, bool closed) {
  const std::size_t fewest =
      std::max(kFewest, static_cast<std::size_t>(kMoreThanUsual * 2 * radius));
  std::vector<Sample> rested;
  for (Samples left = samples; !left.empty();) {
    const Samples crowd = left.first(crowd_at_start(left, radius * usual));
    const Samples rest = crowd.size() < fewest ? crowd : without_ways(crowd);
    const auto before = static_cast<std::size_t>(rest.data() - left.data());
    if (rest.size() >= fewest && stands_still(rest, usual)) {
      rested.insert(rested.end(), left.begin(), left.begin() + static_cast<std::ptrdiff_t>(before));
      left = left.subspan(before + rest.size());
      const bool has_start = !closed && rest.data() == samples.data();
      rested.push_back(rest_of(rest, has_start, !closed && left.empty()));
    } else {  // a rest may begin later; a part of the crowd is skipped, which saves time
      const std::size_t passed = std::max<std::size_t>(1, crowd.size() / fewest);
      rested.insert(rested.end(), left.begin(), left.begin() + static_cast<std::ptrdiff_t>(passed));
      left = left.subspan(passed);
    }
  }
  return rested;
}

/// The samples of a stroke: its ends, the points inside faces, and the points at which it turns. At
/// all other points the stroke crosses an edge.
std::vector<Sample> samples_of(const SurfaceMesh& mesh, const SurfaceCurve& stroke) {
  const std::vector<std::size_t> turning = turning_points(mesh.surface(), stroke);
  const std::size_t n = stroke.points.size();
  std::vector<Sample> samples;
  auto next = turning.begin();
  for (std::size_t k = 0; k < n; ++k) {
    const bool turns = next != turning.end() && *next == k;
    if (turns) ++next;
    const bool is_inside = std::holds_alternative<InFace>(stroke.points[k].where());
    if (!turns && !is_inside && k != 0 && k + 1 != n) continue;
    samples.push_back({mesh.position(stroke.points[k]), {k, k, k}});
  }
  return samples;
}

}  // namespace

std::vector<HandRest> hand_rests(const SurfaceMesh& mesh, const SurfaceCurve& stroke) {
  if (stroke.points.size() < kFewest) return {};
  std::vector<Sample> samples = samples_of(mesh, stroke);
  if (samples.size() < kFewest) return {};
  const double usual = usual_distance(samples);
  for (const double radius : kRadii) {
    if (usual > 0) samples = rested_within(samples, usual, radius, stroke.closed);
  }
  std::vector<HandRest> rests;
  for (const Sample& sample : samples) {
    if (sample.points.first < sample.points.last) rests.push_back(sample.points);
  }
  return rests;
}

}  // namespace talweg
