// A smoother workspace is the common base of plugins that use a CurveSmoother.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "results.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "workspace.hpp"

namespace talweg::plugins {

class SmootherWorkspace : public Workspace {
 public:
  using Workspace::Workspace;

 protected:
  /// The smoother of the current mesh, made when first needed.
  [[nodiscard]] CurveSmoother& smoother();
  [[nodiscard]] bool has_smoother() const { return smoother_ != nullptr; }
  void forget() override {
    Workspace::forget();
    smoother_.reset();
  }

  /// Throws plugin::Services::cancelled() if the run was cancelled.
  static void check(const SmoothingResult& result);

  /// Adds sentences on the repair to the warnings.
  void add_changes(SmoothingResult& result) const;

  using ReportEntriesOf = std::function<std::vector<ReportEntry>(const SmoothingReport& report)>;
  /// Like the function with this name in results.hpp.
  void give_curves(const plugin::Outputs& outputs, const SmoothingResult& result,
                   const FieldsOf& fields_of, const ReportEntriesOf& entries_of) const;

 private:
  std::unique_ptr<CurveSmoother> smoother_;
};

}  // namespace talweg::plugins
