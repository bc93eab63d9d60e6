#include "talweg/core/polish.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

class Polisher {
 public:
  Polisher(const SurfaceMesh& mesh, const ExactPotential& potential,
           std::span<const SurfacePoint> pinned, const PolishOptions& options)
      : surface_(mesh.surface()),
        chain_(mesh, potential, options.tolerance),
        pinned_(pinned),
        options_(options) {}

  PolishResult run(SurfaceCurve& curve);

 private:
  void load(const SurfaceCurve& curve);
  void untangle();
  bool pass_vertices();
  bool pass_vertex(std::size_t first, std::size_t count, VertexId v);
  std::vector<HalfedgeId> spokes(VertexId v, bool& whole) const;
  int slot(const SurfacePoint& p, VertexId v, const std::vector<HalfedgeId>& out) const;
  VertexId driven_to(const ChainNode& node) const;
  [[nodiscard]] bool pinned(const SurfacePoint& p) const {
    return std::find(pinned_.begin(), pinned_.end(), p) != pinned_.end();
  }
  std::size_t index(std::ptrdiff_t i) const {
    const auto n = static_cast<std::ptrdiff_t>(nodes_.size());
    return static_cast<std::size_t>(((i % n) + n) % n);
  }

  const Surface& surface_;
  LiftedChain chain_;
  std::span<const SurfacePoint> pinned_;
  PolishOptions options_;
  bool closed_ = false;
  LiftedChain::Nodes nodes_;
  std::size_t passed_ = 0;
};

void Polisher::load(const SurfaceCurve& curve) {
  closed_ = curve.closed;
  nodes_.clear();
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SurfacePoint& p = curve.points[i];
    const bool end = !closed_ && (i == 0 || i + 1 == n);
    const bool pin = end || pinned(p);
    if (!pin && std::holds_alternative<InFace>(p.where()) &&
        common_face(surface_, nodes_.empty() ? curve.points[n - 1] : nodes_.back().point,
                    curve.points[(i + 1) % n])
            .valid()) {
      continue;
    }
    nodes_.push_back(chain_.node_at(p, pin));
  }
}

/// The vertex that a point wants to pass, or the one it is at.
VertexId Polisher::driven_to(const ChainNode& node) const {
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
  const int p = slot(chain_.place(nodes_[index(begin - 1)]), v, out);
  const int q = slot(chain_.place(nodes_[index(end)]), v, out);
  if (p < 0 || q < 0) return false;

  LiftedChain::Nodes present;
  for (std::ptrdiff_t i = from; i < to; ++i) present.push_back(nodes_[index(i)]);
  double best = chain_.length(present) * (1 - 1e-9);
  LiftedChain::Nodes best_nodes;
  const int slots = static_cast<int>(2 * out.size());
  for (const int way : {+1, -1, 0}) {
    LiftedChain::Nodes around;
    bool possible = true;
    if (way == 0) {
      around.push_back(chain_.node_at(SurfacePoint::at_vertex(surface_, v), true));
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
        around.push_back(chain_.node_at(
            SurfacePoint::on_edge(surface_, e, h == halfedge_of(e) ? kStart : 1 - kStart), false));
      }
    }
    if (!possible) continue;
    LiftedChain::Nodes trial;
    for (std::ptrdiff_t i = from; i < begin; ++i) trial.push_back(nodes_[index(i)]);
    trial.insert(trial.end(), around.begin(), around.end());
    for (std::ptrdiff_t i = end; i < to; ++i) trial.push_back(nodes_[index(i)]);
    const double length = chain_.settle(trial, 6);
    if (length < best) {
      best = length;
      best_nodes = std::move(trial);
    }
  }
  if (best_nodes.empty()) return false;
  ++passed_;
  LiftedChain::Nodes all;
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
  const auto place = [&](std::size_t i) { return chain_.place(nodes_[i]); };
  for (std::size_t i = 1; i + 2 < nodes_.size();) {
    const ChainNode &a = nodes_[i], &b = nodes_[i + 1];
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
    const bool pin = nodes_[i].fixed && pinned(nodes_[i].point);
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
    LiftedChain::Nodes nodes = nodes_;
    if (closed_) nodes.push_back(nodes_.front());
    return nodes;
  };
  result.length_before = result.length_after = chain_.length(chain());
  for (int round = 0; round < options_.max_rounds; ++round) {
    if (closed_) {  // the seam moves, so every point gets its turn
      std::rotate(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(nodes_.size() / 3),
                  nodes_.end());
    }
    LiftedChain::Nodes nodes = chain();
    chain_.settle(nodes, options_.newton_steps);
    chain_.settle_by_parts(nodes);
    if (closed_) nodes.pop_back();
    nodes_ = std::move(nodes);
    const bool changed = pass_vertices();
    untangle();
    const double now = chain_.length(chain());
    const bool worth = result.length_after - now > options_.tolerance * now;
    result.length_after = std::min(result.length_after, now);
    if (!changed && !worth) break;
  }
  result.passed_vertices = passed_;
  curve.points.clear();
  for (const ChainNode& node : nodes_) curve.points.push_back(chain_.place(node));
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
