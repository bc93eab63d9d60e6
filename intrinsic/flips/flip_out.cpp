#include "talweg/intrinsic/flips/flip_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

/// Rounds an angle so that wedges that differ only by rounding count as equally narrow. Regular
/// grids have many such wedges; the wedge that comes first on its path is then cleared first,
/// independent of the numbers of the vertices.
double without_rounding(double angle) {
  constexpr double kPerRadian = 1e9;
  return std::round(angle * kPerRadian) / kPerRadian;
}

}  // namespace

void FlipOutOptions::validate() const {
  const auto fail = [](const char* message) { throw Error(ErrorCode::kBadUsage, message); };
  if (!(angle_tolerance > 0 && angle_tolerance < 1)) fail("angle_tolerance must be in (0, 1) rad.");
  if (!(min_relative_length >= 0 && min_relative_length < 1)) {
    fail("min_relative_length must be in [0, 1).");
  }
  if (!(length_floor >= 0 && std::isfinite(length_floor))) {
    fail("length_floor must be finite and >= 0.");
  }
  if (!std::is_sorted(pinned.begin(), pinned.end())) fail("pinned vertices must be sorted.");
}

const char* to_string(Termination termination) {
  switch (termination) {
    case Termination::kConverged:
      return "converged";
    case Termination::kCollapsed:
      return "collapsed";
    case Termination::kLimit:
      return "limit";
    case Termination::kCancelled:
      return "cancelled";
  }
  return "";
}

void FlipOut::push(SegmentId before) {
  push(before, Side::kLeft);
  push(before, Side::kRight);
}

void FlipOut::push(SegmentId before, Side side) {
  const PathNetwork::Segment& segment = network_.segment(before);
  if (!segment.alive || segment.next == PathNetwork::kNone) return;
  if (terminations_[segment.path] != Termination::kConverged) return;
  if (segment.pinned) return;
  const double angle = network_.angle(network_.wedge(before, side));
  if (angle >= std::numbers::pi - options_.angle_tolerance) return;
  heap_.push_back({without_rounding(angle), before, segment.next, side});
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>{});
}

/// Queues the blocked joints at the tail of `around` again, because a path has moved away from this
/// vertex.
void FlipOut::push_around(HalfedgeId around) {
  if (network_.blocked_count() == 0) return;
  std::vector<SegmentId> again;
  network_.for_each_joint(around, [&](SegmentId s) {
    if (network_.segment(s).blocked) again.push_back(s);
  });
  for (const SegmentId s : again) {
    if (!network_.segment(s).blocked) continue;
    network_.set_blocked(s, false);
    push(s);
  }
}

bool FlipOut::valid(const Candidate& candidate) const {
  const PathNetwork::Segment& before = network_.segment(candidate.before);
  return before.alive && before.next == candidate.after &&
         network_.segment(candidate.after).alive &&
         terminations_[before.path] == Termination::kConverged;
}

/// Flips every edge strictly inside the wedge that ends at a corner of less than pi on the outer
/// boundary.
void FlipOut::flip_inside(HalfedgeId out, HalfedgeId back) {
  SignpostTriangulation& t = *triangulation_;
  std::size_t degree = 0;
  for (HalfedgeId h = out; h != back; h = t.turn_ccw(h)) ++degree;
  // Each flip lowers the degree if the fan is a disc; the limit is for fans that meet themselves.
  std::size_t flips_left = 4 * degree;
  HalfedgeId h = t.turn_ccw(out);
  while (h != back) {
    const double outer = t.corner_angle(t.next(h)) + t.corner_angle(twin(h));
    const HalfedgeId before = t.turn_cw(h);
    if (flips_left > 0 && outer < std::numbers::pi - options_.angle_tolerance &&
        !network_.occupied(edge_of(h)) && t.flip(edge_of(h))) {
      --flips_left;
      h = before == out ? t.turn_ccw(out) : before;
    } else {
      h = t.turn_ccw(h);
    }
  }
}

