#include "vertex_passage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg::plugins {
namespace {

/// The halfedges from a vertex, counterclockwise; at the boundary from boundary edge to boundary
/// edge.
struct Fan {
  std::vector<HalfedgeId> spokes;
  std::vector<double> angles;  // per spoke, from the first spoke
  double cone = 0;             // total angle about the vertex
  bool open = false;
};

/// A direction from a vertex. Slot 2 i is spoke i; slot 2 i + 1 is the face after spoke i.
struct Direction {
  std::size_t slot = 0;
  double angle = 0;
  double distance = 0;
};

double length_of(const Surface& surface, HalfedgeId h) { return surface.length(edge_of(h)); }

Fan fan_of(const Surface& surface, VertexId v) {
  Fan fan;
  fan.open = surface.on_boundary(v);
  const HalfedgeId first = surface.halfedge(v);
  HalfedgeId h = first;
  do {
    fan.spokes.push_back(h);
    fan.angles.push_back(fan.cone);
    const HalfedgeId across = surface.next(h);
    fan.cone += angle_between(length_of(surface, h), length_of(surface, surface.next(across)),
                              length_of(surface, across));
    h = surface.turn_ccw(h);
  } while (h != first && surface.has_face(h));
  if (fan.open) {
    fan.spokes.push_back(h);
    fan.angles.push_back(fan.cone);
  }
  return fan;
}

bool is_along(const Surface& surface, HalfedgeId spoke, const SurfacePoint& p) {
  if (const auto* at = std::get_if<AtVertex>(&p.where())) return surface.head(spoke) == at->vertex;
  const auto* on = std::get_if<OnEdge>(&p.where());
  return on != nullptr && on->edge == edge_of(spoke);
}

double distance_along(const Surface& surface, HalfedgeId spoke, const SurfacePoint& p) {
  const auto* on = std::get_if<OnEdge>(&p.where());
  if (on == nullptr) return length_of(surface, spoke);
  return length_of(surface, spoke) * (spoke == halfedge_of(on->edge) ? on->t : 1 - on->t);
}

/// The angle of the point counterclockwise from the spoke, in the face on the spoke's left.
Direction inside(const Surface& surface, HalfedgeId spoke, const SurfacePoint& p) {
  const FaceId f = surface.face(spoke);
  const auto at = coordinates_in(surface, p, f).barycentric;
  std::size_t k = 0;
  for (HalfedgeId side = surface.halfedge(f); side != spoke; side = surface.next(side)) ++k;
  const double base = length_of(surface, spoke);
  const PlanePoint top =
      apex(base, length_of(surface, surface.prev(spoke)), length_of(surface, surface.next(spoke)));
  const double x = at[(k + 1) % 3] * base + at[(k + 2) % 3] * top.x;
  const double y = at[(k + 2) % 3] * top.y;
  return {0, std::max(0.0, std::atan2(y, x)), std::hypot(x, y)};
}

Direction direction_to(const Surface& surface, const Fan& fan, const SurfacePoint& p) {
  for (std::size_t i = 0; i < fan.spokes.size(); ++i) {
    if (is_along(surface, fan.spokes[i], p)) {
      return {2 * i, fan.angles[i], distance_along(surface, fan.spokes[i], p)};
    }
  }
  const std::vector<FaceId> faces = faces_at(surface, p);
  for (std::size_t i = 0; i < fan.spokes.size(); ++i) {
    if (!surface.has_face(fan.spokes[i])) continue;
    const FaceId f = surface.face(fan.spokes[i]);
    if (std::find(faces.begin(), faces.end(), f) == faces.end()) continue;
    Direction direction = inside(surface, fan.spokes[i], p);
    direction.slot = 2 * i + 1;
    direction.angle += fan.angles[i];
    return direction;
  }
  return {};
}

/// The side that is swept counterclockwise from `from` to `to`.
PassageSide side_between(const Fan& fan, const Direction& from, const Direction& to) {
  PassageSide side;
  const bool ahead = from.slot < to.slot || (from.slot == to.slot && from.angle <= to.angle);
  if (!ahead && fan.open) {
    side.angle = std::numeric_limits<double>::infinity();
    return side;
  }
  side.angle = to.angle - from.angle + (ahead ? 0 : fan.cone);
  const std::size_t slots = 2 * fan.spokes.size();
  const std::size_t end = ahead ? to.slot : to.slot + slots;
  for (std::size_t slot = from.slot + 1; slot < end; ++slot) {
    if (slot % 2 != 0) continue;
    const std::size_t i = slot % slots / 2;
    const double turn = fan.angles[i] - from.angle + (slot < slots ? 0 : fan.cone);
    const double reach = from.distance * std::sin(turn) + to.distance * std::sin(side.angle - turn);
    const double chord = reach > 0 ? from.distance * to.distance * std::sin(side.angle) / reach : 0;
    side.spokes.push_back({fan.spokes[i], chord});
  }
  return side;
}

}  // namespace

std::array<PassageSide, 2> passage_at(const Surface& surface, VertexId v, const SurfacePoint& a,
                                      const SurfacePoint& b) {
  const Fan fan = fan_of(surface, v);
  const Direction to_a = direction_to(surface, fan, a), to_b = direction_to(surface, fan, b);
  std::array<PassageSide, 2> sides = {side_between(fan, to_a, to_b), side_between(fan, to_b, to_a)};
  std::reverse(sides[1].spokes.begin(), sides[1].spokes.end());
  return sides;
}

}  // namespace talweg::plugins
