#include "talweg/core/measure/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace talweg {
namespace {

/// Visits every field of a report with its name, in order; `Report` may be const.
template <class Report, class Visit>
void for_each_field(Report& r, Visit visit) {
  visit("version", r.version);
  visit("faces", r.faces);
  visit("vertices", r.vertices);
  visit("tau", r.tau);
  visit("slack", r.slack);
  visit("slack_from", r.slack_from);
  visit("left_out", r.left_out);
  visit("left_out_max", r.left_out_max);
  visit("max_deviation", r.max_deviation);
  visit("pins_added", r.pins_added);
  visit("edge_length_near", r.edge_length_near);
  visit("potential", r.potential);
  visit("engine", r.engine);
  visit("closed", r.closed);
  visit("points_before", r.points_before);
  visit("points_after", r.points_after);
  visit("length_before", r.length_before);
  visit("length_after", r.length_after);
  visit("lifted_length_before", r.lifted_length_before);
  visit("lifted_length_after", r.lifted_length_after);
  visit("curvature_before", r.curvature_before);
  visit("curvature_after", r.curvature_after);
  visit("curvature_max_before", r.curvature_max_before);
  visit("curvature_max_after", r.curvature_max_after);
  visit("bending_before", r.bending_before);
  visit("bending_after", r.bending_after);
  visit("window_turning_before", r.window_turning_before);
  visit("window_turning_after", r.window_turning_after);
  visit("window_turning_2_before", r.window_turning_2_before);
  visit("window_turning_2_after", r.window_turning_2_after);
  visit("deviation", r.deviation);
  visit("deviation_to_drawn_max", r.deviation_to_drawn_max);
  visit("deviation_to_drawn_mean", r.deviation_to_drawn_mean);
  visit("deviation_from_drawn_max", r.deviation_from_drawn_max);
  visit("deviation_from_drawn_mean", r.deviation_from_drawn_mean);
  visit("deviation_at", r.deviation_at);
  visit("deviation_exact", r.deviation_exact);
  visit("deviation_at_least", r.deviation_at_least);
  visit("moved", r.moved);
  visit("flips", r.flips);
  visit("iterations", r.iterations);
  visit("faces_touched", r.faces_touched);
  visit("trace_fallbacks", r.trace_fallbacks);
  visit("stretches_redrawn", r.stretches_redrawn);
  visit("mollification", r.mollification);
  visit("crossings_before", r.crossings_before);
  visit("crossings_after", r.crossings_after);
  visit("termination", r.termination);
  visit("warnings", r.warnings);
  visit("time_ms.load", r.time_ms.load);
  visit("time_ms.open", r.time_ms.open);
  visit("time_ms.solve", r.time_ms.solve);
  visit("time_ms.straighten", r.time_ms.straighten);
  visit("time_ms.trace", r.time_ms.trace);
  visit("time_ms.relax", r.time_ms.relax);
  visit("time_ms.fair", r.time_ms.fair);
  visit("time_ms.measure", r.time_ms.measure);
  visit("time_ms.total", r.time_ms.total);
  visit("peak_memory_mib", r.peak_memory_mib);
}

}  // namespace

const char* to_string(PotentialKind potential) {
  constexpr std::array kNames = {"paper", "corridor", "custom", "none"};
  return kNames[static_cast<std::size_t>(potential)];
}

const char* to_string(Engine engine) {
  constexpr std::array kNames = {"full", "local", "refined", "preview", "none"};
  return kNames[static_cast<std::size_t>(engine)];
}

const char* to_string(Outcome outcome) {
  constexpr std::array kNames = {"converged", "missed", "deviation",
                                 "collapsed", "limit",  "cancelled"};
  return kNames[static_cast<std::size_t>(outcome)];
}

const char* to_string(SlackSource source) {
  constexpr std::array kNames = {"none", "given", "edges", "trembling", "segments"};
  return kNames[static_cast<std::size_t>(source)];
}

const char* to_string(DeviationMeasure measure) {
  constexpr std::array kNames = {"automatic", "surface", "euclidean", "none"};
  return kNames[static_cast<std::size_t>(measure)];
}

SmoothingReport total_of(const std::vector<SmoothingReport>& reports) {
  if (reports.empty()) return {};
  SmoothingReport total = reports.front();
  // A mean that is infinite stays so even where the length is 0.
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
    total.left_out += r.left_out;
    total.left_out_max = std::max(total.left_out_max, r.left_out_max);
    total.stretches_redrawn += r.stretches_redrawn;
    total.length_before += r.length_before;
    total.length_after += r.length_after;
    total.lifted_length_before += r.lifted_length_before;
    total.lifted_length_after += r.lifted_length_after;
    total.curvature_before += r.curvature_before;
    total.curvature_after += r.curvature_after;
    total.curvature_max_before = std::max(total.curvature_max_before, r.curvature_max_before);
    total.curvature_max_after = std::max(total.curvature_max_after, r.curvature_max_after);
    total.bending_before += r.bending_before;
    total.bending_after += r.bending_after;
    total.window_turning_before = std::max(total.window_turning_before, r.window_turning_before);
    total.window_turning_after = std::max(total.window_turning_after, r.window_turning_after);
    total.window_turning_2_before =
        std::max(total.window_turning_2_before, r.window_turning_2_before);
    total.window_turning_2_after = std::max(total.window_turning_2_after, r.window_turning_2_after);
    if (r.deviation == DeviationMeasure::kEuclidean) total.deviation = r.deviation;
    total.deviation_to_drawn_max = std::max(total.deviation_to_drawn_max, r.deviation_to_drawn_max);
    total.deviation_from_drawn_max =
        std::max(total.deviation_from_drawn_max, r.deviation_from_drawn_max);
    total.deviation_exact = total.deviation_exact && r.deviation_exact;
    total.deviation_at_least = std::max(total.deviation_at_least, r.deviation_at_least);
    mean_to += weighted(r.deviation_to_drawn_mean, r.length_after);
    mean_from += weighted(r.deviation_from_drawn_mean, r.length_before);
    const double own_worst = std::max(r.deviation_to_drawn_max, r.deviation_from_drawn_max);
    if (own_worst > worst) {
      worst = own_worst;
      total.deviation_at = r.deviation_at;
    }
    total.moved = std::max(total.moved, r.moved);
    total.termination = std::max(total.termination, r.termination);
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

std::vector<ReportEntry> entries_of(const SmoothingReport& report) {
  std::vector<ReportEntry> entries;
  for_each_field(report, [&entries]<class Value>(const char* key, const Value& value) {
    if constexpr (std::is_same_v<Value, Point>) {
      entries.push_back({key, std::vector<double>(value.begin(), value.end())});
    } else if constexpr (std::is_same_v<Value, std::size_t>) {
      entries.push_back({key, std::uint64_t{value}});
    } else if constexpr (std::is_enum_v<Value>) {
      entries.push_back({key, std::string(to_string(value))});
    } else {
      entries.push_back({key, value});
    }
  });
  return entries;
}

std::string to_json(const SmoothingReport& report) { return to_json(entries_of(report), {}); }

std::string to_json(const SmoothingReport& total, const std::vector<SmoothingReport>& curves) {
  std::vector<std::vector<ReportEntry>> entries;
  entries.reserve(curves.size());
  for (const SmoothingReport& report : curves) entries.push_back(entries_of(report));
  return to_json(entries_of(total), entries);
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
