#include "talweg/intrinsic/flips/point_insertion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr double kOnSide = FlatFlips::kOnSide;  // relative to a piece's extent

using Weights = std::array<double, 3>;

Weights mix(const Weights& a, const Weights& b, double t) {
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

/// The parameter in [0, 1] of a point's projection to the segment from a to b. The point's weights
/// in a piece would give the same, but are inaccurate in a sliver.
double part_along(const Weights& a, const Weights& b, const Weights& point) {
  double along = 0, whole = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (point[k] - a[k]) * (b[k] - a[k]);
    whole += (b[k] - a[k]) * (b[k] - a[k]);
  }
  return whole > 0 ? std::clamp(along / whole, 0.0, 1.0) : 0;
}

}  // namespace

std::vector<HalfedgeId>& PointInsertion::pieces(FaceId face) {
  std::vector<HalfedgeId>& list = pieces_[face];
  if (list.empty()) {
    list.push_back(triangulation_->surface().halfedge(face));
    slot_[list.front()] = 0;
  }
  return list;
}

Weights PointInsertion::barycentric(VertexId v, FaceId face) const {
  return weights_in(*triangulation_, v, face);
}

/// The point's weights in the piece of this side, whether the point is inside or not; no place if
/// the piece has no area.
PointInsertion::Place PointInsertion::place_in(HalfedgeId side, FaceId face,
                                               const Weights& point) const {
  const Weights a = barycentric(triangulation_->tail(side), face);
  const Weights b = barycentric(triangulation_->tail(triangulation_->next(side)), face);
  const Weights c = barycentric(triangulation_->tail(triangulation_->prev(side)), face);
  const double area = orient(a, b, c);
  if (!(area > 0)) return {};
  return {side,
          {orient(point, b, c) / area, orient(a, point, c) / area, orient(a, b, point) / area}};
}

PointInsertion::Place PointInsertion::locate(FaceId face, const Weights& point) {
  if (crowded_.contains(face)) {
    if (const Place place = walk(face, point); place.side.valid()) return place;
  }
  Place best;
  double best_margin = -std::numeric_limits<double>::infinity();
  for (const HalfedgeId side : pieces(face)) {
    const Place place = place_in(side, face, point);
    if (!place.side.valid()) continue;
    const double margin = std::min({place.weight[0], place.weight[1], place.weight[2]});
    if (margin > best_margin) {
      best_margin = margin;
      best = place;
    }
  }
  return best;
}

/// Walks from the newest piece, because points come in the order of a drawing. A walk over Delaunay
/// pieces ends in exact arithmetic; the limit guards against rounding.
PointInsertion::Place PointInsertion::walk(FaceId face, const Weights& point) {
  const SignpostTriangulation& t = *triangulation_;
  HalfedgeId at = pieces(face).back();
  for (std::size_t left = pieces(face).size(); left > 0; --left) {
    const Place place = place_in(at, face, point);
    if (!place.side.valid()) return {};
    const auto least = std::min_element(place.weight.begin(), place.weight.end());
    if (*least >= 0) return place;
    const std::array<HalfedgeId, 3> opposite = {t.next(at), t.prev(at), at};
    const HalfedgeId side = opposite[static_cast<std::size_t>(least - place.weight.begin())];
    if (!flips_.is_inside(side)) return {};
    at = twin(side);
  }
  return {};
}

/// Makes the pieces around the new vertex Delaunay in faces with many inserted points.
void PointInsertion::improve_around(VertexId v) {
  const SignpostTriangulation& t = *triangulation_;
  std::vector<HalfedgeId> edges;
  const HalfedgeId first = t.halfedge(v);
  HalfedgeId h = first;
  do {
    if (t.has_face(h)) {
      const FaceId face = t.surface_face(h);
      const std::vector<HalfedgeId>& list = pieces(face);
      if (list.size() > kMostUnflippedPieces && crowded_.insert(face).second) {
        for (const HalfedgeId side : list)
          edges.insert(edges.end(), {side, t.next(side), t.prev(side)});
      } else if (list.size() > kMostUnflippedPieces) {
        edges.insert(edges.end(), {h, t.next(h)});
      }
    }
    if (!t.has_face(h)) break;
    h = t.turn_ccw(h);
  } while (h != first);
  flips_.improve(std::move(edges));
}

/// Registers both pieces under the edge that will be flipped, so they keep their slots in the list.
void PointInsertion::before_flip(HalfedgeId h) {
  const FaceId face = triangulation_->surface_face(h);
  for (const HalfedgeId side : {h, twin(h)}) replace_pieces(face, side, std::span(&side, 1));
}

