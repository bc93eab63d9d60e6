#include "lines.hpp"

#include <algorithm>
#include <cmath>

#include "report_json.hpp"
#include "talweg/editing/vectors.hpp"

namespace talweg::browser {
namespace {

std::vector<double> field(const host::Curve& curve, const char* name) {
  for (const host::Field& field : curve.fields) {
    if (field.name == name) return field.values;
  }
  return {};
}

/// Arc length at every point; for a closed curve also at the first point again.
std::vector<double> arcs_of(const host::Curve& curve) {
  const std::size_t n = curve.positions.size();
  std::vector<double> arcs = {0};
  for (std::size_t k = 1; k < n + (curve.closed ? 1 : 0); ++k) {
    const auto step = editing::minus(curve.positions[k % n], curve.positions[k - 1]);
    arcs.push_back(arcs.back() + editing::length(step));
  }
  return arcs;
}

/// The sum of the turns at points with arc lengths in [from, to]; a closed curve is periodic.
double turn_within(const std::vector<double>& arcs, const std::vector<double>& sums, double from,
                   double to) {
  const auto before = [&](double arc) {
    const auto end = arcs.begin() + static_cast<std::ptrdiff_t>(sums.size() - 1);
    return sums[static_cast<std::size_t>(std::lower_bound(arcs.begin(), end, arc) - arcs.begin())];
  };
  return before(std::nextafter(to, HUGE_VAL)) - before(from);
}

std::vector<double> mean_turning(const host::Curve& curve, double window) {
  const std::vector<double> turns = field(curve, "curvature");
  const std::size_t n = curve.positions.size();
  if (turns.size() != n || n < 2) return {};
  const std::vector<double> arcs = arcs_of(curve);
  const double length = arcs.back();
  if (!(length > 0)) return std::vector<double>(n, 0);
  std::vector<double> sums = {0};
  for (const double turn : turns) sums.push_back(sums.back() + turn);
  const double half = std::min(window, length / 4);
  std::vector<double> result;
  for (std::size_t k = 0; k < n; ++k) {
    double from = arcs[k] - half, to = arcs[k] + half;
    double turn = turn_within(arcs, sums, from, to);
    if (curve.closed) {
      if (from < 0) turn += turn_within(arcs, sums, from + length, length);
      if (to > length) turn += turn_within(arcs, sums, 0, to - length);
    } else {
      from = std::max(from, 0.0);
      to = std::min(to, length);
    }
    result.push_back(turn / (to - from));
  }
  return result;
}

Json line_of(const host::Curve& curve, Answer& answer) {
  Json line;
  line["positions"] = answer.array(flat(curve.positions));
  line["faces"] = answer.array(std::vector<std::int32_t>(curve.faces.begin(), curve.faces.end()));
  line["barycentric"] = answer.array(flat(curve.barycentrics));
  line["closed"] = curve.closed;
  return line;
}

Json texts_of(const host::Results& results, const char* key, std::int64_t curve) {
  const host::ReportEntry* entry = results.find(key, curve);
  return entry == nullptr ? Json::array() : Json(entry->texts);
}

/// The decisive warnings, each with its place, if it has one.
Json decisive_of(const host::Results& results, std::int64_t curve) {
  Json all = Json::array();
  const host::ReportEntry* sentences = results.find("decisive", curve);
  const host::ReportEntry* places = results.find("decisive_at", curve);
  if (sentences == nullptr || places == nullptr) return all;
  for (std::size_t k = 0; k < sentences->texts.size(); ++k) {
    const auto first = places->numbers.begin() + static_cast<std::ptrdiff_t>(3 * k);
    const bool has_place = std::isfinite(*first);
    all.push_back(
        {{"sentence", sentences->texts[k]},
         {"at", has_place ? Json(std::vector<double>(first, first + 3)) : Json(nullptr)}});
  }
  return all;
}

/// `RidgeReport` in src/engine/types.ts; null where ridges were not to attract the drawing.
Json ridges_of(const host::Results& results, std::int64_t curve) {
  if (results.find("ridge_moved", curve) == nullptr) return nullptr;
  const auto number = [&](const char* key) { return number_or_null(results, key, curve); };
  return {{"moved", number("ridge_moved")},
          {"farthest", number("ridge_moved_max")},
          {"already", number("ridge_already")},
          {"clicks", number("ridge_clicks_moved")},
          {"farthestClick", number("ridge_clicks_moved_max")},
          {"band", number("ridge_band")}};
}

Json report_of(const host::Results& results, std::int64_t curve) {
  const auto number = [&](const char* key) { return number_or_null(results, key, curve); };
  const std::string of = results.text("farthest_of", curve);
  const host::ReportEntry* at = of == "none" ? nullptr : results.find("farthest_at", curve);
  const double mean = std::max(results.number("deviation_to_drawn_mean", curve, std::nan("")),
                               results.number("deviation_from_drawn_mean", curve, std::nan("")));
  return {{"length", number("length_after")},
          {"drawnLength", number("length_before")},
          {"farthest", number("farthest")},
          {"farthestAtMost", number("farthest_at_most")},
          {"farthestOf", of},
          {"meanDeviation", std::isfinite(mean) ? Json(mean) : Json(nullptr)},
          {"turning", number("curvature_after")},
          {"termination", results.text("termination", curve)},
          {"warnings", texts_of(results, "warnings", curve)},
          {"decisive", decisive_of(results, curve)},
          {"ridges", ridges_of(results, curve)},
          {"worst", at == nullptr ? Json(nullptr) : Json(at->numbers)}};
}

}  // namespace

std::vector<double> flat(const std::vector<std::array<double, 3>>& rows) {
  std::vector<double> numbers;
  numbers.reserve(3 * rows.size());
  for (const auto& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
  return numbers;
}

Json lines_of(const host::Results& results, double window, Answer& answer) {
  Json lines = Json::array();
  for (std::size_t c = 0; c < results.curves.size(); ++c) {
    const host::Curve& curve = results.curves[c];
    Json line = line_of(curve, answer);
    line["turning"] = answer.array(mean_turning(curve, window));
    line["deviation"] = answer.array(field(curve, "deviation"));
    line["report"] = report_of(results, static_cast<std::int64_t>(c));
    lines.push_back(std::move(line));
  }
  return lines;
}

Json drawn_lines(const std::vector<host::Curve>& curves, Answer& answer) {
  Json lines = Json::array();
  for (const host::Curve& curve : curves) {
    Json line = line_of(curve, answer);
    const double length = arcs_of(curve).back();
    line["turning"] = answer.array(std::vector<double>());
    line["deviation"] = answer.array(std::vector<double>());
    line["report"] = {
        {"length", length},          {"drawnLength", length}, {"farthest", nullptr},
        {"farthestAtMost", nullptr}, {"farthestOf", "none"},  {"meanDeviation", nullptr},
        {"turning", nullptr},        {"termination", ""},     {"warnings", Json::array()},
        {"decisive", Json::array()}, {"ridges", nullptr},     {"worst", nullptr}};
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace talweg::browser
