#include "talweg/core/fairing/chain_curve.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "talweg/core/fairing/saddle_passing.hpp"
#include "talweg/core/measure/measures.hpp"

namespace talweg {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLargest = 4.5 * kDegree, kSmall = 1 * kDegree;
constexpr double kApart = 0.55;  // of an edge

struct Node {
  SurfacePoint point;
  double arc = 0;
  bool kept = true;
  bool stays = false;
};

/// The curve's points in their order; one that is met twice in succession counts once.
class Nodes {
 public:
  Nodes(const Surface& surface, const CurveTrace& trace) : trace_(&trace) {
    const std::size_t first = trace.closed ? 0 : 1;  // of the fixed points that are no end
    std::size_t k = 0;
    for (std::size_t i = 0; i < trace.pieces.size(); ++i) {
      const TracePiece& piece = trace.pieces[i];
      if (i == 0 && !trace.closed) {
        add(trace.fixed_points.front(), 0, true, true);
      } else if (k < trace.fixed.size() && trace.fixed[k] == i) {
        add(trace.fixed_points[first + k++], piece.arc, true, true);
      } else {
        add(piece.point(surface, 0), piece.arc, i > 0 && crosses_after(i - 1));
      }
    }
    if (!trace.closed) add(trace.fixed_points.back(), trace.length, true, true);
    while (trace.closed && nodes_.size() > 1 && nodes_.back().point == nodes_.front().point) {
      nodes_.pop_back();
    }
  }

  std::vector<Node> take() { return std::move(nodes_); }

 private:
  void add(const SurfacePoint& point, double arc, bool kept, bool stays = false) {
    if (!nodes_.empty() && nodes_.back().point == point) {
      nodes_.back().kept |= kept;
      nodes_.back().stays |= stays;
    } else {
      nodes_.push_back({point, arc, kept, stays});
    }
  }
  [[nodiscard]] bool crosses_after(std::size_t piece) const {
    const auto& pieces = trace_->pieces;
    return (piece + 1 < pieces.size() ? pieces[piece + 1].crossed : trace_->crossed.size()) >
           pieces[piece].crossed;
  }

  const CurveTrace* trace_;
  std::vector<Node> nodes_;
};

/// Keeps nodes where the curve of those that are kept turns too much at one point.
class Selection {
 public:
  Selection(const Surface& surface, std::vector<Node>& nodes, const CurveTrace& trace, double edge)
      : surface_(&surface),
        nodes_(&nodes),
        closed_(trace.closed),
        length_(trace.length),
        edge_(edge) {}

  void run() {
    for (bool more = true; more;) {
      more = false;
      const std::vector<std::size_t> kept = this->kept();
      if (kept.size() < 3) return;
      std::vector<std::size_t> wanted;
      const std::size_t n = kept.size();
      for (std::size_t k = closed_ ? 0 : 1; k < (closed_ ? n : n - 1); ++k) {
        look_at(kept[(k + n - 1) % n], kept[k], kept[(k + 1) % n], wanted);
      }
      for (const std::size_t i : wanted) {
        more = more || !(*nodes_)[i].kept;
        (*nodes_)[i].kept = true;
      }
    }
  }

 private:
  [[nodiscard]] std::vector<std::size_t> kept() const {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < nodes_->size(); ++i) {
      if ((*nodes_)[i].kept) kept.push_back(i);
    }
    return kept;
  }

  void look_at(std::size_t before, std::size_t at, std::size_t after,
               std::vector<std::size_t>& wanted) const {
    const double turn = std::abs(signed_turning(*surface_, (*nodes_)[before].point,
                                                (*nodes_)[at].point, (*nodes_)[after].point));
    if (turn <= kSmall) return;
    const double in = gap(before, at), out = gap(at, after);
    if (turn <= kLargest && std::max(in, out) <= kApart * edge_) return;
    if (turn > kLargest || in > kApart * edge_) halve(before, at, in, wanted);
    if (turn > kLargest || out > kApart * edge_) halve(at, after, out, wanted);
  }

  [[nodiscard]] double gap(std::size_t from, std::size_t to) const {
    const double gap = (*nodes_)[to].arc - (*nodes_)[from].arc;
    return gap < 0 ? gap + length_ : gap;
  }

  /// Wants the node nearest to the middle between two that are kept, if there is any.
  void halve(std::size_t from, std::size_t to, double gap, std::vector<std::size_t>& wanted) const {
    const std::size_t n = nodes_->size();
    std::size_t best = n;
    double least = HUGE_VAL;
    for (std::size_t i = (from + 1) % n; i != to; i = (i + 1) % n) {
      const double off = std::abs(this->gap(from, i) - gap / 2);
      if (off < least) {
        least = off;
        best = i;
      }
    }
    if (best < n) wanted.push_back(best);
  }

  const Surface* surface_;
  std::vector<Node>* nodes_;
  bool closed_;
  double length_, edge_;
};

}  // namespace

SurfaceCurve curve_of(const Surface& surface, ChainMaker& maker, const SampleChain& chain,
                      double edge) {
  const CurveTrace trace = maker.trace_of(chain);
  std::vector<Node> nodes = Nodes(surface, trace).take();
  Selection(surface, nodes, trace, edge).run();
  std::erase_if(nodes, [](const Node& node) { return !node.kept; });
  SaddlePassing passing(surface);
  SurfaceCurve curve{chain.closed, {}};
  const std::size_t n = nodes.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto* at = std::get_if<AtVertex>(&nodes[i].point.where());
    if (at == nullptr || nodes[i].stays) {
      curve.points.push_back(nodes[i].point);
      continue;
    }
    const SurfacePoint& before = i > 0 ? curve.points.back() : nodes[n - 1].point;
    for (const SurfacePoint& point : passing.beside(before, at->vertex, nodes[(i + 1) % n].point)) {
      curve.points.push_back(point);
    }
  }
  return curve;
}

}  // namespace talweg
