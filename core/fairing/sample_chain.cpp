#include "talweg/core/fairing/sample_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/lines/straight_walk.hpp"
#include "talweg/intrinsic/surface/triangle.hpp"

namespace talweg {
namespace {

constexpr double kOff = 0.05;  // of a join: how far samples keep off the boundary

void add_reversed(FaceStrip& strip, std::span<const HalfedgeId> crossed) {
  for (std::size_t k = crossed.size(); k > 0; --k) add_crossing(strip, twin(crossed[k - 1]));
}

void add_all(FaceStrip& strip, std::span<const HalfedgeId> crossed) {
  for (const HalfedgeId h : crossed) add_crossing(strip, h);
}

}  // namespace

double SampleChain::length() const {
  double sum = 0;
  for (const ChainJoin& join : joins) sum += join.length;
  return sum;
}

PlanePoint SampleChain::tangent(std::size_t i) const {
  const PlanePoint in = join_before(i).end, sum = in + join_after(i).start;
  const double length = norm(sum);
  return length > 1e-3 ? (1 / length) * sum : turned_left(in);
}

/// The turn of a line that bends at a saddle vertex. The line is the limit of curves that pass the
/// vertex on either side, with different turns; a curve through the vertex has the mean of both
/// turns. The least of the three turns counts.
double ChainMaker::turn_at(VertexId bend, double in_strip) const {
  if (surface_->on_boundary(bend)) return 0;
  double other = in_strip + (in_strip > 0 ? 2 : -2) * std::numbers::pi;
  const HalfedgeId first = surface_->halfedge(bend);
  HalfedgeId h = first;
  do {
    const double angle =
        angle_between(surface_->length(edge_of(h)), surface_->length(edge_of(surface_->prev(h))),
                      surface_->length(edge_of(surface_->next(h))));
    other -= in_strip > 0 ? angle : -angle;
    h = surface_->turn_ccw(h);
  } while (h != first);
  const auto less = [](double a, double b) { return std::abs(a) < std::abs(b) ? a : b; };
  return less((in_strip + other) / 2, less(in_strip, other));
}

/// Appends the join through the strip in strip_; false if no line is found.
bool ChainMaker::add_join(SampleChain& chain, const FaceCoordinates& from,
                          const FaceCoordinates& to, std::uint32_t stretch) {
  const StripLine line = lines_.join(from, to, strip_);
  ChainJoin join{line.from, line.to, line.start, line.end, line.length};
  join.first = static_cast<std::uint32_t>(chain.crossed.size());
  join.count = static_cast<std::uint32_t>(strip_.size());
  join.bends = !line.bends.empty();
  join.to_first_bend = line.to_first_bend;
  join.from_last_bend = line.from_last_bend;
  if (join.bends) {
    join.first_turn = turn_at(line.bends.front(), line.turns.front());
    join.last_turn = turn_at(line.bends.back(), line.turns.back());
    join.bends_once = line.bends.size() == 1;
  }
  join.stretch = stretch;
  chain.crossed.insert(chain.crossed.end(), strip_.begin(), strip_.end());
  chain.joins.push_back(join);
  return line.found;
}

namespace {

/// A point of a join near its end or start `at`, in the direction `back`; none in a face without
/// area, which has no directions.
std::optional<SurfacePoint> beside(const Surface& surface, const FaceCoordinates& at,
                                   PlanePoint back, double length) {
  constexpr double kLittle = 1e-3;
  const FaceFrame frame(surface, at.face);
  FaceFrame::Barycentric rates = frame.rates(back);
  double step = kLittle * length;
  for (std::size_t k = 0; k < 3; ++k) {
    if (rates[k] < 0 && at.barycentric[k] > 0) {
      step = std::min(step, at.barycentric[k] / -rates[k] / 2);
    }
  }
  FaceCoordinates there = at;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += there.barycentric[k] = std::max(0.0, at.barycentric[k] + step * rates[k]);
  }
  if (!(sum > 0 && std::isfinite(sum))) return std::nullopt;
  for (double& b : there.barycentric) b /= sum;
  return SurfacePoint::from_barycentric(surface, there.face, there.barycentric, 0);
}

}  // namespace