void FlipOut::accept(const Wedge& wedge, std::span<const HalfedgeId> arc) {
  const std::size_t path = network_.segment(wedge.before).path;
  const SegmentId prev = network_.segment(wedge.before).prev;
  const SegmentId last_of_path = wedge.after;
  const HalfedgeId around = wedge.out;
  network_.replace(wedge, arc, fresh_);
  const bool prev_remains = prev != PathNetwork::kNone && prev != last_of_path &&
                            prev != wedge.before && network_.segment(prev).alive;
  if (prev_remains) {  // the joint at the end of `prev` has changed
    network_.set_blocked(prev, false);
    push(prev);
  }
  for (const SegmentId s : fresh_) push(s);
  push_around(around);
  push_around(twin(around));
  push_around(twin(wedge.back));
  check_floor(path);
}

void FlipOut::check_floor(std::size_t path) {
  const PathNetwork::Path& p = network_.path(path);
  if (p.closed && p.length < options_.length_floor) terminations_[path] = Termination::kCollapsed;
}

bool FlipOut::clear_wedge(const Wedge& wedge) {
  SignpostTriangulation& t = *triangulation_;
  flip_inside(wedge.out, wedge.back);
  arc_.clear();
  double length = 0;
  for (HalfedgeId h = wedge.out; h != wedge.back; h = t.turn_ccw(h)) {
    arc_.push_back(t.next(h));
    length += t.length(arc_.back());
  }
  if (!(length < t.length(wedge.out) + t.length(wedge.back))) return false;
  const std::size_t path = network_.segment(wedge.before).path;
  if (network_.path(path).closed && only_a_spike_remains(wedge)) {
    terminations_[path] = Termination::kCollapsed;
    return false;
  }
  accept(wedge, arc_);
  return true;
}

/// True if the loop would become an edge out and back. Such a loop is contractible, and its current
/// state is the last proper loop.
bool FlipOut::only_a_spike_remains(const Wedge& wedge) const {
  const SegmentId rest = network_.segment(wedge.after).next;
  switch (network_.path(network_.segment(wedge.before).path).size) {
    case 2:
      return arc_.size() == 2 && edge_of(arc_[0]) == edge_of(arc_[1]);
    case 3:
      return arc_.size() == 1 && edge_of(arc_[0]) == edge_of(network_.segment(rest).halfedge);
    default:
      return false;
  }
}

bool FlipOut::remove_spike(const Wedge& wedge) {
  const PathNetwork::Segment& before = network_.segment(wedge.before);
  if (network_.path(before.path).size == 2) {  // only an edge out and back is left
    terminations_[before.path] = Termination::kCollapsed;
    return false;
  }
  accept(wedge, {});
  return true;
}

/// At a loop of one edge the wedge has the same face at both ends. The loop is replaced by the
/// face's other two sides, and then wedges are cleared until the loop is shorter than before. By
/// Gauss-Bonnet this succeeds if the wedges on the inner side of the flat annulus in between are
/// cleared. If rounding prevents success, all steps are undone.
bool FlipOut::open_single_edge_loop(const Wedge& wedge) {
  SignpostTriangulation& t = *triangulation_;
  const std::size_t path = network_.segment(wedge.before).path;
  const HalfedgeId loop = wedge.out;
  const std::array<HalfedgeId, 2> around = {t.next(loop), t.prev(loop)};
  if (around[0] == twin(around[1])) {  // around a single vertex: the loop would vanish
    terminations_[path] = Termination::kCollapsed;
    return false;
  }
  const double target = t.length(loop);
  const std::size_t flips = t.flip_count();
  network_.replace(wedge, around, fresh_);
  if (shorten_opened_loop(network_.wedge(fresh_[1], wedge.side), target)) {
    failed_openings_[path] = 0;
    return true;
  }
  while (t.flip_count() > flips) t.undo_flip();
  network_.restart(path, wedge.side == Side::kLeft ? loop : twin(loop), loop);
  // The loop's other side may still succeed; after both have failed the loop stays.
  if (++failed_openings_[path] == 1) {
    push(network_.path(path).first, wedge.side == Side::kLeft ? Side::kRight : Side::kLeft);
  }
  return false;
}

