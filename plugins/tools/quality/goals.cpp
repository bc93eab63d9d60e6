#include "tools/quality/goals.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "tools/quality/statistics.hpp"
#include "tools/quality/tables.hpp"

namespace talweg::quality {
namespace {

constexpr double kMedianRatio = 0.06, kWorstRatio = 0.25;
constexpr double kClose = 1.5, kFar = 3, kNotFar = 0.95;  // h₀, h₀, part of the runs
constexpr double kRises = 0.02, kMoves = 0.05;            // parts of the steps
constexpr double kApart = 0.5, kRougher = 1.1;            // h₀, times

double percent(double part) { return 100 * part; }

Goal at_most(std::string what, std::string asked, std::string reached, double value, double bound) {
  return {std::move(what), std::move(asked), std::move(reached), value <= bound};
}

void of_ratios(const char* which, const std::vector<double>& ratios, std::vector<Goal>& goals) {
  if (ratios.empty()) return;
  const double median = quantile(ratios, 0.5), worst = quantile(ratios, 1);
  goals.push_back(at_most(fmt::format("curvature after / before, median, {}", which),
                          fmt::format("≤ {}", kMedianRatio), fmt::format("{:.3f}", median), median,
                          kMedianRatio));
  const auto above =
      std::count_if(ratios.begin(), ratios.end(), [](double ratio) { return ratio > kWorstRatio; });
  goals.push_back(at_most(
      fmt::format("curvature after / before, worst, {}", which), fmt::format("≤ {}", kWorstRatio),
      fmt::format("{:.3f}; above in {} of {} runs", worst, above, ratios.size()), worst,
      kWorstRatio));
}

void of_runs(std::span<const Run> runs, std::vector<Goal>& goals) {
  if (runs.empty()) return;
  std::vector<double> ratios, every_ratio, to, both;
  std::size_t collapsed = 0;
  for (const Run& run : runs) {
    every_ratio.push_back(run.ratio());
    if (jagged(run)) ratios.push_back(run.ratio());
    if (run.termination == Outcome::kCollapsed) ++collapsed;
    if (run.tau < 2) continue;
    to.push_back(run.to_drawn);
    both.push_back(std::max(run.to_drawn, run.from_drawn));
  }
  of_ratios("drawings of 25 rad and more", ratios, goals);
  of_ratios("all drawings", every_ratio, goals);
  if (!to.empty()) {
    const double median = quantile(to, 0.5), near = share_within(both, kFar);
    goals.push_back(at_most("τ ≥ 2: result to drawing, median", fmt::format("≤ {} h₀", kClose),
                            fmt::format("{:.2f} h₀", median), median, kClose));
    goals.push_back({fmt::format("τ ≥ 2: both directions within {} h₀", kFar),
                     fmt::format("≥ {:.0f} % of the runs", percent(kNotFar)),
                     fmt::format("{:.1f} %", percent(near)), near >= kNotFar});
  }
  goals.push_back({"loops that collapse", "none", fmt::format("{}", collapsed), collapsed == 0});
}

void of_sweeps(std::span<const Sweep> sweeps, std::vector<Goal>& goals) {
  std::size_t steps = 0, rises = 0, moves = 0;
  for (const Sweep& s : sweeps) {
    steps += s.steps;
    rises += s.rises;
    moves += s.moves;
  }
  if (steps == 0) return;
  const auto add = [&](const char* what, std::size_t part, double bound) {
    const double share = static_cast<double>(part) / static_cast<double>(steps);
    goals.push_back(at_most(what, fmt::format("≤ {:.0f} % of the steps", percent(bound)),
                            fmt::format("{:.1f} %", percent(share)), share, bound));
  };
  add("τ swept: deviation rises by > 0.1 h₀", rises, kRises);
  add("τ swept: curve moves by > 0.2 h₀", moves, kMoves);
}

void of_subdivisions(std::span<const Subdivision> subdivisions, std::vector<Goal>& goals) {
  if (subdivisions.empty()) return;
  std::vector<double> apart, rougher;
  for (const Subdivision& s : subdivisions) {
    apart.push_back(std::max(s.apart[1], s.apart[2]));
    rougher.push_back(std::max(s.curvature[1], s.curvature[2]) / s.curvature[0]);
  }
  const auto add = [&](const char* what, const std::string& asked, const char* unit,
                       const std::vector<double>& values, double bound) {
    const double worst = quantile(values, 1);
    goals.push_back(at_most(
        what, asked,
        fmt::format("median {:.2f}, worst {:.2f}{}; within in {:.0f} %", quantile(values, 0.5),
                    worst, unit, percent(share_within(values, bound))),
        worst, bound));
  };
  add("finer mesh: result apart from the coarse mesh's", fmt::format("≤ {} h₀", kApart), " h₀",
      apart, kApart);
  add("finer mesh: curvature over the coarse mesh's", fmt::format("≤ {}", kRougher), "", rougher,
      kRougher);
}

}  // namespace

std::vector<Goal> goals(std::span<const Run> runs, std::span<const Sweep> sweeps,
                        std::span<const Subdivision> subdivisions) {
  std::vector<Goal> result;
  of_runs(runs, result);
  of_sweeps(sweeps, result);
  of_subdivisions(subdivisions, result);
  return result;
}

std::string tables(std::span<const Goal> goals) {
  std::string text = "| goal | asked | reached | met |\n|---|---|---|---|\n";
  for (const Goal& g : goals) {
    text += fmt::format("| {} | {} | {} | {} |\n", g.what, g.asked, g.reached,
                        g.met ? "yes" : "**no**");
  }
  return text;
}

}  // namespace talweg::quality
