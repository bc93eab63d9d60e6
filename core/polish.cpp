#include "talweg/core/polish.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Lifted = Eigen::Matrix<double, 5, 1>;

constexpr double kStraight = 1e-5;
constexpr double kEnd = 1e-7;  // points stay this far (in t) from the ends of their edges

/// A point of the curve: free on an edge, or fixed.
struct Node {
  SurfacePoint point;
  bool fixed = true;
  EdgeId edge;
  double t = 0;
  Lifted y, dy, ddy;
};

class Polisher {
 public:
  Polisher(const SurfaceMesh& mesh, const ExactPotential& potential,
           std::span<const SurfacePoint> pinned, const PolishOptions& options)
      : mesh_(mesh),
        surface_(mesh.surface()),
        potential_(potential),
        pinned_(pinned),
        options_(options),
        smallest_(1e-7 * mesh.mean_edge_length()) {}

  PolishResult run(SurfaceCurve& curve);

 private:
  Node node_at(const SurfacePoint& point, bool keep) const;
  void evaluate(Node& node) const;
  void move(Node& node, double t) const;
  double segment(const Node& a, const Node& b) const;
  double length(const std::vector<Node>& nodes) const;
  void load(const SurfaceCurve& curve);
  bool newton_step(std::vector<Node>& nodes, double& length) const;
  double settle(std::vector<Node>& nodes, int steps) const;
  void settle_by_parts(std::vector<Node>& nodes) const;

  void untangle();
  bool pass_vertices();
  bool pass_vertex(std::size_t first, std::size_t count, VertexId v);
  std::vector<HalfedgeId> spokes(VertexId v, bool& whole) const;
  int slot(const SurfacePoint& p, VertexId v, const std::vector<HalfedgeId>& out) const;
  VertexId driven_to(const Node& node) const;
  std::size_t index(std::ptrdiff_t i) const {
    const auto n = static_cast<std::ptrdiff_t>(nodes_.size());
    return static_cast<std::size_t>(((i % n) + n) % n);
  }

  const SurfaceMesh& mesh_;
  const Surface& surface_;
  const ExactPotential& potential_;
  std::span<const SurfacePoint> pinned_;
  PolishOptions options_;
  double smallest_;
  bool closed_ = false;
  std::vector<Node> nodes_;
  std::size_t passed_ = 0;
};

void Polisher::evaluate(Node& node) const {
  node.dy.setZero();
  node.ddy.setZero();
  if (node.fixed) {
    const auto phi = potential_.at(node.point);
    node.y << mesh_.position(node.point), phi[0], phi[1];
    return;
  }
  const HalfedgeId h = halfedge_of(node.edge);
  const Point& tail = mesh_.point(surface_.tail(h));
  const Point along = mesh_.point(surface_.head(h)) - tail;
  const PotentialOnEdge phi = potential_.on_edge(node.edge, node.t);
  node.y << tail + node.t * along, phi.value[0], phi.value[1];
  node.dy << along, phi.first[0], phi.first[1];
  node.ddy << 0, 0, 0, phi.second[0], phi.second[1];
}

Node Polisher::node_at(const SurfacePoint& point, bool keep) const {
  Node node{point, true, {}, 0, {}, {}, {}};
  if (const auto* e = std::get_if<OnEdge>(&point.where()); e != nullptr && !keep) {
    node.fixed = false;
    node.edge = e->edge;
    node.t = std::clamp(e->t, kEnd, 1 - kEnd);
  }
  evaluate(node);
  return node;
}

void Polisher::move(Node& node, double t) const {
  node.t = std::clamp(t, kEnd, 1 - kEnd);
  evaluate(node);
}

/// Rounded off at zero, so that points that run together do no harm.
double Polisher::segment(const Node& a, const Node& b) const {
  return std::sqrt((b.y - a.y).squaredNorm() + smallest_ * smallest_);
}

double Polisher::length(const std::vector<Node>& nodes) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) sum += segment(nodes[i], nodes[i + 1]);
  return sum;
}

