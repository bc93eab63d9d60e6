#include "talweg/core/smoothing/unrolled_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kOpen = 0xFFFFFFFFU;
constexpr std::size_t kOfUnrolledFace = 8;  // units of work
constexpr double kStraighter = 0.8;  // length of a way across faces, relative to a way along edges

/// A strip of copies of faces. Corner 3 c + k is corner k of copy c; side 3 c + k leads from this
/// corner to the next corner of the copy.
class Strip {
 public:
  Strip(const Surface& surface, ProgressPoller& poller) : surface_(surface), poller_(poller) {}

  /// Lays copies of faces along a curve. False if the strip of a closed curve does not return to
  /// its first copy from any of the tried starts.
  bool lay_along(const SurfaceCurve& curve);
  void grow(double reach);

  [[nodiscard]] std::span<const FaceId> faces() const { return faces_; }
  [[nodiscard]] std::span<const std::uint32_t> across() const { return across_; }
  /// Per segment of the curve, its copy.
  [[nodiscard]] std::span<const std::uint32_t> copies_along() const { return along_; }
  /// UnrolledMesh::near and may_grow of this strip.
  [[nodiscard]] double near() const { return near_; }
  [[nodiscard]] bool may_grow() const { return may_grow_; }
  /// Whether corners at one vertex are all farther from the curve than near().
  [[nodiscard]] bool is_at_cut(std::span<const std::uint32_t> corners) const {
    return std::all_of(corners.begin(), corners.end(),
                       [&](Index corner) { return distance_[corner] > near_; });
  }