/// The turn from one join to the next. The joins may lie in different faces if their sample is on
/// an edge or at a vertex.
double ChainMaker::turn_between(const ChainJoin& in, const ChainJoin& out) const {
  if (in.to.face == out.from.face) {
    return std::atan2(cross(in.end, out.start), dot(in.end, out.start));
  }
  const auto before = beside(*surface_, in.to, -1 * in.end, in.length);
  const auto after = beside(*surface_, out.from, out.start, out.length);
  if (!before || !after) return 0;
  const SurfacePoint at = SurfacePoint::from_barycentric(*surface_, in.to.face, in.to.barycentric);
  return signed_turning(*surface_, *before, at, *after);
}

void ChainMaker::set_turns(SampleChain& chain) const {
  chain.turns.assign(chain.size(), 0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (!chain.is_end(i)) {
      chain.turns[i] = turn_between(chain.join_before(i), chain.join_after(i));
    }
  }
}

namespace {

/// The place of a sample on a trace.
struct Place {
  std::size_t piece = 0;
  double arc = 0;
  bool fixed = false;
};

/// The place of a free sample; on a loop, `arc` may exceed the length.
Place place_at(const CurveTrace& trace, double arc) {
  if (arc >= trace.length) arc -= trace.length;
  return {trace.piece_at(arc), arc, false};
}

/// Halves parts of a trace.
struct Halving {
  const CurveTrace* trace;
  double least;  ///< mesh units
  const ChainMaker::Divided* divided;

  [[nodiscard]] double drawn_at(double arc) const {
    if (trace->drawn.empty()) return NAN;
    const bool again = trace->closed && arc >= trace->length;
    const double place = again ? arc - trace->length : arc;
    const double turn = again ? trace->drawn.back() - trace->drawn.front() : 0;
    return turn + trace->drawn_at(trace->piece_at(place), place);
  }
  /// Appends the places between two arcs, ascending.
  void between(double from, double to, std::vector<Place>& places) const {
    if (!*divided || to - from < 2 * least) return;
    if (!(*divided)(drawn_at(from), drawn_at(to), to - from)) return;
    const double middle = (from + to) / 2;
    if (!(middle > from && middle < to)) return;
    between(from, middle, places);
    places.push_back(place_at(*trace, middle));
    between(middle, to, places);
  }
};

std::vector<Place> places_on(const CurveTrace& trace, std::span<const double> spacings,
                             const Halving& halving) {
  std::vector<Place> fixed;
  if (!trace.closed) fixed.push_back({0, 0, true});
  for (const std::size_t piece : trace.fixed)
    fixed.push_back({piece, trace.pieces[piece].arc, true});
  if (!trace.closed) fixed.push_back({trace.pieces.size() - 1, trace.length, true});
  const bool free = fixed.empty();  // a loop without fixed points
  if (free) fixed.push_back({0, 0, false});
  if (trace.closed) {
    fixed.push_back({fixed.front().piece, fixed.front().arc + trace.length, fixed.front().fixed});
  }
  const double least = trace.closed ? 8 : 2;
  std::vector<Place> places;
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
    const double most = std::min(spacings[spacings.size() > 1 ? k : 0], trace.length / least);
    const double from = fixed[k].arc, to = fixed[k + 1].arc;
    const double joins = std::max(1.0, std::ceil((to - from) / most * (1 - 1e-9)));
    places.push_back(fixed[k]);
    for (double i = 1; i <= joins; ++i) {
      const double before = from + (to - from) * (i - 1) / joins;
      const double arc = i < joins ? from + (to - from) * i / joins : to;
      halving.between(before, arc, places);
      if (i < joins) places.push_back(place_at(trace, arc));
    }
  }
  if (!trace.closed) places.push_back(fixed.back());
  // The samples of a loop begin where its arc length begins.
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.piece != b.piece ? a.piece < b.piece : a.arc < b.arc;
  });
  return places;
}

}  // namespace

