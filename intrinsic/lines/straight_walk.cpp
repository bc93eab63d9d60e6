#include "talweg/intrinsic/lines/straight_walk.hpp"

#include <algorithm>
#include <cmath>

namespace talweg {
namespace {

constexpr int kMostFaces = 2000;
constexpr double kInside = 1e-9;

/// The side by which a ray leaves its face, 3 for none, and the distance along the ray to that
/// side.
struct Exit {
  std::size_t side = 3;
  double distance = HUGE_VAL;
};

Exit exit_of(const FaceFrame::Barycentric& b, const FaceFrame::Barycentric& rates,
             std::size_t entry) {
  Exit exit;
  for (std::size_t side = 0; side < 3; ++side) {
    const std::size_t opposite = (side + 2) % 3;
    if (side == entry || !(rates[opposite] < 0)) continue;
    const double distance = std::max(0.0, -b[opposite] / rates[opposite]);
    if (distance < exit.distance) exit = {side, distance};
  }
  return exit;
}

void advance(FaceFrame::Barycentric& b, const FaceFrame::Barycentric& rates, double distance) {
  for (std::size_t k = 0; k < 3; ++k) b[k] += distance * rates[k];
}

}  // namespace

FaceCoordinates moved_inside(FaceCoordinates at) {
  double sum = 0;
  for (double& b : at.barycentric) sum += b = std::max(b, kInside);
  for (double& b : at.barycentric) b /= sum;
  return at;
}

WalkEnd walk_straight(const Surface& surface, const FaceCoordinates& from, PlanePoint direction,
                      double distance, std::vector<HalfedgeId>& crossed) {
  WalkEnd walk{from, direction, 0};
  std::size_t entry = 3;
  FaceFrame frame(surface, walk.at.face);
  for (int faces = 0; faces < kMostFaces; ++faces) {
    FaceFrame::Barycentric& b = walk.at.barycentric;
    const FaceFrame::Barycentric rates = frame.rates(walk.direction);
    const Exit exit = exit_of(b, rates, entry);
    const double left = distance - walk.walked;
    if (exit.side == 3 && !(left <= 0)) break;  // a face without area
    if (left <= exit.distance) {
      advance(b, rates, left);
      walk.walked = distance;
      walk.at = moved_inside(walk.at);
      return walk;
    }
    advance(b, rates, exit.distance);
    walk.walked += exit.distance;
    const HalfedgeId h = frame.sides[exit.side];
    if (!surface.has_face(twin(h))) {
      walk.at = moved_inside(walk.at);
      return walk;
    }
    const PlanePoint side = frame.along(exit.side);
    const double length = norm(side);
    const double part = std::clamp(b[(exit.side + 1) % 3], 0.0, 1.0);
    const double forward = dot(walk.direction, side) / length;
    const double outward = -cross(side, walk.direction) / length;
    crossed.push_back(h);
    walk.at.face = surface.face(twin(h));
    frame = FaceFrame(surface, walk.at.face);
    entry = frame.side_of(twin(h));
    const PlanePoint back = (1 / length) * frame.along(entry);
    walk.direction = -forward * back + outward * turned_left(back);
    walk.at.barycentric = {};
    walk.at.barycentric[entry] = part;  // the tail of the twin is the head of h
    walk.at.barycentric[(entry + 1) % 3] = 1 - part;
  }
  walk.walked = -1;
  return walk;
}

}  // namespace talweg
