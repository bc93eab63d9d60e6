#include "talweg/core/smoothing/lifted_chain.hpp"

#include <algorithm>
#include <cmath>

namespace talweg {
namespace {

constexpr double kBarelyBent = 1e-4;  // rad
constexpr double kFromEnds = 1e-7;    // points stay this far (in t) from the ends of their edges
constexpr double kNearer = 0.8;       // largest part of the way to a vertex in one step
constexpr std::size_t kOfNode = 4;    // units of work each time a node is evaluated

}  // namespace

/// Counts the work for one node.
void LiftedChain::tell_work() const {
  if (asker_ != nullptr) asker_->did(kOfNode);
}

ChainNode LiftedChain::node_at(const SurfacePoint& point, bool keep) const {
  ChainNode node(point);
  const auto* e = std::get_if<OnEdge>(&point.where());
  if (e == nullptr || keep) {
    const auto phi = potential_.at(node.point);
    node.y << mesh_.position(node.point), phi[0], phi[1];
    return node;
  }
  node.fixed = false;
  node.edge = e->edge;
  const HalfedgeId h = halfedge_of(node.edge);
  node.origin = mesh_.point(mesh_.surface().tail(h));
  node.along = mesh_.point(mesh_.surface().head(h)) - node.origin;
  static_cast<LiftedPlace&>(node) = place_at(node, e->t);
  return node;
}

LiftedPlace LiftedChain::place_at(const ChainNode& node, double t) const {
  LiftedPlace place;
  place.t = std::clamp(t, kFromEnds, 1 - kFromEnds);
  const PotentialOnEdge phi = potential_.on_edge(node.edge, place.t);
  place.y << node.origin + place.t * node.along, phi.value[0], phi.value[1];
  place.dphi << phi.first[0], phi.first[1];
  place.ddphi << phi.second[0], phi.second[1];
  place.clear = phi.clear;
  return place;
}

FaceId LiftedChain::face_between(const ChainNode& a, const ChainNode& b) const {
  const Surface& surface = mesh_.surface();
  if (a.fixed && b.fixed) return common_face(surface, a.point, b.point);
  const ChainNode &free = a.fixed ? b : a, &other = a.fixed ? a : b;
  const auto* corner = other.fixed ? std::get_if<AtVertex>(&other.point.where()) : nullptr;
  if (other.fixed && corner == nullptr) return common_face(surface, place(a), place(b));
  FaceId face;
  for (const HalfedgeId h : {halfedge_of(free.edge), twin(halfedge_of(free.edge))}) {
    if (!surface.has_face(h)) continue;
    const HalfedgeId next = surface.next(h), prev = surface.next(next);
    const bool shared =
        corner != nullptr
            ? surface.tail(h) == corner->vertex || surface.tail(next) == corner->vertex ||
                  surface.tail(prev) == corner->vertex
            : free.edge == other.edge || edge_of(next) == other.edge || edge_of(prev) == other.edge;
    if (shared && (!face.valid() || surface.face(h) < face)) face = surface.face(h);
  }
  return face;
}

LiftedChain::Link LiftedChain::link_between(const ChainNode& a, const ChainNode& b) const {
  Link link;
  link.face = face_between(a, b);
  if (!link.face.valid()) return link;
  const Surface& surface = mesh_.surface();
  for (std::size_t i = 0; i < 2; ++i) {
    const ChainNode& node = i == 0 ? a : b;
    if (node.fixed) {
      const auto corners = coordinates_in(surface, node.point, link.face).barycentric;
      for (std::size_t k = 0; k < 3; ++k) link.base[k] += corners[k] / 2;
      continue;
    }
    HalfedgeId h = surface.halfedge(link.face);
    std::size_t k = 0;
    for (; edge_of(h) != node.edge; ++k) h = surface.next(h);
    const bool own = h == halfedge_of(node.edge);
    const std::size_t tail = own ? k : (k + 1) % 3, head = own ? (k + 1) % 3 : k;
    link.base[tail] += 0.5;
    link.along[i][tail] = -0.5;
    link.along[i][head] = 0.5;
  }
  return link;
}

/// The potential halfway between two nodes, with derivatives by the nodes' parameters.
PotentialInFace LiftedChain::halfway(const Link& link, const LiftedPlace& a,
                                     const LiftedPlace& b) const {
  const double clear = std::max(a.clear, b.clear);
  if (clear > 0 && (b.y - a.y).head<3>().squaredNorm() < 4 * clear * clear) return {};
  if (!link.face.valid()) return {};
  ExactPotential::Barycentric at = link.base;
  for (std::size_t k = 0; k < 3; ++k) at[k] += a.t * link.along[0][k] + b.t * link.along[1][k];
  return potential_.in_face(link.face, at, link.along);
}

/// The length is rounded off at zero, so that coinciding points do no harm.
double LiftedChain::segment(const LiftedPlace& a, const PotentialInFace& middle,
                            const LiftedPlace& b) const {
  const Eigen::Vector2d phi(middle.value[0], middle.value[1]);
  const double squared = (b.y - a.y).head<3>().squaredNorm() / 4 + smallest_ * smallest_;
  return std::sqrt(squared + (phi - a.y.tail<2>()).squaredNorm()) +
         std::sqrt(squared + (b.y.tail<2>() - phi).squaredNorm());
}

double LiftedChain::length(std::span<const ChainNode> nodes) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    sum += length(nodes[i], nodes[i + 1]);
  }
  return sum;
}