/// The vertex of the face that is nearest to the point, for a face in which every piece is a
/// sliver.
VertexId PointInsertion::nearest_vertex(FaceId face, const Weights& point) {
  const SignpostTriangulation& t = *triangulation_;
  VertexId best;
  double least = std::numeric_limits<double>::infinity();
  for (const HalfedgeId piece : pieces(face)) {
    for (const HalfedgeId side : {piece, t.next(piece), t.prev(piece)}) {
      const Weights at = barycentric(t.tail(side), face);
      const double apart = std::hypot(at[0] - point[0], at[1] - point[1], at[2] - point[2]);
      if (!(apart < least)) continue;
      least = apart;
      best = t.tail(side);
    }
  }
  return best;
}

double PointInsertion::distance(VertexId v, FaceId face, const Weights& point) const {
  return distance_in_face(triangulation_->surface(), {face, barycentric(v, face)}, {face, point});
}

void PointInsertion::replace_pieces(FaceId face, HalfedgeId old,
                                    std::span<const HalfedgeId> fresh) {
  std::vector<HalfedgeId>& list = pieces(face);
  auto known = slot_.find(old);
  if (known == slot_.end()) known = slot_.find(triangulation_->next(old));
  if (known == slot_.end()) known = slot_.find(triangulation_->prev(old));
  assert(known != slot_.end());
  const std::size_t slot = known->second;
  slot_.erase(known);
  list[slot] = fresh[0];
  slot_[fresh[0]] = slot;
  for (const HalfedgeId side : fresh.subspan(1)) {
    slot_[side] = list.size();
    list.push_back(side);
  }
}

VertexId PointInsertion::insert(const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) return v->vertex;
  const std::size_t before = triangulation_->vertex_count();
  const VertexId v = insert_new(point);
  if (triangulation_->vertex_count() > before) improve_around(v);
  return v;
}

