#include "tools/quality/goals.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "tools/quality/statistics.hpp"
#include "tools/quality/tables.hpp"

namespace talweg::quality {
namespace {

constexpr double kMedianBent = 0.008, kWorstBent = 0.03;               // after / before
constexpr double kMedianWindow = 18, kWorstWindow = 30, kLargest = 5;  // degrees
constexpr double kMedianRatio = 0.058, kWorstRatio = 0.25;
constexpr double kClose = 1, kFar = 3, kNotFar = 0.97;              // h₀, h₀, part of the runs
constexpr double kRises = 0.02, kMoves = 0.01, kMovesOfOne = 0.03;  // parts of the steps
constexpr double kMedianApart = 0.1, kWorstApart = 0.3;             // h₀
constexpr double kMissed = 1e-6, kInserted = 0.1;                   // h₀
constexpr double kClickedBent = 0.15, kSwing = 0.25, kLonger = 1.08;
constexpr double kMedianHandsApart = 0.25, kWorstHandsApart = 0.5;  // h₀
constexpr double kMedianHandsOther = 1.5, kWorstHandsOther = 3, kHandsBent = 0.3;
constexpr double kOther = 1.1;  // larger / smaller bending

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

/// A goal for the median and one for the worst of these values.
void of_values(const char* what, const char* unit, const std::vector<double>& values,
               double median_bound, double worst_bound, std::vector<Goal>& goals) {
  if (values.empty()) return;
  const double median = quantile(values, 0.5), worst = quantile(values, 1);
  goals.push_back(at_most(fmt::format("{}, median", what),
                          fmt::format("≤ {}{}", median_bound, unit),
                          fmt::format("{:.3g}{}", median, unit), median, median_bound));
  goals.push_back(at_most(fmt::format("{}, worst", what), fmt::format("≤ {}{}", worst_bound, unit),
                          fmt::format("{:.3g}{}; within in {:.0f} %", worst, unit,
                                      percent(share_within(values, worst_bound))),
                          worst, worst_bound));
}

/// The distribution of turning at τ = 1.
void of_spread(std::span<const Run> runs, std::vector<Goal>& goals) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::vector<double> bent, windows, turns;
  for (const Run& run : runs) {
    if (run.tau != 1) continue;
    if (jagged(run)) bent.push_back(run.bending_after / run.bending_before);
    windows.push_back(kDegrees * run.window_turning);
    turns.push_back(kDegrees * run.largest_turn);
  }
  of_values("τ = 1: bending after / before, drawings of 25 rad and more", "", bent, kMedianBent,
            kWorstBent, goals);
  of_values("τ = 1: turn in one h₀", "°", windows, kMedianWindow, kWorstWindow, goals);
  of_values("τ = 1: largest turn at one point", "°", turns, kLargest, kLargest, goals);
}

void of_runs(std::span<const Run> runs, std::vector<Goal>& goals) {
  if (runs.empty()) return;
  std::vector<double> ratios, every_ratio, to, both;
  std::size_t collapsed = 0;
  for (const Run& run : runs) {
    every_ratio.push_back(run.ratio());
    if (jagged(run)) ratios.push_back(run.ratio());
    if (run.termination == Outcome::kCollapsed) ++collapsed;
    if (run.tau != 1) continue;
    to.push_back(run.to_drawn);
    both.push_back(std::max(run.to_drawn, run.from_drawn));
  }
  of_ratios("drawings of 25 rad and more", ratios, goals);
  of_ratios("all drawings", every_ratio, goals);
  if (!to.empty()) {
    const double median = quantile(to, 0.5), near = share_within(both, kFar);
    goals.push_back(at_most("τ = 1: result to drawing, median", fmt::format("≤ {} h₀", kClose),
                            fmt::format("{:.2f} h₀", median), median, kClose));
    goals.push_back({fmt::format("τ = 1: both directions within {} h₀", kFar),
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
  double worst = 0;
  for (const Sweep& s : sweeps) {
    if (s.steps == 0) continue;
    worst = std::max(worst, static_cast<double>(s.moves) / static_cast<double>(s.steps));
  }
  goals.push_back(at_most("τ swept: curve moves by > 0.2 h₀, worst drawing",
                          fmt::format("≤ {:.0f} %", percent(kMovesOfOne)),
                          fmt::format("{:.1f} %", percent(worst)), worst, kMovesOfOne));
}

void of_subdivisions(std::span<const Subdivision> subdivisions, std::vector<Goal>& goals) {
  std::vector<double> apart, other;
  for (const Subdivision& s : subdivisions) {
    apart.push_back(std::max(s.apart[1], s.apart[2]));
    double most = 1;
    for (const std::size_t level : {1, 2}) {
      const double ratio = s.bending[level] / s.bending[0];
      most = std::max({most, ratio, 1 / ratio});
    }
    other.push_back(most);
  }
  of_values("finer mesh: distance from the result on the coarse mesh", " h₀", apart, kMedianApart,
            kWorstApart, goals);
  of_values("finer mesh: bending on both meshes, larger / smaller", "", other, kOther, kOther,
            goals);
}

void of_clicks(std::span<const ClickedRun> clicked, std::vector<Goal>& goals) {
  std::vector<double> missed, bent, swings, longer, moved, turns;
  for (const ClickedRun& run : clicked) {
    missed.push_back(run.missed);
    bent.push_back(run.bending);
    swings.push_back(run.swing);
    longer.push_back(run.longer);
    moved.push_back(run.inserted);
    turns.push_back(run.largest_turn * 180 / std::numbers::pi);
  }
  of_values("clicks: largest distance of a click from the result", " h₀", missed, kMissed, kMissed,
            goals);
  of_values("clicks: bending / bending of the taut curve", "", bent, kClickedBent, kClickedBent,
            goals);
  of_values("clicks: largest turn at one point", "°", turns, kLargest, kLargest, goals);
  of_values("clicks: largest distance from the legs / length of the shorter adjacent leg", "",
            swings, kSwing, kSwing, goals);
  of_values("clicks: length / length of the legs", "", longer, kLonger, kLonger, goals);
  of_values("clicks: movement by an inserted click", " h₀", moved, kInserted, kInserted, goals);
}

/// Results of one hand with different samplings.
void of_hands(std::span<const HandRun> hands, std::vector<Goal>& goals) {
  std::vector<double> apart, ratio, bending;
  for (const HandRun& run : hands) {
    apart.push_back(run.apart);
    ratio.push_back(run.ratio);
    bending.push_back(run.bending);
  }
  of_values("hands: distance from 10 per edge of the same hand", " h₀", apart, kMedianHandsApart,
            kWorstHandsApart, goals);
  of_values("hands: bending, larger / smaller, against 10 per edge of the same hand", "", ratio,
            kMedianHandsOther, kWorstHandsOther, goals);
  of_values("hands: bending", "", bending, kHandsBent, kHandsBent, goals);
}

}  // namespace

std::vector<Goal> goals(std::span<const Run> runs, std::span<const Sweep> sweeps,
                        std::span<const Subdivision> subdivisions,
                        std::span<const ClickedRun> clicked, std::span<const HandRun> hands) {
  std::vector<Goal> result;
  of_hands(hands, result);
  of_spread(runs, result);
  of_runs(runs, result);
  of_sweeps(sweeps, result);
  of_subdivisions(subdivisions, result);
  of_clicks(clicked, result);
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
