#include "talweg/core/cutting/cut_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "talweg/core/cutting/face_triangulation.hpp"
#include "talweg/core/cutting/mixed_order.hpp"
#include "talweg/core/cutting/point_merging.hpp"
#include "talweg/core/cutting/vertex_origin.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"

namespace talweg {
namespace {

/// A point of a curve, and the vertex that it becomes.
struct Placed {
  SurfacePoint point;
  std::uint32_t vertex = 0;
};
/// The number of a curve, and the number of a point or segment of this curve.
using Where = std::pair<std::size_t, std::size_t>;

/// Whether the surface has the element of a point. A curve of another mesh may have elements
/// beyond.
bool is_on(const Surface& surface, const SurfacePoint& point) {
  if (const auto* v = std::get_if<AtVertex>(&point.where())) {
    return v->vertex.index() < surface.vertex_count();
  }
  if (const auto* e = std::get_if<OnEdge>(&point.where())) {
    return e->edge.index() < surface.edge_count();
  }
  return std::get<InFace>(point.where()).face.index() < surface.face_count();
}

class Planner {
 public:
  Planner(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves, const CutOptions& options,
          const Progress& progress)
      : mesh_(mesh),
        surface_(mesh.surface()),
        curves_(curves),
        merging_(surface_, options.merge, options.resolution),
        poller_(progress, "cut") {
    plan_.old_vertices = surface_.vertex_count();
  }
  CutPlan run();

 private:
  struct OnOneEdge {
    double t = 0;
    std::uint32_t vertex = 0;
  };
  struct Segment {
    FaceId face;  // invalid if the segment runs along an edge
    std::uint32_t from = 0, to = 0;
    Where where;
  };
  using Chains = std::map<Where, std::vector<std::uint32_t>>;  // inner vertices, per segment

  void settle();
  std::uint32_t add(const SurfacePoint& point);
  void place_on_edges(std::vector<std::pair<OnEdge, Where>>& points);
  void place_in_faces(std::vector<std::pair<InFace, Where>>& points);
  void find_segments();
  [[nodiscard]] EdgeId edge_of_both(const SurfacePoint& p, const SurfacePoint& q) const;
  void go_along(EdgeId edge, const Placed& from, const Placed& to, const Where& where);
  [[nodiscard]] std::vector<FaceId> touched_faces() const;
  [[nodiscard]] std::vector<std::pair<FaceTriangulation::Place, std::uint32_t>> places_in(
      FaceId face) const;
  void cut_up(FaceId face);
  void cut_up_touched();
  void collect_chains();
  void collect_faces();
  /// The place of a new vertex inside a face.
  [[nodiscard]] const InFace& face_point(std::uint32_t v) const {
    return std::get<InFace>(plan_.vertex_from[v - plan_.old_vertices].where());
  }

  const SurfaceMesh& mesh_;
  const Surface& surface_;
  std::span<const SurfaceCurve> curves_;
  PointMerging merging_;
  ProgressPoller poller_;
  CutPlan plan_;
  std::vector<std::vector<Placed>> placed_;                // per curve
  std::map<EdgeId, std::vector<OnOneEdge>> on_edges_;      // per edge, by t
  std::map<FaceId, std::vector<std::uint32_t>> in_faces_;  // new vertices, per face
  std::map<FaceId, std::vector<Segment>> segments_;        // per face
  std::map<std::uint32_t, std::vector<Triangle>> parts_;   // per old face, its triangles
  Chains between_;
};

std::uint32_t Planner::add(const SurfacePoint& point) {
  plan_.vertex_from.push_back(point);
  plan_.points.push_back(mesh_.position(point));
  return static_cast<std::uint32_t>(plan_.old_vertices + plan_.points.size() - 1);
}

/// Merges points that lie together, and gives every point a vertex.
void Planner::settle() {
  std::vector<std::pair<OnEdge, Where>> on_edges;
  std::vector<std::pair<InFace, Where>> in_faces;
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    std::vector<Placed>& placed = placed_.emplace_back();
    for (const SurfacePoint& point : curves_[c].points) {
      const SurfacePoint at = merging_.settled(point);
      if (!(at == point)) {
        ++plan_.merged;
        plan_.largest_move =
            std::max(plan_.largest_move, (mesh_.position(at) - mesh_.position(point)).norm());
      }
      const Where where{c, placed.size()};
      placed.push_back({at, 0});
      if (const auto* v = std::get_if<AtVertex>(&at.where())) {
        placed.back().vertex = static_cast<std::uint32_t>(v->vertex.index());
      } else if (const auto* e = std::get_if<OnEdge>(&at.where())) {
        on_edges.emplace_back(*e, where);
      } else {
        in_faces.emplace_back(std::get<InFace>(at.where()), where);
      }
    }
  }
  place_on_edges(on_edges);
  place_in_faces(in_faces);
}

void Planner::place_on_edges(std::vector<std::pair<OnEdge, Where>>& points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    if (a.first.edge != b.first.edge) return a.first.edge < b.first.edge;
    return a.first.t != b.first.t ? a.first.t < b.first.t : a.second < b.second;
  });
  for (const auto& [at, where] : points) {
    std::vector<OnOneEdge>& there = on_edges_[at.edge];
    if (there.empty() || at.t - there.back().t > merging_.on(at.edge)) {
      there.push_back({at.t, add(SurfacePoint::on_edge(surface_, at.edge, at.t))});
    }
    placed_[where.first][where.second].vertex = there.back().vertex;
  }
}