 private:
  using Index = std::uint32_t;
  static Index next(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index prev(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  [[nodiscard]] HalfedgeId halfedge(Index side) const {
    HalfedgeId h = surface_.halfedge(faces_[side / 3]);
    for (Index k = side % 3; k > 0; --k) h = surface_.next(h);
    return h;
  }
  [[nodiscard]] Index side_of(Index copy, HalfedgeId h) const {
    Index side = 3 * copy;
    for (HalfedgeId k = surface_.halfedge(faces_[copy]); k != h; k = surface_.next(k)) ++side;
    return side;
  }
  Index add(FaceId face);
  void glue(Index a, Index b) {
    across_[a] = b;
    across_[b] = a;
  }
  [[nodiscard]] std::size_t degree(VertexId v) const;
  /// The copies around one corner, and the open sides at the two ends of the fan; kOpen for a
  /// closed fan.
  struct Fan {
    std::size_t count = 0;
    Index clockwise = kOpen;  // side that leaves the corner
    Index counter = kOpen;    // side that ends at the corner
  };
  [[nodiscard]] Fan fan_at(Index corner) const;
  bool close_at(Index side, bool at_tail);
  bool join_around_handle(Index side);
  [[nodiscard]] bool may_join(Index a, Index b) const;
  Index cross(Index side, bool at_tail, bool at_head);
  bool walk(const SurfacePoint& around, Index& copy, FaceId to, Index last);
  void complete_around(Index corner);
  [[nodiscard]] std::vector<FaceId> faces_along(const SurfaceCurve& curve) const;
  [[nodiscard]] std::vector<double> arcs_along(const SurfaceCurve& curve) const;
  static std::vector<std::size_t> starts_of(const SurfaceCurve& curve,
                                            std::span<const FaceId> faces);
  bool lay_from(const SurfaceCurve& curve, std::span<const FaceId> faces,
                std::span<const double> arcs, std::size_t start);

  const Surface& surface_;
  ProgressPoller& poller_;
  std::vector<FaceId> faces_;
  std::vector<Index> across_;
  // The open sides along each halfedge, and sides that were joined since: per halfedge of a copied
  // face, the last side; per side, the side before.
  std::unordered_map<std::size_t, Index> newest_;
  std::vector<Index> older_;
  std::vector<double> place_;     // per copy, the arc length of the curve that it belongs to
  double length_ = 0, here_ = 0;  // of the curve; arc length for new copies
  bool closed_ = false;
  std::vector<Index> along_;
  std::vector<double> distance_;  // from the curve, per corner of a copy
  double near_ = HUGE_VAL;
  bool may_grow_ = false;
};

Strip::Index Strip::add(FaceId face) {
  poller_.add_work(kOfUnrolledFace);
  faces_.push_back(face);
  across_.insert(across_.end(), 3, kOpen);
  place_.push_back(here_);
  const auto copy = static_cast<Index>(faces_.size() - 1);
  for (Index side = 3 * copy; side < 3 * copy + 3; ++side) {
    const auto [last, is_first] = newest_.try_emplace(halfedge(side).index(), side);
    older_.push_back(is_first ? kOpen : std::exchange(last->second, side));
  }
  return copy;
}

std::size_t Strip::degree(VertexId v) const {
  std::size_t count = 0;
  const HalfedgeId first = surface_.halfedge(v);
  HalfedgeId h = first;
  do {
    if (!surface_.has_face(h)) break;
    ++count;
    h = surface_.turn_ccw(h);
  } while (h != first);
  return count;
}

Strip::Fan Strip::fan_at(Index corner) const {
  Fan fan{1, kOpen, kOpen};
  Index at = corner;
  while (across_[prev(at)] != kOpen) {  // counterclockwise, across the incoming side
    at = across_[prev(at)];
    if (at == corner) return fan;
    ++fan.count;
  }
  fan.counter = prev(at);
  at = corner;
  while (across_[at] != kOpen) {  // clockwise, across the outgoing side
    at = next(across_[at]);
    ++fan.count;
  }
  fan.clockwise = at;
  return fan;
}

/// Whether two open sides of one edge can be joined without more copies around an end of the edge
/// than the mesh has faces there.
bool Strip::may_join(Index a, Index b) const {
  const auto fits = [&](Index p, Index q) {  // corners at the same vertex
    const Fan one = fan_at(p), other = fan_at(q);
    const bool same = one.clockwise == other.clockwise;
    const std::size_t whole = degree(surface_.tail(halfedge(p)));
    return same ? one.count == whole : one.count + other.count <= whole;
  };
  return fits(a, next(b)) && fits(next(a), b);
}

/// Joins a side with the open side at the other end of the fan around its tail or head, if both are
/// sides of the same edge. Tells whether they were joined.
bool Strip::close_at(Index side, bool at_tail) {
  const Fan fan = fan_at(at_tail ? side : next(side));
  const Index other = at_tail ? fan.counter : fan.clockwise;
  if (other == kOpen || other == side || halfedge(other) != twin(halfedge(side))) return false;
  if (!may_join(side, other)) return false;
  glue(side, other);
  return true;
}

/// Joins a side with an open side of another copy if the ways from both back to the curve end near
/// each other on the curve. Such copies meet around a handle or a tube of the surface, not because
/// the curve comes back. Without this joining, a strip beside small handles would grow
/// exponentially with its reach. Tells whether sides were joined.
bool Strip::join_around_handle(Index side) {
  const HalfedgeId h = twin(halfedge(side));
  const auto found = newest_.find(h.index());
  if (found == newest_.end()) return false;
  const auto out = [&](Index at) { return std::min(distance_[at], distance_[next(at)]); };
  for (Index* link = &found->second; *link != kOpen;) {
    const Index other = *link;
    if (across_[other] != kOpen) {  // joined sides stay joined
      *link = older_[other];
      continue;
    }
    link = &older_[other];
    double apart = std::abs(place_[other / 3] - place_[side / 3]);
    if (closed_) apart = std::min(apart, length_ - apart);
    if (apart > out(side) + out(other) || !may_join(side, other)) continue;
    glue(side, other);
    return true;
  }
  return false;
}

/// The side across a side; adds a copy of the face there if none is joined. `at_tail`, `at_head`:
/// whether to try close_at() first. kOpen at the boundary.
Strip::Index Strip::cross(Index side, bool at_tail, bool at_head) {
  if (across_[side] != kOpen) return across_[side];
  const HalfedgeId h = twin(halfedge(side));
  if (!surface_.has_face(h)) return kOpen;
  if ((at_tail && close_at(side, true)) || (at_head && close_at(side, false))) return across_[side];
  const Index copy = add(surface_.face(h));
  glue(side, side_of(copy, h));
  return across_[side];
}

/// Goes from `copy` to a copy of face `to`, the shorter way around a point of both faces. Unless
/// `last` is kOpen, the way must end at copy `last`.
bool Strip::walk(const SurfacePoint& around, Index& copy, FaceId to, Index last) {
  const auto arrive = [&](Index side, bool at_tail) {  // across the last side
    const HalfedgeId h = twin(halfedge(side));
    if (last != kOpen && across_[side] == kOpen) {
      const Index other = side_of(last, h);
      if (across_[other] == kOpen) glue(side, other);
    }
    const Index there = last != kOpen ? across_[side] : cross(side, at_tail, !at_tail);
    if (there == kOpen) return false;
    copy = there / 3;
    return last == kOpen || copy == last;
  };
  if (faces_[copy] == to) return last == kOpen || copy == last;
  if (const auto* e = std::get_if<OnEdge>(&around.where())) {
    for (Index side = 3 * copy; side < 3 * copy + 3; ++side) {
      if (edge_of(halfedge(side)) == e->edge) return arrive(side, true);
    }
    return false;
  }
  const auto* v = std::get_if<AtVertex>(&around.where());
  if (v == nullptr) return false;
  Index corner = 3 * copy;
  while (surface_.tail(halfedge(corner)) != v->vertex) ++corner;
  // The number of faces up to `to`, counterclockwise or clockwise.
  const auto steps = [&](bool counter) {
    std::size_t count = 0;
    HalfedgeId h = halfedge(corner);
    for (const HalfedgeId first = h;;) {
      if (counter) {
        h = surface_.turn_ccw(h);
      } else {
        h = twin(h);
        if (surface_.has_face(h)) h = surface_.next(h);
      }
      ++count;
      if (!surface_.has_face(h) || h == first) return SIZE_MAX;
      if (surface_.face(h) == to) return count;
    }
  };
  const std::size_t left = steps(true), right = steps(false);
  if (left == SIZE_MAX && right == SIZE_MAX) return false;
  const bool counter = left <= right;
  for (std::size_t k = std::min(left, right); k > 0; --k) {
    const Index side = counter ? prev(corner) : corner;
    if (k == 1) return arrive(side, !counter);
    const Index there = cross(side, !counter, counter);
    if (there == kOpen) return false;
    corner = counter ? there : next(there);
  }
  return false;
}

/// Per segment, its face.
std::vector<FaceId> Strip::faces_along(const SurfaceCurve& curve) const {
  const std::size_t n = curve.points.size(), segments = n - (curve.closed ? 0 : 1);
  std::vector<FaceId> faces;
  for (std::size_t i = 0; i < segments; ++i) {
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    // Prefers the face of the previous segment.
    FaceId face = faces.empty() ? FaceId{} : faces.back();
    const auto has = [&](const SurfacePoint& point) {
      const std::vector<FaceId> at = faces_at(surface_, point);
      return std::find(at.begin(), at.end(), face) != at.end();
    };
    if (!face.valid() || !has(p) || !has(q)) face = common_face(surface_, p, q);
    faces.push_back(face);
  }
  return faces;
}

/// The arc length at the beginning of each segment; then the length of the curve.
std::vector<double> Strip::arcs_along(const SurfaceCurve& curve) const {
  const std::size_t n = curve.points.size(), segments = n - (curve.closed ? 0 : 1);
  std::vector<double> arcs{0};
  for (std::size_t i = 0; i < segments; ++i) {
    const SurfaceCurve segment{false, {curve.points[i], curve.points[(i + 1) % n]}};
    arcs.push_back(arcs.back() + curve_length(surface_, segment));
  }
  return arcs;
}

/// The segments where laying may start. A closed strip must start where the curve enters another
/// face. Closing fails at a face that the curve enters and leaves across the same edge, so several
/// segments, far apart, are returned.
std::vector<std::size_t> Strip::starts_of(const SurfaceCurve& curve,
                                          std::span<const FaceId> faces) {
  if (!curve.closed) return {0};
  constexpr std::size_t kMost = 16;
  std::vector<std::size_t> changes, starts;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[(i + faces.size() - 1) % faces.size()] != faces[i]) changes.push_back(i);
  }
  const std::size_t count = std::min(changes.size(), kMost);
  for (std::size_t k = 0; k < count; ++k) starts.push_back(changes[k * changes.size() / count]);
  return starts;
}