std::optional<SampleChain> ChainMaker::sampled(const CurveTrace& trace,
                                               std::span<const double> spacings, double least,
                                               const Divided& divided) {
  SampleChain chain;
  chain.closed = trace.closed;
  chain.fixed_points = trace.fixed_points;
  const bool spaced = std::all_of(spacings.begin(), spacings.end(), [](double s) { return s > 0; });
  if (trace.pieces.empty() || !(trace.length > 0) || !spaced) return std::nullopt;
  const std::vector<Place> places = places_on(trace, spacings, {&trace, least, &divided});
  std::size_t passed = 0;  // fixed points
  for (const Place& place : places) {
    const FaceCoordinates at = trace.point(place.piece, place.arc);
    chain.samples.push_back(place.fixed ? at : moved_inside(at));
    chain.fixed.push_back(place.fixed);
    if (!trace.drawn.empty()) chain.drawn.push_back(trace.drawn_at(place.piece, place.arc));
    if (trace.corners.empty()) continue;
    chain.corners.push_back(place.fixed && trace.corners[passed]);
    if (place.fixed) ++passed;
  }
  if (!trace.drawn.empty()) chain.drawn_length = trace.drawn.back() - trace.drawn.front();
  const std::size_t joins = places.size() - (trace.closed ? 0 : 1);
  const auto crossed_after = [&](std::size_t piece) {
    const std::size_t stop =
        piece + 1 < trace.pieces.size() ? trace.pieces[piece + 1].crossed : trace.crossed.size();
    return std::span(trace.crossed)
        .subspan(trace.pieces[piece].crossed, stop - trace.pieces[piece].crossed);
  };
  const auto fixed =
      static_cast<std::uint32_t>(std::count(chain.fixed.begin(), chain.fixed.end(), true));
  std::uint32_t stretch = fixed > 0 ? fixed - 1 : 0;  // a loop may begin in its last stretch
  for (std::size_t i = 0; i < joins; ++i) {
    const std::size_t j = chain.after(i);
    if (chain.fixed[i]) stretch = stretch + 1 < fixed ? stretch + 1 : 0;
    strip_.clear();
    const std::size_t stop = places[j].piece + (trace.closed && j == 0 ? trace.pieces.size() : 0);
    for (std::size_t p = places[i].piece; p < stop; ++p) {
      add_all(strip_, crossed_after(p % trace.pieces.size()));
    }
    if (!add_join(chain, chain.samples[i], chain.samples[j], stretch)) return std::nullopt;
  }
  set_turns(chain);
  return chain;
}

/// Walks a step; a walk that reaches the boundary ends `off` before it.
WalkEnd ChainMaker::walk_off_boundary(const FaceCoordinates& from, const SampleStep& step,
                                      double off, FaceStrip& crossed) const {
  const std::size_t known = crossed.size();
  const WalkEnd end = walk_straight(*surface_, from, step.direction, step.distance, crossed);
  if (end.walked < 0 || end.walked >= step.distance) return end;
  crossed.resize(known);
  return walk_straight(*surface_, from, step.direction, std::max(0.0, end.walked - off), crossed);
}

std::optional<ChainMove> ChainMaker::moved_left(const SampleChain& chain,
                                                std::span<const double> left,
                                                const ChainMove* other) {
  std::vector<SampleStep> steps(chain.size());
  ChainMove result;
  result.left.assign(left.begin(), left.end());
  result.changed.assign(chain.size(), true);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (other != nullptr) result.changed[i] = left[i] != other->left[i];
    if (chain.fixed[i] || !result.changed[i]) continue;
    const PlanePoint side = turned_left(chain.tangent(i));
    steps[i] = {left[i] < 0 ? -1 * side : side, std::abs(left[i])};
  }
  if (!move(chain, steps, other, result)) return std::nullopt;
  return result;
}

std::optional<SampleChain> ChainMaker::moved(const SampleChain& chain,
                                             std::span<const SampleStep> steps) {
  ChainMove result;
  result.changed.assign(chain.size(), true);
  if (!move(chain, steps, nullptr, result)) return std::nullopt;
  return std::move(result.chain);
}