/// Points that are merged lie in the same or in neighbouring cells of a grid over their face.
void Planner::place_in_faces(std::vector<std::pair<InFace, Where>>& points) {
  using Cell = std::tuple<FaceId, std::int64_t, std::int64_t>;
  std::map<Cell, std::vector<std::uint32_t>> cells;
  for (const auto& [at, where] : points) {
    const std::array<double, 3> reach = merging_.in(at.face);
    const auto cell = [&, in = &at](std::size_t k) {
      constexpr double kWider = 1.001;  // rounding then puts no merged point two cells away
      return static_cast<std::int64_t>(std::floor(in->barycentric[k] / (kWider * reach[k])));
    };
    const std::int64_t x = cell(1), y = cell(2);
    std::uint32_t& vertex = placed_[where.first][where.second].vertex;
    std::uint32_t same = kNoVertex;  // the smallest vertex within reach
    for (std::int64_t i = x - 1; i <= x + 1; ++i) {
      for (std::int64_t k = y - 1; k <= y + 1; ++k) {
        const auto there = cells.find({at.face, i, k});
        if (there == cells.end()) continue;
        for (const std::uint32_t v : there->second) {
          if (v < same && merging_.same(face_point(v), at)) same = v;
        }
      }
    }
    if (same == kNoVertex) {
      same = add(placed_[where.first][where.second].point);
      in_faces_[at.face].push_back(same);
      cells[{at.face, x, y}].push_back(same);
    }
    vertex = same;
  }
}

/// The edge with both points, its ends included; invalid if there is none.
EdgeId Planner::edge_of_both(const SurfacePoint& p, const SurfacePoint& q) const {
  const auto *v = std::get_if<AtVertex>(&p.where()), *w = std::get_if<AtVertex>(&q.where());
  if (v != nullptr && w != nullptr) {
    const HalfedgeId h = surface_.find_halfedge(v->vertex, w->vertex);
    return h.valid() ? edge_of(h) : EdgeId{};
  }
  const auto *e = std::get_if<OnEdge>(&p.where()), *f = std::get_if<OnEdge>(&q.where());
  if (e != nullptr && f != nullptr) return e->edge == f->edge ? e->edge : EdgeId{};
  const OnEdge* edge = e != nullptr ? e : f;
  const AtVertex* vertex = v != nullptr ? v : w;
  if (edge == nullptr || vertex == nullptr) return {};
  const HalfedgeId h = halfedge_of(edge->edge);
  const bool meets = surface_.tail(h) == vertex->vertex || surface_.head(h) == vertex->vertex;
  return meets ? edge->edge : EdgeId{};
}

void Planner::go_along(EdgeId edge, const Placed& from, const Placed& to, const Where& where) {
  const auto place = [&](const Placed& placed) {
    if (const auto* e = std::get_if<OnEdge>(&placed.point.where())) return e->t;
    return surface_.tail(halfedge_of(edge)).index() == placed.vertex ? 0.0 : 1.0;
  };
  const double a = place(from), b = place(to);
  const auto there = on_edges_.find(edge);
  if (there == on_edges_.end()) return;
  std::vector<std::uint32_t>& between = between_[where];
  const std::vector<OnOneEdge>& points = there->second;  // by t
  auto point = std::upper_bound(points.begin(), points.end(), std::min(a, b),
                                [](double t, const OnOneEdge& p) { return t < p.t; });
  for (; point != points.end() && point->t < std::max(a, b); ++point) {
    if (point->vertex != from.vertex && point->vertex != to.vertex) {
      between.push_back(point->vertex);
    }
  }
  if (b < a) std::reverse(between.begin(), between.end());
}