SurfacePoint LiftedChain::place(const ChainNode& node) const {
  return node.fixed ? node.point : SurfacePoint::on_edge(mesh_.surface(), node.edge, node.t);
}

/// Adds the segment's terms to the length's derivatives: two halves with equal extent in space,
/// from a to the middle and from there to b.
void LiftedChain::add_segment(const ChainNode& a, const PotentialInFace& at, const ChainNode& b,
                              Row& row, Row& next) const {
  using Eigen::Vector2d;
  const auto vector = [](const std::array<double, 2>& v) { return Vector2d(v[0], v[1]); };
  const Vector2d middle = vector(at.value), by_a = vector(at.first[0]), by_b = vector(at.first[1]);
  const Vector2d by_aa = vector(at.second[0]), by_ab = vector(at.second[1]),
                 by_bb = vector(at.second[2]);
  const Point way = (b.y - a.y).head<3>() / 2, da = -a.along / 2, db = b.along / 2;
  const double squared = way.squaredNorm() + smallest_ * smallest_;
  const double way_a = way.dot(da), way_b = way.dot(db);
  const double aa = da.squaredNorm(), ab = da.dot(db), bb = db.squaredNorm();
  const auto add = [&](const Vector2d& rise, const Vector2d& ra, const Vector2d& rb,
                       const Vector2d& raa, const Vector2d& rab, const Vector2d& rbb) {
    const double l = std::sqrt(squared + rise.squaredNorm());
    const double ua = (way_a + rise.dot(ra)) / l, ub = (way_b + rise.dot(rb)) / l;
    row.gradient += ua;
    next.gradient += ub;
    row.diagonal += (aa + ra.squaredNorm() - ua * ua) / l;
    next.diagonal += (bb + rb.squaredNorm() - ub * ub) / l;
    row.upper += (ab + ra.dot(rb) - ua * ub + rise.dot(rab)) / l;
    row.bend += rise.dot(raa) / l;
    next.bend += rise.dot(rbb) / l;
  };
  add(middle - a.y.tail<2>(), by_a - a.dphi, by_b, by_aa - a.ddphi, by_ab, by_bb);
  add(b.y.tail<2>() - middle, -by_a, b.dphi - by_b, -by_aa, -by_ab, b.ddphi - by_bb);
}

/// Computes gradient and second derivatives of the length. False when the curve is straight
/// already.
bool LiftedChain::assemble(std::span<const ChainNode> nodes) {
  const std::size_t n = nodes.size();
  rows_.assign(n, Row{});
  for (std::size_t i = 0; i + 1 < n; ++i) {
    tell_work();
    add_segment(nodes[i], middles_[i], nodes[i + 1], rows_[i], rows_[i + 1]);
  }
  double force = 0;  // sine of the angle by which the curve is not straight yet
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const ChainNode& node = nodes[i];
    Row& row = rows_[i];
    row.held = node.fixed || (node.t <= kFromEnds && row.gradient > 0) ||
               (node.t >= 1 - kFromEnds && row.gradient < 0);
    if (row.held) continue;
    row.speed = std::sqrt(node.along.squaredNorm() + node.dphi.squaredNorm());
    row.diagonal += std::max(0.0, row.bend);
    force = std::max(force, std::abs(row.gradient) / row.speed);
  }
  return force >= kBarelyBent;
}