bool Strip::lay_from(const SurfaceCurve& curve, std::span<const FaceId> faces,
                     std::span<const double> arcs, std::size_t start) {
  const std::size_t segments = faces.size();
  faces_.clear();
  across_.clear();
  older_.clear();
  newest_.clear();
  place_.clear();
  here_ = arcs[start];
  along_.assign(segments, 0);
  Index copy = add(faces[start]);
  along_[start] = copy;
  for (std::size_t k = 1; k < segments; ++k) {
    const std::size_t i = (start + k) % segments;
    here_ = arcs[i];
    if (!walk(curve.points[i], copy, faces[i], kOpen)) return false;
    along_[i] = copy;
  }
  return !curve.closed || walk(curve.points[start], copy, faces[start], along_[start]);
}

bool Strip::lay_along(const SurfaceCurve& curve) {
  const std::vector<FaceId> faces = faces_along(curve);
  const std::vector<std::size_t> starts = starts_of(curve, faces);
  const std::vector<double> arcs = arcs_along(curve);
  closed_ = curve.closed;
  length_ = arcs.back();
  if (std::none_of(starts.begin(), starts.end(),
                   [&](std::size_t start) { return lay_from(curve, faces, arcs, start); })) {
    return false;
  }
  const std::size_t n = curve.points.size(), segments = faces.size();
  // Completes the faces around the curve's vertices, one vertex at a time.
  for (std::size_t i = 0; i < segments; ++i) {
    here_ = arcs[i];
    for (const std::size_t end : {i, (i + 1) % n}) {
      const auto* v = std::get_if<AtVertex>(&curve.points[end].where());
      for (Index corner = 3 * along_[i]; v != nullptr && corner < 3 * along_[i] + 3; ++corner) {
        if (surface_.tail(halfedge(corner)) == v->vertex) complete_around(corner);
      }
    }
  }
  return true;
}

