#include "quality/tables.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

#include <fmt/format.h>

namespace talweg::quality {
namespace {

constexpr double kJagged = 25;  // rad; drawings that turn less are smooth already

/// Linear between the ranks.
double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(at);
  const double f = at - static_cast<double>(i);
  return i + 1 < values.size() ? values[i] * (1 - f) + values[i + 1] * f : values[i];
}

double share(std::span<const double> values, double bound) {
  if (values.empty()) return 1;
  const auto good =
      std::count_if(values.begin(), values.end(), [bound](double value) { return value <= bound; });
  return static_cast<double>(good) / static_cast<double>(values.size());
}

std::string row(const std::string& name, std::span<const Run> runs) {
  std::vector<double> ratios, to, from, both, shrunk, solve, smooth;
  std::size_t collapsed = 0;
  for (const Run& run : runs) {
    if (run.curvature_before >= kJagged) ratios.push_back(run.ratio());
    to.push_back(run.to_drawn);
    from.push_back(run.from_drawn);
    both.push_back(std::max(run.to_drawn, run.from_drawn));
    if (run.closed) shrunk.push_back(run.length_ratio);
    if (run.termination == "collapsed") ++collapsed;
    solve.push_back(run.solve_ms);
    smooth.push_back(run.smooth_ms);
  }
  return fmt::format(
      "| {} | {} | {:.3f} | {:.3f} | {:.2f} | {:.2f} | {:.0f} % | {:.2f} | {} | {:.1f} | {:.1f} "
      "|\n",
      name, runs.size(), quantile(ratios, 0.5), quantile(ratios, 1), quantile(to, 0.5),
      quantile(from, 0.5), 100 * share(both, 3), quantile(shrunk, 0), collapsed,
      quantile(solve, 0.5), quantile(smooth, 0.5));
}

}  // namespace

std::string csv(std::span<const Run> runs) {
  std::string text =
      "mesh,drawing,closed,edge,tau,curvature_before,curvature_after,least_curvature,ratio,to_"
      "drawn,"
      "from_drawn,slack,length_ratio,solve_ms,smooth_ms,termination,warned\n";
  for (const Run& r : runs) {
    text += fmt::format(
        "{},{},{},{:.6g},{},{:.3f},{:.3f},{:.3f},{:.4f},{:.3f},{:.3f},{:.3f},"
        "{:.4f},{:.2f},{:.2f},{},{}\n",
        r.mesh, r.drawing, int{r.closed}, r.edge, r.tau, r.curvature_before, r.curvature_after,
        r.least_curvature, r.ratio(), r.to_drawn, r.from_drawn, r.slack, r.length_ratio, r.solve_ms,
        r.smooth_ms, r.termination, int{r.warned});
  }
  return text;
}

std::string tables(std::span<const Run> runs) {
  std::string text =
      "| | runs | curvature after / before, median | worst | result to drawing, median [h₀] | "
      "drawing to result, median [h₀] | both within 3 h₀ | shortest loop after / before | "
      "collapsed "
      "| distance, median [ms] | new τ, median [ms] |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  const auto add = [&](const std::string& name, const std::function<bool(const Run&)>& pick) {
    std::vector<Run> picked;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(picked), pick);
    if (!picked.empty()) text += row(name, picked);
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
      "| mesh | drawing | curvature on the mesh [rad] | divided once | twice | apart, once [h₀] | "
      "twice [h₀] |\n|---|---|--:|--:|--:|--:|--:|\n";
  for (const Subdivision& s : subdivisions) {
    text +=
        fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", s.mesh, s.drawing,
                    s.curvature[0], s.curvature[1], s.curvature[2], s.apart[1], s.apart[2]);
  }
  return text;
}

}  // namespace talweg::quality
