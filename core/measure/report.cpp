#include "talweg/core/measure/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "talweg/core/measure/named_measures.hpp"
#include "talweg/core/system/process.hpp"

namespace talweg {
namespace {

/// Calls visit(name, value) for each entry of a report, in order.
template <class Visit>
void for_each_field(const SmoothingReport& r, Visit visit) {
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
  visit("roughness_near", r.roughness_near);
  visit("potential", r.potential);
  visit("engine", r.engine);
  visit("closed", r.closed);
  visit("points_before", r.points_before);
  visit("points_after", r.points_after);
  for (const NamedMeasure& measure : kNamedMeasures) {
    const std::string name = measure.name;
    visit(name + "_before", r.before.*measure.value);
    visit(name + "_after", r.after.*measure.value);
  }
  visit("lifted_length_before", r.lifted_length_before);
  visit("lifted_length_after", r.lifted_length_after);
  visit("deviation", r.deviation);
  visit("deviation_to_drawn_max", r.deviation_to_drawn_max);
  visit("deviation_to_drawn_mean", r.deviation_to_drawn_mean);
  visit("deviation_from_drawn_max", r.deviation_from_drawn_max);
  visit("deviation_from_drawn_mean", r.deviation_from_drawn_mean);
  visit("deviation_at", r.deviation_at);
  visit("deviation_exact", r.deviation_exact);
  visit("deviation_at_least", r.deviation_at_least);
  visit("missed_points", r.missed_points);
  visit("missed_max", r.missed_max);
  visit("missed_at", r.missed_at);
  const Farthest far = farthest(r);
  visit("farthest", far.at_least);
  visit("farthest_at_most", far.at_most);
  visit("farthest_at", far.at);
  visit("farthest_of", far.of);
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
  std::vector<std::string> decisive;
  std::vector<double> places;
  for (const Decisive& one : r.decisive) {
    decisive.push_back(one.sentence);
    places.insert(places.end(), one.at.begin(), one.at.end());
  }
  visit("decisive", decisive);
  visit("decisive_at", places);
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

/// Adds the warnings that the total does not have.
template <class Warning>
void add(std::vector<Warning>& total, const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) {
    if (std::find(total.begin(), total.end(), warning) == total.end()) total.push_back(warning);
  }
}

void add_missed(SmoothingReport& total, const SmoothingReport& r) {
  if (r.missed_max > total.missed_max) total.missed_at = r.missed_at;
  total.missed_max = std::max(total.missed_max, r.missed_max);
  total.missed_points += r.missed_points;
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

const char* to_string(FarthestOf of) {
  constexpr std::array kNames = {"none", "result", "drawing", "point"};
  return kNames[static_cast<std::size_t>(of)];
}

void warn_decisively(SmoothingReport& report, Decisive warning) {
  report.warnings.push_back(warning.sentence);
  report.decisive.push_back(std::move(warning));
}

void lead_with(SmoothingReport& report, const std::vector<std::string>& sentences) {
  std::vector<Decisive> first;
  first.reserve(sentences.size());
  for (const std::string& sentence : sentences) first.push_back({sentence});
  report.decisive.insert(report.decisive.begin(), first.begin(), first.end());
}

Farthest farthest(const SmoothingReport& r) {
  Farthest far;
  if (r.deviation != DeviationMeasure::kNone) {
    const double most = std::max(r.deviation_to_drawn_max, r.deviation_from_drawn_max);
    const bool along = r.deviation == DeviationMeasure::kAlongSurface;
    const bool cut = r.deviation_from_drawn_max > r.deviation_to_drawn_max;
    far = {r.deviation_exact ? most : r.deviation_at_least, along ? most : HUGE_VAL, r.deviation_at,
           cut ? FarthestOf::kDrawing : FarthestOf::kResult};
  }
  if (r.missed_points == 0) return far;
  far.at_most = HUGE_VAL;                 // distances of missed points are through space
  constexpr double kRounding = 1 + 1e-6;  // the missed point may be the drawing's farthest point
  if (far.of != FarthestOf::kNothing && far.at_least > kRounding * r.missed_max) return far;
  return {r.missed_max, HUGE_VAL, r.missed_at, FarthestOf::kPoint};
}

SmoothingReport total_of(const std::vector<SmoothingReport>& reports) {
  if (reports.empty()) return {};
  SmoothingReport total = reports.front();
  // An infinite mean stays infinite even if the length is 0.
  const auto weighted = [](double mean, double length) {
    return std::isfinite(mean) ? mean * length : mean;
  };
  double mean_to = weighted(total.deviation_to_drawn_mean, total.after.length);
  double mean_from = weighted(total.deviation_from_drawn_mean, total.before.length);
  double worst = std::max(total.deviation_to_drawn_max, total.deviation_from_drawn_max);
  for (std::size_t i = 1; i < reports.size(); ++i) {
    const SmoothingReport& r = reports[i];
    total.closed = total.closed && r.closed;
    total.points_before += r.points_before;
    total.points_after += r.points_after;
    total.left_out += r.left_out;
    total.left_out_max = std::max(total.left_out_max, r.left_out_max);
    total.stretches_redrawn += r.stretches_redrawn;
    add(total.before, r.before);
    add(total.after, r.after);
    total.lifted_length_before += r.lifted_length_before;
    total.lifted_length_after += r.lifted_length_after;
    if (r.deviation == DeviationMeasure::kEuclidean) total.deviation = r.deviation;
    total.deviation_to_drawn_max = std::max(total.deviation_to_drawn_max, r.deviation_to_drawn_max);
    total.deviation_from_drawn_max =
        std::max(total.deviation_from_drawn_max, r.deviation_from_drawn_max);
    total.deviation_exact = total.deviation_exact && r.deviation_exact;
    total.deviation_at_least = std::max(total.deviation_at_least, r.deviation_at_least);
    mean_to += weighted(r.deviation_to_drawn_mean, r.after.length);
    mean_from += weighted(r.deviation_from_drawn_mean, r.before.length);
    const double own_worst = std::max(r.deviation_to_drawn_max, r.deviation_from_drawn_max);
    if (own_worst > worst) {
      worst = own_worst;
      total.deviation_at = r.deviation_at;
    }
    total.moved = std::max(total.moved, r.moved);
    total.termination = std::max(total.termination, r.termination);
    add_missed(total, r);
    add(total.warnings, r.warnings);
    add(total.decisive, r.decisive);
  }
  if (total.after.length > 0) total.deviation_to_drawn_mean = mean_to / total.after.length;
  if (total.before.length > 0) total.deviation_from_drawn_mean = mean_from / total.before.length;
  return total;
}

std::vector<ReportEntry> entries_of(const SmoothingReport& report) {
  std::vector<ReportEntry> entries;
  for_each_field(report, [&entries]<class Value>(const std::string& key, const Value& value) {
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

double peak_memory_mib() { return static_cast<double>(peak_memory_bytes()) / 1048576; }

}  // namespace talweg