void Strip::complete_around(Index corner) {
  const std::size_t whole = degree(surface_.tail(halfedge(corner)));
  for (;;) {
    const Fan fan = fan_at(corner);
    if (fan.clockwise == kOpen) return;
    if (fan.count >= whole) {
      close_at(fan.clockwise, true);
      return;
    }
    if (cross(fan.clockwise, true, false) == kOpen && cross(fan.counter, false, true) == kOpen) {
      return;
    }
  }
}

void Strip::grow(double reach) {
  // Around handles and holes a covering grows without end, and a face of a strip takes up to 2 KB,
  // hence the limits; nearer faces are added first.
  constexpr std::size_t kMost = 1'000'000;
  const std::size_t most =
      std::min(2 * surface_.face_count() + 32 * faces_.size(), std::max(kMost, 2 * faces_.size()));
  distance_.assign(3 * faces_.size(), 0.0);
  using Item = std::pair<double, Index>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  const auto push = [&](Index side) {
    if (across_[side] == kOpen) {
      queue.emplace(std::min(distance_[side], distance_[next(side)]), side);
    }
  };
  for (Index side = 0; side < across_.size(); ++side) push(side);
  while (!queue.empty()) {
    const auto [near, side] = queue.top();
    queue.pop();
    poller_.add_work(kOfUnrolledFace);
    if (across_[side] != kOpen || !surface_.has_face(twin(halfedge(side)))) continue;
    if (close_at(side, true) || close_at(side, false)) continue;
    const HalfedgeId h = halfedge(side);
    if (fan_at(side).count >= degree(surface_.tail(h)) ||
        fan_at(next(side)).count >= degree(surface_.head(h))) {
      continue;  // a copy here would turn around the vertex a second time
    }
    if (near > reach || faces_.size() >= most) {
      near_ = kStraighter * std::min(near, reach);
      may_grow_ = faces_.size() < most;
      break;
    }
    if (join_around_handle(side)) continue;
    here_ = place_[side / 3];
    const Index there = cross(side, false, false);
    distance_.resize(3 * faces_.size());
    const Index apex = prev(there);
    distance_[there] = distance_[next(side)];
    distance_[next(there)] = distance_[side];
    distance_[apex] =
        std::min(distance_[there] + surface_.length(edge_of(halfedge(apex))),
                 distance_[next(there)] + surface_.length(edge_of(halfedge(next(there)))));
    push(next(there));
    push(apex);
  }
}

