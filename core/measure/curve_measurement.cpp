#include "talweg/core/measure/curve_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "talweg/core/measure/edge_length_near.hpp"
#include "talweg/core/measure/named_measures.hpp"
#include "talweg/core/measure/self_contacts.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/core/version.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

void count_contacts(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                    MeasuredCurve& measured) {
  for (const SelfContact& contact : self_contacts(mesh.surface(), curves)) {
    measured.contacts.push_back(mesh.position(contact.at));
    if (contact.stretch) ++measured.stretches;
  }
}

MeasuredCurve measured_one(const SurfaceMesh& mesh, const SurfaceCurve& curve,
                           std::optional<double> edge) {
  MeasuredCurve measured;
  measured.points = curve.points.size();
  measured.closed = curve.closed;
  measured.edge = edge ? *edge : edge_length_near(mesh.surface(), curve);
  measured.measures = measure_curve(mesh, curve, measured.edge);
  measured.max_at = mesh.position(curve.points[measured.measures.max_at]);
  count_contacts(mesh, std::span(&curve, 1), measured);
  return measured;
}

void add_to(MeasuredCurve& total, const MeasuredCurve& c) {
  total.points += c.points;
  total.closed = total.closed && c.closed;
  total.edge += c.edge;
  if (c.measures.max_curvature > total.measures.max_curvature) total.max_at = c.max_at;
  add(total.measures, c.measures);
}

MeasuredCurves measured_all(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                            std::optional<double> edge) {
  MeasuredCurves all;
  for (const SurfaceCurve& curve : curves) all.each.push_back(measured_one(mesh, curve, edge));
  all.total = all.each.front();
  if (curves.size() == 1) return all;
  all.total.contacts.clear();
  all.total.stretches = 0;
  count_contacts(mesh, curves, all.total);
  for (const MeasuredCurve& c : std::span(all.each).subspan(1)) add_to(all.total, c);
  all.total.edge /= static_cast<double>(curves.size());
  return all;
}

/// Combines the deviations of pairs: maxima, and means weighted by length.
MeasuredDistance all_of(const CurveMeasurement& m) {
  MeasuredDistance all = m.deviations.front();
  double to = 0, from = 0;
  for (std::size_t i = 0; i < m.deviations.size(); ++i) {
    const MeasuredDistance& d = m.deviations[i];
    if (std::max(d.to_max, d.from_max) > std::max(all.to_max, all.from_max)) all.at = d.at;
    all.to_max = std::max(all.to_max, d.to_max);
    all.from_max = std::max(all.from_max, d.from_max);
    to += d.to_mean * m.curves.each[i].measures.length;
    from += d.from_mean * m.others->each[i].measures.length;
  }
  all.to_mean = to / m.curves.total.measures.length;
  all.from_mean = from / m.others->total.measures.length;
  return all;
}

void compare(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
             std::span<const SurfaceCurve> others, const Progress& progress, CurveMeasurement& m) {
  DeviationMeter meter(mesh);
  const auto between = [&](std::span<const SurfaceCurve> a, std::span<const SurfaceCurve> b) {
    const SurfaceDeviation d = meter.measure(a, b, progress);
    return MeasuredDistance{d.to_drawn.max, d.to_drawn.mean, d.from_drawn.max, d.from_drawn.mean,
                            mesh.position(d.larger().at)};
  };
  if (curves.size() == others.size()) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      m.deviations.push_back(between(curves.subspan(i, 1), others.subspan(i, 1)));
    }
    m.deviation = all_of(m);
  } else {
    m.deviation = between(curves, others);
    m.warnings.push_back(std::to_string(curves.size()) + " curves are compared with " +
                         std::to_string(others.size()) +
                         ": all together, because the numbers of curves differ.");
  }
  if (!std::isfinite(std::max(m.deviation.to_max, m.deviation.from_max))) {
    m.warnings.emplace_back(
        "Some curves lie on parts of the mesh that are not connected: their deviation is "
        "infinite.");
  }
}

std::vector<double> numbers(const Point& p) { return {p[0], p[1], p[2]}; }

std::vector<ReportEntry> entries_of(const MeasuredCurve& c) {
  std::vector<ReportEntry> entries = {{"points", std::uint64_t{c.points}}, {"closed", c.closed}};
  for (const NamedMeasure& measure : kNamedMeasures) {
    entries.push_back({measure.name, c.measures.*measure.value});
  }
  append(entries, "",
         {{"curvature_signed", c.measures.signed_curvature},
          {"curvature_max_at", numbers(c.max_at)},
          {"edge_length_near", c.edge},
          {"self_contacts", std::uint64_t{c.contacts.size()}},
          {"self_contact_stretches", std::uint64_t{c.stretches}}});
  if (c.contacts.empty()) entries.push_back({"self_contacts_at", std::vector<double>{}});
  for (std::size_t k = 0; k < c.contacts.size(); ++k) {
    entries.push_back({"self_contacts_at." + std::to_string(k), numbers(c.contacts[k])});
  }
  return entries;
}

std::vector<ReportEntry> entries_of(const MeasuredDistance& d) {
  return {{"deviation_to_other_max", d.to_max},
          {"deviation_to_other_mean", d.to_mean},
          {"deviation_from_other_max", d.from_max},
          {"deviation_from_other_mean", d.from_mean},
          {"deviation_at", numbers(d.at)}};
}

}  // namespace

void CurveMeasurementOptions::validate() const {
  if (edge && !(*edge > 0 && std::isfinite(*edge))) {
    throw Error(ErrorCode::kBadUsage, "edge must be finite and > 0.");
  }
}

CurveMeasurement measure_curves(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                                std::span<const SurfaceCurve> others,
                                const CurveMeasurementOptions& options, const Progress& progress) {
  options.validate();
  if (curves.empty()) throw Error(ErrorCode::kBadCurve, "There is no curve to measure.");
  CurveMeasurement m;
  m.faces = mesh.surface().face_count();
  m.vertices = mesh.surface().vertex_count();
  m.curves = measured_all(mesh, curves, options.edge);
  if (others.empty()) return m;
  m.others = measured_all(mesh, others, options.edge);
  compare(mesh, curves, others, progress, m);
  return m;
}

std::vector<ReportEntry> entries_of(const CurveMeasurement& m) {
  std::vector<ReportEntry> entries = {{"version", std::string(version())},
                                      {"faces", std::uint64_t{m.faces}},
                                      {"vertices", std::uint64_t{m.vertices}}};
  append(entries, "", entries_of(m.curves.total));
  if (m.others) {
    append(entries, "", entries_of(m.deviation));
    append(entries, "other.", entries_of(m.others->total));
    const std::vector<MeasuredCurve>& each = m.others->each;
    for (std::size_t k = 0; k < each.size() && each.size() > 1; ++k) {
      append(entries, "other.curves." + std::to_string(k) + ".", entries_of(each[k]));
    }
  }
  entries.push_back({"warnings", m.warnings});
  return entries;
}

std::vector<std::vector<ReportEntry>> curve_entries_of(const CurveMeasurement& m) {
  std::vector<std::vector<ReportEntry>> all;
  for (std::size_t k = 0; k < m.curves.each.size(); ++k) {
    all.push_back(entries_of(m.curves.each[k]));
    if (!m.deviations.empty()) append(all.back(), "", entries_of(m.deviations[k]));
  }
  return all;
}

}  // namespace talweg
