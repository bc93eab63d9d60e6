#include "talweg/core/fairing/chain_parts.hpp"

#include <algorithm>
#include <cstdint>

namespace talweg {
namespace {

SurfacePoint point_of(const Surface& surface, const FaceCoordinates& at) {
  return SurfacePoint::from_barycentric(surface, at.face, at.barycentric, 0);
}

void add_join(const SampleChain& from, std::size_t join, SampleChain& to) {
  const auto strip = from.strip(from.joins[join]);
  to.joins.push_back(from.joins[join]);
  to.joins.back().first = static_cast<std::uint32_t>(to.crossed.size());
  to.crossed.insert(to.crossed.end(), strip.begin(), strip.end());
}

/// Appends samples without the joins between them.
void add_samples(const SampleChain& from, std::size_t first, std::size_t last, SampleChain& to) {
  const auto add = [&](const auto& values, auto& all) {
    all.insert(all.end(), values.begin() + static_cast<std::ptrdiff_t>(first),
               values.begin() + static_cast<std::ptrdiff_t>(last));
  };
  add(from.samples, to.samples);
  add(from.fixed, to.fixed);
  add(from.turns, to.turns);
  if (!from.drawn.empty()) add(from.drawn, to.drawn);
  to.drawn_length = from.drawn_length;
  to.corners.resize(to.samples.size(), false);
  for (std::size_t i = first; i < last && !from.corners.empty(); ++i) {
    to.corners[to.samples.size() - last + i] = from.corners[i];
  }
}

void add_fixed_points(const SampleChain& from, std::size_t first, std::size_t last,
                      SampleChain& to) {
  const auto count = [&](std::size_t end) {
    return std::count(from.fixed.begin(), from.fixed.begin() + static_cast<std::ptrdiff_t>(end),
                      true);
  };
  to.fixed_points.insert(to.fixed_points.end(), from.fixed_points.begin() + count(first),
                         from.fixed_points.begin() + count(last));
}

/// Numbers the stretches as ChainMaker::sampled() does, and clears `corners` if no sample is a
/// corner.
void settle(SampleChain& chain) {
  const auto fixed =
      static_cast<std::uint32_t>(std::count(chain.fixed.begin(), chain.fixed.end(), true));
  std::uint32_t stretch = fixed > 0 ? fixed - 1 : 0;  // a loop may begin in its last stretch
  for (std::size_t i = 0; i < chain.joins.size(); ++i) {
    if (chain.fixed[i]) stretch = stretch + 1 < fixed ? stretch + 1 : 0;
    chain.joins[i].stretch = stretch;
  }
  if (std::find(chain.corners.begin(), chain.corners.end(), true) == chain.corners.end()) {
    chain.corners.clear();
  }
}

}  // namespace

std::vector<ChainRange> ranges_about(std::span<const std::size_t> samples, std::size_t beside,
                                     std::size_t size) {
  std::vector<ChainRange> ranges;
  for (const std::size_t i : samples) {
    const ChainRange range{i > beside ? i - beside : 0, std::min(i + beside, size - 1)};
    if (!ranges.empty() && range.first <= ranges.back().last + 1) {
      ranges.back().last = range.last;
    } else {
      ranges.push_back(range);
    }
  }
  return ranges;
}

bool is_small_part(std::span<const ChainRange> ranges, std::size_t size) {
  std::size_t sum = 0;
  for (const ChainRange& range : ranges) sum += range.last - range.first;
  return sum < size / 4;
}

SampleChain part_of(const Surface& surface, const SampleChain& chain, ChainRange range) {
  SampleChain part;
  add_samples(chain, range.first, range.last + 1, part);
  for (std::size_t i = range.first; i < range.last; ++i) add_join(chain, i, part);
  // A fixed sample has a stored point, which may lie on an edge or at a vertex.
  const auto add_end = [&](std::size_t i) {
    if (chain.fixed[i]) return add_fixed_points(chain, i, i + 1, part);
    part.fixed_points.push_back(point_of(surface, chain.samples[i]));
  };
  add_end(range.first);
  add_fixed_points(chain, range.first + 1, range.last, part);
  add_end(range.last);
  part.fixed.front() = part.fixed.back() = true;
  part.turns.front() = part.turns.back() = 0;
  settle(part);
  return part;
}

std::optional<SampleChain> framed(const Surface& surface, SampleChain part,
                                  const ChainFrame& frame) {
  const SampleChain& chain = *frame.chain;
  const ChainRange inside = frame.inside();
  SampleChain result;
  const auto stay = [&](std::size_t i) {
    add_samples(chain, i, i + 1, result);
    result.fixed.back() = true;
    if (chain.fixed[i]) return add_fixed_points(chain, i, i + 1, result);
    result.fixed_points.push_back(point_of(surface, chain.samples[i]));
  };
  if (frame.has_first()) {
    if (part.samples.front().face != chain.samples[inside.first].face) return std::nullopt;
    stay(frame.range.first);
    add_join(chain, frame.range.first, result);
  }
  add_samples(part, 0, part.size(), result);
  result.fixed_points.insert(result.fixed_points.end(), part.fixed_points.begin(),
                             part.fixed_points.end());
  for (std::size_t i = 0; i < part.joins.size(); ++i) add_join(part, i, result);
  if (frame.has_last()) {
    if (part.samples.back().face != chain.samples[inside.last].face) return std::nullopt;
    add_join(chain, inside.last, result);
    stay(frame.range.last);
  }
  settle(result);
  return result;
}

SampleChain with_parts(const SampleChain& chain, std::span<const ChainRange> ranges,
                       std::span<const SampleChain> parts) {
  SampleChain result;
  result.closed = chain.closed;
  std::size_t next = 0;  // the first sample that is not in `result` yet
  const auto stay_until = [&](std::size_t end) {
    add_samples(chain, next, end, result);
    add_fixed_points(chain, next, end, result);
    next = end;
  };
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const ChainRange& range = ranges[k];
    for (std::size_t i = next; i < range.first; ++i) add_join(chain, i, result);
    // The first two and the last two samples of a part are the chain's, and fixed only if they are
    // fixed in the chain.
    const SampleChain& part = parts[k];
    const ChainFrame frame{&chain, range};
    const std::size_t before = frame.has_first() ? 1 : 0, after = frame.has_last() ? 1 : 0;
    stay_until(range.first + 1);
    const std::size_t begun = result.size();
    add_samples(part, 1, part.size() - 1, result);
    // The fixed points of these samples are taken from the chain.
    if (before > 0) {
      result.fixed[begun] = chain.fixed[range.first + 1];
      add_fixed_points(chain, range.first + 1, range.first + 2, result);
    }
    result.fixed_points.insert(result.fixed_points.end(),
                               part.fixed_points.begin() + static_cast<std::ptrdiff_t>(1 + before),
                               part.fixed_points.end() - static_cast<std::ptrdiff_t>(1 + after));
    if (after > 0) {
      result.fixed.back() = chain.fixed[range.last - 1];
      add_fixed_points(chain, range.last - 1, range.last, result);
    }
    for (std::size_t i = 0; i < part.joins.size(); ++i) add_join(part, i, result);
    next = range.last;
  }
  for (std::size_t i = next; i < chain.joins.size(); ++i) add_join(chain, i, result);
  stay_until(chain.size());
  settle(result);
  return result;
}

}  // namespace talweg
