#include "talweg/core/ridges/ridge_corridor.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

constexpr std::size_t kOnEdge = 3;  // nodes inside each edge
constexpr double kGround = 4;       // cost per length without a ridge; 1 / kGround on the best one
constexpr double kTurnAsDrawn = 10 * std::numbers::pi / 180;  // such a ridge costs as the drawing
constexpr double kRim = 0.5;                                  // growth of costs at the rim
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNoElement = 0xFFFFFFFFU;

/// The pull of a ridge, in [0, 1). At a pull of a half, a ridge costs as much as the drawing.
double pull_of(double angle, double strength) {
  const double pull = strength * angle / kTurnAsDrawn;
  return pull / (1 + pull);
}

}  // namespace

RidgeCorridor::RidgeCorridor(const SurfaceMesh& mesh, RidgeField& field,
                             std::span<const SurfacePoint> line, const Settings& settings,
                             ProgressPoller& poller)
    : mesh_(&mesh), line_(line.begin(), line.end()) {
  reach(settings.width, poller);
  add_faces(poller);
  place_nodes(field, settings, poller);
  place_drawn(field, settings.strength);
}

/// Finds the vertices within the width of the line by Dijkstra's algorithm along edges.
void RidgeCorridor::reach(double width, ProgressPoller& poller) {
  const Surface& surface = mesh_->surface();
  using Entry = std::pair<double, std::size_t>;
  std::vector<Entry> heap;
  const auto offer = [&](VertexId v, double distance) {
    if (!(distance <= width)) return;
    const auto [there, is_new] = reached_.try_emplace(v.index(), distance);
    if (!is_new && there->second <= distance) return;
    there->second = distance;
    heap.emplace_back(distance, v.index());
    std::push_heap(heap.begin(), heap.end(), std::greater<>());
  };
  for (const SurfacePoint& point : line_) {
    const Point place = mesh_->position(point);
    for (const FaceId face : faces_at(surface, point)) {
      for (const VertexId v : surface.corners(face)) offer(v, (mesh_->point(v) - place).norm());
    }
  }
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    const auto [distance, index] = heap.back();
    heap.pop_back();
    if (reached_.at(index) < distance) continue;
    poller.add_work(8);
    for_each_spoke(surface, VertexId{index}, [&, way = distance](HalfedgeId h) {
      offer(surface.head(h), way + surface.length(edge_of(h)));
    });
  }
}

std::uint32_t RidgeCorridor::vertex_node(VertexId v) {
  const auto [there, is_new] =
      vertex_nodes_.try_emplace(v.index(), static_cast<std::uint32_t>(vertices_.size()));
  if (is_new) vertices_.push_back(v);
  return there->second;
}

std::uint32_t RidgeCorridor::side_number(EdgeId edge) {
  const auto [there, is_new] =
      side_numbers_.try_emplace(edge.index(), static_cast<std::uint32_t>(edges_.size()));
  if (is_new) edges_.push_back(edge);
  return there->second;
}

