#include "measure_text.hpp"

#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "talweg/core/version.hpp"

namespace talweg::driver {
namespace {

using nlohmann::ordered_json;

std::string place(const Point& p) { return fmt::format("{:.6g} {:.6g} {:.6g}", p[0], p[1], p[2]); }

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

std::string row(const std::string& name, const MeasuredCurve& c) {
  const CurveMeasures& m = c.measures;
  std::string contacts = std::to_string(c.contacts.size());
  if (c.stretches > 0) contacts += fmt::format(" ({} stretches)", c.stretches);
  return fmt::format(
      "{:<8}{:>8}{:>8}{:>14.6g}{:>12.6g}{:>12.6g}{:>10.4g}{:>10.4g}{:>10.4g}{:>10.4g}  "
      "{:<16}{}\n",
      name, c.points, c.closed ? "yes" : "no", m.length, m.total_curvature, m.signed_curvature,
      m.bending, degrees(m.window_turning), degrees(m.window_turning_2), degrees(m.max_curvature),
      contacts, m.max_curvature > 0 ? place(c.max_at) : "");
}

std::string block(const MeasuredFile& file) {
  std::string text = fmt::format(
      "{}\n{:<8}{:>8}{:>8}{:>14}{:>12}{:>12}{:>10}{:>10}{:>10}{:>10}  "
      "{:<16}{}\n",
      file.name, "curve", "points", "closed", "length", "curvature", "signed", "bending", "in 1 h",
      "in 2 h", "max turn", "self-contacts", "max turn at");
  for (std::size_t i = 0; i < file.curves.size(); ++i) {
    text += row(std::to_string(i), file.curves[i]);
  }
  if (file.curves.size() > 1) text += row("all", file.total);
  return text;
}

std::string deviation_lines(const std::string& name, const MeasuredDeviation& d) {
  return fmt::format(
      "{:<8}{:<16}{:>14.6g}{:>14.6g}\n{:<8}{:<16}{:>14.6g}{:>14.6g}\n"
      "{:<8}{:<16}  {}\n",
      name, "to the other", d.to_max, d.to_mean, "", "from the other", d.from_max, d.from_mean, "",
      "largest at", place(d.at));
}

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}
ordered_json numbers(const Point& p) { return {number(p[0]), number(p[1]), number(p[2])}; }

ordered_json object_of(const MeasuredCurve& c) {
  ordered_json contacts = ordered_json::array();
  for (const Point& p : c.contacts) contacts.push_back(numbers(p));
  return {{"points", c.points},
          {"closed", c.closed},
          {"length", number(c.measures.length)},
          {"curvature", number(c.measures.total_curvature)},
          {"curvature_signed", number(c.measures.signed_curvature)},
          {"curvature_max", number(c.measures.max_curvature)},
          {"curvature_max_at", numbers(c.max_at)},
          {"bending", number(c.measures.bending)},
          {"window_turning", number(c.measures.window_turning)},
          {"window_turning_2", number(c.measures.window_turning_2)},
          {"edge_length_near", number(c.edge)},
          {"self_contacts", c.contacts.size()},
          {"self_contact_stretches", c.stretches},
          {"self_contacts_at", contacts}};
}

ordered_json object_of(const MeasuredDeviation& d) {
  return {{"deviation_to_other_max", number(d.to_max)},
          {"deviation_to_other_mean", number(d.to_mean)},
          {"deviation_from_other_max", number(d.from_max)},
          {"deviation_from_other_mean", number(d.from_mean)},
          {"deviation_at", numbers(d.at)}};
}

ordered_json object_of(const MeasuredFile& file) {
  ordered_json json = object_of(file.total);
  if (file.curves.size() > 1) {
    for (const MeasuredCurve& c : file.curves) json["curves"].push_back(object_of(c));
  }
  return json;
}

}  // namespace

std::string measure_table(const Measurement& m) {
  std::string text = block(m.file);
  if (m.other) {
    text += '\n';
    text += block(*m.other);
    text += fmt::format("\n{:<24}{:>14}{:>14}\n", "deviation", "max", "mean");
    if (m.deviations.size() > 1) {
      for (std::size_t i = 0; i < m.deviations.size(); ++i) {
        text += deviation_lines(std::to_string(i), m.deviations[i]);
      }
    }
    text += deviation_lines("all", m.deviation);
  }
  text +=
      "Lengths in mesh units, curvatures in radians, turns (in windows of one and two mean edges "
      "near the curve, and at one point) in degrees.\n";
  for (const std::string& warning : m.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

std::string measure_json(const Measurement& m) {
  ordered_json json{{"version", version()}, {"faces", m.faces}, {"vertices", m.vertices}};
  ordered_json curves = object_of(m.file);
  if (m.other) {
    curves.update(object_of(m.deviation));
    for (std::size_t i = 0; i < m.deviations.size() && m.deviations.size() > 1; ++i) {
      curves["curves"][i].update(object_of(m.deviations[i]));
    }
    curves["other"] = object_of(*m.other);
  }
  json.update(curves);
  json["warnings"] = m.warnings;
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace talweg::driver
