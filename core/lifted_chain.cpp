#include "talweg/core/lifted_chain.hpp"

#include <algorithm>
#include <cmath>

namespace talweg {
namespace {

constexpr double kStraight = 1e-5;  // rad
constexpr double kEnd = 1e-7;       // points stay this far (in t) from the ends of their edges

}  // namespace

void LiftedChain::evaluate(ChainNode& node) const {
  node.dy.setZero();
  node.ddy.setZero();
  if (node.fixed) {
    const auto phi = potential_.at(node.point);
    node.y << mesh_.position(node.point), phi[0], phi[1];
    return;
  }
  const HalfedgeId h = halfedge_of(node.edge);
  const Point& tail = mesh_.point(mesh_.surface().tail(h));
  const Point along = mesh_.point(mesh_.surface().head(h)) - tail;
  const PotentialOnEdge phi = potential_.on_edge(node.edge, node.t);
  node.y << tail + node.t * along, phi.value[0], phi.value[1];
  node.dy << along, phi.first[0], phi.first[1];
  node.ddy << 0, 0, 0, phi.second[0], phi.second[1];
}

ChainNode LiftedChain::node_at(const SurfacePoint& point, bool keep) const {
  ChainNode node{point, true, {}, 0, {}, {}, {}};
  if (const auto* e = std::get_if<OnEdge>(&point.where()); e != nullptr && !keep) {
    node.fixed = false;
    node.edge = e->edge;
    node.t = std::clamp(e->t, kEnd, 1 - kEnd);
  }
  evaluate(node);
  return node;
}

void LiftedChain::move(ChainNode& node, double t) const {
  node.t = std::clamp(t, kEnd, 1 - kEnd);
  evaluate(node);
}

/// Rounded off at zero, so that points that run together do no harm.
double LiftedChain::segment(const ChainNode& a, const ChainNode& b) const {
  return std::sqrt((b.y - a.y).squaredNorm() + smallest_ * smallest_);
}

double LiftedChain::length(const Nodes& nodes) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) sum += segment(nodes[i], nodes[i + 1]);
  return sum;
}

SurfacePoint LiftedChain::place(const ChainNode& node) const {
  return node.fixed ? node.point : SurfacePoint::on_edge(mesh_.surface(), node.edge, node.t);
}

/// One damped Newton step on a chain whose ends stay. False when nothing is gained.
bool LiftedChain::newton_step(Nodes& nodes, double& total) const {
  const std::size_t n = nodes.size();
  std::vector<double> gradient(n, 0), diagonal(n, 0), upper(n, 0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const ChainNode &a = nodes[i], &b = nodes[i + 1];
    const double l = segment(a, b);
    const ChainNode::Lifted u = (b.y - a.y) / l;
    const double ua = u.dot(a.dy), ub = u.dot(b.dy);
    gradient[i] -= ua;
    gradient[i + 1] += ub;
    diagonal[i] += (a.dy.squaredNorm() - ua * ua) / l;
    diagonal[i + 1] += (b.dy.squaredNorm() - ub * ub) / l;
    upper[i] = -(a.dy.dot(b.dy) - ua * ub) / l;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const ChainNode::Lifted u = (nodes[i].y - nodes[i - 1].y) / segment(nodes[i - 1], nodes[i]);
    const ChainNode::Lifted w = (nodes[i + 1].y - nodes[i].y) / segment(nodes[i], nodes[i + 1]);
    diagonal[i] += std::max(0.0, (u - w).dot(nodes[i].ddy));
  }
  const auto held = [&](std::size_t i) {
    if (nodes[i].fixed || i == 0 || i + 1 == n) return true;
    return (nodes[i].t <= kEnd && gradient[i] > 0) || (nodes[i].t >= 1 - kEnd && gradient[i] < 0);
  };
  double force = 0;  // sine of the angle by which the curve is not straight yet
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (!held(i)) force = std::max(force, std::abs(gradient[i]) / nodes[i].dy.norm());
  }
  if (force < kStraight) return false;
  // Thomas' algorithm; held points are rows of the identity.
  std::vector<double> c(n, 0), step(n, 0);
  double before = 0;
  bool before_held = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (held(i)) {
      c[i] = step[i] = 0;
      before_held = true;
      continue;
    }
    const double lower = before_held ? 0 : upper[i - 1];
    const double pivot = diagonal[i] * (1 + 1e-9) + 1e-12 * nodes[i].dy.norm() - lower * before;
    if (!(pivot > 0)) return false;
    c[i] = upper[i] / pivot;
    step[i] = (-gradient[i] - (before_held ? 0 : lower * step[i - 1])) / pivot;
    before = c[i];
    before_held = false;
  }
  for (std::size_t i = n - 1; i-- > 0;) {
    if (step[i + 1] != 0 && !held(i)) step[i] -= c[i] * step[i + 1];
  }
  Nodes moved = nodes;
  for (double scale = 1; scale > 1e-3; scale /= 2) {
    for (std::size_t i = 1; i + 1 < n; ++i) {
      if (!nodes[i].fixed && step[i] != 0) {
        move(moved[i], nodes[i].t + scale * std::clamp(step[i], -0.5, 0.5));
      }
    }
    const double shorter = length(moved);
    if (shorter < total) {
      nodes.swap(moved);
      const bool worth = total - shorter > tolerance_ * total;
      total = shorter;
      return worth;
    }
  }
  return false;
}

double LiftedChain::settle(Nodes& nodes, int steps) const {
  double total = length(nodes);
  for (int k = 0; k < steps && newton_step(nodes, total); ++k) {
  }
  return total;
}

/// A crease of the distance at one point would make all others take its small steps, so short
/// overlapping parts are settled one after the other.
void LiftedChain::settle_by_parts(Nodes& nodes) const {
  constexpr std::size_t kPart = 12;
  Nodes part;
  for (std::size_t i = 0; i + 2 < nodes.size(); i += kPart / 2) {
    const std::size_t end = std::min(nodes.size(), i + kPart);
    part.assign(nodes.begin() + static_cast<std::ptrdiff_t>(i),
                nodes.begin() + static_cast<std::ptrdiff_t>(end));
    settle(part, 4);
    std::copy(part.begin(), part.end(), nodes.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace talweg
