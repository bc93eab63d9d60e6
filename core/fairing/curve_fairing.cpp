#include "talweg/core/fairing/curve_fairing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "talweg/core/fairing/chain_curve.hpp"
#include "talweg/core/fairing/curve_trace.hpp"

namespace talweg {
namespace {

constexpr int kLevels = 4, kLevelsWithLegs = 2, kResamplingParts = 2, kResultParts = 4,
              kMostParts = 16;
constexpr int kTightenings = 4;
constexpr int kSamplings = 3;
constexpr double kJoinsOfLeg = 6, kMostOnLeg = 2;  // edges
constexpr double kJoinsOfStretch = 8, kLeastOfEdge = 16, kUnequal = 1.5;
constexpr int kSwingRounds = 8;
constexpr double kEarlier = 0.95, kStiffer = 4, kFarBeyond = 0.25;
constexpr double kUneven = 2, kMostSamples = 1e5;
constexpr std::size_t kLong = 4'096;       // samples; of longer chains only parts are faired again
constexpr std::size_t kMargin = 32;        // samples on either side of a part that is faired again
constexpr double kCoarseTolerance = 2e-2;  // finer samples change the energy by as much

/// The largest allowed swing of a leg: kMostSwing times the shortest length among the leg and its
/// neighbours, which counts as at least three quarters of the leg's own length. The intended limit
/// is a quarter; kMostSwing is smaller, because the offsets of samples underestimate the swing.
double allowed_swing(const std::vector<double>& lengths, std::size_t leg, bool closed) {
  constexpr double kMostSwing = 0.23;
  const std::size_t n = lengths.size();
  double shortest = lengths[leg];
  if (closed || leg > 0) shortest = std::min(shortest, lengths[(leg + n - 1) % n]);
  if (closed || leg + 1 < n) shortest = std::min(shortest, lengths[(leg + 1) % n]);
  return kMostSwing * std::max(shortest, 0.75 * lengths[leg]);
}

}  // namespace

/// The number of sampling levels: two for a curve with legs, four for strokes alone.
int CurveFairing::levels() const { return legs_.any() ? kLevelsWithLegs : kLevels; }

/// The spacing of samples on a level, relative to the last level.
double CurveFairing::coarser(int level) const { return std::exp2(levels() - 1 - level); }

/// The wanted spacing of samples on a stretch of this length, for this slack; mesh units.
double CurveFairing::wanted(double slack, double stretch, int level) const {
  const double finest = std::max(slack / 2, edge_ / 8);
  return std::max(finest, std::min(coarser(level) * finest, stretch / kJoinsOfStretch));
}

/// The spacing of samples on each stretch, mesh units.
std::vector<double> CurveFairing::spacings(const CurveTrace& trace, int level) const {
  const double most = trace.length / kMostSamples;
  double slack = 0;
  if (band_ != nullptr) slack = legs_.any() ? band_->least_slack() : band_->largest_slack();
  std::vector<double> spacings = trace.stretch_lengths();
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    const double stretch = spacings[k];
    const bool is_leg = k < legs_.is_leg.size() && legs_.is_leg[k];
    if (is_leg) {
      const double leg = std::min({stretch / kJoinsOfLeg, kMostOnLeg * edge_, reach_of_corner(k)});
      spacings[k] = std::max(coarser(level) / 2 * leg, coarser(level) * edge_ / 8);
    } else {
      spacings[k] = wanted(slack, stretch, level);
    }
    spacings[k] = std::max(spacings[k], most);
  }
  return spacings;
}

std::optional<SampleChain> CurveFairing::sampled(const CurveTrace& trace, int level) {
  const std::vector<double> apart = spacings(trace, level);
  if (trace.drawn.empty()) return maker_.sampled(trace, apart);
  const double most = *std::max_element(apart.begin(), apart.end());
  const double least = std::max(edge_ / kLeastOfEdge, trace.length / kMostSamples);
  const auto is_divided = [&](double from, double to, double length) {
    const double here = std::max(least, wanted(band_->slack_between(from, to), HUGE_VAL, level));
    return length > kUnequal * std::min(most, here) || band_->chord_cuts_off(from, to);
  };
  return maker_.sampled(trace, apart, least, is_divided);
}

double CurveFairing::least_spacing(double length) const {
  const double slack = band_ != nullptr ? band_->least_slack() : 0;
  return std::max({slack / 2, edge_ / 8, length / kMostSamples});
}

bool CurveFairing::is_too_long(double length) const {
  return length > kMostSamples * least_spacing(0);
}