bool FlipOut::shorten_opened_loop(const Wedge& first, double target) {
  const std::size_t path = network_.segment(first.before).path;
  const Side inner = first.side == Side::kLeft ? Side::kRight : Side::kLeft;
  if (first.out == first.back ? !remove_spike(first) : !clear_wedge(first)) return false;
  constexpr int kMaxSteps = 100;
  for (int step = 0; step < kMaxSteps; ++step) {
    if (network_.path(path).length < target) return true;
    if (terminations_[path] != Termination::kConverged || network_.path(path).size < 2) break;
    Wedge best;
    double best_angle = std::numbers::pi - options_.angle_tolerance;
    for (const Side side : {inner, first.side}) {
      if (best.before != PathNetwork::kNone) break;
      SegmentId s = network_.path(path).first;
      for (std::size_t k = 0; k < network_.path(path).size; ++k, s = network_.segment(s).next) {
        if (network_.segment(s).pinned) continue;
        const Wedge wedge = network_.wedge(s, side);
        const double angle = network_.angle(wedge);
        if (angle < best_angle && network_.is_free(wedge)) {
          best = wedge;
          best_angle = angle;
        }
      }
    }
    if (best.before == PathNetwork::kNone) break;
    if (best.out == best.back ? !remove_spike(best) : !clear_wedge(best)) break;
  }
  return network_.path(path).length < target;
}

bool FlipOut::process(const Candidate& candidate) {
  const Wedge wedge = network_.wedge(candidate.before, candidate.side);
  if (!network_.is_free(wedge)) {
    network_.set_blocked(wedge.before, true);
    return false;
  }
  if (wedge.before == wedge.after) return open_single_edge_loop(wedge);
  if (wedge.out == wedge.back) return remove_spike(wedge);
  return clear_wedge(wedge);
}

FlipOutResult FlipOut::run(std::span<const EdgePath> paths, const FlipOutOptions& options,
                           const Progress& progress) {
  options.validate();
  options_ = options;
  network_.clear();
  heap_.clear();
  failed_openings_.assign(paths.size(), 0);
  terminations_.assign(paths.size(), Termination::kConverged);
  for (const EdgePath& path : paths) network_.add(path);

  FlipOutResult result;
  double initial = 0;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    initial += network_.path(k).length;
    result.paths.push_back(
        {paths[k], Termination::kConverged, network_.path(k).length, network_.path(k).length});
    check_floor(k);
  }
  const std::size_t flips = triangulation_->flip_count();
  const std::size_t segments = network_.segment_count();
  const std::size_t limit = options.max_iterations.value_or(1'000'000 + 1'000 * segments);
  const std::size_t most_flips =
      options.max_flips.value_or(4'000'000 + 16 * triangulation_->edge_count());
  for (std::size_t s = 0; s < segments; ++s) {
    const auto id = static_cast<SegmentId>(s);
    if (std::binary_search(options.pinned.begin(), options.pinned.end(),
                           triangulation_->head(network_.segment(id).halfedge))) {
      network_.pin(id);
    }
  }
  constexpr std::size_t kPoll = 64;
  Termination stop = Termination::kConverged;
  for (std::size_t s = 0; s < segments && stop == Termination::kConverged; ++s) {
    if (s % (16 * kPoll) == 0 && !go_on(progress, "straighten", 0)) {
      stop = Termination::kCancelled;
    }
    push(static_cast<SegmentId>(s));
  }

  std::size_t steps = 0;
  while (!heap_.empty() && stop == Termination::kConverged) {
    if (steps++ % kPoll == 0) {
      const double share = static_cast<double>(result.iterations) /
                           static_cast<double>(result.iterations + heap_.size());
      if (!go_on(progress, "straighten", share)) {
        stop = Termination::kCancelled;
        break;
      }
    }
    if (result.iterations >= limit || triangulation_->flip_count() - flips >= most_flips) {
      stop = Termination::kLimit;
      break;
    }
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>{});
    const Candidate candidate = heap_.back();
    heap_.pop_back();
    if (!valid(candidate) || !process(candidate)) continue;
    ++result.iterations;
    if (options.min_relative_length > 0) {
      double length = 0;
      for (std::size_t k = 0; k < paths.size(); ++k) length += network_.path(k).length;
      if (length <= options.min_relative_length * initial) {
        stop = Termination::kLimit;
        break;
      }
    }
  }

  for (std::size_t k = 0; k < paths.size(); ++k) {
    result.paths[k].path = network_.extract(k);
    result.paths[k].length_after = path_length(*triangulation_, result.paths[k].path);
    result.paths[k].termination =
        terminations_[k] == Termination::kConverged ? stop : terminations_[k];
  }
  result.flips = triangulation_->flip_count() - flips;
  result.blocked = network_.blocked_count();
  network_.clear();
  return result;
}

}  // namespace talweg
