#include "report_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "talweg/core/space/message_numbers.hpp"

namespace talweg::driver {
namespace {

/// The decisive warnings, and the distance of the result from the drawing.
std::string head_of(const SmoothingReport& r) {
  std::string out;
  for (const Decisive& one : r.decisive) out += fmt::format("warning: {}\n", one.sentence);
  const Farthest far = farthest(r);
  if (far.of == FarthestOf::kNothing) return out;
  const char* what = far.of == FarthestOf::kPoint     ? "a point that it should pass"
                     : far.of == FarthestOf::kDrawing ? "the drawing from the result"
                                                      : "the result from the drawing";
  const std::string distance = far.at_most > far.at_least
                                   ? bounds_text(far.at_least, far.at_most) + " mesh units"
                                   : mesh_units_text(far.at_least, 6);
  return out + fmt::format("farthest apart: {}, {}, at {}\n", distance, what,
                           position_text(far.at, r.edge_length_near));
}

}  // namespace

std::string table_of(const SmoothingReport& r) {
  std::string out = head_of(r);
  const auto line = [&](const char* name, auto before, auto after, const char* unit) {
    fmt::format_to(std::back_inserter(out), "{:<22}{:>14}{:>14}  {}\n", name, before, after, unit);
  };
  const auto number = [](double value) { return fmt::format("{:.6g}", value); };
  const auto degrees = [](double angle) {
    return fmt::format("{:.4g}", angle * 180 / std::numbers::pi);
  };
  fmt::format_to(std::back_inserter(out), "{:<22}{:>14}{:>14}\n", "", "drawn", "smoothed");
  line("points", r.points_before, r.points_after, "");
  line("length", number(r.before.length), number(r.after.length), "mesh units");
  if (r.lifted_length_before > 0) {
    line("lifted length", number(r.lifted_length_before), number(r.lifted_length_after), "");
  }
  line("total curvature", number(r.before.total_curvature), number(r.after.total_curvature), "rad");
  line("bending", number(r.before.bending), number(r.after.bending), "");
  line("turn in one edge", degrees(r.before.window_turning), degrees(r.after.window_turning),
       "degrees");
  line("turn in two edges", degrees(r.before.window_turning_2), degrees(r.after.window_turning_2),
       "degrees");
  line("largest turn", degrees(r.before.max_curvature), degrees(r.after.max_curvature), "degrees");
  if (std::isfinite(r.before.tortuosity) && std::isfinite(r.after.tortuosity)) {
    line("tortuosity", number(r.before.tortuosity), number(r.after.tortuosity), "");
  }
  const bool through_space = r.deviation == DeviationMeasure::kEuclidean;
  fmt::format_to(std::back_inserter(out), "{:<22}{:>14}{:>14}{}\n",
                 r.deviation_exact ? "deviation" : "deviation at most", "max", "mean",
                 through_space ? "  through space" : "");
  line("  smoothed to drawn", number(r.deviation_to_drawn_max), number(r.deviation_to_drawn_mean),
       "mesh units");
  line("  drawn to smoothed", number(r.deviation_from_drawn_max),
       number(r.deviation_from_drawn_mean), "mesh units");
  fmt::format_to(
      std::back_inserter(out),
      "tau {:g}, slack {:.6g}, potential {}, engine {}: {} after {} iterations, {} flips, "
      "{} of {} faces touched\n",
      r.tau, r.slack, to_string(r.potential), to_string(r.engine), to_string(r.termination),
      r.iterations, r.flips, r.faces_touched, r.faces);
  const StageTimes& t = r.time_ms;
  fmt::format_to(std::back_inserter(out),
                 "ms: load {:.1f}, open {:.1f}, solve {:.1f}, straighten {:.2f}, trace {:.2f}, "
                 "relax {:.2f}, fair {:.2f}, measure {:.2f}; memory {:.0f} MiB\n",
                 t.load, t.open, t.solve, t.straighten, t.trace, t.relax, t.fair, t.measure,
                 r.peak_memory_mib);
  if (r.pins_added > 0) {
    fmt::format_to(std::back_inserter(out), "{} points of the drawing were pinned\n", r.pins_added);
  }
  for (const std::string& warning : r.warnings) {
    const auto says_so = [&](const Decisive& one) { return one.sentence == warning; };
    if (std::any_of(r.decisive.begin(), r.decisive.end(), says_so)) continue;
    fmt::format_to(std::back_inserter(out), "warning: {}\n", warning);
  }
  return out;
}

}  // namespace talweg::driver
