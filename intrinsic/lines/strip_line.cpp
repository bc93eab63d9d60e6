#include "talweg/intrinsic/lines/strip_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talweg {
namespace {

constexpr std::size_t kMostWork = 200'000;  // portals that one join may visit
constexpr double kShorter = 1e-12;          // relative

PlanePoint rotated(PlanePoint by, PlanePoint p) {
  return {by.x * p.x - by.y * p.y, by.x * p.y + by.y * p.x};
}

PlanePoint unit(PlanePoint p) {
  const double length = norm(p);
  return length > 0 ? (1 / length) * p : PlanePoint{1, 0};
}

/// The coordinates of a point on a side in the face beyond that side.
FaceCoordinates beyond(const Surface& surface, const FaceCoordinates& at, HalfedgeId side) {
  const FaceFrame frame(surface, at.face);
  const FaceFrame next(surface, surface.face(twin(side)));
  const std::size_t i = frame.side_of(side), j = next.side_of(twin(side));
  FaceCoordinates result{surface.face(twin(side)), {}};
  result.barycentric[j] = at.barycentric[(i + 1) % 3];
  result.barycentric[(j + 1) % 3] = at.barycentric[i];
  return result;
}

bool lies_on(const Surface& surface, const FaceCoordinates& at, HalfedgeId side) {
  const auto& b = at.barycentric;
  if (b[0] != 0 && b[1] != 0 && b[2] != 0) return false;
  const HalfedgeId first = surface.halfedge(at.face);
  const std::size_t i = side == first ? 0 : side == surface.next(first) ? 1 : 2;
  return b[(i + 2) % 3] == 0;
}

// A strip that crosses halfedges with a common head turns counterclockwise around that vertex and
// passes it on the left. A strip that crosses halfedges with a common tail turns clockwise and
// passes the vertex on the right.

/// The other halfedge of the face at the passed vertex; a crossing of it turns around the vertex in
/// the other direction.
HalfedgeId beside(const Surface& surface, HalfedgeId h, bool left) {
  return left ? surface.next(h) : surface.prev(h);
}

/// The number of faces around the vertex that a halfedge passes; 0 on the boundary.
std::size_t closed_degree(const Surface& surface, HalfedgeId around, bool left) {
  std::size_t degree = 0;
  HalfedgeId h = around;
  do {
    if (!surface.has_face(twin(h))) return 0;
    h = left ? surface.prev(twin(h)) : surface.next(twin(h));
    ++degree;
  } while (h != around);
  return degree;
}

}  // namespace

void add_crossing(FaceStrip& strip, HalfedgeId crossed, std::size_t first) {
  if (strip.size() > first && strip.back() == twin(crossed)) {
    strip.pop_back();
  } else {
    strip.push_back(crossed);
  }
}