/// Whether two triangles have a common directed side.
bool has_repeated_side(std::span<const Triangle> triangles) {
  std::vector<std::array<std::uint32_t, 2>> sides;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) sides.push_back({t[k], t[(k + 1) % 3]});
  }
  std::sort(sides.begin(), sides.end());
  return std::adjacent_find(sides.begin(), sides.end()) != sides.end();
}

/// Appends the copies of a strip, with one vertex per fan. False, without a change, if the strip is
/// not a valid mesh: a strip that turns around two neighbouring vertices more than once has several
/// edges between them.
bool append(const SurfaceMesh& mesh, const Strip& strip, UnrolledMesh& result) {
  const std::size_t vertices = result.vertex_of.size(), faces = result.face_of.size();
  const auto across = strip.across();
  constexpr std::uint32_t kNone = kOpen;
  std::vector<std::uint32_t> vertex(across.size(), kNone),
      fan;  // vertex per corner; corners of a fan
  const auto next = [](std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; };
  const auto prev = [](std::uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; };
  for (std::uint32_t corner = 0; corner < across.size(); ++corner) {
    if (vertex[corner] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(result.lists.points.size());
    const VertexId v = mesh.surface().corners(strip.faces()[corner / 3])[corner % 3];
    result.lists.points.push_back(mesh.point(v));
    result.vertex_of.push_back(v);
    fan.clear();
    std::uint32_t at = corner;
    do {  // counterclockwise
      fan.push_back(at);
      at = across[prev(at)];
    } while (at != kOpen && at != corner);
    for (std::uint32_t last = corner; at != corner && across[last] != kOpen;) {
      last = next(across[last]);
      fan.push_back(last);
    }
    for (const std::uint32_t each : fan) vertex[each] = id;
    result.at_cut.push_back(strip.is_at_cut(fan));
  }
  for (std::size_t copy = 0; copy < strip.faces().size(); ++copy) {
    result.lists.triangles.push_back(
        {vertex[3 * copy], vertex[3 * copy + 1], vertex[3 * copy + 2]});
    result.face_of.push_back(strip.faces()[copy]);
  }
  if (!has_repeated_side(std::span(result.lists.triangles).subspan(faces))) return true;
  result.lists.points.resize(vertices);
  result.vertex_of.resize(vertices);
  result.at_cut.resize(vertices);
  result.lists.triangles.resize(faces);
  result.face_of.resize(faces);
  return false;
}

void append_whole(const SurfaceMesh& mesh, UnrolledMesh& result) {
  const Surface& surface = mesh.surface();
  const auto first = static_cast<std::uint32_t>(result.lists.points.size());
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    result.lists.points.push_back(mesh.point(VertexId{v}));
    result.vertex_of.emplace_back(v);
  }
  result.at_cut.resize(result.vertex_of.size(), false);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    Triangle t{};
    const auto corners = surface.corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = first + static_cast<std::uint32_t>(corners[k].index());
    result.lists.triangles.push_back(t);
    result.face_of.emplace_back(f);
  }
}

