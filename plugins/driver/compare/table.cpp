#include "compare/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "compare/verdict.hpp"

namespace talweg::driver {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMeasures = 10;
using TableRow = std::array<std::string, kMeasures>;

const TableRow kHead = {"method",           "parameter",
                        "curvature, rad",   "bending",
                        "in one edge, deg", "to drawing, edges",
                        "from it, edges",   "length, x",
                        "first, again, ms", "kind"};

/// Curvature, bending and turning in one edge.
void add_turns(const CurveNumbers& n, TableRow& row) {
  row[2] = fmt::format("{:.3f}", n.curvature);
  row[3] = fmt::format("{:.3f}", n.bending);
  row[4] = fmt::format("{:.0f}", n.window_turning * 180 / std::numbers::pi);
}

std::string parameter_of(const Comparison& c, const ComparedRun& run) {
  if (!run.value) return "default";
  return fmt::format("{} {:.4g}", c.methods[run.method].swept, *run.value);
}

TableRow drawing_row(const Comparison& c) {
  TableRow row{"(drawing)"};
  add_turns(c.drawn, row);
  return row;
}

TableRow row_of(const Comparison& c, const ComparedRun& run) {
  TableRow row;
  row[0] = c.methods[run.method].name;
  row[1] = parameter_of(c, run);
  if (!run.refusal.empty()) {
    row[9] = "refused";
    return row;
  }
  add_turns(run.numbers, row);
  row[5] = fmt::format("{:.2f} ({:.2f})", run.to_drawn / c.edge, run.to_drawn_mean / c.edge);
  row[6] = fmt::format("{:.2f} ({:.2f})", run.from_drawn / c.edge, run.from_drawn_mean / c.edge);
  row[7] = fmt::format("{:.4f}", run.numbers.length / c.drawn.length);
  row[8] = fmt::format("{:.0f}", run.first_ms);
  if (run.again_ms) row[8] += fmt::format(", {:.0f}", *run.again_ms);
  row[9] = run.changed.empty() ? "kept" : run.changed;
  return row;
}

ordered_json json_of(const CurveNumbers& n) {
  return {{"curves", n.curves},
          {"points", n.points},
          {"length", n.length},
          {"curvature", n.curvature},
          {"curvature_max", n.largest_turn},
          {"bending", n.bending},
          {"window_turning", n.window_turning},
          {"contacts", n.contacts}};
}

ordered_json json_of(const Comparison& c, const ComparedRun& run) {
  const Method& method = c.methods[run.method];
  ordered_json json = {{"method", method.name}, {"plugin", method.plugin}};
  if (run.value) json["parameter"] = {{"id", method.swept}, {"value", *run.value}};
  if (!run.refusal.empty()) {
    json["refused"] = run.refusal;
    return json;
  }
  json.update(json_of(run.numbers));
  json["deviation_to_drawn_max"] = run.to_drawn;
  json["deviation_to_drawn_mean"] = run.to_drawn_mean;
  json["deviation_from_drawn_max"] = run.from_drawn;
  json["deviation_from_drawn_mean"] = run.from_drawn_mean;
  json["first_ms"] = run.first_ms;
  if (run.again_ms) json["again_ms"] = *run.again_ms;
  json["kind_kept"] = run.changed.empty();
  if (!run.changed.empty()) json["kind_changed"] = run.changed;
  return json;
}

bool swept(const Comparison& c) {
  return std::any_of(c.runs.begin(), c.runs.end(),
                     [](const ComparedRun& run) { return run.value.has_value(); });
}

constexpr std::array<double, 6> kBounds = {0.5, 1, 2, 4, 8, 16};  // mean edges

/// The least curvature among a method's runs that deviate by at most this many edges and kept the
/// topology.
std::string least_within(const Comparison& c, const Method& method, double edges) {
  double least = HUGE_VAL;
  for (const ComparedRun& run : c.runs) {
    if (!run.ok() || !same_method(c.methods[run.method], method)) continue;
    if (run.deviation() <= edges * c.edge) least = std::min(least, run.numbers.curvature);
  }
  return std::isfinite(least) ? fmt::format("{:.2f}", least) : "";
}

/// The result of the sweep: how smooth each method gets within bounds on the deviation.
std::string within_table(const Comparison& c) {
  std::string head = fmt::format("| {:<13} ", "rad, within"), line = "|" + std::string(15, '-');
  for (const double edges : kBounds) {
    head += fmt::format("| {:>4g} edges ", edges);
    line += "|" + std::string(11, '-') + ":";
  }
  std::string text = "\n" + head + "|\n" + line + "|\n";
  for (std::size_t m = 0; m < c.methods.size(); ++m) {
    const auto begin = c.methods.begin();
    if (std::any_of(begin, begin + static_cast<std::ptrdiff_t>(m),
                    [&](const Method& other) { return same_method(other, c.methods[m]); })) {
      continue;
    }
    text += fmt::format("| {:<13} ", c.methods[m].name);
    for (const double edges : kBounds) {
      text += fmt::format("| {:>10} ", least_within(c, c.methods[m], edges));
    }
    text += "|\n";
  }
  return text + "\n";
}

std::string beaten_text(const Comparison& c) {
  const std::vector<std::size_t> beaten = beaten_by(c);
  const std::size_t judged = judged_runs(c);
  std::string text = fmt::format(
      "{} is as smooth or smoother, at no larger deviation, in {} of {} runs of other "
      "methods.\n",
      c.methods.front().name, judged - beaten.size(), judged);
  for (const std::size_t k : beaten) {
    const ComparedRun& run = c.runs[k];
    text +=
        fmt::format("  beaten by {}, {}: {:.3f} rad at {:.2f} edges\n", c.methods[run.method].name,
                    parameter_of(c, run), run.numbers.curvature, run.deviation() / c.edge);
  }
  return text;
}

}  // namespace