void StripLines::trim(FaceCoordinates& from, FaceCoordinates& to, FaceStrip& strip) const {
  std::size_t first = 0;
  while (first < strip.size() && lies_on(*surface_, from, strip[first])) {
    from = beyond(*surface_, from, strip[first++]);
  }
  while (strip.size() > first && lies_on(*surface_, to, twin(strip.back()))) {
    to = beyond(*surface_, to, twin(strip.back()));
    strip.pop_back();
  }
  strip.erase(strip.begin(), strip.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Lays out each face beside its entry side; only the apex is a new point.
void StripLines::unfold(const FaceCoordinates& from, const FaceCoordinates& to,
                        const FaceStrip& strip) {
  portals_.clear();
  const FaceFrame frame(*surface_, from.face);
  from_ = frame.at(from.barycentric);
  turn_ = {1, 0};
  std::array<PlanePoint, 3> corners = frame.corners;  // of the last face; side k starts at corner k
  std::array<HalfedgeId, 3> sides = frame.sides;
  for (const HalfedgeId h : strip) {
    const std::size_t side = h == sides[0] ? 0 : h == sides[1] ? 1 : 2;
    const PlanePoint tail = corners[side], head = corners[(side + 1) % 3];
    portals_.push_back({head, tail, surface_->head(h), surface_->tail(h)});
    const HalfedgeId entry = twin(h), next = surface_->next(entry), last = surface_->next(next);
    const PlanePoint along = unit(tail - head);
    const PlanePoint top = apex(surface_->length(edge_of(h)), surface_->length(edge_of(last)),
                                surface_->length(edge_of(next)));
    corners = {head, tail, head + rotated(along, top)};
    sides = {entry, next, last};
  }
  if (strip.empty()) {
    to_ = frame.at(to.barycentric);
    return;
  }
  // The corner order of the last face in the layout may differ from the order in its own frame.
  const HalfedgeId first = surface_->halfedge(surface_->face(sides[0]));
  const std::size_t k = first == sides[0] ? 0 : first == sides[1] ? 1 : 2;
  const PlanePoint &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
  turn_ = unit(b - a);
  to_ = a + to.barycentric[1] * (b - a) + to.barycentric[2] * (c - a);
}

bool StripLines::is_straight() const {
  const PlanePoint way = to_ - from_;
  double last = 0;
  for (const Portal& portal : portals_) {
    const double left = cross(way, portal.left - from_), right = cross(way, portal.right - from_);
    if (!(left > 0 && right < 0)) return false;
    // The sides alone cannot detect a turn of more than π around a vertex, so the crossings must
    // also be in order along the line.
    const PlanePoint at = (1 / (left - right)) * (left * portal.right - right * portal.left);
    const double along = dot(way, at - from_);
    if (along < last) return false;
    last = along * (1 - kShorter);
  }
  return last <= dot(way, way);
}

/// Lee and Preparata, "Euclidean shortest paths in the presence of rectilinear barriers" (1984),
/// with the funnel as the apex and the two sides of its view through the portals.
void StripLines::pull_funnel() {
  bends_.clear();
  if (is_straight()) return;
  const std::size_t n = portals_.size();
  const auto left_of = [&](std::size_t i) { return i < n ? portals_[i].left : to_; };
  const auto right_of = [&](std::size_t i) { return i < n ? portals_[i].right : to_; };
  PlanePoint apex = from_;
  std::size_t left = 0, right = 0, i = 0;
  PlanePoint left_at = left_of(0), right_at = right_of(0);
  const auto restart = [&](std::size_t at, bool on_left) {
    const Portal& portal = portals_[at];
    bends_.push_back({at, on_left, on_left ? portal.left : portal.right,
                      on_left ? portal.left_vertex : portal.right_vertex});
    apex = bends_.back().at;
    // Portals that end at the new apex do not narrow its view.
    i = at + 1;
    const auto ends_here = [&](std::size_t k) {
      return (on_left ? portals_[k].left_vertex : portals_[k].right_vertex) == bends_.back().vertex;
    };
    while (i < n && ends_here(i)) ++i;
    left = right = i;
    left_at = left_of(i);
    right_at = right_of(i);
  };
  i = 1;
  while (i <= n && bends_.size() <= n) {
    const PlanePoint next_left = left_of(i), next_right = right_of(i);
    if (cross(right_at - apex, next_right - apex) >= 0) {  // the right side does not widen
      if (cross(left_at - apex, next_right - apex) > 0) {  // the right side crosses the left one
        restart(left, true);
        ++i;
        continue;
      }
      right = i;
      right_at = next_right;
    }
    if (cross(left_at - apex, next_left - apex) <= 0) {
      if (cross(right_at - apex, next_left - apex) < 0) {
        restart(right, false);
        ++i;
        continue;
      }
      left = i;
      left_at = next_left;
    }
    ++i;
  }
}

double StripLines::length() const {
  PlanePoint last = from_;
  double sum = 0;
  for (const Bend& bend : bends_) {
    sum += norm(bend.at - last);
    last = bend.at;
  }
  return sum + norm(to_ - last);
}

/// Sets `other` to the strip that passes the vertex of a bend on the other side; false at the
/// boundary.
bool StripLines::flip(const FaceStrip& strip, const Bend& bend, FaceStrip& other) const {
  const auto ends_here = [&](std::size_t k) {
    return (bend.left ? portals_[k].left_vertex : portals_[k].right_vertex) == bend.vertex;
  };
  std::size_t first = bend.portal, last = bend.portal;
  while (first > 0 && ends_here(first - 1)) --first;
  while (last + 1 < strip.size() && ends_here(last + 1)) ++last;
  const std::size_t degree = closed_degree(*surface_, strip[first], bend.left),
                    run = last + 1 - first;
  if (degree == 0) return false;
  other.clear();
  for (std::size_t k = 0; k < first; ++k) add_crossing(other, strip[k]);
  // The flip of a strip that makes more than a full turn around the vertex removes one full turn.
  for (std::size_t k = degree; k < run; ++k) add_crossing(other, strip[first + k]);
  HalfedgeId h = beside(*surface_, strip[first], bend.left);
  for (std::size_t k = run; k < degree; ++k) {
    add_crossing(other, h);
    h = beside(*surface_, twin(h), bend.left);
  }
  for (std::size_t k = last + 1; k < strip.size(); ++k) add_crossing(other, strip[k]);
  return true;
}

void StripLines::fill(StripLine& line) const {
  line.bends.clear();
  line.turns.clear();
  if (bends_.empty()) {
    const PlanePoint way = to_ - from_;
    line.length = line.to_first_bend = line.from_last_bend = norm(way);
    line.start = line.length > 0 ? (1 / line.length) * way : PlanePoint{1, 0};
    line.end = rotated({turn_.x, -turn_.y}, line.start);
    line.found = std::isfinite(line.length);
    return;
  }
  line.length = length();
  const PlanePoint first = bends_.front().at - from_, last = to_ - bends_.back().at;
  line.start = unit(first);
  line.to_first_bend = norm(first);
  line.from_last_bend = norm(last);
  line.end = rotated({turn_.x, -turn_.y}, unit(last));
  for (std::size_t b = 0; b < bends_.size(); ++b) {
    const PlanePoint in = bends_[b].at - (b > 0 ? bends_[b - 1].at : from_);
    const PlanePoint out = (b + 1 < bends_.size() ? bends_[b + 1].at : to_) - bends_[b].at;
    line.bends.push_back(bends_[b].vertex);
    line.turns.push_back(std::atan2(cross(in, out), dot(in, out)));
  }
  line.found = std::isfinite(line.length);
}

StripLine StripLines::join(const FaceCoordinates& from, const FaceCoordinates& to,
                           FaceStrip& strip) {
  StripLine line{from, to};
  trim(line.from, line.to, strip);
  unfold(line.from, line.to, strip);
  pull_funnel();
  if (bends_.empty()) {
    fill(line);
    return line;
  }
  std::size_t work = strip.size();
  while (work < kMostWork) {
    const double before = length();
    if (!std::isfinite(before)) return line;
    bool flipped = false;
    const std::vector<Bend> bends = bends_;
    for (std::size_t b = 0; b < bends.size() && !flipped; ++b) {
      if (!flip(strip, bends[b], other_)) continue;
      FaceCoordinates start = line.from, stop = line.to;
      trim(start, stop, other_);
      const std::vector<Portal> portals = portals_;
      unfold(start, stop, other_);
      pull_funnel();
      work += other_.size();
      flipped = length() < before * (1 - kShorter);
      if (flipped) {
        strip = other_;
        line.from = start;
        line.to = stop;
      } else {
        portals_ = portals;  // for the next flip
      }
    }
    if (!flipped) {
      unfold(line.from, line.to, strip);
      pull_funnel();
      fill(line);
      return line;
    }
  }
  return line;
}

StripLine StripLines::trace(const FaceCoordinates& from, const FaceCoordinates& to,
                            const FaceStrip& strip) {
  StripLine line{from, to};
  unfold(from, to, strip);
  pull_funnel();
  fill(line);
  find_parts();
  return line;
}

void StripLines::find_parts() {
  parts_.clear();
  std::size_t next = 0;
  PlanePoint last = from_;
  const auto bends_at = [&](const Portal& portal, std::size_t bend, bool left) {
    return bend < bends_.size() && bends_[bend].left == left &&
           bends_[bend].vertex == (left ? portal.left_vertex : portal.right_vertex);
  };
  for (std::size_t i = 0; i < portals_.size(); ++i) {
    while (next < bends_.size() && bends_[next].portal < i) last = bends_[next++].at;
    const Portal& portal = portals_[i];
    if (bends_at(portal, next, true) || (next > 0 && bends_at(portal, next - 1, true))) {
      parts_.push_back(1);
    } else if (bends_at(portal, next, false) || (next > 0 && bends_at(portal, next - 1, false))) {
      parts_.push_back(0);
    } else {
      const PlanePoint way = (next < bends_.size() ? bends_[next].at : to_) - last;
      const double right = -cross(way, portal.right - last), left = cross(way, portal.left - last);
      parts_.push_back(right + left > 0 ? std::clamp(right / (right + left), 0.0, 1.0) : 0.5);
    }
  }
}

}  // namespace talweg