/// Moves the samples that move.changed marks, and copies the other samples from `other`.
bool ChainMaker::walk(const SampleChain& chain, std::span<const SampleStep> steps,
                      const ChainMove* other, ChainMove& move) {
  move.chain.samples = chain.samples;
  move.walks.reserve(chain.size());
  move.first.assign(1, 0);
  move.first.reserve(chain.size() + 1);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (other != nullptr && !move.changed[i]) {
      const auto way = other->way(i);
      move.walks.insert(move.walks.end(), way.begin(), way.end());
      move.chain.samples[i] = other->chain.samples[i];
    } else if (!chain.fixed[i] && steps[i].distance > 0) {
      const WalkEnd end = walk_off_boundary(chain.samples[i], steps[i],
                                            kOff * chain.join_before(i).length, move.walks);
      if (end.walked < 0) return false;
      move.chain.samples[i] = end.at;
    }
    move.first.push_back(static_cast<std::uint32_t>(move.walks.size()));
  }
  return true;
}

bool ChainMaker::move(const SampleChain& chain, std::span<const SampleStep> steps,
                      const ChainMove* other, ChainMove& move) {
  SampleChain& result = move.chain;
  result.closed = chain.closed;
  result.fixed_points = chain.fixed_points;
  result.fixed = chain.fixed;
  result.corners = chain.corners;
  result.freed = chain.freed;
  result.drawn = chain.drawn;
  result.drawn_length = chain.drawn_length;
  if (!walk(chain, steps, other, move)) return false;
  result.joins.reserve(chain.joins.size());
  result.crossed.reserve(chain.crossed.size() + chain.size() / 8);
  const std::vector<bool> walked = move.changed;
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const std::size_t j = chain.after(i);
    if (other != nullptr && !walked[i] && !walked[j]) {
      const ChainJoin& join = other->chain.joins[i];
      const auto strip = other->chain.strip(join);
      result.joins.push_back(join);
      result.joins.back().first = static_cast<std::uint32_t>(result.crossed.size());
      result.crossed.insert(result.crossed.end(), strip.begin(), strip.end());
      continue;
    }
    move.changed[i] = move.changed[j] = true;
    const ChainJoin& old = chain.joins[i];
    strip_.clear();
    add_reversed(strip_, move.way(i));
    add_all(strip_, chain.strip(old));
    add_all(strip_, move.way(j));
    if (!add_join(result, chain.fixed[i] ? old.from : result.samples[i],
                  chain.fixed[j] ? old.to : result.samples[j], old.stretch)) {
      return false;
    }
  }
  set_turns(result);
  return true;
}

/// A fixed sample may have joins in different faces; the freed sample lies in the face of the join
/// after it.
std::optional<SampleChain> ChainMaker::with_freed(const SampleChain& chain,
                                                  const std::vector<bool>& freed) {
  SampleChain result;
  result.closed = chain.closed;
  result.corners = chain.corners;
  result.freed = freed;
  result.drawn = chain.drawn;
  result.drawn_length = chain.drawn_length;
  result.fixed = chain.fixed;
  result.samples = chain.samples;
  std::size_t passed = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.fixed[i] && !freed[i]) result.fixed_points.push_back(chain.fixed_points[passed]);
    if (chain.fixed[i]) ++passed;
    if (!freed[i]) continue;
    result.fixed[i] = false;
    result.samples[i] = moved_inside(chain.join_after(i).from);
  }
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const std::size_t j = chain.after(i);
    const ChainJoin& old = chain.joins[i];
    const auto strip = chain.strip(old);
    strip_.assign(strip.begin(), strip.end());
    if (freed[j]) {
      const auto at = SurfacePoint::from_barycentric(*surface_, old.to.face, old.to.barycentric);
      side_.clear();
      cross_at(*surface_, at, old.to.face, result.samples[j].face, side_);
      add_all(strip_, side_);
    }
    if (!add_join(result, freed[i] ? result.samples[i] : old.from,
                  freed[j] ? result.samples[j] : old.to, old.stretch)) {
      return std::nullopt;
    }
  }
  set_turns(result);
  return result;
}