void Planner::find_segments() {
  for (std::size_t c = 0; c < placed_.size(); ++c) {
    const std::vector<Placed>& points = placed_[c];
    const std::size_t n = points.size();
    for (std::size_t i = 0; i + (curves_[c].closed ? 0 : 1) < n; ++i) {
      const Placed &from = points[i], &to = points[(i + 1) % n];
      if (from.vertex == to.vertex) continue;
      if (const EdgeId edge = edge_of_both(from.point, to.point); edge.valid()) {
        go_along(edge, from, to, {c, i});
        continue;
      }
      const FaceId face = common_face(surface_, from.point, to.point);
      if (!face.valid()) {
        throw Error(ErrorCode::kBadCurve, "Points " + std::to_string(i) + " and " +
                                              std::to_string((i + 1) % n) + " of curve " +
                                              std::to_string(c) + " lie in no common face.");
      }
      segments_[face].push_back({face, from.vertex, to.vertex, {c, i}});
    }
  }
}

std::vector<FaceId> Planner::touched_faces() const {
  std::vector<FaceId> faces;
  for (const auto& [face, segments] : segments_) faces.push_back(face);
  for (const auto& [face, vertices] : in_faces_) faces.push_back(face);
  for (const auto& [edge, points] : on_edges_) {
    for (const HalfedgeId h : {halfedge_of(edge), twin(halfedge_of(edge))}) {
      if (surface_.has_face(h)) faces.push_back(surface_.face(h));
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::int64_t on_lattice(double part) {
  return std::clamp<std::int64_t>(std::llround(part * static_cast<double>(FaceTriangulation::kOne)),
                                  1, FaceTriangulation::kOne - 1);
}

/// The new vertices on the sides of a face and inside it, with their places.
std::vector<std::pair<FaceTriangulation::Place, std::uint32_t>> Planner::places_in(
    FaceId face) const {
  constexpr std::int64_t kOne = FaceTriangulation::kOne;
  std::vector<std::pair<FaceTriangulation::Place, std::uint32_t>> points;
  HalfedgeId h = surface_.halfedge(face);
  for (std::size_t k = 0; k < 3; ++k, h = surface_.next(h)) {
    const auto there = on_edges_.find(edge_of(h));
    if (there == on_edges_.end()) continue;
    for (const OnOneEdge& point : there->second) {
      FaceTriangulation::Place place{};
      const std::int64_t along = on_lattice(point.t);
      place[(k + 1) % 3] = h == halfedge_of(edge_of(h)) ? along : kOne - along;
      place[k] = kOne - place[(k + 1) % 3];
      points.emplace_back(place, point.vertex);
    }
  }
  if (const auto inside = in_faces_.find(face); inside != in_faces_.end()) {
    for (const std::uint32_t v : inside->second) {
      const auto& b = face_point(v).barycentric;
      FaceTriangulation::Place place{0, on_lattice(b[1]), on_lattice(b[2])};
      place[0] = kOne - place[1] - place[2];
      points.emplace_back(place, v);
    }
  }
  return points;
}

void Planner::cut_up(FaceId face) {
  constexpr std::int64_t kOne = FaceTriangulation::kOne;
  const SideFrame frame = side_frame(surface_, face, 0);
  FaceTriangulation triangulation({PlanePoint{0, 0}, PlanePoint{frame.length, 0}, frame.apex});
  std::vector<std::uint32_t> global;
  for (const VertexId v : surface_.corners(face)) {
    global.push_back(static_cast<std::uint32_t>(v.index()));
  }
  const auto points = places_in(face);
  constexpr std::size_t kFew = 32;
  const bool many = points.size() > kFew;
  const MixedOrder mixed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [place, vertex] = points[many ? mixed[i] : i];
    triangulation.insert(place);
    global.push_back(vertex);
  }
  std::unordered_map<std::uint32_t, std::uint32_t> number;  // in the triangulation; for many points
  if (many) {
    for (std::uint32_t i = 0; i < global.size(); ++i) number.emplace(global[i], i);
    triangulation.improve();  // segments then cross fewer edges
  }
  const auto local = [&](std::uint32_t v) {
    if (!number.empty()) return number.at(v);
    return static_cast<std::uint32_t>(std::find(global.begin(), global.end(), v) - global.begin());
  };
  const std::vector<Segment>& segments = segments_[face];
  constexpr std::size_t kManySegments = 256;
  const MixedOrder order(segments.size());
  std::vector<std::size_t> connected(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::size_t s = segments.size() > kManySegments ? order[i] : i;
    connected[s] = triangulation.connect(local(segments[s].from), local(segments[s].to));
  }
  triangulation.improve();
  const auto& places = triangulation.places();
  for (std::size_t i = global.size(); i < places.size(); ++i) {
    std::array<double, 3> b{};
    for (std::size_t k = 0; k < 3; ++k) {
      b[k] = static_cast<double>(places[i][k]) / static_cast<double>(kOne);
    }
    global.push_back(add(SurfacePoint::from_barycentric(surface_, face, b, 0)));
    ++plan_.crossings;
  }
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::vector<std::uint32_t> chain = triangulation.chain(connected[s]);
    std::vector<std::uint32_t>& between = between_[segments[s].where];
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) between.push_back(global[chain[i]]);
  }
  std::vector<Triangle>& parts = parts_[static_cast<std::uint32_t>(face.index())];
  for (const auto& [a, b, c] : triangulation.triangles()) {
    parts.push_back({global[a], global[b], global[c]});
  }
}

