#include "strands.hpp"

#include <algorithm>

namespace talweg::plugins {
namespace {

constexpr std::uint32_t kNoNode = StrandNode::kNone;
// The fraction of an edge's length that stays between two nodes, or a node and a vertex.
constexpr double kFromEnds = 1e-6;

}  // namespace

Strands::Strands(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                 std::span<const SurfacePoint> pins)
    : mesh_(&mesh) {
  for (const SurfaceCurve& curve : curves) {
    const auto number = static_cast<std::uint32_t>(closed_.size());
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    const auto n = static_cast<std::uint32_t>(curve.points.size());
    closed_.push_back(curve.closed ? 1 : 0);
    first_.push_back(first);
    counts_.push_back(n);
    for (std::uint32_t k = 0; k < n; ++k) {
      const SurfacePoint& p = curve.points[k];
      const bool end = !curve.closed && (k == 0 || k + 1 == n);
      const bool pinned = std::find(pins.begin(), pins.end(), p) != pins.end();
      nodes_.push_back({p, mesh.position(p), number,
                        k > 0 ? first + k - 1 : (curve.closed ? first + n - 1 : kNoNode),
                        k + 1 < n ? first + k + 1 : (curve.closed ? first : kNoNode), end || pinned,
                        true});
      enter(first + k);
    }
  }
  for (StrandNode& node : nodes_) {
    const auto* v = std::get_if<AtVertex>(&node.at.where());
    if (v != nullptr && at_vertex_.at(v->vertex.index()).size() > 1) node.fixed = true;
  }
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    if (!std::holds_alternative<InFace>(nodes_[node].at.where()) || nodes_[node].fixed) continue;
    if (counts_[nodes_[node].curve] > 3) {
      remove(node);
    } else {
      nodes_[node].fixed = true;  // a loop within one face
    }
  }
}

void Strands::enter(std::uint32_t node) {
  const auto& where = nodes_[node].at.where();
  if (const auto* e = std::get_if<OnEdge>(&where)) on_edge_[e->edge.index()].push_back(node);
  if (const auto* v = std::get_if<AtVertex>(&where)) at_vertex_[v->vertex.index()].push_back(node);
}

void Strands::leave(std::uint32_t node) {
  const auto& where = nodes_[node].at.where();
  if (const auto* e = std::get_if<OnEdge>(&where)) std::erase(on_edge_[e->edge.index()], node);
  const auto* v = std::get_if<AtVertex>(&where);
  if (v == nullptr) return;
  std::vector<std::uint32_t>& there = at_vertex_[v->vertex.index()];
  std::erase(there, node);
  if (there.empty()) at_vertex_.erase(v->vertex.index());
}

void Strands::join(std::uint32_t before, std::uint32_t after) {
  if (before != kNoNode) nodes_[before].after = after;
  if (after != kNoNode) nodes_[after].before = before;
}

std::vector<std::uint32_t> Strands::chain(std::uint32_t curve) const {
  std::vector<std::uint32_t> chain;
  std::uint32_t node = first_[curve];
  do {
    chain.push_back(node);
    node = nodes_[node].after;
  } while (node != kNoNode && node != first_[curve]);
  return chain;
}

SurfaceCurve Strands::curve(std::uint32_t curve) const {
  SurfaceCurve result{closed_[curve] != 0, {}};
  for (const std::uint32_t node : chain(curve)) result.points.push_back(nodes_[node].at);
  return result;
}

double Strands::length(std::uint32_t curve) const {
  double length = 0;
  for (const std::uint32_t node : chain(curve)) {
    const std::uint32_t after = nodes_[node].after;
    if (after != kNoNode) length += (nodes_[after].position - nodes_[node].position).norm();
  }
  return length;
}

void Strands::fix(std::uint32_t curve) {
  for (const std::uint32_t node : chain(curve)) nodes_[node].fixed = true;
}

Strands::Room Strands::room(std::uint32_t node) const {
  const OnEdge& here = std::get<OnEdge>(nodes_[node].at.where());
  const HalfedgeId h = halfedge_of(here.edge);
  Room room{is_taken(mesh_->surface().tail(h)) ? std::min(kFromEnds, here.t) : 0,
            is_taken(mesh_->surface().head(h)) ? std::max(1 - kFromEnds, here.t) : 1};
  for (const std::uint32_t other : on_edge_.at(here.edge.index())) {
    if (other == node) continue;
    const double t = std::get<OnEdge>(nodes_[other].at.where()).t;
    const double share = std::max(0.0, std::abs(here.t - t) - kFromEnds) / 2;
    if (t <= here.t) room.low = std::max(room.low, here.t - share);
    if (t >= here.t) room.high = std::min(room.high, here.t + share);
  }
  return room;
}

double Strands::free_along(HalfedgeId h, std::uint32_t a, std::uint32_t b) const {
  const EdgeId e = edge_of(h);
  double part = 1;
  if (const auto there = on_edge_.find(e.index()); there != on_edge_.end()) {
    for (const std::uint32_t other : there->second) {
      if (other == a || other == b) continue;
      const double t = std::get<OnEdge>(nodes_[other].at.where()).t;
      part = std::min(part, h == halfedge_of(e) ? t : 1 - t);
    }
  }
  return part * mesh_->surface().length(e);
}

void Strands::move(std::uint32_t node, const SurfacePoint& to) {
  leave(node);
  nodes_[node].at = to;
  nodes_[node].position = mesh_->position(to);
  enter(node);
}

void Strands::remove(std::uint32_t node) {
  StrandNode& gone = nodes_[node];
  leave(node);
  gone.alive = false;
  join(gone.before, gone.after);
  --counts_[gone.curve];
  if (first_[gone.curve] == node) first_[gone.curve] = gone.after;
}

void Strands::replace(std::uint32_t node, std::span<const SurfacePoint> points) {
  if (points.empty()) return remove(node);
  move(node, points.front());
  std::uint32_t last = node;
  for (const SurfacePoint& point : points.subspan(1)) {
    const auto added = static_cast<std::uint32_t>(nodes_.size());
    const std::uint32_t after = nodes_[last].after, curve = nodes_[node].curve;
    nodes_.push_back({point, mesh_->position(point), curve, last, after, false, true});
    join(added, after);
    join(last, added);
    ++counts_[curve];
    enter(added);
    last = added;
  }
}

}  // namespace talweg::plugins
