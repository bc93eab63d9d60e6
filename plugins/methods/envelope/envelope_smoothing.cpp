#include "envelope_smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <fmt/format.h>

#include "strands.hpp"
#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/exact_distance/polyline_distance.hpp"
#include "vertex_passage.hpp"

namespace talweg::plugins {
namespace {

constexpr std::uint32_t kNone = StrandNode::kNone;
constexpr double kStraight = 1e-6;  // radians: a smaller turn is not split
constexpr double kFloor = 3;        // mesh edges: a shorter loop has collapsed
constexpr int kHalvings = 30;
constexpr double kMargin = 1e-6;  // as a fraction of an edge's length
// A fraction of an edge's length: a node this near to a vertex may pass it.
constexpr double kNear = 0.1;

class EnvelopeSmoothing {
 public:
  EnvelopeSmoothing(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                    std::span<const SurfacePoint> pins, const EnvelopeOptions& options)
      : mesh_(mesh),
        options_(options),
        drawn_(curves),
        distance_(mesh.surface()),
        strands_(mesh, curves, pins) {
    distance_.set(curves);
    for (const SurfaceCurve& curve : curves) {
      floors_.push_back(kFloor * edge_length_near(mesh.surface(), curve));
    }
    result_.collapsed.assign(curves.size(), 0);
  }

  EnvelopeResult run();

 private:
  [[nodiscard]] bool is_inside(const SurfacePoint& p) {
    return distance_.at(p).distance <= options_.envelope;
  }
  [[nodiscard]] bool is_free(std::uint32_t node) const {
    const StrandNode& n = strands_[node];
    return n.alive && !n.fixed && n.before != kNone && n.after != kNone;
  }
  [[nodiscard]] double best_place(std::uint32_t node) const;
  void slide(std::uint32_t node);
  void slide_all();
  bool merge(std::uint32_t node);
  bool pass_over(std::uint32_t node);
  bool pass_over(std::uint32_t node, HalfedgeId spoke);
  [[nodiscard]] HalfedgeId spoke_of(std::uint32_t node, VertexId v) const;
  bool split(std::uint32_t node);
  bool split_to(std::uint32_t node, const PassageSide& side);
  void tidy();
  void stop_collapsed();
  [[nodiscard]] double length() const;

