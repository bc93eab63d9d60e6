#include "tools/scenes/hands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "talweg/intrinsic/lines/face_frame.hpp"
#include "talweg/intrinsic/lines/straight_walk.hpp"
#include "tools/scenes/random.hpp"

namespace talweg::scenes {
namespace {

constexpr double kFine = 0.1;  // edges
constexpr double kUnusual = 1.6;
constexpr int kAttempts = 100, kWaves = 12, kSmoothed = 10, kRest = 60;
constexpr double kTurn = 2 * std::numbers::pi;

/// A place of a path, with the directions to its left and away from the surface.
struct Place {
  Point at, side, normal;
};

Place place_of(const SurfaceMesh& mesh, const FaceCoordinates& at, PlanePoint direction) {
  const auto corners = mesh.surface().corners(at.face);
  const std::array<Point, 3> p{mesh.point(corners[0]), mesh.point(corners[1]),
                               mesh.point(corners[2])};
  const Point right = (p[1] - p[0]).normalized();
  const Point normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
  const Point along = direction.x * right + direction.y * normal.cross(right);
  const auto& b = at.barycentric;
  return {b[0] * p[0] + b[1] * p[1] + b[2] * p[2], normal.cross(along), normal};
}

double mean_side(const Surface& surface, FaceId face) {
  double sum = 0;
  for (const HalfedgeId side : FaceFrame(surface, face).sides) sum += surface.length(edge_of(side));
  return sum / 3;
}

PlanePoint turned(PlanePoint direction, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * direction.x - s * direction.y, s * direction.x + c * direction.y};
}

double normal_random(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(kTurn * random.unit());
}

Point random_offset(Random& random) {
  const double x = normal_random(random), y = normal_random(random), z = normal_random(random);
  return {x, y, z};
}

void smooth(std::vector<Point>& directions) {
  const std::vector<Point> old = directions;
  const auto n = static_cast<int>(old.size());
  for (int k = 0; k < n; ++k) {
    Point sum = Point::Zero();
    for (int i = k - kSmoothed; i <= k + kSmoothed; ++i) {
      sum += old[static_cast<std::size_t>(std::clamp(i, 0, n - 1))];
    }
    directions[static_cast<std::size_t>(k)] = sum.normalized();
  }
}

}  // namespace

HandStroke::HandStroke(const SurfaceMesh& mesh, const Hand& hand, std::uint64_t seed)
    : hand_(hand), seed_(seed) {
  Random random(seed);
  const std::size_t faces = mesh.surface().face_count();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const FaceId face{static_cast<std::size_t>(random.unit() * static_cast<double>(faces))};
    const double ratio = mean_side(mesh.surface(), face) / mesh.mean_edge_length();
    if (ratio < 1 / kUnusual || ratio > kUnusual)
      continue;  // lengths of the hand are in the mean
                 // edge there
    const double heading = random.in(0, kTurn);
    const bool found = hand.radius > 0 ? go_round(mesh, face, heading) : walk(mesh, face, heading);
    if (!found) continue;
    tremble();
    return;
  }
  way_.clear();
}