void Polisher::load(const SurfaceCurve& curve) {
  closed_ = curve.closed;
  nodes_.clear();
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SurfacePoint& p = curve.points[i];
    const bool end = !closed_ && (i == 0 || i + 1 == n);
    const bool pin = end || std::find(pinned_.begin(), pinned_.end(), p) != pinned_.end();
    if (!pin && std::holds_alternative<InFace>(p.where()) &&
        common_face(surface_, nodes_.empty() ? curve.points[n - 1] : nodes_.back().point,
                    curve.points[(i + 1) % n])
            .valid()) {
      continue;
    }
    nodes_.push_back(node_at(p, pin));
  }
}

/// One damped Newton step on a chain whose ends stay. False when nothing is gained.
bool Polisher::newton_step(std::vector<Node>& nodes, double& total) const {
  const std::size_t n = nodes.size();
  std::vector<double> gradient(n, 0), diagonal(n, 0), upper(n, 0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Node &a = nodes[i], &b = nodes[i + 1];
    const double l = segment(a, b);
    const Lifted u = (b.y - a.y) / l;
    const double ua = u.dot(a.dy), ub = u.dot(b.dy);
    gradient[i] -= ua;
    gradient[i + 1] += ub;
    diagonal[i] += (a.dy.squaredNorm() - ua * ua) / l;
    diagonal[i + 1] += (b.dy.squaredNorm() - ub * ub) / l;
    upper[i] = -(a.dy.dot(b.dy) - ua * ub) / l;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Lifted u = (nodes[i].y - nodes[i - 1].y) / segment(nodes[i - 1], nodes[i]);
    const Lifted w = (nodes[i + 1].y - nodes[i].y) / segment(nodes[i], nodes[i + 1]);
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
  std::vector<Node> moved = nodes;
  for (double scale = 1; scale > 1e-3; scale /= 2) {
    for (std::size_t i = 1; i + 1 < n; ++i) {
      if (!nodes[i].fixed && step[i] != 0) {
        move(moved[i], nodes[i].t + scale * std::clamp(step[i], -0.5, 0.5));
      }
    }
    const double shorter = length(moved);
    if (shorter < total) {
      nodes.swap(moved);
      const bool worth = total - shorter > options_.tolerance * total;
      total = shorter;
      return worth;
    }
  }
  return false;
}

double Polisher::settle(std::vector<Node>& nodes, int steps) const {
  double total = length(nodes);
  for (int k = 0; k < steps && newton_step(nodes, total); ++k) {
  }
  return total;
}

/// A crease of the distance at one point would make all others take its small steps, so short
/// overlapping parts are settled one after the other.
void Polisher::settle_by_parts(std::vector<Node>& nodes) const {
  constexpr std::size_t kPart = 12;
  std::vector<Node> part;
  for (std::size_t i = 0; i + 2 < nodes.size(); i += kPart / 2) {
    const std::size_t end = std::min(nodes.size(), i + kPart);
    part.assign(nodes.begin() + static_cast<std::ptrdiff_t>(i),
                nodes.begin() + static_cast<std::ptrdiff_t>(end));
    settle(part, 4);
    std::copy(part.begin(), part.end(), nodes.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// The vertex that a point wants to pass, or the one it is at.
VertexId Polisher::driven_to(const Node& node) const {
  if (node.fixed) {
    const auto* v = std::get_if<AtVertex>(&node.point.where());
    return v != nullptr ? v->vertex : VertexId{};
  }
  const HalfedgeId h = halfedge_of(node.edge);
  constexpr double kNear = 1e-4;
  if (node.t <= kNear) return surface_.tail(h);
  if (node.t >= 1 - kNear) return surface_.head(h);
  return {};
}

std::vector<HalfedgeId> Polisher::spokes(VertexId v, bool& whole) const {
  std::vector<HalfedgeId> out;
  const HalfedgeId first = surface_.halfedge(v);
  whole = true;
  HalfedgeId h = first;
  do {
    out.push_back(h);
    if (!surface_.has_face(h)) {
      whole = false;
      break;
    }
    h = surface_.turn_ccw(h);
  } while (h != first);
  return out;
}

/// Where a point lies around v: 2 k on spoke k, 2 k + 1 in the face after it, -1 elsewhere.
int Polisher::slot(const SurfacePoint& p, VertexId v, const std::vector<HalfedgeId>& out) const {
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (const auto* e = std::get_if<OnEdge>(&p.where()); e != nullptr && e->edge == edge_of(out[k]))
      return static_cast<int>(2 * k);
    if (const auto* w = std::get_if<AtVertex>(&p.where());
        w != nullptr && w->vertex == surface_.head(out[k]) && w->vertex != v)
      return static_cast<int>(2 * k);
  }
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (!surface_.has_face(out[k])) continue;
    const FaceId f = surface_.face(out[k]);
    if (const auto* e = std::get_if<OnEdge>(&p.where());
        e != nullptr && e->edge == edge_of(surface_.next(out[k])))
      return static_cast<int>(2 * k + 1);
    if (const auto* i = std::get_if<InFace>(&p.where()); i != nullptr && i->face == f)
      return static_cast<int>(2 * k + 1);
  }
  return -1;
}

/// Tries the ways around v for the nodes [first, first + count): on either side, or through it.
bool Polisher::pass_vertex(std::size_t first, std::size_t count, VertexId v) {
  constexpr std::ptrdiff_t kReach = 4;  // nodes on either side that may move along
  const auto n = static_cast<std::ptrdiff_t>(nodes_.size());
  const auto begin = static_cast<std::ptrdiff_t>(first);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  if (!closed_ && (begin == 0 || end >= n)) return false;
  if (closed_ && n < static_cast<std::ptrdiff_t>(count) + 2 * kReach + 2) return false;
  const std::ptrdiff_t from =
      closed_ ? begin - kReach : std::max<std::ptrdiff_t>(0, begin - kReach);
  const std::ptrdiff_t to = closed_ ? end + kReach : std::min(n, end + kReach);

  bool whole = false;
  const std::vector<HalfedgeId> out = spokes(v, whole);
  const auto place = [&](const Node& node) {
    return node.fixed ? node.point : SurfacePoint::on_edge(surface_, node.edge, node.t);
  };
  const int p = slot(place(nodes_[index(begin - 1)]), v, out);
  const int q = slot(place(nodes_[index(end)]), v, out);
  if (p < 0 || q < 0) return false;

  std::vector<Node> present;
  for (std::ptrdiff_t i = from; i < to; ++i) present.push_back(nodes_[index(i)]);
  double best = length(present) * (1 - 1e-9);
  std::vector<Node> best_nodes;
  const int slots = static_cast<int>(2 * out.size());
  for (const int way : {+1, -1, 0}) {
    std::vector<Node> around;
    bool possible = true;
    if (way == 0) {
      around.push_back(node_at(SurfacePoint::at_vertex(surface_, v), true));
    } else {
      for (int s = p; s != q;) {
        const int next = s + way;
        if (!whole && (next < 0 || next > slots - 2)) {
          possible = false;
          break;
        }
        s = (next + slots) % slots;
        if (s % 2 != 0 || s == q) continue;
        const HalfedgeId h = out[static_cast<std::size_t>(s) / 2];
        const EdgeId e = edge_of(h);
        constexpr double kStart = 0.02;
        around.push_back(node_at(
            SurfacePoint::on_edge(surface_, e, h == halfedge_of(e) ? kStart : 1 - kStart), false));
      }
    }
    if (!possible) continue;
    std::vector<Node> trial;
    for (std::ptrdiff_t i = from; i < begin; ++i) trial.push_back(nodes_[index(i)]);
    trial.insert(trial.end(), around.begin(), around.end());
    for (std::ptrdiff_t i = end; i < to; ++i) trial.push_back(nodes_[index(i)]);
    const double length = settle(trial, 6);
    if (length < best) {
      best = length;
      best_nodes = std::move(trial);
    }
  }
  if (best_nodes.empty()) return false;
  ++passed_;
  std::vector<Node> all;
  if (from < 0 || to > n) {  // over the seam of a closed curve: turn it so that the window is whole
    std::rotate(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(index(from)),
                nodes_.end());
    all = best_nodes;
    all.insert(all.end(), nodes_.begin() + (to - from), nodes_.end());
  } else {
    all.assign(nodes_.begin(), nodes_.begin() + from);
    all.insert(all.end(), best_nodes.begin(), best_nodes.end());
    all.insert(all.end(), nodes_.begin() + to, nodes_.end());
  }
  nodes_.swap(all);
  return true;
}

/// Two points in a row on one edge: the curve turns back there, or runs along it.
void Polisher::untangle() {
  const auto place = [&](std::size_t i) {
    const Node& node = nodes_[i];
    return node.fixed ? node.point : SurfacePoint::on_edge(surface_, node.edge, node.t);
  };
  for (std::size_t i = 1; i + 2 < nodes_.size();) {
    const Node &a = nodes_[i], &b = nodes_[i + 1];
    if (a.fixed || b.fixed || a.edge != b.edge) {
      ++i;
      continue;
    }
    const auto at = nodes_.begin() + static_cast<std::ptrdiff_t>(i);
    if (common_face(surface_, place(i - 1), place(i + 2)).valid()) {
      nodes_.erase(at, at + 2);
    } else if (common_face(surface_, place(i - 1), place(i + 1)).valid()) {
      nodes_.erase(at);
    } else {
      ++i;
      continue;
    }
    if (i > 1) --i;
  }
}

bool Polisher::pass_vertices() {
  bool changed = false;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const bool pin = nodes_[i].fixed &&
                     std::find(pinned_.begin(), pinned_.end(), nodes_[i].point) != pinned_.end();
    const VertexId v = driven_to(nodes_[i]);
    if (!v.valid() || pin) continue;
    std::size_t count = 1;
    while (i + count < nodes_.size() && driven_to(nodes_[i + count]) == v) ++count;
    changed = pass_vertex(i, count, v) || changed;
  }
  return changed;
}

PolishResult Polisher::run(SurfaceCurve& curve) {
  load(curve);
  PolishResult result;
  if (nodes_.size() < 3) return result;
  const auto chain = [&] {
    std::vector<Node> nodes = nodes_;
    if (closed_) nodes.push_back(nodes_.front());
    return nodes;
  };
  result.length_before = result.length_after = length(chain());
  for (int round = 0; round < options_.max_rounds; ++round) {
    if (closed_) {  // the seam moves, so every point gets its turn
      std::rotate(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(nodes_.size() / 3),
                  nodes_.end());
    }
    std::vector<Node> nodes = chain();
    settle(nodes, options_.newton_steps);
    settle_by_parts(nodes);
    if (closed_) nodes.pop_back();
    nodes_ = std::move(nodes);
    const bool changed = pass_vertices();
    untangle();
    const double now = length(chain());
    const bool worth = result.length_after - now > options_.tolerance * now;
    result.length_after = std::min(result.length_after, now);
    if (!changed && !worth) break;
  }
  result.passed_vertices = passed_;
  curve.points.clear();
  for (const Node& node : nodes_) {
    curve.points.push_back(node.fixed ? node.point
                                      : SurfacePoint::on_edge(surface_, node.edge, node.t));
  }
  return result;
}

}  // namespace

void PolishOptions::validate() const {
  const auto fail = [](const char* message) { throw Error(ErrorCode::kBadUsage, message); };
  if (max_rounds < 0) fail("The polish's max_rounds must be >= 0.");
  if (newton_steps < 1) fail("The polish's newton_steps must be >= 1.");
  if (!(tolerance > 0)) fail("The polish's tolerance must be > 0.");
}

PolishResult polish(const SurfaceMesh& mesh, SurfaceCurve& curve, const ExactPotential& potential,
                    std::span<const SurfacePoint> pinned, const PolishOptions& options) {
  options.validate();
  return Polisher(mesh, potential, pinned, options).run(curve);
}

}  // namespace talweg
