#include "talweg/core/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace talweg {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json object_of(const SmoothingReport& r) {
  Json j;
  j["version"] = r.version;
  j["faces"] = r.faces;
  j["vertices"] = r.vertices;
  j["tau"] = number(r.tau);
  j["slack"] = number(r.slack);
  j["max_deviation"] = number(r.max_deviation);
  j["pins_added"] = r.pins_added;
  j["edge_length_near"] = number(r.edge_length_near);
  j["potential"] = r.potential;
  j["engine"] = r.engine;
  j["closed"] = r.closed;
  j["points_before"] = r.points_before;
  j["points_after"] = r.points_after;
  j["length_before"] = number(r.length_before);
  j["length_after"] = number(r.length_after);
  j["lifted_length_before"] = number(r.lifted_length_before);
  j["lifted_length_after"] = number(r.lifted_length_after);
  j["curvature_before"] = number(r.curvature_before);
  j["curvature_after"] = number(r.curvature_after);
  j["curvature_max_before"] = number(r.curvature_max_before);
  j["curvature_max_after"] = number(r.curvature_max_after);
  j["deviation"] = r.deviation;
  j["deviation_to_drawn_max"] = number(r.deviation_to_drawn_max);
  j["deviation_to_drawn_mean"] = number(r.deviation_to_drawn_mean);
  j["deviation_from_drawn_max"] = number(r.deviation_from_drawn_max);
  j["deviation_from_drawn_mean"] = number(r.deviation_from_drawn_mean);
  j["deviation_at"] = {number(r.deviation_at[0]), number(r.deviation_at[1]),
                       number(r.deviation_at[2])};
  j["moved"] = number(r.moved);
  j["flips"] = r.flips;
  j["iterations"] = r.iterations;
  j["faces_touched"] = r.faces_touched;
  j["trace_fallbacks"] = r.trace_fallbacks;
  j["termination"] = r.termination;
  j["warnings"] = r.warnings;
  j["time_ms"] = {{"load", r.time_ms.load},     {"open", r.time_ms.open},
                  {"solve", r.time_ms.solve},   {"straighten", r.time_ms.straighten},
                  {"trace", r.time_ms.trace},   {"relax", r.time_ms.relax},
                  {"polish", r.time_ms.polish}, {"total", r.time_ms.total}};
  j["peak_memory_mib"] = number(r.peak_memory_mib);
  return j;
}

/// Worse outcomes last.
std::size_t rank(const std::string& termination) {
  constexpr std::array<const char*, 5> kOrder = {"converged", "deviation", "collapsed", "limit",
                                                 "cancelled"};
  const auto at = std::find(kOrder.begin(), kOrder.end(), termination);
  return static_cast<std::size_t>(at - kOrder.begin());
}

}  // namespace

SmoothingReport total_of(const std::vector<SmoothingReport>& reports) {
  if (reports.empty()) return {};
  SmoothingReport total = reports.front();
  // Infinite even where the length is 0.
  const auto weighted = [](double mean, double length) {
    return std::isfinite(mean) ? mean * length : mean;
  };
  double mean_to = weighted(total.deviation_to_drawn_mean, total.length_after);
  double mean_from = weighted(total.deviation_from_drawn_mean, total.length_before);
  double worst = std::max(total.deviation_to_drawn_max, total.deviation_from_drawn_max);
  for (std::size_t i = 1; i < reports.size(); ++i) {
    const SmoothingReport& r = reports[i];
    total.closed = total.closed && r.closed;
    total.points_before += r.points_before;
    total.points_after += r.points_after;
    total.length_before += r.length_before;
    total.length_after += r.length_after;
    total.lifted_length_before += r.lifted_length_before;
    total.lifted_length_after += r.lifted_length_after;
    total.curvature_before += r.curvature_before;
    total.curvature_after += r.curvature_after;
    total.curvature_max_before = std::max(total.curvature_max_before, r.curvature_max_before);
    total.curvature_max_after = std::max(total.curvature_max_after, r.curvature_max_after);
    total.deviation_to_drawn_max = std::max(total.deviation_to_drawn_max, r.deviation_to_drawn_max);
    total.deviation_from_drawn_max =
        std::max(total.deviation_from_drawn_max, r.deviation_from_drawn_max);
    mean_to += weighted(r.deviation_to_drawn_mean, r.length_after);
    mean_from += weighted(r.deviation_from_drawn_mean, r.length_before);
    const double own_worst = std::max(r.deviation_to_drawn_max, r.deviation_from_drawn_max);
    if (own_worst > worst) {
      worst = own_worst;
      total.deviation_at = r.deviation_at;
    }
    total.moved = std::max(total.moved, r.moved);
    if (rank(r.termination) > rank(total.termination)) total.termination = r.termination;
    for (const std::string& warning : r.warnings) {
      if (std::find(total.warnings.begin(), total.warnings.end(), warning) ==
          total.warnings.end()) {
        total.warnings.push_back(warning);
      }
    }
  }
  if (total.length_after > 0) total.deviation_to_drawn_mean = mean_to / total.length_after;
  if (total.length_before > 0) total.deviation_from_drawn_mean = mean_from / total.length_before;
  return total;
}

std::string to_json(const SmoothingReport& report) { return object_of(report).dump(2) + "\n"; }

std::string to_json(const SmoothingReport& total, const std::vector<SmoothingReport>& curves) {
  Json j = object_of(total);
  if (curves.size() > 1) {
    for (const SmoothingReport& r : curves) j["curves"].push_back(object_of(r));
  }
  return j.dump(2) + "\n";
}

double peak_memory_mib() {
#if defined(__APPLE__)
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<double>(usage.ru_maxrss) / 1048576 : 0;
#elif defined(__unix__)
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<double>(usage.ru_maxrss) / 1024 : 0;
#else
  return 0;
#endif
}

}  // namespace talweg