/// The length 1/√t over which a spline turns at a corner of its legs; infinite until t is known.
double CurveFairing::reach_of_corner(std::size_t leg) const {
  if (!(tension_ > 0)) return HUGE_VAL;
  const double factor = leg < legs_.factors.size() ? legs_.factors[leg] : 1;
  return 1 / std::sqrt(tension_ * factor);
}

FairChain CurveFairing::chain_fairing(const FairOptions& options) {
  FairChain fair(maker_, band_, *curvature_, options);
  if (legs_.any()) fair.set_legs(legs_);
  return fair;
}

/// The trace of the cubic through the chain; none where the chain cannot be divided.
std::optional<CurveTrace> CurveFairing::traced(const SampleChain& chain) {
  const std::optional<SampleChain> divided = maker_.divided(chain, kResamplingParts);
  if (!divided) return std::nullopt;
  return maker_.trace_of(*divided);
}

/// Starts with coarse samples, which find a course of little bending. Fine samples would end in one
/// of many small minima of the bending.
std::optional<SampleChain> CurveFairing::from_curve(const CurveTrace& start,
                                                    ProgressPoller& poller) {
  return from_level(0, start, poller);
}

std::optional<SampleChain> CurveFairing::from_level(int first, const CurveTrace& start,
                                                    ProgressPoller& poller) {
  CurveTrace trace = start;
  std::optional<SampleChain> chain;
  for (int level = first; level < levels(); ++level) {
    const bool last = level + 1 == levels();
    for (int sampling = 0;; ++sampling) {
      chain = sampled(trace, level);
      if (!chain) return chain;
      FairOptions options = options_;
      if (!last) options.tolerance = kCoarseTolerance;
      FairChain fair = chain_fairing(options);
      fair.run(*chain, nullptr, poller);
      if (level == 0 && sampling == 0) hold_swings(fair, *chain, start, poller);
      tension_ = fair.tension();
      if (chain->length() > most_length_) return std::nullopt;
      const auto is_enough = [&] { return sampling == kSamplings || is_even(*chain, level); };
      if (!legs_.any() || (last && is_enough())) keep_within(fair, *chain, nullptr, poller);
      passes_too_many_faces_ = passes_too_many_faces_ || fair.passes_too_many_faces();
      if (passes_too_many_faces_) return std::nullopt;
      const bool enough = is_enough();
      if (last && enough) return with_freed(*std::move(chain), poller);
      std::optional<CurveTrace> finer = traced(*chain);
      if (!finer) return std::nullopt;
      trace = *std::move(finer);
      if (enough) break;
    }
  }
  return chain;
}

/// A spline swings out of its legs where they turn sharply or differ much in length. Legs from
/// which the spline swings too far for their length get more tension, while the other legs keep
/// theirs.
void CurveFairing::hold_swings(FairChain& fair, SampleChain& chain, const CurveTrace& legs,
                               ProgressPoller& poller) {
  if (!legs_.any()) return;
  const std::vector<double> lengths = legs.stretch_lengths();
  const std::size_t n = lengths.size();
  legs_.factors.resize(n, 1);
  for (int round = 0; round < kSwingRounds; ++round) {
    std::vector<double> swings(n, 0);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (chain.fixed[i]) continue;
      double& swing = swings[chain.join_before(i).stretch];
      swing = std::max(swing, std::abs(fair.offsets()[i]));
    }
    bool any = false;
    for (std::size_t k = 0; k < n; ++k) {
      const double excess = swings[k] / allowed_swing(lengths, k, legs.closed);
      if (!legs_.is_leg[k] || excess <= 1.05) continue;
      any = true;
      legs_.factors[k] *= std::min(excess * excess, 4.0);
    }
    if (!any) return;
    if (!legs_.tension) legs_.tension = fair.tension();
    fair.run(chain, nullptr, poller);
  }
}

/// Lets samples at way-points with a tolerance move within the tolerance. Returns the chain
/// unchanged if a sample leaves its tolerance.
std::optional<SampleChain> CurveFairing::with_freed(SampleChain chain, ProgressPoller& poller) {
  std::vector<bool> freed(chain.size(), false);
  std::vector<double> reach(chain.size(), 0);
  std::size_t passed = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (!chain.fixed[i]) continue;
    if (passed < legs_.tolerances.size() && !chain.turns_freely(i))
      reach[i] = legs_.tolerances[passed];
    freed[i] = reach[i] > 0;
    ++passed;
  }
  if (std::find(freed.begin(), freed.end(), true) == freed.end()) return chain;
  std::optional<SampleChain> free = maker_.with_freed(chain, freed);
  if (!free) return chain;
  FairChain fair(maker_, band_, *curvature_, options_);
  fair.set_legs(legs_, reach);
  fair.run(*free, nullptr, poller);
  keep_within(fair, *free, nullptr, poller);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (freed[i] && !(std::abs(fair.offsets()[i]) <= reach[i])) return chain;
  }
  return free;
}

