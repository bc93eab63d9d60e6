#include "talweg/core/offset/distance_isoline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "talweg/core/offset/level_crossings.hpp"

namespace talweg {
namespace {

constexpr double kOntoVertex = 1e-9;  // of an edge

/// Nodes of isolines on edges and in faces, linked to their successors.
struct LevelNodes {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::vector<SurfacePoint> points;
  std::vector<std::uint32_t> next;
  std::vector<char> has_last;
  std::vector<FaceId> faces;  // of the chord to the successor, or else from the predecessor

  std::uint32_t add(const SurfacePoint& point) {
    points.push_back(point);
    next.push_back(kNone);
    has_last.push_back(0);
    faces.emplace_back();
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  void join(std::uint32_t from, std::uint32_t to, FaceId face) {
    next[from] = to;
    has_last[to] = 1;
    faces[from] = face;
    if (!faces[to].valid()) faces[to] = face;
  }
};

class IsolineTracer {
 public:
  IsolineTracer(const Surface& surface, PolylineDistance& distance, const LevelChoice& choice)
      : surface_(surface),
        distance_(distance),
        choice_(choice),
        beyond_(choice.level + 4 * choice.tolerance),
        known_(surface.edge_count(), LevelNodes::kNone),
        visited_(surface.face_count(), 0) {}

  std::vector<LevelCurve> trace(std::span<const SurfaceCurve> curves);

 private:
  struct EdgeCrossings {
    std::vector<double> parts;  // fractions of the edge, from the tail of halfedge_of(edge)
    std::uint32_t first = 0;    // node of the first crossing; the other nodes follow
    bool passable = false;      // whether a point of the edge is within the level
  };

  [[nodiscard]] double at_vertex(VertexId v) const {
    return distance_.below(std::nextafter(choice_.level, HUGE_VAL),
                           SurfacePoint::at_vertex(surface_, v));
  }
  const EdgeCrossings& crossings(EdgeId edge);
  void visit(FaceId face);
  void look_into(FaceId face);
  [[nodiscard]] bool is_near_throughout(FaceId face) const;
  LevelCurve follow(std::uint32_t first, bool closed);

