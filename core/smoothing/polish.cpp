#include "talweg/core/smoothing/polish.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::size_t kOfPolishNode = 8;  // units of work each time a node is visited

/// How far from the origin the line from radius p at angle 0 to radius q at angle `end` crosses the
/// ray at `angle`; 0 where it goes around the other side.
double straight_across(double p, double q, double end, double angle) {
  if (end >= std::numbers::pi) return 0;
  return p * q * std::sin(end) / (p * std::sin(angle) + q * std::sin(end - angle));
}

class Polisher {
 public:
  Polisher(const SurfaceMesh& mesh, const ExactPotential& potential,
           std::span<const SurfacePoint> pinned, const PolishOptions& options, double scale,
           Asker& asker)
      : mesh_(mesh),
        surface_(mesh.surface()),
        asker_(asker),
        chain_(mesh, potential, options.tolerance, scale, &asker),
        pinned_(pinned),
        options_(options),
        tiny_(1e-6 * scale) {}

  PolishResult run(SurfaceCurve& curve);

 private:
  void load(const SurfaceCurve& curve);
  [[nodiscard]] std::pair<std::size_t, std::size_t> run_at(std::size_t i, bool whole) const;
  void settle_awake(bool whole);
  void turn();
  [[nodiscard]] double length() const;
  void untangle();
  [[nodiscard]] bool has_changed(std::size_t first, std::size_t count) const;
  bool pass_vertices();
  bool pass_vertex(std::size_t first, std::size_t count, VertexId v);
  [[nodiscard]] bool is_present(std::size_t first, std::size_t count, std::size_t before) const;
  double settled_below(double goal);
  bool way_around(const ChainNode& from, const ChainNode& to, int way, VertexId v,
                  LiftedChain::Nodes& trial);
  void find_spokes(VertexId v);
  [[nodiscard]] int slot(const SurfacePoint& p, VertexId v) const;
  [[nodiscard]] VertexId driven_to(const ChainNode& node) const;
  [[nodiscard]] bool is_clear_of(VertexId v, std::size_t before, std::size_t after) const;
  [[nodiscard]] bool pinned(const SurfacePoint& p) const {
    return std::find(pinned_.begin(), pinned_.end(), p) != pinned_.end();
  }
  void store(SurfaceCurve& curve) const;
  [[nodiscard]] ChainNode& ahead(std::size_t next, std::size_t k);
  [[nodiscard]] ChainNode& behind(std::size_t k);

  const SurfaceMesh& mesh_;
  const Surface& surface_;
  Asker& asker_;
  LiftedChain chain_;
  std::span<const SurfacePoint> pinned_;
  PolishOptions options_;
  double tiny_;  // shorter lengths count as none
  bool closed_ = false;
  LiftedChain::Nodes nodes_;
  LiftedChain::Nodes done_;  // the nodes already visited while nodes_ is traversed
  std::vector<HalfedgeId> spokes_;
  bool whole_ = false;  // whether the spokes go all around the vertex
  struct Crossed {
    HalfedgeId spoke;
    double angle = 0;  // between the start of the way and this spoke
  };
  std::vector<Crossed> crossed_;
  LiftedChain::Nodes trial_, best_;
  std::size_t passed_ = 0;
  int round_ = 0;
};