bool HandStroke::walk(const SurfaceMesh& mesh, FaceId face, double heading) {
  const Surface& surface = mesh.surface();
  edge_ = mean_side(surface, face);
  way_.clear();
  side_.clear();
  normal_.clear();
  FaceCoordinates at{face, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
  PlanePoint direction{std::cos(heading), std::sin(heading)};
  const auto steps = static_cast<std::size_t>(hand_.length / kFine);
  for (std::size_t k = 0; k <= steps; ++k) {
    const Place place = place_of(mesh, at, direction);
    way_.push_back(place.at);
    side_.push_back(place.side);
    normal_.push_back(place.normal);
    std::vector<HalfedgeId> crossed;
    const WalkEnd end = walk_straight(surface, at, direction, kFine * edge_, crossed);
    if (!(end.walked >= 0.99 * kFine * edge_)) return false;
    at = end.at;
    const double along = kFine * static_cast<double>(k);
    direction = turned(end.direction, hand_.bend * kFine *
                                          std::sin(kTurn * along / (0.7 * hand_.length) + heading));
  }
  return true;
}

/// The ends of straight paths from one point in all directions.
bool HandStroke::go_round(const SurfaceMesh& mesh, FaceId face, double heading) {
  const Surface& surface = mesh.surface();
  edge_ = mean_side(surface, face);
  way_.clear();
  side_.clear();
  normal_.clear();
  const double round = kTurn + hand_.over / hand_.radius;
  const auto steps = static_cast<std::size_t>(round * hand_.radius / kFine);
  for (std::size_t k = 0; k <= steps; ++k) {
    const double angle = heading + round * static_cast<double>(k) / static_cast<double>(steps);
    std::vector<HalfedgeId> crossed;
    const FaceCoordinates from{face, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
    const WalkEnd end = walk_straight(surface, from, {std::cos(angle), std::sin(angle)},
                                      hand_.radius * edge_, crossed);
    if (!(end.walked >= 0.99 * hand_.radius * edge_)) return false;
    const Place place = place_of(mesh, end.at, turned(end.direction, kTurn / 4));
    const bool jumps = !way_.empty() && (place.at - way_.back()).norm() > 5 * kFine * edge_;
    if (jumps) return false;  // the circle has a gap behind a hill
    way_.push_back(place.at);
    side_.push_back(place.side);
    normal_.push_back(place.normal);
  }
  return true;
}

void HandStroke::tremble() {
  smooth(side_);
  smooth(normal_);
  Random random(seed_ + 1);
  std::array<double, kWaves> waves{}, phases{};
  for (int k = 0; k < kWaves; ++k) {
    waves[static_cast<std::size_t>(k)] = random.in(hand_.wave, 2 * hand_.wave);
    phases[static_cast<std::size_t>(k)] = random.in(0, kTurn);
  }
  drawn_.clear();
  for (std::size_t i = 0; i < way_.size(); ++i) {
    double off = 0;
    for (std::size_t k = 0; k < kWaves; ++k) {
      off += std::sin(kTurn * kFine * static_cast<double>(i) / waves[k] + phases[k]);
    }
    drawn_.push_back(way_[i] + side_[i] * (hand_.amplitude * edge_ * off / std::sqrt(kWaves)));
  }
}

/// The position of the hand after this many edges of its path.
Point HandStroke::at(double along) const {
  const double place = std::clamp(along / kFine, 0.0, static_cast<double>(drawn_.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(place), drawn_.size() - 2);
  const double t = place - static_cast<double>(k);
  return (1 - t) * drawn_[k] + t * drawn_[k + 1];
}

std::vector<Point> HandStroke::sampled(const Sampling& sampling) const {
  Random random(seed_ + 2);
  const double length = kFine * static_cast<double>(way_.size() - 1);
  std::vector<double> places;
  for (double along = 0; along <= length;) {
    places.push_back(along);
    along += sampling.step * std::pow(sampling.uneven, random.in(-1, 1));
  }
  for (double back = sampling.step; back <= sampling.hook; back += sampling.step) {
    places.push_back(length - back);
  }
  std::vector<bool> rests(places.size(), false), spikes(places.size(), false);
  const auto somewhere = [&] {
    return static_cast<std::size_t>(random.in(0.1, 0.9) * static_cast<double>(places.size()));
  };
  for (std::size_t k = 0; k < sampling.rests; ++k) rests[somewhere()] = true;
  for (std::size_t k = 0; k < sampling.spikes; ++k) spikes[somewhere()] = true;
  const double phase = random.in(0, kTurn);
  std::vector<Point> samples;
  const auto add = [&](const Point& p) {
    samples.push_back(p + sampling.jitter * edge_ * random_offset(random));
  };
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto nearest = std::min(static_cast<std::size_t>(places[k] / kFine), normal_.size() - 1);
    const double off = sampling.off / 2 * (1 + std::sin(kTurn * places[k] / 25 + phase));
    const Point here = at(places[k]) + off * edge_ * normal_[nearest];
    add(here);
    if (sampling.doubled) samples.push_back(samples.back());
    for (int i = 0; rests[k] && i < kRest; ++i) add(here + 0.004 * edge_ * random_offset(random));
    if (spikes[k]) samples.push_back(here + 12 * edge_ * random_offset(random).normalized());
  }
  return samples;
}

}  // namespace talweg::scenes