VertexId PointInsertion::insert_new(const SurfacePoint& point) {
  const Surface& surface = triangulation_->surface();
  if (std::holds_alternative<OnEdge>(point.where())) return insert_on_edge(point);
  const FaceId face = any_face(surface, point);
  const Weights weights = coordinates_in(surface, point, face).barycentric;
  Place place = locate(face, weights);
  if (!place.side.valid()) return nearest_vertex(face, weights);

  std::array<HalfedgeId, 3> side = {place.side, triangulation_->next(place.side),
                                    triangulation_->prev(place.side)};
  std::array<bool, 3> zero{};
  for (std::size_t k = 0; k < 3; ++k) zero[k] = place.weight[k] <= kOnSide;
  for (std::size_t k = 0; k < 3; ++k) {
    if (zero[(k + 1) % 3] && zero[(k + 2) % 3]) return triangulation_->tail(side[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (!zero[k]) continue;
    const HalfedgeId on = side[(k + 1) % 3];
    const VertexId tail = triangulation_->tail(on), head = triangulation_->head(on);
    const double t = part_along(barycentric(tail, face), barycentric(head, face), weights);
    if (!(t > kOnSide)) return tail;
    if (!(t < 1 - kOnSide)) return head;
    return insert_on_side(on, t, &point);
  }

  std::array<double, 3> lengths{};
  for (std::size_t k = 0; k < 3; ++k) {
    lengths[k] = distance(triangulation_->tail(side[k]), face, weights);
  }
  replace_pieces(face, side[0], side);  // each side bounds one of the new pieces
  return triangulation_->split_face(side[0], lengths, point);
}

/// Considers only the pieces along the edge. Among slivers, a vertex inside one of the two faces
/// may be as near, but that vertex is not in the other face, where the curve may continue.
VertexId PointInsertion::insert_on_edge(const SurfacePoint& point) {
  const OnEdge& at = std::get<OnEdge>(point.where());
  const HalfedgeId whole = halfedge_of(at.edge);
  const VertexId begin = triangulation_->surface().tail(whole);
  const auto parameter = [&](VertexId v) {
    const SurfacePoint where = triangulation_->location(v);
    if (const auto* e = std::get_if<OnEdge>(&where.where())) return e->t;
    return std::get<AtVertex>(where.where()).vertex == begin ? 0.0 : 1.0;
  };
  const std::vector<HalfedgeId> chain = with_splits(std::span(&whole, 1), 0);
  const auto piece = std::find_if(chain.begin(), chain.end() - 1, [&](HalfedgeId h) {
    return at.t <= parameter(triangulation_->head(h));
  });
  const double from = parameter(triangulation_->tail(*piece));
  const double t = (at.t - from) / (parameter(triangulation_->head(*piece)) - from);
  if (!(t > kOnSide)) return triangulation_->tail(*piece);
  if (!(t < 1 - kOnSide)) return triangulation_->head(*piece);
  return insert_on_side(*piece, t, &point);
}

VertexId PointInsertion::insert_on_side(HalfedgeId side, double t, const SurfacePoint* exact) {
  if (!triangulation_->has_face(side)) {
    side = twin(side);
    t = 1 - t;
  }
  const Surface& surface = triangulation_->surface();
  const HalfedgeId other = twin(side);
  const FaceId left = triangulation_->surface_face(side);
  // The location lies exactly on the side, so a point of a mesh edge belongs to both faces.
  const bool inner = triangulation_->has_face(other) && triangulation_->surface_face(other) == left;
  const bool keep = exact != nullptr && (inner || std::holds_alternative<OnEdge>(exact->where()));
  const SurfacePoint location =
      keep ? *exact
           : SurfacePoint::from_barycentric(surface, left,
                                            mix(barycentric(triangulation_->tail(side), left),
                                                barycentric(triangulation_->head(side), left), t));
  const double whole = triangulation_->surface_length(edge_of(side));
  SignpostTriangulation::EdgeSplit split{t * whole, (1 - t) * whole, 0, 0};
  split.to_left = distance(triangulation_->tail(triangulation_->prev(side)), left,
                           coordinates_in(surface, location, left).barycentric);
  const HalfedgeId left_next = triangulation_->next(side);
  const HalfedgeId left_prev = triangulation_->prev(side);
  HalfedgeId right_next, right_prev;
  FaceId right;
  pieces(left);
  if (triangulation_->has_face(other)) {
    right = triangulation_->surface_face(other);
    right_next = triangulation_->next(other);
    right_prev = triangulation_->prev(other);
    pieces(right);
    split.to_right = distance(triangulation_->tail(right_prev), right,
                              coordinates_in(surface, location, right).barycentric);
  }
  // The pieces are replaced before the split, while any of their sides still leads to them.
  const std::array<HalfedgeId, 2> fresh_left = {left_prev, left_next};
  replace_pieces(left, side, fresh_left);
  if (right.valid()) {
    const std::array<HalfedgeId, 2> fresh_right = {right_next, right_prev};
    replace_pieces(right, other, fresh_right);
  }
  const VertexId middle = triangulation_->split_edge(side, split, location);
  const HalfedgeId rest = triangulation_->next(twin(triangulation_->next(side)));
  splits_[edge_of(side)].push_back({split_count_++, side, rest});
  if (flips_.is_fixed(edge_of(side))) flips_.fix(edge_of(rest));
  return middle;
}

/// The straight edge from the tail of h towards `to`, made by flips: to the next vertex on the
/// segment, or to its crossing with another segment. The segment starts in the piece of h. Invalid
/// if the segment crosses no edge or rounding prevents the flips.
HalfedgeId PointInsertion::clear_segment(HalfedgeId h, VertexId to, FaceId face) {
  const VertexId from = triangulation_->tail(h);
  const FlatFlips::Segment segment = flips_.segment(h, to, face);
  if (segment.crossed.empty()) return {};
  VertexId end = segment.end;
  if (!end.valid() && segment.stop.valid()) end = insert_on_side(segment.stop, segment.part);
  return end.valid() ? flips_.clear(segment, from, end, face) : HalfedgeId{};
}

/// The halfedge from `from` towards `to` inside the face; inserts its end if necessary.
HalfedgeId PointInsertion::step(VertexId from, VertexId to, FaceId face, bool may_flip) {
  SignpostTriangulation& t = *triangulation_;
  const Weights p = barycentric(from, face), q = barycentric(to, face);
  const HalfedgeId first = t.halfedge(from);
  HalfedgeId h = first;
  do {
    const bool left_inside = t.has_face(h) && t.surface_face(h) == face;
    const bool right_inside = t.has_face(twin(h)) && t.surface_face(twin(h)) == face;
    if ((left_inside || right_inside) && t.head(h) == to) return h;
    if (left_inside) {
      const Weights b = barycentric(t.head(h), face);
      const Weights c = barycentric(t.head(t.next(h)), face);
      const double right_of = orient(p, b, q), left_of = orient(p, q, c);
      const double size = orient(p, b, c);
      // The piece whose two sides at `from` enclose the direction to `to`.
      if (right_of >= -kOnSide * size && left_of >= -kOnSide * size && right_of + left_of > 0 &&
          orient(b, c, q) <= kOnSide * size) {
        if (right_of <= kOnSide * (right_of + left_of)) return h;
        if (left_of <= kOnSide * (right_of + left_of)) return twin(t.prev(h));
        if (may_flip && crowded_.contains(face)) {
          const HalfedgeId edge = clear_segment(h, to, face);
          return edge.valid() ? edge : step(from, to, face, false);
        }
        return t.find_halfedge(from, insert_on_side(t.next(h), right_of / (right_of + left_of)));
      }
    }
    if (!t.has_face(h)) break;
    h = t.turn_ccw(h);
  } while (h != first);
  return {};
}

void PointInsertion::connect(VertexId from, VertexId to, std::vector<HalfedgeId>& path) {
  const std::size_t own = triangulation_->surface().vertex_count();
  if (from.index() < own && to.index() < own) {  // the common case: an edge of the surface
    if (const HalfedgeId h = triangulation_->find_halfedge(from, to); h.valid()) {
      path.push_back(h);
      return;
    }
  }
  const SurfacePoint p = triangulation_->location(from), q = triangulation_->location(to);
  const FaceId face = common_face(triangulation_->surface(), p, q);
  if (!face.valid()) {
    throw Error(ErrorCode::kBadCurve,
                "Two consecutive points of the curve do not lie in a common face.");
  }
  // A straight segment meets each piece of the face at most once.
  for (std::size_t left = pieces(face).size() + 2; from != to && left > 0; --left) {
    const HalfedgeId h = step(from, to, face);
    if (!h.valid()) break;
    path.push_back(h);
    flips_.fix(edge_of(h));
    from = triangulation_->head(h);
  }
  if (from != to) go_along_edges(from, to, face, path);
}

/// Appends the shortest path along the edges inside the face. A path always exists, because the
/// pieces of a face form a disc.
void PointInsertion::go_along_edges(VertexId from, VertexId to, FaceId face,
                                    std::vector<HalfedgeId>& path) {
  const SignpostTriangulation& t = *triangulation_;
  const auto inside = [&](HalfedgeId h) { return t.has_face(h) && t.surface_face(h) == face; };
  struct Reached {
    double distance = 0;
    HalfedgeId by;
  };
  std::map<VertexId, Reached> reached;
  std::set<std::pair<double, VertexId>> front;
  reached[from] = {};
  front.emplace(0, from);
  while (!front.empty()) {
    const auto [distance, at] = *front.begin();
    if (at == to) break;
    front.erase(front.begin());
    const HalfedgeId first = t.halfedge(at);
    HalfedgeId h = first;
    do {
      if (inside(h) || inside(twin(h))) {
        const double way = distance + t.surface_length(edge_of(h));
        const auto [known, fresh] = reached.try_emplace(t.head(h), Reached{way, h});
        if (fresh || way < known->second.distance) {
          if (!fresh) front.erase({known->second.distance, t.head(h)});
          known->second = {way, h};
          front.emplace(way, t.head(h));
        }
      }
      if (!t.has_face(h)) break;
      h = t.turn_ccw(h);
    } while (h != first);
  }
  if (!reached.contains(to)) {
    throw Error(ErrorCode::kBadCurve, "The curve cannot be inserted in face " +
                                          std::to_string(face.index()) +
                                          ": the pieces of the face are not connected.");
  }
  const auto first = static_cast<std::ptrdiff_t>(path.size());
  for (VertexId at = to; at != from; at = t.tail(path.back())) {
    path.push_back(reached[at].by);
    flips_.fix(edge_of(path.back()));
  }
  std::reverse(path.begin() + first, path.end());
}

void PointInsertion::append_with_splits(HalfedgeId h, std::size_t since,
                                        std::vector<HalfedgeId>& path) const {
  const auto splits = splits_.find(edge_of(h));
  if (splits != splits_.end()) {
    for (const Split& split : splits->second) {
      if (split.number < since) continue;
      const bool same = split.first == h;
      append_with_splits(same ? h : twin(split.second), split.number + 1, path);
      append_with_splits(same ? split.second : h, split.number + 1, path);
      return;
    }
  }
  path.push_back(h);
}

std::vector<HalfedgeId> PointInsertion::with_splits(std::span<const HalfedgeId> path,
                                                    std::size_t since) const {
  std::vector<HalfedgeId> result;
  for (const HalfedgeId h : path) append_with_splits(h, since, result);
  return result;
}

}  // namespace talweg
