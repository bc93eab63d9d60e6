#include "talweg/core/drawing/stroke_spikes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace talweg {
namespace {

constexpr double kAway = 8, kBack = 4;  // usual steps
constexpr double kUsualOfLength = 0.25;
constexpr std::size_t kLongest = 3, kFewest = 24;  // samples

double usual_step(std::span<const Point> samples) {
  std::vector<double> steps;
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
    steps.push_back((samples[k + 1] - samples[k]).norm());
  }
  std::sort(steps.begin(), steps.end());
  // The longest tenth of the steps is left out, since spikes make the longest steps.
  steps.resize(steps.size() - steps.size() / 10);
  const double length = std::accumulate(steps.begin(), steps.end(), 0.0);
  double before = 0;
  for (const double step : steps) {
    before += step;
    if (before >= kUsualOfLength * length) return step;
  }
  return 0;
}

}  // namespace

std::vector<std::size_t> spikes_of(std::span<const Point> samples, bool closed) {
  std::vector<std::size_t> spikes;
  const std::size_t n = samples.size();
  if (n < kFewest) return spikes;
  const double usual = usual_step(samples);
  if (!(usual > 0 && std::isfinite(usual))) return spikes;
  const auto apart = [&](std::size_t a, std::size_t b) {
    return (samples[a % n] - samples[b % n]).norm();
  };
  for (std::size_t k = closed ? 0 : 1; k + 1 < (closed ? n + 1 : n); ++k) {
    for (std::size_t count = 1; count <= kLongest && k + count < n + (closed ? 1 : 0); ++count) {
      const std::size_t before = k + n - 1, after = k + count;
      if (apart(before, after) > kBack * usual) continue;
      bool away = true;
      for (std::size_t i = k; i < after; ++i) {
        away = away && apart(i, before) > kAway * usual && apart(i, after) > kAway * usual;
      }
      if (!away) continue;
      for (std::size_t i = k; i < after; ++i) spikes.push_back(i % n);
      k = after - 1;
      break;
    }
  }
  std::sort(spikes.begin(), spikes.end());
  spikes.erase(std::unique(spikes.begin(), spikes.end()), spikes.end());
  return spikes;
}

}  // namespace talweg