/// Converts a point of one face to the same point of a copy of this face on another surface.
SurfacePoint moved(const Surface& from_surface, FaceId from_face, const SurfacePoint& point,
                   const Surface& to_surface, FaceId to_face) {
  if (const auto* inside = std::get_if<InFace>(&point.where())) {
    return SurfacePoint::in_face(to_surface, to_face, inside->barycentric);
  }
  HalfedgeId h = from_surface.halfedge(from_face), g = to_surface.halfedge(to_face);
  for (int k = 0; k < 3; ++k, h = from_surface.next(h), g = to_surface.next(g)) {
    if (const auto* v = std::get_if<AtVertex>(&point.where())) {
      if (from_surface.tail(h) == v->vertex) {
        return SurfacePoint::at_vertex(to_surface, to_surface.tail(g));
      }
    } else if (const auto& e = std::get<OnEdge>(point.where()); edge_of(h) == e.edge) {
      const bool same = (h == halfedge_of(edge_of(h))) == (g == halfedge_of(edge_of(g)));
      const double t = same ? e.t : 1 - e.t;
      if (t < 1) return SurfacePoint::on_edge(to_surface, edge_of(g), t);
      return SurfacePoint::at_vertex(to_surface, to_surface.head(halfedge_of(edge_of(g))));
    }
  }
  return SurfacePoint::in_face(to_surface, to_face,
                               {1, 0, 0});  // throws: the point is not in the face
}

}  // namespace

UnrolledMesh unroll(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                    const std::vector<bool>& alone, double reach, const Progress& progress) {
  ProgressPoller poller(progress, "solve");
  const Surface& surface = mesh.surface();
  UnrolledMesh result;
  result.curves.resize(curves.size());
  std::vector<std::size_t> together;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    Strip strip(surface, poller);
    const std::size_t first = result.face_of.size();
    const auto is_laid = [&] {
      if (!strip.lay_along(curves[c])) return false;
      strip.grow(reach);
      poller.poll();
      return append(mesh, strip, result);
    };
    if (!alone[c] || !is_laid()) {
      together.push_back(c);
      continue;
    }
    result.near = std::min(result.near, strip.near());
    result.may_grow = result.may_grow || strip.may_grow();
    result.faces_of_strips = result.face_of.size();
    const auto along = strip.copies_along();
    for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
      const std::size_t copy = along[std::min(i, along.size() - 1)];
      result.curves[c].push_back({FaceId{first + copy}, curves[c].points[i]});
    }
  }
  if (together.empty()) return result;
  poller.poll();
  const std::size_t first = result.face_of.size();
  append_whole(mesh, result);
  for (const std::size_t c : together) {
    for (const SurfacePoint& point : curves[c].points) {
      result.curves[c].push_back({FaceId{first + any_face(surface, point).index()}, point});
    }
  }
  return result;
}

std::vector<SurfaceCurve> UnrolledMesh::unrolled(const SurfaceMesh& from, const Surface& copies,
                                                 std::span<const SurfaceCurve> drawn) const {
  std::vector<SurfaceCurve> result;
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    SurfaceCurve& curve = result.emplace_back();
    curve.closed = drawn[c].closed;
    for (const Place& place : curves[c]) {
      curve.points.push_back(
          moved(from.surface(), face_of[place.face.index()], place.point, copies, place.face));
    }
  }
  return result;
}

SurfaceCurve UnrolledMesh::folded(const Surface& copies, const Surface& original,
                                  const SurfaceCurve& curve) const {
  SurfaceCurve result{curve.closed, {}};
  for (const SurfacePoint& point : curve.points) {
    const FaceId face = any_face(copies, point);
    result.points.push_back(moved(copies, face, point, original, face_of[face.index()]));
  }
  return result;
}

}  // namespace talweg