/// Adds the faces of the line, and all faces at reached vertices, in the order of their numbers.
void RidgeCorridor::add_faces(ProgressPoller& poller) {
  const Surface& surface = mesh_->surface();
  std::vector<std::size_t> ids;
  const auto add = [&](const SurfacePoint& point) {
    for (const FaceId face : faces_at(surface, point)) ids.push_back(face.index());
  };
  for (const SurfacePoint& point : line_) add(point);
  for (const auto& [vertex, distance] : reached_) {
    add(SurfacePoint::at_vertex(surface, VertexId{vertex}));
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  faces_.reserve(ids.size());
  for (const std::size_t id : ids) {
    poller.add_work(8);
    Face face{FaceId{id}, {}, {}, {}};
    HalfedgeId side = surface.halfedge(face.id);
    for (std::size_t k = 0; k < 3; ++k, side = surface.next(side)) {
      face.corners[k] = vertex_node(surface.tail(side));
      face.sides[k] = side_number(edge_of(side));
    }
    face_numbers_.emplace(id, static_cast<std::uint32_t>(faces_.size()));
    faces_.push_back(std::move(face));
  }
  faces_at_.resize(vertices_.size() + edges_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    for (const std::uint32_t v : faces_[f].corners) faces_at_[v].push_back(f);
    for (const std::uint32_t e : faces_[f].sides) faces_at_[vertices_.size() + e].push_back(f);
  }
}

void RidgeCorridor::place_nodes(RidgeField& field, const Settings& settings,
                                ProgressPoller& poller) {
  first_drawn_ = vertices_.size() + kOnEdge * edges_.size();
  std::vector<double> away, ridge;
  for (const VertexId v : vertices_) {
    const auto there = reached_.find(v.index());
    away.push_back(there == reached_.end() ? kNever : there->second / settings.width);
    poller.add_work(400);
    ridge.push_back(there == reached_.end() ? 0 : field.at(v));
  }
  const auto add = [&](const Point& place, double from_line, double angle) {
    places_.push_back(place);
    inside_.push_back(from_line <= 1 ? 1 : 0);
    pull_.push_back(pull_of(angle, settings.strength));
    rim_.push_back(inside_.back() != 0 ? std::log(1 + kRim * from_line * from_line) : 0);
  };
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    add(mesh_->point(vertices_[i]), away[i], ridge[i]);
    elements_.push_back({static_cast<std::uint32_t>(i), kNoElement});
  }
  const Surface& surface = mesh_->surface();
  for (const EdgeId edge : edges_) {
    const HalfedgeId h = halfedge_of(edge);
    const std::size_t a = vertex_nodes_.at(surface.tail(h).index());
    const std::size_t b = vertex_nodes_.at(surface.head(h).index());
    for (std::size_t k = 1; k <= kOnEdge; ++k) {
      const double t = static_cast<double>(k) / (kOnEdge + 1);
      add((1 - t) * places_[a] + t * places_[b], (1 - t) * away[a] + t * away[b],
          (1 - t) * ridge[a] + t * ridge[b]);
      elements_.push_back({kNoElement, side_numbers_.at(edge.index())});
    }
    poller.add_work(20);
    edge_pull_.push_back(pull_of(field.along(edge), settings.strength));
  }
}

void RidgeCorridor::place_drawn(RidgeField& field, double strength) {
  const Surface& surface = mesh_->surface();
  for (std::size_t k = 0; k < line_.size(); ++k) {
    const auto node = static_cast<std::uint32_t>(drawn_node(k));
    double angle = 0;
    const FaceCoordinates in = coordinates_in(surface, line_[k], any_face(surface, line_[k]));
    const auto corners = surface.corners(in.face);
    for (std::size_t c = 0; c < 3; ++c) {
      if (in.barycentric[c] > 0) angle += in.barycentric[c] * field.at(corners[c]);
    }
    places_.push_back(mesh_->position(line_[k]));
    inside_.push_back(1);
    pull_.push_back(pull_of(angle, strength));
    rim_.push_back(0);
    const auto* v = std::get_if<AtVertex>(&line_[k].where());
    const auto* e = std::get_if<OnEdge>(&line_[k].where());
    elements_.push_back({v != nullptr ? vertex_nodes_.at(v->vertex.index()) : kNoElement,
                         e != nullptr ? side_numbers_.at(e->edge.index()) : kNoElement});
    faces_at_.emplace_back();
    for (const FaceId face : faces_at(surface, line_[k])) {
      const std::uint32_t f = face_numbers_.at(face.index());
      faces_at_.back().push_back(f);
      faces_[f].drawn.push_back(node);
    }
  }
}

SurfacePoint RidgeCorridor::point(std::size_t node) const {
  const Surface& surface = mesh_->surface();
  if (node < vertices_.size()) return SurfacePoint::at_vertex(surface, vertices_[node]);
  if (is_drawn(node)) return line_[node - first_drawn_];
  const std::size_t on = node - vertices_.size();
  const double t = static_cast<double>(on % kOnEdge + 1) / (kOnEdge + 1);
  return SurfacePoint::on_edge(surface, edges_[on / kOnEdge], t);
}

std::uint64_t RidgeCorridor::key(std::size_t node) const {
  if (node < vertices_.size()) return (kOnEdge + 1) * std::uint64_t{vertices_[node].index()};
  const std::size_t on = node - vertices_.size();
  return (kOnEdge + 1) * std::uint64_t{edges_[on / kOnEdge].index()} + 1 + on % kOnEdge;
}