/// Whether no join is much longer than wanted; a long join misses the surface and the drawing
/// between its samples.
bool CurveFairing::is_even(const SampleChain& chain, int level) const {
  std::vector<double> lengths, counts;
  for (const ChainJoin& join : chain.joins) {
    lengths.resize(std::max<std::size_t>(lengths.size(), join.stretch + 1), 0);
    counts.resize(lengths.size(), 0);
    lengths[join.stretch] += join.length;
    ++counts[join.stretch];
  }
  const double most = chain.length() / kMostSamples;
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    const ChainJoin& join = chain.joins[i];
    const double stretch = lengths[join.stretch];
    double apart = stretch / counts[join.stretch];
    if (!chain.drawn.empty()) {
      const double slack = band_->slack_between(chain.drawn[i], chain.drawn_after(i));
      apart = std::max(most, wanted(slack, stretch, level));
    }
    if (!(join.length <= kUneven * apart)) return false;
  }
  return true;
}

std::optional<SampleChain> CurveFairing::from_chain(SampleChain chain, SampleTrail& trail,
                                                    ProgressPoller& poller) {
  FairChain fair = chain_fairing(options_);
  fair.run(chain, &trail, poller);
  keep_within(fair, chain, &trail, poller);
  if (chain.length() > most_length_) return std::nullopt;
  return chain;
}

std::optional<SampleChain> CurveFairing::resampled(const SampleChain& chain,
                                                   ProgressPoller& poller) {
  const int last = levels() - 1;
  if (is_even(chain, last)) return std::nullopt;
  const std::optional<CurveTrace> trace = traced(chain);
  return trace ? from_level(last, *trace, poller) : std::nullopt;
}

/// Fairs the chain again with stiffer walls where samples are beyond them, until all samples are
/// within or the rounds are used up.
void CurveFairing::keep_within(FairChain& fair, SampleChain& chain, SampleTrail* trail,
                               ProgressPoller& poller) {
  if (chain.size() > kLong && trail == nullptr && !legs_.any() &&
      keep_parts_within(fair.near_walls(chain), fair.options(), chain, poller)) {
    return;
  }
  for (int round = 0; round < kTightenings && fair.stiffen(chain); ++round) {
    fair.run(chain, trail, poller);
  }
}

/// The same for parts of a long chain around these samples; false if the parts are too much of the
/// chain.
bool CurveFairing::keep_parts_within(const std::vector<std::size_t>& samples, FairOptions options,
                                     SampleChain& chain, ProgressPoller& poller) {
  if (samples.empty()) return true;
  const auto ranges = ranges_about(samples, kMargin, chain.size());
  if (!is_small_part(ranges, chain.size())) return false;
  options.mean = FairChain::mean_curvature(chain);
  std::vector<SampleChain> parts;
  for (const ChainRange& range : ranges) {
    auto part = part_of_chain(chain, range);
    if (!part) return false;
    FairChain fair(maker_, band_, *curvature_, options);
    fair.run(*part, nullptr, poller);
    keep_within(fair, *part, nullptr, poller);
    parts.push_back(*std::move(part));
  }
  chain = with_parts(chain, ranges, parts);
  return true;
}

/// Whether a sample has walls, that is, neither of its joins is on a leg.
bool CurveFairing::is_held(const SampleChain& chain, std::size_t i) const {
  return !legs_.is_on_leg(chain.join_before(i)) && !legs_.is_on_leg(chain.join_after(i));
}

bool CurveFairing::keeps_within(const SampleChain& chain) const {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.fixed[i] || !is_held(chain, i)) continue;
    const BandPlace place = band_->at(chain.samples[i], {1, 0});
    if (!(place.distance <= place.wall)) return false;
  }
  return true;
}

/// The largest distance of the samples on strokes to the drawing, relative to the wall there.
double CurveFairing::farthest(const SampleChain& chain) const {
  double most = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.fixed[i] || !is_held(chain, i)) continue;
    const BandPlace place = band_->at(chain.samples[i], {1, 0});
    most = std::max(most, place.distance / place.wall);
  }
  return most;
}

double CurveFairing::in_walls(const SurfacePoint& point) const {
  const BandPlace place = band_->at(point);
  return place.distance / place.wall;
}

/// Calls look() with the curve's points, and with the middles of its segments.
template <class Look>
void CurveFairing::look_along(const SurfaceCurve& curve, const Look& look) const {
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SurfacePoint &p = curve.points[i], &q = curve.points[(i + 1) % n];
    look(p);
    if (i + 1 == n && !curve.closed) break;
    look(segment_between(*surface_, p, q, common_face(*surface_, p, q)).point(*surface_, 0.5));
  }
}

