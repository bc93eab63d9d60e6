#include "tools/quality/tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "tools/quality/statistics.hpp"

namespace talweg::quality {
namespace {

constexpr double kJagged = 25;  // rad; a drawing that turns less is already smooth

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

std::string row(const std::string& name, std::span<const Run> runs) {
  std::vector<double> bent, windows, turns, ratios, to, from, both, shrunk;
  std::size_t collapsed = 0;
  for (const Run& run : runs) {
    if (jagged(run)) {
      bent.push_back(run.bending_after / run.bending_before);
      ratios.push_back(run.ratio());
    }
    windows.push_back(degrees(run.window_turning));
    turns.push_back(degrees(run.largest_turn));
    to.push_back(run.to_drawn);
    from.push_back(run.from_drawn);
    both.push_back(std::max(run.to_drawn, run.from_drawn));
    if (run.closed) shrunk.push_back(run.length_ratio);
    if (run.termination == Outcome::kCollapsed) ++collapsed;
  }
  return fmt::format(
      "| {} | {} | {} | {:.0f} | {:.0f} | {:.0f} | {} | {:.2f} | {:.2f} | {:.0f} % | {} | {} |\n",
      name, runs.size(),
      bent.empty() ? " | " : fmt::format("{:.3f} | {:.3f}", quantile(bent, 0.5), quantile(bent, 1)),
      quantile(windows, 0.5), quantile(windows, 1), quantile(turns, 1),
      ratios.empty() ? " | "
                     : fmt::format("{:.3f} | {:.3f}", quantile(ratios, 0.5), quantile(ratios, 1)),
      quantile(to, 0.5), quantile(from, 0.5), 100 * share_within(both, 3),
      shrunk.empty() ? "" : fmt::format("{:.2f}", quantile(shrunk, 0)), collapsed);
}

constexpr const char* kHead =
    "| | runs | bending after / before, median | worst | turn in one h₀, median [°] | worst | "
    "largest turn [°] | curvature after / before, median | worst | result to drawing, median [h₀] "
    "| "
    "drawing to result, median [h₀] | both within 3 h₀ | shortest loop after / before | collapsed "
    "|\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";

std::vector<Run> picked(std::span<const Run> runs, const std::function<bool(const Run&)>& pick) {
  std::vector<Run> result;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(result), pick);
  return result;
}

// The time of a single τ says little, since later τ reuse results of the first.
std::string times(const std::string& name, std::span<const Run> runs) {
  std::vector<double> solve, smooth;
  double last = HUGE_VAL;
  for (const Run& run : runs) {
    if (run.tau <= last) {  // another drawing
      solve.push_back(run.solve_ms);
      smooth.push_back(0);
    }
    smooth.back() += run.smooth_ms;
    last = run.tau;
  }
  return fmt::format("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", name, solve.size(),
                     quantile(solve, 0.5), quantile(solve, 1), quantile(smooth, 0.5),
                     quantile(smooth, 1));
}

}  // namespace

bool jagged(const Run& run) { return run.curvature_before >= kJagged; }

std::string csv(std::span<const Run> runs) {
  std::string text =
      "mesh,drawing,closed,edge,tau,bending_before,bending_after,window_turning,largest_turn,"
      "curvature_before,curvature_after,least_curvature,ratio,to_"
      "drawn,"
      "from_drawn,slack,length_ratio,solve_ms,smooth_ms,termination,warned,touches,left_taut\n";
  for (const Run& r : runs) {
    text += fmt::format(
        "{},{},{},{:.6g},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.3f},{:.3f},{:.3f},{:.4f},{:.3f},{:.3f},{"
        ":.3f},"
        "{:.4f},{:.2f},{:.2f},{},{},{},{}\n",
        r.mesh, r.drawing, int{r.closed}, r.edge, r.tau, r.bending_before, r.bending_after,
        r.window_turning, r.largest_turn, r.curvature_before, r.curvature_after, r.least_curvature,
        r.ratio(), r.to_drawn, r.from_drawn, r.slack, r.length_ratio, r.solve_ms, r.smooth_ms,
        to_string(r.termination), int{r.warned}, int{r.touches}, int{r.left_taut});
  }
  return text;
}