void Planner::cut_up_touched() {
  const std::vector<FaceId> touched = touched_faces();
  for (std::size_t k = 0; k < touched.size(); ++k) {
    poller_.set_fraction(0.7 * static_cast<double>(k) / static_cast<double>(touched.size()));
    cut_up(touched[k]);
    poller_.add_work(20 * parts_[static_cast<std::uint32_t>(touched[k].index())].size());
  }
}

void Planner::collect_chains() {
  for (std::size_t c = 0; c < placed_.size(); ++c) {
    CutChain& chain = plan_.chains.emplace_back();
    chain.closed = curves_[c].closed;
    const auto append = [&](std::uint32_t v) {
      if (chain.vertices.empty() || chain.vertices.back() != v) chain.vertices.push_back(v);
    };
    for (std::size_t i = 0; i < placed_[c].size(); ++i) {
      append(placed_[c][i].vertex);
      const auto between = between_.find({c, i});
      if (between == between_.end()) continue;
      for (const std::uint32_t v : between->second) append(v);
    }
    if (chain.closed && chain.vertices.size() > 1 &&
        chain.vertices.front() == chain.vertices.back()) {
      chain.vertices.pop_back();
    }
  }
}

void Planner::collect_faces() {
  for (const auto& [face, parts] : parts_) {
    if (parts.size() == 1) continue;  // curves only touch the face
    plan_.faces.push_back(face);
    plan_.first.push_back(plan_.triangles.size());
    plan_.triangles.insert(plan_.triangles.end(), parts.begin(), parts.end());
  }
  plan_.first.push_back(plan_.triangles.size());
  plan_.cut_faces = plan_.faces.size();
  plan_.new_vertices = plan_.points.size();
}

CutPlan Planner::run() {
  check_on(surface_, curves_);
  settle();
  find_segments();
  cut_up_touched();
  collect_faces();
  collect_chains();
  poller_.set_fraction(0.7);
  poller_.poll();
  return std::move(plan_);
}

}  // namespace

void CutOptions::validate() const {
  if (!(merge >= 1e-11 && merge <= 1e-2)) {
    throw Error(ErrorCode::kBadUsage, "merge must be in [1e-11, 1e-2].");
  }
  if (!(resolution >= 0 && std::isfinite(resolution))) {
    throw Error(ErrorCode::kBadUsage, "resolution must be >= 0 and finite.");
  }
}

void check_on(const Surface& surface, std::span<const SurfaceCurve> curves) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
      if (is_on(surface, curves[c].points[i])) continue;
      throw Error(ErrorCode::kBadCurve, "Point " + std::to_string(i) + " of curve " +
                                            std::to_string(c) +
                                            " is not on this mesh: the curve belongs to another "
                                            "mesh.");
    }
  }
}

CutPlan plan_cut(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                 const CutOptions& options, const Progress& progress) {
  options.validate();
  return Planner(mesh, curves, options, progress).run();
}

}  // namespace talweg