void Polisher::load(const SurfaceCurve& curve) {
  closed_ = curve.closed;
  nodes_.clear();
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    asker_.did(kOfPolishNode + pinned_.size());
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

void Polisher::find_spokes(VertexId v) {
  spokes_.clear();
  const HalfedgeId first = surface_.halfedge(v);
  whole_ = true;
  HalfedgeId h = first;
  do {
    spokes_.push_back(h);
    if (!surface_.has_face(h)) {
      whole_ = false;
      break;
    }
    h = surface_.turn_ccw(h);
  } while (h != first);
}

/// Where a point lies around v: 2 k on spoke k, 2 k + 1 in the face after it, -1 elsewhere.
int Polisher::slot(const SurfacePoint& p, VertexId v) const {
  const auto& out = spokes_;
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

/// The k-th node not visited yet, and the k-th of those visited last; on a loop both continue over
/// the seam.
ChainNode& Polisher::ahead(std::size_t next, std::size_t k) {
  const std::size_t left = nodes_.size() - next;
  return k < left ? nodes_[next + k] : done_[k - left];
}
ChainNode& Polisher::behind(std::size_t k) {
  const std::size_t n = done_.size();
  return k < n ? done_[n - 1 - k] : nodes_[nodes_.size() - 1 - (k - n)];
}

/// Appends the nodes of one way around v (way = +1 or -1), or of that through v (way = 0), from a
/// node in slot `from` to one in `to`. False where there is no such way.
bool Polisher::way_around(const ChainNode& from, const ChainNode& to, int way, VertexId v,
                          LiftedChain::Nodes& trial) {
  if (way == 0) {
    trial.push_back(chain_.node_at(SurfacePoint::at_vertex(surface_, v), true));
    return true;
  }
  const int p = slot(chain_.place(from), v), q = slot(chain_.place(to), v);
  const int slots = static_cast<int>(2 * spokes_.size());
  const Point centre = mesh_.point(v);
  Point last = from.y.head<3>() - centre;
  const Point target = to.y.head<3>() - centre;
  const double from_radius = last.norm();
  crossed_.clear();
  double turned = 0;
  const auto turn_to = [&](const Point& next) {
    turned += std::atan2(last.cross(next).norm(), last.dot(next));
    last = next;
  };
  for (int s = p; s != q;) {
    const int next = s + way;
    if (!whole_ && (next < 0 || next > slots - 2)) return false;
    s = (next + slots) % slots;
    if (s % 2 != 0 || s == q) continue;
    const HalfedgeId h = spokes_[static_cast<std::size_t>(s) / 2];
    turn_to(mesh_.point(surface_.head(h)) - centre);
    crossed_.push_back({h, turned});
  }
  turn_to(target);
  for (const auto& [h, angle] : crossed_) {
    const EdgeId e = edge_of(h);
    const double part =
        straight_across(from_radius, target.norm(), turned, angle) / surface_.length(e);
    constexpr double kStart = 0.001;
    const double t = part > kStart ? std::min(part, 1 - kStart) : kStart;  // also where it is NaN
    trial.push_back(
        chain_.node_at(SurfacePoint::on_edge(surface_, e, h == halfedge_of(e) ? t : 1 - t), false));
  }
  return true;
}

/// Whether the way in trial_, after its first `before` nodes, is the one that the curve takes
/// already.
bool Polisher::is_present(std::size_t first, std::size_t count, std::size_t before) const {
  if (trial_.size() != before + count) return false;
  for (std::size_t k = 0; k < count; ++k) {
    const ChainNode &a = nodes_[first + k], &b = trial_[before + k];
    if (a.fixed != b.fixed || (a.fixed ? a.point != b.point : a.edge != b.edge)) return false;
  }
  return true;
}

/// Settles trial_ and returns its length. Stops early when the length is not going to fall below
/// `goal`, because each Newton step gains less than the one before.
double Polisher::settled_below(double goal) {
  const double early = chain_.settle(trial_, 2);
  const double late = chain_.settle(trial_, 1);
  if (late - goal > 3 * (early - late)) return late;
  return chain_.settle(trial_, 3);
}

/// Whether the best way found passes v without being driven to it.
bool Polisher::is_clear_of(VertexId v, std::size_t before, std::size_t after) const {
  return std::none_of(best_.begin() + static_cast<std::ptrdiff_t>(before),
                      best_.end() - static_cast<std::ptrdiff_t>(after),
                      [&](const ChainNode& node) { return driven_to(node) == v; });
}

/// Tries the ways around v for the nodes [first, first + count): on either side, or through it.
/// Appends the nodes that replace them to done_.
bool Polisher::pass_vertex(std::size_t first, std::size_t count, VertexId v) {
  constexpr std::size_t kReach = 4;  // nodes on either side that may move along
  const std::size_t next = first + count;
  std::size_t before = kReach, after = kReach;
  if (closed_) {
    if (done_.size() + nodes_.size() - first < count + 2 * kReach + 2) return false;
  } else {
    before = std::min(before, done_.size());
    after = std::min(after, nodes_.size() - next);
    if (before == 0 || after == 0) return false;
  }
  find_spokes(v);
  const ChainNode from = behind(0), to = ahead(next, 0);
  if (slot(chain_.place(from), v) < 0 || slot(chain_.place(to), v) < 0) return false;

  const auto begin = [&] {
    trial_.clear();
    for (std::size_t k = before; k-- > 0;) trial_.push_back(behind(k));
  };
  const auto end = [&] {
    for (std::size_t k = 0; k < after; ++k) trial_.push_back(ahead(next, k));
  };
  begin();
  for (std::size_t k = 0; k < count; ++k) trial_.push_back(nodes_[first + k]);
  end();
  double best = chain_.length(trial_) * (1 - 1e-9);
  bool found = false;
  for (const int way : {+1, -1, 0}) {
    // A way that passes clear of the vertex would gain nothing by touching it.
    if (way == 0 && found && is_clear_of(v, before, after)) break;
    begin();
    if (!way_around(from, to, way, v, trial_) || is_present(first, count, before)) continue;
    end();
    const double length = settled_below(best);
    if (!(length < best)) continue;
    best = length;
    best_.swap(trial_);
    found = true;
  }
  if (!found) return false;
  ++passed_;
  for (ChainNode& node : best_) {
    node.awake = true;
    node.changed = round_ + 1;  // so that vertices it is driven to are tried in the next round
  }
  for (std::size_t k = 0; k < before; ++k) behind(k) = best_[before - 1 - k];
  for (std::size_t k = 0; k < after; ++k) ahead(next, k) = best_[best_.size() - after + k];
  done_.insert(done_.end(), best_.begin() + static_cast<std::ptrdiff_t>(before),
               best_.end() - static_cast<std::ptrdiff_t>(after));
  return true;
}

/// Removes points that the curve does not need: a point whose neighbours share a face (the curve
/// only touches its edge), and two successive points on one edge (the curve turns back there, or
/// runs along it). Points stay if the curve would become longer without them, because it comes
/// nearer to a wall.
void Polisher::untangle() {
  const auto in_one_face = [&](const ChainNode& a, const ChainNode& b) {
    return common_face(surface_, chain_.place(a), chain_.place(b)).valid();
  };
  const auto is_no_longer = [&](const ChainNode& a, const ChainNode& without, const ChainNode& b) {
    return chain_.length(a, b) <= chain_.length(a, without) + chain_.length(without, b);
  };
  const std::size_t least = closed_ ? 3 : 2;
  done_.clear();
  for (std::size_t next = 0; next < nodes_.size();) {
    asker_.did(kOfPolishNode);
    done_.push_back(nodes_[next++]);
    while (done_.size() > 1 && next < nodes_.size() && !behind(0).fixed &&
           done_.size() + nodes_.size() - next > least) {
      const bool doubled = !behind(1).fixed && behind(1).edge == behind(0).edge;
      const bool moved = std::max(behind(0).changed, nodes_[next].changed) >= round_;
      if (!doubled && !moved) break;
      if (in_one_face(behind(1), nodes_[next]) &&
          is_no_longer(behind(1), behind(0), nodes_[next])) {
        done_.pop_back();
      } else if (doubled && done_.size() > 2 && in_one_face(behind(2), behind(0)) &&
                 is_no_longer(behind(2), behind(1), behind(0))) {
        done_.erase(done_.end() - 2);
      } else {
        break;
      }
      for (ChainNode* node : {&done_.back(), &nodes_[next]}) {
        node->awake = true;
        node->changed = round_ + 1;
      }
    }
  }
  nodes_.swap(done_);
}

/// Whether these nodes or their neighbours have changed since they were last tried.
bool Polisher::has_changed(std::size_t first, std::size_t count) const {
  const auto changed = [&](const ChainNode& node) { return node.changed >= round_; };
  if (!done_.empty() && changed(done_.back())) return true;
  const std::size_t end = std::min(nodes_.size(), first + count + 1);
  for (std::size_t i = first; i < end; ++i) {
    if (changed(nodes_[i])) return true;
  }
  return false;
}

bool Polisher::pass_vertices() {
  bool changed = false;
  done_.clear();
  for (std::size_t i = 0; i < nodes_.size();) {
    asker_.did(kOfPolishNode + pinned_.size());
    const bool pin = nodes_[i].fixed && pinned(nodes_[i].point);
    const VertexId v = pin ? VertexId{} : driven_to(nodes_[i]);
    std::size_t count = 1;
    if (v.valid()) {
      while (i + count < nodes_.size() && driven_to(nodes_[i + count]) == v) ++count;
    }
    if (v.valid() && has_changed(i, count) && pass_vertex(i, count, v)) {
      changed = true;
    } else {
      const auto from = nodes_.begin() + static_cast<std::ptrdiff_t>(i);
      done_.insert(done_.end(), from, from + static_cast<std::ptrdiff_t>(count));
    }
    i += count;
  }
  nodes_.swap(done_);
  return changed;
}

/// The range [first, second) of nodes to settle together with node i: the nodes near it that still
/// gain, plus a few neighbours, or all nodes between two fixed ones.
std::pair<std::size_t, std::size_t> Polisher::run_at(std::size_t i, bool whole) const {
  constexpr std::size_t kMargin = 4;
  const std::size_t n = nodes_.size();
  std::size_t begin = i - std::min(i, whole ? 1 : kMargin), last = i, end = i + 1;
  if (whole) {
    while (begin > 0 && !nodes_[begin].fixed) --begin;
    while (end < n && !nodes_[end].fixed) ++end;
    return {begin, std::min(n, end + 1)};
  }
  for (; end < n && end <= last + 2 * kMargin; ++end) {
    if (nodes_[end].awake) last = end;
  }
  return {begin, std::min(n, last + 1 + kMargin)};
}

/// Settles only the nodes that still gain.
void Polisher::settle_awake(bool whole) {
  const bool front = nodes_.front().awake;
  if (closed_) nodes_.push_back(nodes_.front());
  for (std::size_t i = 0; i < nodes_.size();) {
    if (!nodes_[i].awake) {
      ++i;
      continue;
    }
    const auto [begin, end] = run_at(i, whole);
    const auto run = std::span(nodes_).subspan(begin, end - begin);
    chain_.settle(run, options_.newton_steps);
    chain_.settle_by_parts(run);
    i = std::max(end - 1, i + 1);
  }
  if (!closed_) return;
  nodes_.pop_back();
  nodes_.front().awake = front;  // the seam was fixed and not settled
}

/// Moves the seam of a loop, because the seam's point does not move.
void Polisher::turn() {
  if (!closed_) return;
  const auto third = static_cast<std::ptrdiff_t>(nodes_.size() / 3);
  std::rotate(nodes_.begin(), nodes_.begin() + third, nodes_.end());
}

double Polisher::length() const {
  if (!closed_) return chain_.length(nodes_);
  return chain_.length(nodes_) + chain_.length(std::array{nodes_.back(), nodes_.front()});
}

/// Replaces neighbouring points that are numerically at a vertex by that vertex, because the turns
/// between such points are only rounding.
void Polisher::store(SurfaceCurve& curve) const {
  const auto vertex_at = [&](const ChainNode& node) {
    const VertexId v = node.fixed ? VertexId{} : driven_to(node);
    return v.valid() && (node.y.head<3>() - mesh_.point(v)).norm() < tiny_ ? v : VertexId{};
  };
  curve.points.clear();
  for (std::size_t i = 0; i < nodes_.size();) {
    const VertexId v = vertex_at(nodes_[i]);
    std::size_t end = i + 1;
    while (v.valid() && end < nodes_.size() && vertex_at(nodes_[end]) == v) ++end;
    curve.points.push_back(end > i + 1 ? SurfacePoint::at_vertex(surface_, v)
                                       : chain_.place(nodes_[i]));
    i = end;
  }
}

PolishResult Polisher::run(SurfaceCurve& curve) {
  load(curve);
  PolishResult result;
  if (nodes_.size() < 3) return result;
  result.length_before = result.length_after = length();
  bool whole = true;  // first all nodes together, then only those that still gain, and so on
  for (round_ = 0; round_ < options_.max_rounds; ++round_) {
    asker_.is_at(static_cast<double>(round_) / options_.max_rounds);
    turn();
    chain_.begin_round(round_);
    settle_awake(whole);
    const bool changed = pass_vertices();
    untangle();
    const bool awake =
        std::any_of(nodes_.begin(), nodes_.end(), [](const ChainNode& node) { return node.awake; });
    const bool was_whole = std::exchange(whole, !whole && (!(changed || awake) || round_ % 3 == 2));
    if (was_whole) {
      const double now = length();
      const bool worth = result.length_after - now > options_.tolerance * now;
      result.length_after = std::min(result.length_after, now);
      if (!changed && !(worth && awake)) break;
    }
    if (whole) {
      for (ChainNode& node : nodes_) node.awake = true;
    }
  }
  result.length_after = std::min(result.length_after, length());
  result.passed_vertices = passed_;
  store(curve);
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
                    std::span<const SurfacePoint> pinned, const PolishOptions& options,
                    const Progress& progress) {
  options.validate();
  if (curve.points.size() < 3) return {};
  const double scale =
      curve_length(mesh.surface(), curve) / static_cast<double>(curve.points.size());
  Asker asker(progress, "polish");
  return Polisher(mesh, potential, pinned, options, scale, asker).run(curve);
}

}  // namespace talweg