/// The mean pull of both nodes, or, if it is larger, the pull of the crease along the side of the
/// face on which both nodes lie.
double RidgeCorridor::arc_pull(const Face& face, std::size_t from, std::size_t to) const {
  double pull = (pull_[from] + pull_[to]) / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<std::uint32_t, 2> ends{face.corners[k], face.corners[(k + 1) % 3]};
    const auto is_on = [&](std::size_t node) {
      const Element& at = elements_[node];
      return at.edge == face.sides[k] || at.vertex == ends[0] || at.vertex == ends[1];
    };
    if (is_on(from) && is_on(to)) pull = std::max(pull, edge_pull_[face.sides[k]]);
  }
  return pull;
}

double RidgeCorridor::pull(std::size_t node) const {
  double pull = pull_[node];
  const Element& at = elements_[node];
  for (const std::uint32_t f : faces_at_[element_number(node)]) {
    const Face& face = faces_[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const bool meets = at.edge == face.sides[k] || at.vertex == face.corners[k] ||
                         at.vertex == face.corners[(k + 1) % 3];
      if (meets) pull = std::max(pull, edge_pull_[face.sides[k]]);
    }
  }
  return pull;
}

bool RidgeCorridor::is_ridge_between(std::size_t from, std::size_t to) const {
  double pull = 0;
  for (const std::uint32_t f : faces_at_[element_number(from)]) {
    visit_face(faces_[f], [&](std::size_t node) {
      if (node == to) pull = std::max(pull, arc_pull(faces_[f], from, to));
    });
  }
  return pull >= kAsDrawn;
}

double RidgeCorridor::arc_cost(const Face& face, std::size_t from, std::size_t to) const {
  const double length = (places_[from] - places_[to]).norm();
  const double factor = std::exp(std::log(kGround) * (1 - 2 * arc_pull(face, from, to)) +
                                 (rim_[from] + rim_[to]) / 2);
  const bool drawn = is_drawn(from) && is_drawn(to) && (from > to ? from - to : to - from) == 1;
  return length * (drawn ? std::min(1.0, factor) : factor);
}

template <class Visit>
void RidgeCorridor::visit_face(const Face& face, const Visit& visit) const {
  for (const std::uint32_t v : face.corners) visit(v);
  for (const std::uint32_t e : face.sides) {
    for (std::size_t k = 0; k < kOnEdge; ++k) visit(vertices_.size() + kOnEdge * e + k);
  }
  for (const std::uint32_t drawn : face.drawn) visit(drawn);
}

/// The index in faces_at_ of the list of faces at a node.
std::size_t RidgeCorridor::element_number(std::size_t node) const {
  if (node < vertices_.size()) return node;
  if (is_drawn(node)) return vertices_.size() + edges_.size() + (node - first_drawn_);
  return vertices_.size() + (node - vertices_.size()) / kOnEdge;
}

void RidgeCorridor::relax(std::size_t from, std::size_t to, double cost) {
  if (!(cost < cost_[to])) return;
  cost_[to] = cost;
  before_[to] = static_cast<std::uint32_t>(from);
  heap_.emplace_back(cost, static_cast<std::uint32_t>(to));
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

void RidgeCorridor::run(std::span<const Start> starts, ProgressPoller& poller) {
  cost_.assign(size(), kNever);
  before_.assign(size(), kNoElement);
  heap_.clear();
  for (const Start& start : starts) relax(kNoElement, start.node, start.cost);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const auto [cost, node] = heap_.back();
    heap_.pop_back();
    if (cost > cost_[node]) continue;
    poller.add_work(20);
    for (const std::uint32_t f : faces_at_[element_number(node)]) {
      visit_face(faces_[f], [&, cost = cost, node = node](std::size_t to) {
        if (to == node || inside_[to] == 0 || cost_[to] <= cost) return;
        relax(node, to, cost + arc_cost(faces_[f], node, to));
      });
    }
  }
}

std::vector<std::size_t> RidgeCorridor::way_to(std::size_t node) const {
  std::vector<std::size_t> way;
  for (std::size_t at = node; at != kNoElement; at = before_[at]) way.push_back(at);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace talweg
