#include "talweg/core/fairing/chain_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "talweg/core/fairing/near_points.hpp"
#include "talweg/core/fairing/saddle_passing.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/lines/face_frame.hpp"

namespace talweg {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLargest = 4.5 * kDegree, kSmall = 1 * kDegree;
constexpr double kApart = 0.55;  // of an edge
constexpr double kNear = 1e-6;   // edges

struct Node {
  SurfacePoint point;
  double arc = 0;
  bool kept = true;
  std::size_t in = 0, out = 0;  // the pieces of the trace that end and begin here
  bool stays = false;
  bool corner = false;
};

/// The points of a trace in order; equal points in succession are one node.
class Nodes {
 public:
  Nodes(const Surface& surface, const CurveTrace& trace) : trace_(&trace) {
    const std::size_t first = trace.closed ? 0 : 1;  // the first fixed point that is not an end
    std::size_t k = 0;
    for (std::size_t i = 0; i < trace.pieces.size(); ++i) {
      const TracePiece& piece = trace.pieces[i];
      if (i == 0 && !trace.closed) {
        add(trace.fixed_points.front(), i, 0, true, true);
      } else if (k < trace.fixed.size() && trace.fixed[k] == i) {
        add(trace.fixed_points[first + k], i, piece.arc, true, true);
        nodes_.back().corner |= !trace.corners.empty() && trace.corners[first + k];
        ++k;
      } else {
        add(piece.point(surface, 0), i, piece.arc, i > 0 && crosses_after(i - 1));
      }
    }
    if (!trace.closed) {
      add(trace.fixed_points.back(), trace.pieces.size(), trace.length, true, true);
    }
    while (trace.closed && nodes_.size() > 1 && nodes_.back().point == nodes_.front().point) {
      nodes_.front().in = nodes_.back().in;
      nodes_.pop_back();
    }
  }

  std::vector<Node> take() { return std::move(nodes_); }

