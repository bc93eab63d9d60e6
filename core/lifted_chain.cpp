#include "talweg/core/lifted_chain.hpp"

#include <algorithm>
#include <cmath>

namespace talweg {
namespace {

constexpr double kStraight = 1e-4;  // rad
constexpr double kEnd = 1e-7;       // points stay this far (in t) from the ends of their edges

}  // namespace

ChainNode LiftedChain::node_at(const SurfacePoint& point, bool keep) const {
  ChainNode node{point, true, {}, 0, {}, {}, {}, {}};
  node.dy.setZero();
  node.ddphi.setZero();
  const auto* e = std::get_if<OnEdge>(&point.where());
  if (e == nullptr || keep) {
    const auto phi = potential_.at(node.point);
    node.y << mesh_.position(node.point), phi[0], phi[1];
    return node;
  }
  node.fixed = false;
  node.edge = e->edge;
  node.t = std::clamp(e->t, kEnd, 1 - kEnd);
  const HalfedgeId h = halfedge_of(node.edge);
  node.origin = mesh_.point(mesh_.surface().tail(h));
  node.dy.head<3>() = mesh_.point(mesh_.surface().head(h)) - node.origin;
  Trial here;
  try_at(node, node.t, here);
  take(here, node);
  return node;
}

void LiftedChain::try_at(const ChainNode& node, double t, Trial& trial) const {
  trial.t = std::clamp(t, kEnd, 1 - kEnd);
  const PotentialOnEdge phi = potential_.on_edge(node.edge, trial.t);
  trial.y << node.origin + trial.t * node.dy.head<3>(), phi.value[0], phi.value[1];
  trial.dphi << phi.first[0], phi.first[1];
  trial.ddphi << phi.second[0], phi.second[1];
}

void LiftedChain::take(const Trial& trial, ChainNode& node) {
  node.t = trial.t;
  node.y = trial.y;
  node.dy.tail<2>() = trial.dphi;
  node.ddphi = trial.ddphi;
}

/// Rounded off at zero, so that points that run together do no harm.
double LiftedChain::segment(const ChainNode::Lifted& a, const ChainNode::Lifted& b) const {
  return std::sqrt((b - a).squaredNorm() + smallest_ * smallest_);
}

double LiftedChain::length(std::span<const ChainNode> nodes) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) sum += segment(nodes[i].y, nodes[i + 1].y);
  return sum;
}

SurfacePoint LiftedChain::place(const ChainNode& node) const {
  return node.fixed ? node.point : SurfacePoint::on_edge(mesh_.surface(), node.edge, node.t);
}

/// Gradient and second derivatives of the length. False when the curve is straight already.
bool LiftedChain::assemble(std::span<const ChainNode> nodes) {
  const std::size_t n = nodes.size();
  rows_.resize(n);
  rows_[0].clear();
  double before = nodes[0].dy.squaredNorm();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const ChainNode &a = nodes[i], &b = nodes[i + 1];
    Row &row = rows_[i], &next = rows_[i + 1];
    next.clear();
    row.direction = b.y - a.y;
    const double l = std::sqrt(row.direction.squaredNorm() + smallest_ * smallest_);
    row.direction /= l;
    row.length = l;
    const double ua = row.direction.dot(a.dy), ub = row.direction.dot(b.dy);
    row.gradient -= ua;
    next.gradient += ub;
    const double squared = b.dy.squaredNorm();
    row.diagonal += (before - ua * ua) / l;
    next.diagonal += (squared - ub * ub) / l;
    row.upper = -(a.dy.dot(b.dy) - ua * ub) / l;
    next.speed = std::sqrt(squared);
    before = squared;
  }
  double force = 0;  // sine of the angle by which the curve is not straight yet
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const ChainNode& node = nodes[i];
    Row& row = rows_[i];
    row.held = node.fixed || (node.t <= kEnd && row.gradient > 0) ||
               (node.t >= 1 - kEnd && row.gradient < 0);
    if (row.held) continue;
    row.diagonal +=
        std::max(0.0, (rows_[i - 1].direction - row.direction).tail<2>().dot(node.ddphi));
    force = std::max(force, std::abs(row.gradient) / row.speed);
  }
  return force >= kStraight;
}

/// Thomas' algorithm; held points are rows of the identity.
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

/// Goes along the Newton step, each point by at most `most` of it and half its edge, as far as it
/// shortens the curve. False when it does not.
bool LiftedChain::go_along(std::span<ChainNode> nodes, double most, double& total) {
  for (double scale = most; scale > 1e-3 * most; scale /= 2) {
    double shorter = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const double step = rows_[i].step;
      if (step != 0 && i + 1 < nodes.size()) {
        try_at(nodes[i], nodes[i].t + std::clamp(scale * step, -0.5, 0.5), trials_[i]);
      }
      shorter += segment(trials_[i - 1].y, trials_[i].y);
    }
    if (!(shorter < total)) continue;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      if (rows_[i].step == 0) continue;
      take(trials_[i], nodes[i]);
      nodes[i].changed = round_;
    }
    total = shorter;
    return true;
  }
  return false;
}

/// One damped Newton step on a chain whose ends stay. False when nothing is gained.
bool LiftedChain::newton_step(std::span<ChainNode> nodes, double& total) {
  if (!assemble(nodes) || !solve(nodes)) return false;
  trials_.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) trials_[i].y = nodes[i].y;
  const double before = total;
  if (!go_along(nodes, 1, total)) {
    // Points that lie close together, around a vertex, must keep their proportions.
    double largest = 0;
    for (const Row& row : rows_) largest = std::max(largest, std::abs(row.step));
    if (!(largest > 0.5) || !go_along(nodes, 0.5 / largest, total)) return false;
  }
  return before - total > tolerance_ * before;
}

double LiftedChain::settle_between(std::span<ChainNode> nodes, int steps) {
  double total = length(nodes);
  if (nodes.size() < 3) return total;
  for (int k = 0; k < steps && newton_step(nodes, total); ++k) {
  }
  return total;
}

double LiftedChain::settle(std::span<ChainNode> nodes, int steps) {
  double total = 0;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (!nodes[i].fixed && i + 1 < nodes.size()) continue;
    total += settle_between(nodes.subspan(begin, i - begin + 1), steps);
    begin = i;
  }
  return total;
}

void LiftedChain::settle_by_parts(std::span<ChainNode> nodes) {
  constexpr std::size_t kPart = 12;
  for (ChainNode& node : nodes) node.awake = false;
  for (std::size_t i = 0; i + 2 < nodes.size(); i += kPart / 2) {
    const auto part = nodes.subspan(i, std::min(nodes.size() - i, kPart));
    const double before = length(part);
    if (before - settle(part, 4) <= tolerance_ * before) continue;
    for (ChainNode& node : part) node.awake = true;
  }
}

}  // namespace talweg