/// Thomas' algorithm; fixed points are rows of the identity.
bool LiftedChain::solve(std::span<const ChainNode> nodes) {
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    Row& row = rows_[i];
    if (row.held) continue;
    const Row& before = rows_[i - 1];
    const double lower = before.held ? 0 : before.upper;
    const double pivot = row.diagonal * (1 + 1e-9) + 1e-12 * row.speed - lower * before.factor;
    if (!(pivot > 0)) return false;
    row.factor = row.upper / pivot;
    row.step = (-row.gradient - lower * before.step) / pivot;
  }
  for (std::size_t i = nodes.size() - 1; i-- > 1;) {
    if (!rows_[i].held) rows_[i].step -= rows_[i].factor * rows_[i + 1].step;
  }
  return true;
}

/// Goes along the Newton step as far as it shortens the curve. Each point moves by at most `most`
/// of its step, at most half its edge, and never all the way to a vertex (a point that should only
/// have come closer would not come back). False when nothing shortens the curve.
bool LiftedChain::go_along(std::span<ChainNode> nodes, double most, double& total) {
  for (double scale = most; scale > 1e-3 * most; scale /= 2) {
    double shorter = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      tell_work();
      const double step = rows_[i].step, t = nodes[i].t;
      if (step != 0 && i + 1 < nodes.size()) {
        trials_[i] = place_at(nodes[i], t + std::clamp(scale * step, std::max(-0.5, -kNearer * t),
                                                       std::min(0.5, kNearer * (1 - t))));
      }
      const bool stays = rows_[i - 1].step == 0 && (step == 0 || i + 1 == nodes.size());
      tried_middles_[i - 1] =
          stays ? middles_[i - 1] : halfway(links_[i - 1], trials_[i - 1], trials_[i]);
      shorter += segment(trials_[i - 1], tried_middles_[i - 1], trials_[i]);
    }
    if (!(shorter < total)) continue;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      if (rows_[i].step == 0) continue;
      static_cast<LiftedPlace&>(nodes[i]) = trials_[i];
      nodes[i].changed = round_;
    }
    middles_.swap(tried_middles_);
    total = shorter;
    return true;
  }
  return false;
}

/// One damped Newton step on a chain whose ends stay. False when nothing is gained.
bool LiftedChain::newton_step(std::span<ChainNode> nodes, double& total) {
  if (!assemble(nodes) || !solve(nodes)) return false;
  trials_.assign(nodes.begin(), nodes.end());
  const double before = total;
  // Points that lie close together around a vertex must keep their proportions.
  double most = 1;
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const double step = rows_[i].step, room = step < 0 ? nodes[i].t : 1 - nodes[i].t;
    if (std::abs(step) * most > kNearer * room) most = kNearer * room / std::abs(step);
  }
  constexpr std::size_t kFew = 16;
  const bool together = nodes.size() <= kFew;
  if (!go_along(nodes, together ? most : 1, total) &&
      (most == 1 || !go_along(nodes, together ? 1 : most, total))) {
    return false;
  }
  return before - total > tolerance_ * before;
}

LiftedChain::Settled LiftedChain::settle_between(std::span<ChainNode> nodes, int steps) {
  links_.resize(nodes.size());
  middles_.resize(nodes.size());
  tried_middles_.resize(nodes.size());
  double total = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    tell_work();
    const ChainNode &a = nodes[i], &b = nodes[i + 1];
    links_[i] = link_between(a, b);
    middles_[i] = halfway(links_[i], a, b);
    total += segment(a, middles_[i], b);
  }
  Settled result{total, total};
  if (nodes.size() < 3) return result;
  for (int k = 0; k < steps && newton_step(nodes, result.after); ++k) {
  }
  return result;
}

LiftedChain::Settled LiftedChain::settle_runs(std::span<ChainNode> nodes, int steps) {
  Settled total;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (!nodes[i].fixed && i + 1 < nodes.size()) continue;
    const Settled run = settle_between(nodes.subspan(begin, i - begin + 1), steps);
    total.before += run.before;
    total.after += run.after;
    begin = i;
  }
  return total;
}

double LiftedChain::settle(std::span<ChainNode> nodes, int steps) {
  return settle_runs(nodes, steps).after;
}

void LiftedChain::settle_by_parts(std::span<ChainNode> nodes) {
  constexpr std::size_t kPart = 12;
  for (ChainNode& node : nodes) node.awake = false;
  for (std::size_t i = 0; i + 2 < nodes.size(); i += kPart / 2) {
    const auto part = nodes.subspan(i, std::min(nodes.size() - i, kPart));
    const Settled settled = settle_runs(part, 4);
    if (settled.before - settled.after <= tolerance_ * settled.before) continue;
    for (ChainNode& node : part) node.awake = true;
  }
}

}  // namespace talweg
