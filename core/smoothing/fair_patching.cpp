#include "talweg/core/smoothing/fair_patching.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "talweg/core/fairing/chain_curve.hpp"
#include "talweg/core/smoothing/cut_off_detours.hpp"

namespace talweg {

namespace {

constexpr std::size_t kLeast = 2048;  // samples: trying again as a whole costs little with fewer
constexpr std::size_t kEase = 32;     // samples on either side of what is replaced
using From = FairPatch::From;
constexpr FairPatch kPatchings[] = {{From::kTaut, 1, 16},      {From::kDrawing, 1, 16},
                                    {From::kTaut, 1, 64},      {From::kDrawing, 1, 64},
                                    {From::kDrawing, 0.7, 16}, {From::kDrawing, 0.4, 32}};

/// Where a loop begins farthest from what is bad.
std::size_t farthest_from(const std::vector<std::size_t>& bad, std::size_t size) {
  std::size_t best = 0, most = 0;
  for (std::size_t k = 0; k < bad.size(); ++k) {
    const std::size_t next = k + 1 < bad.size() ? bad[k + 1] : bad[0] + size;
    if (next - bad[k] <= most) continue;
    most = next - bad[k];
    best = (bad[k] + most / 2) % size;
  }
  return best;
}

NearestSegment segments_in_space(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  return NearestSegment(segments_of(positions_of(mesh, curve), curve.closed));
}

}  // namespace

FairPatching::FairPatching(CorridorHold& hold, const FairGroup& group, const Taus& taus,
                           const SurfaceCurve& taut, Asker& asker)
    : hold_(&hold),
      group_(&group),
      taus_(&taus),
      asker_(&asker),
      drawn_{&group.drawn, segments_in_space(hold.drawing().mesh(), group.drawn)},
      taut_{&taut, segments_in_space(hold.drawing().mesh(), taut)},
      maker_(hold.drawing().surface()) {}

/// Those nearest to bad places, ascending.
std::vector<std::size_t> FairPatching::bad_samples(const SampleChain& chain,
                                                   std::span<const SurfacePoint> bad) const {
  const SurfaceMesh& mesh = hold_->drawing().mesh();
  std::vector<Point> places;
  for (const FaceCoordinates& at : chain.samples) {
    places.push_back(
        mesh.position(SurfacePoint::from_barycentric(mesh.surface(), at.face, at.barycentric)));
  }
  const NearestSegment joins(segments_of(places, chain.closed));
  std::vector<std::size_t> samples;
  for (const SurfacePoint& point : bad) samples.push_back(joins.to(mesh.position(point)).segment);
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  return samples;
}

/// The segment of a course beside a sample.
std::size_t FairPatching::nearest(const Course& course, const SampleChain& chain,
                                  std::size_t sample) const {
  const SurfaceMesh& mesh = hold_->drawing().mesh();
  const FaceCoordinates& at = chain.samples[sample];
  return course.nearest
      .to(mesh.position(SurfacePoint::from_barycentric(mesh.surface(), at.face, at.barycentric)))
      .segment;
}

/// The chain's curve inside a stretch, with what the course has beside its core instead of it; none
/// where one cannot change from one to the other inside faces.
std::optional<SurfaceCurve> FairPatching::start_of(const SampleChain& chain, ChainRange range,
                                                   ChainRange core, const Course& course) {
  const Surface& surface = hold_->drawing().surface();
  const ChainRange inside = ChainFrame{&chain, range}.inside();
  const std::size_t n = course.curve->points.size();
  const std::size_t begin = nearest(course, chain, inside.first);
  const auto on = [&](std::size_t sample) {
    const std::size_t segment = nearest(course, chain, sample);
    return segment >= begin || !course.curve->closed ? segment : segment + n;
  };
  const std::size_t first = on(std::max(core.first, inside.first)),
                    last = on(std::min(core.last, inside.last)), end = on(inside.last);
  if (!(begin <= first && first <= last && last <= end) || end - begin > n / 4) {
    return std::nullopt;
  }
  SurfaceCurve other{false, {}};
  std::vector<double> far;
  for (std::size_t i = begin; i <= end + 1 && (course.curve->closed || i < n); ++i) {
    other.points.push_back(course.curve->points[i % n]);
    far.push_back(i >= first && i <= last + 1 ? -1 : HUGE_VAL);
  }
  const SurfaceCurve own = curve_of(surface, maker_, part_of(surface, chain, inside), group_->edge);
  WithDetours start = with_detours(hold_->drawing().mesh(), own, other, far);
  if (start.stretches != 1) return std::nullopt;
  return std::move(start.curve);
}

std::optional<SampleChain> FairPatching::next(const SampleChain& chain,
                                              std::span<const SurfacePoint> bad, bool has_curve) {
  if (chain.size() < kLeast) return std::nullopt;
  // What has made it worse is left again.
  if (!best_ || has_curve > has_curve_ || (has_curve == has_curve_ && bad.size() < bad_.size())) {
    best_ = chain;
    has_curve_ = has_curve;
    bad_.assign(bad.begin(), bad.end());
  }
  std::optional<SampleChain> patched;
  while (!patched && round_ < std::size(kPatchings)) patched = patched_by(kPatchings[round_++]);
  return patched;
}

std::optional<SampleChain> FairPatching::patched_by(const FairPatch& patch) {
  std::vector<std::size_t> samples = bad_samples(*best_, bad_);
  const std::size_t size = best_->size();
  SampleChain chain = *best_;
  if (chain.closed) {
    const std::size_t first = farthest_from(samples, size);
    chain = begun_at(chain, first);
    for (std::size_t& i : samples) i = (i + size - first) % size;
    std::sort(samples.begin(), samples.end());
  }
  const std::vector<ChainRange> all = ranges_about(samples, patch.core + kEase, size);
  if (!is_little(all, size)) return std::nullopt;
  std::vector<ChainRange> ranges;
  std::vector<SampleChain> parts;
  hold_->with_fairing(*group_, *taus_, patch.band, {}, *asker_, [&](CurveFairing& fairing) {
    for (const ChainRange& range : all) {
      const auto first = std::lower_bound(samples.begin(), samples.end(), range.first);
      const auto last = std::prev(std::upper_bound(samples.begin(), samples.end(), range.last));
      const ChainRange core{*first - std::min(*first, patch.core), *last + patch.core};
      auto part = part_from(chain, range, core, patch.from, fairing);
      if (!part) continue;
      ranges.push_back(range);
      parts.push_back(*std::move(part));
    }
  });
  if (parts.empty()) return std::nullopt;
  if (patch.from == From::kDrawing) redrawn_ += parts.size();
  return with_parts(chain, ranges, parts);
}

/// A range of the chain without fixed samples, faired anew from what a course has beside its core.
std::optional<SampleChain> FairPatching::part_from(const SampleChain& chain, ChainRange range,
                                                   ChainRange core, FairPatch::From from,
                                                   CurveFairing& fairing) {
  const ChainFrame frame{&chain, range};
  const ChainRange inside = frame.inside();
  const auto at = [&](std::size_t i) {
    return chain.fixed.begin() + static_cast<std::ptrdiff_t>(i);
  };
  if (std::find(at(inside.first + 1), at(inside.last), true) != at(inside.last))
    return std::nullopt;
  const auto start =
      start_of(chain, range, core, from == FairPatch::From::kDrawing ? drawn_ : taut_);
  if (!start) return std::nullopt;
  return fairing.part_from(trace_of(hold_->drawing().surface(), *start), frame, *asker_);
}

}  // namespace talweg