 private:
  void add(const SurfacePoint& point, std::size_t piece, double arc, bool kept,
           bool stays = false) {
    if (!nodes_.empty() && nodes_.back().point == point) {
      nodes_.back().kept |= kept;
      nodes_.back().stays |= stays;
      nodes_.back().out = piece;
    } else {
      const std::size_t before = piece == 0 ? trace_->pieces.size() - 1 : piece - 1;
      nodes_.push_back({point, arc, kept, before, piece, stays});
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

/// Keeps more nodes where the curve through the kept nodes turns too much at one node.
class Selection {
 public:
  Selection(const Surface& surface, std::vector<Node>& nodes, const CurveTrace& trace, double edge)
      : surface_(&surface), nodes_(&nodes), trace_(&trace), edge_(edge), seen_(nodes.size()) {}

  void run() {
    if (trace_->closed) make_loop();
    for (bool more = true; more;) {
      more = false;
      const std::vector<std::size_t> kept = this->kept();
      if (kept.size() < 3) return;
      std::vector<std::size_t> wanted;
      const std::size_t n = kept.size();
      const bool closed = trace_->closed;
      for (std::size_t k = closed ? 0 : 1; k < (closed ? n : n - 1); ++k) {
        const std::size_t before = kept[k == 0 ? n - 1 : k - 1],
                          after = kept[k + 1 == n ? 0 : k + 1];
        // A node between the same neighbours as in an earlier round is done.
        const std::array<std::size_t, 2> beside{before + 1, after + 1};
        if (seen_[kept[k]] == beside) continue;
        seen_[kept[k]] = beside;
        look_at(before, kept[k], after, wanted);
      }
      for (const std::size_t i : wanted) {
        more = more || !(*nodes_)[i].kept;
        (*nodes_)[i].kept = true;
      }
    }
  }

 private:
  /// Keeps three nodes of a loop with fewer crossings of edges, inside one face or around the end
  /// of an edge.
  void make_loop() {
    const std::size_t least = std::min<std::size_t>(3, nodes_->size());
    for (std::vector<std::size_t> kept = this->kept(); kept.size() < least; kept = this->kept()) {
      std::vector<std::size_t> wanted;
      if (kept.empty()) wanted.push_back(0);
      for (std::size_t k = 0; k < kept.size(); ++k) {
        const std::size_t from = kept[k], to = kept[(k + 1) % kept.size()];
        halve(from, to, from == to ? trace_->length : gap(from, to), wanted);
      }
      for (const std::size_t i : wanted) (*nodes_)[i].kept = true;
    }
  }

  [[nodiscard]] std::vector<std::size_t> kept() const {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < nodes_->size(); ++i) {
      if ((*nodes_)[i].kept) kept.push_back(i);
    }
    return kept;
  }

  void look_at(std::size_t before, std::size_t at, std::size_t after,
               std::vector<std::size_t>& wanted) const {
    if ((*nodes_)[at].corner) return;
    const double turn = std::abs(turn_at(before, at, after));
    if (turn <= kSmall) return;
    const double in = gap(before, at), out = gap(at, after);
    if (turn <= kLargest && std::max(in, out) <= kApart * edge_) return;
    if (turn > kLargest || in > kApart * edge_) halve(before, at, in, wanted);
    if (turn > kLargest || out > kApart * edge_) halve(at, after, out, wanted);
  }

  /// The turn at a node, measured in the faces of the pieces beside it. All points between two kept
  /// nodes lie in one face.
  [[nodiscard]] double turn_at(std::size_t before, std::size_t at, std::size_t after) const {
    const Node &a = (*nodes_)[before], &b = (*nodes_)[at], &c = (*nodes_)[after];
    const TracePiece &first = trace_->pieces[a.out], &in = trace_->pieces[b.in],
                     &out = trace_->pieces[b.out], &last = trace_->pieces[c.in];
    const auto* edge = std::get_if<OnEdge>(&b.point.where());
    if (first.face != in.face || out.face != last.face || b.point.is_vertex() ||
        (edge == nullptr && in.face != out.face)) {
      return signed_turning(*surface_, a.point, b.point, c.point);
    }
    const auto way = [](const FaceFrame& frame, const auto& from, const auto& to) {
      return frame.at({to[0] - from[0], to[1] - from[1], to[2] - from[2]});
    };
    const FaceFrame here(*surface_, in.face);
    const PlanePoint arriving = way(here, first.from, in.to);
    if (in.face == out.face) return angle(arriving, way(here, out.from, last.to));
    const FaceFrame there(*surface_, out.face);
    const PlanePoint leaving = way(there, out.from, last.to);
    // Both directions are compared in the frame of the edge.
    const auto along = [&](const FaceFrame& frame) {
      const HalfedgeId h = halfedge_of(edge->edge);
      for (std::size_t k = 0; k < 3; ++k) {
        if (frame.sides[k] == h) return frame.along(k);
        if (frame.sides[k] == twin(h)) return -1 * frame.along(k);
      }
      return PlanePoint{};
    };
    const PlanePoint p = along(here), q = along(there);
    return angle({dot(p, arriving), cross(p, arriving)}, {dot(q, leaving), cross(q, leaving)});
  }
  static double angle(PlanePoint from, PlanePoint to) {
    return std::atan2(cross(from, to), dot(from, to));
  }

  [[nodiscard]] double gap(std::size_t from, std::size_t to) const {
    const double gap = (*nodes_)[to].arc - (*nodes_)[from].arc;
    return gap < 0 ? gap + trace_->length : gap;
  }

  /// Appends the node nearest to the middle between two kept nodes to `wanted`, if there is any.
  void halve(std::size_t from, std::size_t to, double gap, std::vector<std::size_t>& wanted) const {
    const std::size_t n = nodes_->size();
    std::size_t best = n;
    double least = HUGE_VAL;
    const auto next = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
    for (std::size_t i = next(from); i != to; i = next(i)) {
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
  const CurveTrace* trace_;
  double edge_;
  std::vector<std::array<std::size_t, 2>> seen_;  // per node: its last neighbours, counted from 1
};

}  // namespace

SurfaceCurve curve_of(const Surface& surface, ChainMaker& maker, const SampleChain& chain,
                      double edge) {
  const CurveTrace trace = maker.trace_of(chain);
  std::vector<Node> nodes = Nodes(surface, trace).take();
  Selection(surface, nodes, trace, edge).run();
  std::vector<KeptPoint> kept;
  for (const Node& node : nodes) {
    if (node.kept) kept.push_back({node.point, node.arc, node.stays});
  }
  drop_near_points(surface, chain.closed, trace.length, kNear * edge, kept);
  return SaddlePassing(surface).moved_off_saddles(kept, chain.closed);
}

}  // namespace talweg
