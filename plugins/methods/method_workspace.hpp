// A method workspace is the common base of plugins for other smoothing methods. Their output is
// curves and a report as of talweg.smooth, so that methods can be compared.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/core/measure/surface_deviation.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"
#include "workspace.hpp"

namespace talweg::plugins {

/// A method's result for one drawn curve.
struct MethodCurve {
  SurfaceCurve curve;
  Outcome termination = Outcome::kConverged;
  std::size_t iterations = 0;         ///< rounds of whatever kind the method has
  std::vector<std::string> warnings;  ///< sentences for the user
  std::vector<ReportEntry>
      entries;  ///< entries that only this method reports; with one curve also in the total
};

class MethodWorkspace : public Workspace {
 public:
  using Workspace::Workspace;

  /// The outputs of every method.
  static std::vector<talweg_output> outputs();

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs);

 protected:
  ~MethodWorkspace() = default;

  struct Method {
    const char* engine;               ///< name in the report
    std::vector<MethodCurve> curves;  ///< one per drawn curve, in their order
    StageTimes times;                 ///< open and total are not set
  };
  /// Smooths drawing(). Throws plugin::Services::cancelled().
  virtual Method smooth(const plugin::Parameters& parameters) = 0;

 private:
  [[nodiscard]] SmoothingReport report_on(const Method& method, std::size_t curve,
                                          DeviationMeasure measure, DeviationMeter& meter) const;
  [[nodiscard]] std::vector<SmoothingReport> reports_on(const Method& method,
                                                        const std::vector<SurfaceCurve>& curves,
                                                        DeviationMeasure measure) const;
};

}  // namespace talweg::plugins