std::string comparison_table(const Comparison& c) {
  std::vector<TableRow> rows{kHead, drawing_row(c)};
  for (const ComparedRun& run : c.runs) rows.push_back(row_of(c, run));
  std::array<std::size_t, kMeasures> width{};
  for (const TableRow& row : rows) {
    for (std::size_t k = 0; k < kMeasures; ++k) width[k] = std::max(width[k], row[k].size());
  }
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t k = 0; k < kMeasures; ++k) {
      text += fmt::format("| {:<{}} ", rows[r][k], width[k]);
    }
    text += "|\n";
    if (r > 0) continue;
    for (const std::size_t w : width) text += fmt::format("|{:-<{}}", "", w + 2);
    text += "|\n";
  }
  return text;
}

std::string comparison_remarks(const Comparison& c) {
  std::string text = fmt::format(
      "Deviations are the largest (and mean) along the surface; a mean edge near the drawing is "
      "{:.4g}.\n",
      c.edge);
  for (std::size_t k = 0; k < c.runs.size(); ++k) {
    const ComparedRun& run = c.runs[k];
    const bool said =
        k > 0 && c.runs[k - 1].method == run.method && c.runs[k - 1].refusal == run.refusal;
    if (run.refusal.empty() || said) continue;
    text += fmt::format("{}: {}\n", c.methods[run.method].name, run.refusal);
  }
  return swept(c) ? text + within_table(c) + beaten_text(c) : text;
}

std::string comparison_json(const Comparison& c) {
  ordered_json json = {{"format", "talweg-comparison"},
                       {"version", 1},
                       {"mesh", c.mesh},
                       {"curve", c.curve},
                       {"faces", c.faces},
                       {"edge_length_near", c.edge},
                       {"drawing", json_of(c.drawn)},
                       {"runs", ordered_json::array()}};
  for (const ComparedRun& run : c.runs) json["runs"].push_back(json_of(c, run));
  if (swept(c)) json["beaten_by"] = beaten_by(c);
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string comparison_csv(const Comparison& c) {
  std::string text =
      "method,plugin,parameter,value,curvature,curvature_before,bending,bending_before,"
      "window_turning,window_turning_before,deviation_to_drawn_max,"
      "deviation_to_drawn_mean,deviation_from_drawn_max,deviation_from_drawn_mean,edge_length_near,"
      "length,length_before,contacts,first_ms,again_ms,kind\n";
  for (const ComparedRun& run : c.runs) {
    const Method& m = c.methods[run.method];
    text += fmt::format("{},{},{},{}", m.name, m.plugin, run.value ? m.swept : "",
                        run.value ? fmt::format("{}", *run.value) : "");
    if (!run.refusal.empty()) {
      text += ",,,,,,,,,,,,,,,,,refused\n";
      continue;
    }
    text += fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.3f},{},{}\n",
                        run.numbers.curvature, c.drawn.curvature, run.numbers.bending,
                        c.drawn.bending, run.numbers.window_turning, c.drawn.window_turning,
                        run.to_drawn, run.to_drawn_mean, run.from_drawn, run.from_drawn_mean,
                        c.edge, run.numbers.length, c.drawn.length, run.numbers.contacts,
                        run.first_ms, run.again_ms ? fmt::format("{:.3f}", *run.again_ms) : "",
                        run.changed.empty() ? "kept" : run.changed);
  }
  return text;
}

}  // namespace talweg::driver
