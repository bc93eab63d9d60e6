#include "measure_text.hpp"

#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "talweg/core/space/message_numbers.hpp"

namespace talweg::driver {
namespace {

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

std::string row(const std::string& name, const MeasuredCurve& c) {
  const CurveMeasures& m = c.measures;
  std::string contacts = std::to_string(c.contacts.size());
  if (c.stretches > 0) contacts += fmt::format(" ({} stretches)", c.stretches);
  return fmt::format(
      "{:<8}{:>8}{:>8}{:>14.6g}{:>13.6g}{:>13.6g}{:>10.4g}{:>10.4g}{:>10.4g}{:>10.4g}{:>12}  "
      "{:<16}{}\n",
      name, c.points, c.closed ? "yes" : "no", m.length, m.total_curvature, m.signed_curvature,
      m.bending, degrees(m.window_turning), degrees(m.window_turning_2), degrees(m.max_curvature),
      std::isfinite(m.tortuosity) ? fmt::format("{:.6g}", m.tortuosity) : "-", contacts,
      m.max_curvature > 0 ? position_text(c.max_at, c.edge) : "");
}

std::string block(const std::string& file, const MeasuredCurves& curves) {
  std::string text = fmt::format(
      "{}\n{:<8}{:>8}{:>8}{:>14}{:>13}{:>13}{:>10}{:>10}{:>10}{:>10}{:>12}  "
      "{:<16}{}\n",
      file, "curve", "points", "closed", "length", "curvature", "signed", "bending", "in 1 h",
      "in 2 h", "max turn", "tortuosity", "self-contacts", "max turn at");
  for (std::size_t i = 0; i < curves.each.size(); ++i) {
    text += row(std::to_string(i), curves.each[i]);
  }
  if (curves.each.size() > 1) text += row("all", curves.total);
  return text;
}

std::string deviation_lines(const std::string& name, const MeasuredDistance& d, double edge) {
  return fmt::format(
      "{:<8}{:<16}{:>14.6g}{:>14.6g}\n{:<8}{:<16}{:>14.6g}{:>14.6g}\n"
      "{:<8}{:<16}  {}\n",
      name, "to the other", d.to_max, d.to_mean, "", "from the other", d.from_max, d.from_mean, "",
      "largest at", position_text(d.at, edge));
}

}  // namespace

std::string measure_table(const CurveMeasurement& m, const std::string& name,
                          const std::string& other) {
  std::string text = block(name, m.curves);
  if (m.others) {
    text += '\n';
    text += block(other, *m.others);
    text += fmt::format("\n{:<24}{:>14}{:>14}\n", "deviation", "max", "mean");
    if (m.deviations.size() > 1) {
      for (std::size_t i = 0; i < m.deviations.size(); ++i) {
        text += deviation_lines(std::to_string(i), m.deviations[i], m.curves.each[i].edge);
      }
    }
    text += deviation_lines("all", m.deviation, m.curves.total.edge);
  }
  text +=
      "Lengths in mesh units, curvatures in radians, turns in degrees (in windows of h and 2 h, "
      "where h is --edge or the mean edge near the curve, and at one point); tortuosity: length "
      "over the straight distance between the ends, - for loops.\n";
  for (const std::string& warning : m.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

}  // namespace talweg::driver