double CurveFairing::farthest(const SurfaceCurve& curve) const {
  double most = 0;
  look_along(curve, [&](const SurfacePoint& p) { most = std::max(most, in_walls(p)); });
  return most;
}

/// The number of joins of the result for each join of the chain, so that turns are about 3 degrees:
/// peaks of the curvature lie between samples. Two joins are enough where the chain hardly turns.
std::vector<int> CurveFairing::result_parts(const SampleChain& chain) {
  constexpr double kDegree = std::numbers::pi / 180, kLargest = 3 * kDegree, kSmall = kDegree;
  constexpr int kFew = 2;
  double most = 0;
  const auto turn_of = [&](std::size_t i) {
    return chain.turns_freely(i) ? 0 : std::abs(chain.turns[i]);
  };
  for (std::size_t i = 0; i < chain.size(); ++i) most = std::max(most, turn_of(i));
  const int many =
      std::clamp(static_cast<int>(std::ceil(most / kLargest)), kResultParts, kMostParts);
  std::vector<int> parts(chain.joins.size(), many);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (std::max(turn_of(i), turn_of(chain.after(i))) < kSmall) parts[i] = kFew;
  }
  return parts;
}

/// Fairs the parts of a long chain again where its curve comes near to the walls. `dense` is the
/// chain divided into joins[i] joins for join i. False if no part was faired, or the parts are too
/// much of the chain.
bool CurveFairing::draw_in(const SampleChain& dense, const std::vector<int>& joins,
                           SampleChain& chain, ProgressPoller& poller) {
  constexpr double kAlmost = 0.98;
  std::vector<std::size_t> samples;
  std::size_t next = 0;
  for (std::size_t i = 0; i < joins.size(); ++i) {
    bool near = false;
    for (int k = 0; k < joins[i]; ++k, ++next) {
      if (near || dense.fixed[next]) continue;
      const BandPlace place = band_->at(dense.samples[next], {1, 0});
      near = place.distance > kAlmost * place.wall;
    }
    if (near) samples.push_back(i);
  }
  const auto ranges = ranges_about(samples, kMargin, chain.size());
  if (ranges.empty() || !is_small_part(ranges, chain.size())) return false;
  const std::optional<double> mean = options_.mean;
  options_.mean = FairChain::mean_curvature(chain);
  std::vector<ChainRange> replaced;
  std::vector<SampleChain> parts;
  for (const ChainRange& range : ranges) {
    auto part = part_of_chain(chain, range);
    auto faired = part ? curve_of(*std::move(part), poller) : std::nullopt;
    if (!faired) continue;
    replaced.push_back(range);
    parts.push_back(std::move(faired->chain));
  }
  options_.mean = mean;
  chain = with_parts(chain, replaced, parts);
  return !parts.empty();
}

/// A part of a chain in its frame, not yet faired.
std::optional<SampleChain> CurveFairing::part_of_chain(const SampleChain& chain, ChainRange range) {
  const ChainFrame frame{&chain, range};
  auto part = framed(*surface_, part_of(*surface_, chain, frame.inside()), frame);
  if (part) maker_.set_turns(*part);
  return part;
}

/// The curve may be beyond a wall between samples that are within. The chain is then faired again
/// with walls that are felt earlier, as long as each round halves the excess.
std::optional<FairedCurve> CurveFairing::curve_of(SampleChain chain, ProgressPoller& poller) {
  if (band_ != nullptr && !keeps_within(chain)) return std::nullopt;
  FairOptions options = options_;
  for (int round = 0;; ++round) {
    const std::vector<int> parts = result_parts(chain);
    const std::optional<SampleChain> dense = maker_.divided(chain, parts);
    if (!dense) return std::nullopt;
    FairedCurve result{talweg::curve_of(*surface_, maker_, *dense, edge_), {}};
    result.farthest = legs_.any() ? farthest(*dense) : farthest(result.curve);
    const double beyond = result.farthest - 1, allowed = kFarBeyond * std::exp2(-round);
    if (beyond <= 0 || beyond > allowed || round == kTightenings) {
      result.chain = std::move(chain);
      return result;
    }
    if (chain.size() > kLong && !legs_.any()) {
      if (round > 0 || !draw_in(*dense, parts, chain, poller)) {
        result.chain = std::move(chain);
        return result;
      }
      continue;
    }
    options.felt *= kEarlier;
    options.stiffness *= kStiffer;
    FairChain fair = chain_fairing(options);
    fair.run(chain, nullptr, poller);
    keep_within(fair, chain, nullptr, poller);
  }
}

}  // namespace talweg
