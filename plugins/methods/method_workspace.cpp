#include "method_workspace.hpp"

#include <algorithm>

#include "deviation_choice.hpp"
#include "point_fields.hpp"
#include "talweg/core/measure/result_report.hpp"
#include "talweg/core/measure/self_contacts.hpp"

namespace talweg::plugins {
namespace {

/// The number of contacts of each curve with itself and with later curves.
std::vector<std::size_t> contacts_of(const Surface& surface, std::span<const SurfaceCurve> curves) {
  std::vector<std::size_t> count(curves.size(), 0);
  for (const SelfContact& contact : self_contacts(surface, curves)) ++count[contact.curve];
  return count;
}

}  // namespace

std::vector<talweg_output> MethodWorkspace::outputs() {
  using plugin::output;
  return {output(TALWEG_OUTPUT_CURVES, "curves", "Smoothed curves", "",
                 "One for each drawn curve, in their order."),
          output(TALWEG_OUTPUT_POINT_FIELD, "deviation", "Deviation", "mesh units",
                 "Distance along the surface to the drawn curve."),
          output(TALWEG_OUTPUT_POINT_FIELD, "curvature", "Geodesic curvature", "radians",
                 "The turning angle at each point; 0 at the ends."),
          output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
                 "Steps and measures, for each curve and in total.")};
}

SmoothingReport MethodWorkspace::report_on(const Method& method, std::size_t curve,
                                           DeviationMeasure measure, DeviationMeter& meter) const {
  const MethodCurve& made = method.curves[curve];
  SmoothingReport report =
      report_on_result(mesh(), meter, drawing().curves[curve], made.curve, measure);
  report.termination = made.termination;
  report.iterations = made.iterations;
  report.warnings.insert(report.warnings.begin(), made.warnings.begin(), made.warnings.end());
  drawing().add_to(report.warnings, reading_warnings());
  lead_with(report, drawing().decisive());
  StageTimes& t = report.time_ms = method.times;
  t.open = opened_mesh()->open_ms();
  t.total = t.load + t.open + t.solve + t.straighten + t.trace + t.relax + t.fair;
  return report;
}

std::vector<SmoothingReport> MethodWorkspace::reports_on(const Method& method,
                                                         const std::vector<SurfaceCurve>& curves,
                                                         DeviationMeasure measure) const {
  const auto before = contacts_of(mesh().surface(), drawing().curves);
  const auto after = contacts_of(mesh().surface(), curves);
  DeviationMeter meter(mesh());
  std::vector<SmoothingReport> reports;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    go_on("report", static_cast<double>(c) / static_cast<double>(curves.size()));
    SmoothingReport& report = reports.emplace_back(report_on(method, c, measure, meter));
    report.crossings_before = before[c];
    report.crossings_after = after[c];
    if (after[c] <= before[c]) continue;
    warn_decisively(report,
                    {"The result meets itself or another curve where the drawing does not."});
  }
  return reports;
}

namespace {

/// Writes the method's name as the engine of reports.
void name_engine(std::vector<ReportEntry>& entries, const char* engine) {
  for (ReportEntry& entry : entries) {
    if (entry.key == "engine") entry.value = std::string(engine);
  }
}

}  // namespace

void MethodWorkspace::run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
  const Method method = smooth(parameters);
  std::vector<SurfaceCurve> curves;
  for (const MethodCurve& made : method.curves) curves.push_back(made.curve);
  std::vector<SmoothingReport> reports;
  if (outputs.wants_report()) reports = reports_on(method, curves, deviation_of(parameters));
  SmoothingReport total = total_of(reports);
  total.crossings_before = total.crossings_after = 0;
  for (const SmoothingReport& report : reports) {
    total.crossings_before += report.crossings_before;
    total.crossings_after += report.crossings_after;
    total.iterations = std::max(total.iterations, report.iterations);
  }
  for (const std::string& warning : total.warnings) services().log(TALWEG_LOG_WARNING, warning);
  const auto fields = [&](std::size_t c) -> std::vector<PointField> {
    return {deviation_field(mesh(), drawing().curves[c], curves[c], services()),
            curvature_field(mesh(), curves[c])};
  };
  const auto entries = [&](std::int64_t curve) {
    const auto c = static_cast<std::size_t>(std::max<std::int64_t>(curve, 0));
    std::vector<ReportEntry> all = entries_of(curve < 0 ? total : reports[c]);
    name_engine(all, method.engine);
    if (curve < 0 && curves.size() > 1) return all;
    const std::vector<ReportEntry>& own = method.curves[c].entries;
    all.insert(all.end(), own.begin(), own.end());
    return all;
  };
  give_curves(outputs, host_mesh(), curves, fields, entries);
}

}  // namespace talweg::plugins