  const SurfaceMesh& mesh_;
  const EnvelopeOptions& options_;
  std::span<const SurfaceCurve> drawn_;
  PolylineDistance distance_;
  Strands strands_;
  std::vector<double> floors_;  // per curve
  EnvelopeResult result_;
};

/// The best parameter on the node's edge, not limited to [0, 1].
double EnvelopeSmoothing::best_place(std::uint32_t node) const {
  const StrandNode& n = strands_[node];
  const OnEdge& here = std::get<OnEdge>(n.at.where());
  const HalfedgeId h = halfedge_of(here.edge);
  const Point along = mesh_.point(mesh_.surface().head(h)) - mesh_.point(mesh_.surface().tail(h));
  const Point before = strands_[n.before].position - n.position;
  const Point after = strands_[n.after].position - n.position;
  const double first = before.norm(), second = after.norm(), squared = along.squaredNorm();
  // A neighbour at the same place does not pull, and its weight would be infinite.
  if (!(squared > 0) || !(first > 0) || !(second > 0)) return here.t;
  const double pull = second * before.dot(along) + first * after.dot(along);
  return here.t + pull / ((first + second) * squared);
}

void EnvelopeSmoothing::slide(std::uint32_t node) {
  const Surface& surface = mesh_.surface();
  const OnEdge here = std::get<OnEdge>(strands_[node].at.where());
  const Strands::Room room = strands_.room(node);
  const double best = best_place(node);
  double t = std::clamp(here.t + options_.weight * (best - here.t), room.low, room.high);
  const auto at = [&](double s) {
    const HalfedgeId h = halfedge_of(here.edge);
    if (s <= 0) return SurfacePoint::at_vertex(surface, surface.tail(h));
    if (s >= 1) return SurfacePoint::at_vertex(surface, surface.head(h));
    return SurfacePoint::on_edge(surface, here.edge, s);
  };
  if (t == here.t) return;
  if (!is_inside(at(t))) {
    double inside = here.t;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (inside + t) / 2;
      (is_inside(at(middle)) ? inside : t) = middle;
    }
    t = inside;
  }
  if (t != here.t) strands_.move(node, at(t));
}

/// Moves every other node first. Neighbours never move at the same time, so each step shortens the
/// curve. On a closed curve with an odd number of nodes two neighbours move one after the other.
void EnvelopeSmoothing::slide_all() {
  std::array<std::vector<std::uint32_t>, 2> turns;
  for (std::uint32_t c = 0; c < drawn_.size(); ++c) {
    const std::vector<std::uint32_t> chain = strands_.chain(c);
    for (std::size_t k = 0; k < chain.size(); ++k) {
      if (is_free(chain[k]) && std::holds_alternative<OnEdge>(strands_[chain[k]].at.where())) {
        turns[k % 2].push_back(chain[k]);
      }
    }
  }
  for (const std::vector<std::uint32_t>& turn : turns) {
    for (const std::uint32_t node : turn) slide(node);
  }
}

/// Removes a node at the place of a neighbour, or between two neighbours in one face.
bool EnvelopeSmoothing::merge(std::uint32_t node) {
  const StrandNode& n = strands_[node];
  if (!is_free(node) || strands_.count(n.curve) <= 3) return false;
  const SurfacePoint &before = strands_[n.before].at, &after = strands_[n.after].at;
  bool merges = n.at == before || n.at == after;
  if (const auto* e = std::get_if<OnEdge>(&n.at.where()); e != nullptr && !merges) {
    const auto holds = [&](FaceId f, const SurfacePoint& p) {
      const std::vector<FaceId> faces = faces_at(mesh_.surface(), p);
      return std::find(faces.begin(), faces.end(), f) != faces.end();
    };
    for (const FaceId f : faces_at(mesh_.surface(), n.at)) {
      merges = merges || (holds(f, before) && holds(f, after));
    }
  }
  if (!merges) return false;
  strands_.remove(node);
  ++result_.merges;
  return true;
}

/// The halfedge from v on which the node slides; invalid if the node is on no edge of v.
HalfedgeId EnvelopeSmoothing::spoke_of(std::uint32_t node, VertexId v) const {
  if (node == kNone || !is_free(node)) return {};
  const auto* e = std::get_if<OnEdge>(&strands_[node].at.where());
  if (e == nullptr) return {};
  const HalfedgeId h = halfedge_of(e->edge);
  if (mesh_.surface().tail(h) == v) return h;
  return mesh_.surface().head(h) == v ? twin(h) : HalfedgeId{};
}

bool EnvelopeSmoothing::pass_over(std::uint32_t node) {
  const auto* e = std::get_if<OnEdge>(&strands_[node].at.where());
  if (e == nullptr || !is_free(node) || (e->t > kNear && e->t < 1 - kNear)) return false;
  const HalfedgeId h = halfedge_of(e->edge);
  return pass_over(node, e->t <= kNear ? h : twin(h));
}

/// Where a curve turns away from a vertex, the nodes on the vertex's edges would approach the
/// vertex forever. All these nodes therefore pass over the vertex at once.
bool EnvelopeSmoothing::pass_over(std::uint32_t node, HalfedgeId spoke) {
  const Surface& surface = mesh_.surface();
  const VertexId v = surface.tail(spoke);
  std::vector<std::uint32_t> run = {node};
  std::uint32_t a = strands_[node].before, b = strands_[node].after;
  const std::size_t most = strands_.count(strands_[node].curve);
  for (; spoke_of(a, v).valid() && run.size() < most; a = strands_[a].before) run.push_back(a);
  for (; spoke_of(b, v).valid() && run.size() < most; b = strands_[b].after) run.push_back(b);
  if (run.size() + 2 >= most || a == b || strands_.is_taken(v)) return false;
  const auto sides = passage_at(surface, v, strands_[a].at, strands_[b].at);
  const bool first = std::any_of(sides[0].spokes.begin(), sides[0].spokes.end(),
                                 [&](const auto& s) { return s.halfedge == spoke; });
  if (sides[first ? 0 : 1].angle <= std::numbers::pi + kStraight) return false;
  const SurfacePoint at = SurfacePoint::at_vertex(surface, v);
  if (!is_inside(at)) return false;
  for (const std::uint32_t other : run) {
    const HalfedgeId h = spoke_of(other, v);
    const double way = (strands_[other].position - mesh_.point(v)).norm();
    if (strands_.free_along(h, other, other) <= way) return false;
  }
  for (const std::uint32_t other : run) {
    if (other != node) strands_.remove(other);
  }
  result_.merges += run.size() - 1;
  strands_.move(node, at);
  split(node);
  return true;
}

/// Moves the curve to the side of the vertex where it is shorter.
bool EnvelopeSmoothing::split(std::uint32_t node) {
  const StrandNode& n = strands_[node];
  const auto* v = std::get_if<AtVertex>(&n.at.where());
  if (!is_free(node) || v == nullptr || strands_.count(n.curve) <= 3) return false;
  const auto sides =
      passage_at(mesh_.surface(), v->vertex, strands_[n.before].at, strands_[n.after].at);
  const PassageSide& side = sides[0].angle <= sides[1].angle ? sides[0] : sides[1];
  if (side.angle >= std::numbers::pi - kStraight) return false;
  return split_to(node, side);
}

/// Places the nodes on a line parallel to the chord from neighbour to neighbour: on the chord
/// itself unless that leaves an edge or the envelope, or meets another curve. The nearer the line
/// is to the chord, the shorter the curve.
bool EnvelopeSmoothing::split_to(std::uint32_t node, const PassageSide& side) {
  const Surface& surface = mesh_.surface();
  const StrandNode& n = strands_[node];
  double part = 1;
  for (const PassageSide::Spoke& spoke : side.spokes) {
    const double room = strands_.free_along(spoke.halfedge, n.before, n.after) / 2;
    if (spoke.chord > room) part = std::min(part, room / spoke.chord);
  }
  std::vector<SurfacePoint> points;
  for (int k = 0; k < kHalvings; ++k, part /= 2) {
    points.clear();
    bool good = true;
    for (const PassageSide::Spoke& spoke : side.spokes) {
      const EdgeId e = edge_of(spoke.halfedge);
      const double t = part * spoke.chord / surface.length(e);
      if (!(t > kMargin) || !(t < 1 - kMargin)) return false;
      points.push_back(
          SurfacePoint::on_edge(surface, e, spoke.halfedge == halfedge_of(e) ? t : 1 - t));
      good = good && is_inside(points.back());
    }
    if (!good) continue;
    strands_.replace(node, points);
    ++(points.empty() ? result_.merges : result_.splits);
    return true;
  }
  return false;
}

void EnvelopeSmoothing::tidy() {
  for (std::uint32_t c = 0; c < drawn_.size(); ++c) {
    for (const std::uint32_t node : strands_.chain(c)) {
      if (strands_[node].alive && !merge(node) && !split(node)) pass_over(node);
    }
    for (bool again = true; again;) {
      again = false;
      for (const std::uint32_t node : strands_.chain(c)) {
        if (strands_[node].alive && merge(node)) again = true;
      }
    }
  }
}

void EnvelopeSmoothing::stop_collapsed() {
  for (std::uint32_t c = 0; c < drawn_.size(); ++c) {
    if (!drawn_[c].closed || result_.collapsed[c] != 0) continue;
    if (strands_.count(c) > 3 && strands_.length(c) >= floors_[c]) continue;
    result_.collapsed[c] = 1;
    strands_.fix(c);
  }
}

double EnvelopeSmoothing::length() const {
  double sum = 0;
  for (std::uint32_t c = 0; c < drawn_.size(); ++c) sum += strands_.length(c);
  return sum;
}

EnvelopeResult EnvelopeSmoothing::run() {
  tidy();
  double last = length();
  while (result_.rounds < options_.iterations && !result_.converged) {
    if (options_.go_on && !options_.go_on(result_.rounds)) {
      result_.cancelled = true;
      break;
    }
    slide_all();
    tidy();
    stop_collapsed();
    ++result_.rounds;
    const double now = length();
    result_.converged = !(last - now > options_.tolerance * last);
    last = now;
  }
  for (std::uint32_t c = 0; c < drawn_.size(); ++c) result_.curves.push_back(strands_.curve(c));
  return std::move(result_);
}

}  // namespace

EnvelopeResult smooth_in_envelope(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                  std::span<const SurfacePoint> pins,
                                  const EnvelopeOptions& options) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].closed || !(curves[c].points.front() == curves[c].points.back())) continue;
    throw Error(ErrorCode::kBadCurve,
                fmt::format("Curve {} is open but ends where it begins. Draw it as a closed curve.",
                            c + 1));
  }
  return EnvelopeSmoothing(mesh, curves, pins, options).run();
}

}  // namespace talweg::plugins