std::string tables(std::span<const Run> runs) {
  std::string text = kHead;
  const auto add = [&](const std::string& name, const std::function<bool(const Run&)>& pick) {
    const std::vector<Run> some = picked(runs, pick);
    if (!some.empty()) text += row(name, some);
  };
  add("all", [](const Run&) { return true; });
  for (const double tau : {0.5, 1.0, 2.0, 4.0}) {
    add(fmt::format("τ = {}", tau), [tau](const Run& run) { return run.tau == tau; });
  }
  add("open", [](const Run& run) { return !run.closed; });
  add("closed", [](const Run& run) { return run.closed; });
  std::vector<std::string> meshes;
  for (const Run& run : runs) {
    if (meshes.empty() || meshes.back() != run.mesh) meshes.push_back(run.mesh);
  }
  for (const std::string& mesh : meshes) {
    add(mesh, [&](const Run& run) { return run.mesh == mesh; });
  }
  return text;
}

std::string side_by_side(std::span<const Run> defaults, std::span<const Run> paper,
                         std::span<const Run> relaxed) {
  const auto with_paper = picked(defaults, [&](const Run& run) {
    return std::any_of(paper.begin(), paper.end(),
                       [&](const Run& other) { return other.mesh == run.mesh; });
  });
  std::string text = kHead;
  const auto add = [&](const std::string& which, const std::function<bool(const Run&)>& pick) {
    const std::vector<Run> ours = picked(with_paper, pick), theirs = picked(paper, pick),
                           smoother = picked(relaxed, pick);
    if (ours.empty() || theirs.empty()) return;
    text += row(fmt::format("default, {}", which), ours);
    text += row(fmt::format("paper, {}", which), theirs);
    text += row(fmt::format("paper, relaxed, {}", which), smoother);
  };
  add("all", [](const Run&) { return true; });
  for (const double tau : {0.5, 1.0, 2.0, 4.0}) {
    add(fmt::format("τ = {}", tau), [tau](const Run& run) { return run.tau == tau; });
  }
  text +=
      "\n| | drawings | distance, median [ms] | largest | all τ together, median [ms] | largest "
      "|\n|---|--:|--:|--:|--:|--:|\n";
  text += times("default", with_paper);
  text += times("paper", paper);
  text += times("paper, relaxed", relaxed);
  return text;
}

std::string tables(std::span<const Sweep> sweeps) {
  std::string text =
      "| mesh | drawing | steps | deviation rises by > 0.1 h₀ | curve moves by > 0.2 h₀ | largest "
      "move [h₀] |\n|---|---|--:|--:|--:|--:|\n";
  std::size_t steps = 0, rises = 0, moves = 0;
  const auto percent = [](std::size_t part, std::size_t all) {
    return 100 * static_cast<double>(part) / static_cast<double>(all);
  };
  double largest = 0;
  for (const Sweep& s : sweeps) {
    text +=
        fmt::format("| {} | {} | {} | {:.1f} % | {:.1f} % | {:.2f} |\n", s.mesh, s.drawing, s.steps,
                    percent(s.rises, s.steps), percent(s.moves, s.steps), s.largest_move);
    steps += s.steps;
    rises += s.rises;
    moves += s.moves;
    largest = std::max(largest, s.largest_move);
  }
  text += fmt::format("| all | | {} | {:.1f} % | {:.1f} % | {:.2f} |\n", steps,
                      percent(rises, steps), percent(moves, steps), largest);
  return text;
}

std::string tables(std::span<const Subdivision> subdivisions) {
  std::string text =
      "| mesh | drawing | bending on the mesh | divided once | twice | curvature on the mesh [rad] "
      "| divided once | twice | distance, once [h₀] | twice [h₀] |\n"
      "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Subdivision& s : subdivisions) {
    text += fmt::format(
        "| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | "
        "{:.2f} |\n",
        s.mesh, s.drawing, s.bending[0], s.bending[1], s.bending[2], s.curvature[0], s.curvature[1],
        s.curvature[2], s.apart[1], s.apart[2]);
  }
  return text;
}

}  // namespace talweg::quality