  const Surface& surface_;
  PolylineDistance& distance_;
  LevelChoice choice_;
  double beyond_;
  std::vector<std::uint32_t> known_;  // per edge, its index in edges_
  std::vector<EdgeCrossings> edges_;
  std::vector<char> visited_;  // per face
  std::vector<FaceId> open_;
  LevelNodes nodes_;
};

const IsolineTracer::EdgeCrossings& IsolineTracer::crossings(EdgeId edge) {
  std::uint32_t& known = known_[edge.index()];
  if (known != LevelNodes::kNone) return edges_[known];
  known = static_cast<std::uint32_t>(edges_.size());
  EdgeCrossings& made = edges_.emplace_back();
  const HalfedgeId h = halfedge_of(edge);
  const double length = surface_.length(edge);
  const std::vector<Stretch> near = distance_.within(edge, choice_.level);
  const bool tail = std::isfinite(at_vertex(surface_.tail(h)));
  const bool head = std::isfinite(at_vertex(surface_.head(h)));
  made.passable = !near.empty() || tail || head;
  made.first = static_cast<std::uint32_t>(nodes_.points.size());
  for (const double x : level_crossings(near, length, tail, head)) {
    const double t = length > 0 ? x / length : x > 0 ? 1.0 : 0.0;
    made.parts.push_back(t);
    nodes_.add(t < kOntoVertex       ? SurfacePoint::at_vertex(surface_, surface_.tail(h))
               : t > 1 - kOntoVertex ? SurfacePoint::at_vertex(surface_, surface_.head(h))
                                     : SurfacePoint::on_edge(surface_, edge, t));
  }
  return made;
}

void IsolineTracer::visit(FaceId face) {
  if (!face.valid() || visited_[face.index()] != 0) return;
  visited_[face.index()] = 1;
  open_.push_back(face);
}

/// Whether the whole face is nearer than the level. The distance in a face is at most the distance
/// of a corner plus the longest edge.
bool IsolineTracer::is_near_throughout(FaceId face) const {
  double longest = 0, least = HUGE_VAL;
  HalfedgeId h = surface_.halfedge(face);
  for (int k = 0; k < 3; ++k, h = surface_.next(h)) {
    longest = std::max(longest, surface_.length(edge_of(h)));
    least = std::min(least, at_vertex(surface_.tail(h)));
  }
  return least + longest < choice_.level;
}

void IsolineTracer::look_into(FaceId face) {
  FaceRim rim;
  std::vector<std::uint32_t> outer;  // numbers of the rim's nodes in nodes_
  HalfedgeId h = surface_.halfedge(face);
  for (std::size_t k = 0; k < 3; ++k, h = surface_.next(h)) {
    const EdgeCrossings& edge = crossings(edge_of(h));
    rim.near[k] = std::isfinite(at_vertex(surface_.tail(h)));
    const bool own = h == halfedge_of(edge_of(h));
    const auto n = static_cast<std::uint32_t>(edge.parts.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t at = own ? i : n - 1 - i;
      rim.crossings[k].push_back(own ? edge.parts[at] : 1 - edge.parts[at]);
      outer.push_back(edge.first + at);
    }
    if (edge.passable) visit(surface_.face(twin(h)));
  }
  if (outer.empty() && is_near_throughout(face)) return;
  const FaceLevel level = level_in_face(distance_.paths_into(face, beyond_), rim, choice_);
  std::vector<std::uint32_t> all = outer;
  for (std::size_t i = outer.size(); i < level.nodes.size(); ++i) {
    all.push_back(
        nodes_.add(SurfacePoint::from_barycentric(surface_, face, level.nodes[i], kOntoVertex)));
  }
  for (const FaceLevel::Chord& chord : level.chords) {
    nodes_.join(all[chord.from], all[chord.to], face);
  }
}

/// Follows the nodes from `first`. Equal consecutive points are merged.
LevelCurve IsolineTracer::follow(std::uint32_t first, bool closed) {
  LevelCurve curve;
  curve.closed = closed;
  for (std::uint32_t i = first; i != LevelNodes::kNone;) {
    const std::uint32_t here = i;
    i = std::exchange(nodes_.next[here], LevelNodes::kNone);
    if (!curve.points.empty() && curve.points.back() == nodes_.points[here]) {
      curve.faces.back() = nodes_.faces[here];
    } else {
      curve.points.push_back(nodes_.points[here]);
      curve.faces.push_back(nodes_.faces[here]);
    }
    if (closed && i == first) break;
  }
  while (closed && curve.points.size() > 1 && curve.points.back() == curve.points.front()) {
    curve.points.pop_back();
    curve.faces.pop_back();
  }
  return curve;
}

std::vector<LevelCurve> IsolineTracer::trace(std::span<const SurfaceCurve> curves) {
  for (const SurfaceCurve& curve : curves) {
    for (const SurfacePoint& point : curve.points) {
      for (const FaceId face : faces_at(surface_, point)) visit(face);
    }
  }
  while (!open_.empty()) {
    const FaceId face = open_.back();
    open_.pop_back();
    look_into(face);
  }
  std::vector<LevelCurve> found;
  for (const bool closed : {false, true}) {
    for (std::uint32_t i = 0; i < nodes_.points.size(); ++i) {
      if (nodes_.next[i] == LevelNodes::kNone || (nodes_.has_last[i] != 0) != closed) continue;
      LevelCurve curve = follow(i, closed);
      if (curve.points.size() > (closed ? 2U : 1U)) found.push_back(std::move(curve));
    }
  }
  return found;
}

}  // namespace

std::vector<LevelCurve> distance_isoline(const Surface& surface,
                                         std::span<const SurfaceCurve> curves,
                                         PolylineDistance& distance, const LevelChoice& choice) {
  constexpr double kBeyond = 1e-11;
  const LevelChoice beyond{choice.level * (1 + kBeyond), choice.tolerance};
  return IsolineTracer(surface, distance, beyond).trace(curves);
}

}  // namespace talweg