std::optional<SampleChain> ChainMaker::between(const SampleChain& from, const SampleChain& to,
                                               const SampleTrail& trail,
                                               std::span<const double> parts) {
  if (trail.size() != from.size()) return parts.front() < 0.5 ? from : to;
  std::vector<SampleStep> steps(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from.fixed[i]) continue;
    strip_ = trail[i];
    const StripLine line = lines_.join(from.samples[i], to.samples[i], strip_);
    if (!line.found) return std::nullopt;
    steps[i] = {line.start, parts[i] * (line.bends.empty() ? line.length : line.to_first_bend)};
  }
  return moved(from, steps);
}

std::optional<SampleChain> ChainMaker::divided(const SampleChain& chain,
                                               std::span<const int> parts) {
  SampleChain result;
  result.closed = chain.closed;
  result.fixed_points = chain.fixed_points;
  result.drawn_length = chain.drawn_length;
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const std::size_t first = result.samples.size();
    result.samples.push_back(chain.samples[i]);
    result.fixed.push_back(chain.fixed[i]);
    if (!chain.corners.empty()) result.corners.push_back(chain.corners[i]);
    if (!divide(chain, i, parts[parts.size() > 1 ? i : 0], result)) return std::nullopt;
    if (!chain.corners.empty()) result.corners.resize(result.samples.size(), false);
    const auto added = static_cast<double>(result.samples.size() - first);
    for (double k = 0; k < added && !chain.drawn.empty(); ++k) {
      result.drawn.push_back(chain.drawn_along(i, k / added));
    }
  }
  if (!chain.closed) {
    result.samples.push_back(chain.samples.back());
    result.fixed.push_back(true);
    if (!chain.corners.empty()) result.corners.push_back(chain.corners.back());
    if (!chain.drawn.empty()) result.drawn.push_back(chain.drawn.back());
  }
  set_turns(result);
  return result;
}

/// Appends samples beside a straight piece, on the cubic with the piece's slopes at both ends. Each
/// inserted sample has its way from the start of the piece.
bool ChainMaker::insert_beside(const StraightPiece& piece, int parts,
                               std::vector<Inserted>& inserted) {
  WalkEnd on{piece.from, piece.direction, 0};
  FaceStrip along;
  for (int k = 1; k < parts; ++k) {
    const double u = static_cast<double>(k) / parts;
    const double y = piece.length * (piece.start_slope * u * (1 - u) * (1 - u) -
                                     piece.end_slope * u * u * (1 - u));
    on = walk_straight(*surface_, on.at, on.direction, piece.length / parts, along);
    if (on.walked < 0) return false;
    const PlanePoint side = turned_left(on.direction);
    side_.clear();
    const WalkEnd end =
        walk_straight(*surface_, on.at, y < 0 ? -1 * side : side, std::abs(y), side_);
    if (end.walked < 0) return false;
    inserted.push_back({end.at, along, piece.backwards});
    add_all(inserted.back().way, side_);
  }
  return true;
}

bool ChainMaker::divide(const SampleChain& chain, std::size_t i, int parts, SampleChain& result) {
  const ChainJoin& join = chain.joins[i];
  const std::size_t j = chain.after(i);
  // The slope between this join and the tangent at a sample, which splits its turn by the lengths
  // of its joins. Ends and corners have no slope.
  const auto slope = [&](std::size_t sample, double sign) {
    const double both = chain.join_before(sample).length + chain.join_after(sample).length;
    return std::tan(std::clamp(sign * chain.turns[sample] * join.length / both, -0.7, 0.7));
  };
  const bool free = chain.turns_freely(i), stop = chain.turns_freely(j);
  const double m0 = free ? 0 : slope(i, -1), m1 = stop ? 0 : slope(j, 1);
  std::vector<Inserted> inserted;
  if (!join.bends) {
    const StraightPiece whole{join.from, join.start, join.length, free ? -m1 / 2 : m0,
                              stop ? -m0 / 2 : m1};
    if (!insert_beside(whole, parts, inserted)) return false;
  } else {  // the join turns freely about a vertex
    const StraightPiece first{join.from, join.start, join.to_first_bend, m0, -m0 / 2};
    const StraightPiece last{join.to, -1 * join.end, join.from_last_bend, m1, -m1 / 2, true};
    if (!insert_beside(first, parts, inserted)) return false;
    const std::size_t n = inserted.size();
    if (!insert_beside(last, parts, inserted)) return false;
    std::reverse(inserted.begin() + static_cast<std::ptrdiff_t>(n), inserted.end());
  }
  const Inserted end{join.to, {}, true};
  const Inserted* before = nullptr;
  const auto add = [&](const Inserted& next) {
    strip_.clear();
    if (before != nullptr) add_reversed(strip_, before->way);
    if (next.from_end != (before != nullptr && before->from_end)) {
      add_all(strip_, chain.strip(join));
    }
    add_all(strip_, next.way);
    const FaceCoordinates from = before != nullptr ? before->at : join.from;
    before = &next;
    return add_join(result, from, next.at, join.stretch);
  };
  for (const Inserted& next : inserted) {
    if (!add(next)) return false;
    result.samples.push_back(next.at);
    result.fixed.push_back(false);
  }
  return add(end);
}

CurveTrace ChainMaker::trace_of(const SampleChain& chain) {
  CurveTrace trace;
  trace.closed = chain.closed;
  trace.fixed_points = chain.fixed_points;
  for (std::size_t i = 0; i < chain.corners.size(); ++i) {
    if (chain.fixed[i]) trace.corners.push_back(chain.corners[i]);
  }
  const auto add = [&](const FaceCoordinates& from, const std::array<double, 3>& to) {
    trace.add(
        {from.face, from.barycentric, to, distance_in_face(*surface_, from, {from.face, to})});
  };
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const ChainJoin& join = chain.joins[i];
    const std::size_t begun = trace.pieces.size();
    const double before = trace.length;
    if (chain.fixed[i] && !chain.is_end(i)) trace.fixed.push_back(trace.pieces.size());
    const auto strip = chain.strip(join);
    strip_.assign(strip.begin(), strip.end());
    lines_.trace(join.from, join.to, strip_);
    FaceCoordinates at = join.from;
    for (std::size_t k = 0; k < strip.size(); ++k) {
      const HalfedgeId h = strip[k];
      const double part = lines_.parts()[k];
      const FaceFrame here(*surface_, at.face);
      std::array<double, 3> to{};
      to[here.side_of(h)] = 1 - part;
      to[(here.side_of(h) + 1) % 3] = part;
      add(at, to);
      trace.crossed.push_back(h);
      at.face = surface_->face(twin(h));
      const FaceFrame there(*surface_, at.face);
      at.barycentric = {};
      at.barycentric[there.side_of(twin(h))] = part;
      at.barycentric[(there.side_of(twin(h)) + 1) % 3] = 1 - part;
    }
    add(at, join.to.barycentric);
    for (std::size_t k = begun; k < trace.pieces.size() && !chain.drawn.empty(); ++k) {
      const double own = trace.length - before, along = trace.pieces[k].arc - before;
      trace.drawn.push_back(chain.drawn_along(i, own > 0 ? along / own : 0));
    }
    // The joins before and after a sample at a vertex or on an edge may lie in different faces.
    if (i + 1 == chain.joins.size() && !chain.closed) break;
    const ChainJoin& next = chain.joins[i + 1 == chain.joins.size() ? 0 : i + 1];
    if (next.from.face == join.to.face) continue;
    const SurfacePoint point =
        SurfacePoint::from_barycentric(*surface_, join.to.face, join.to.barycentric);
    cross_at(*surface_, point, join.to.face, next.from.face, trace.crossed);
  }
  if (!chain.drawn.empty()) trace.drawn.push_back(chain.drawn_after(chain.joins.size() - 1));
  return trace;
}

}  // namespace talweg
