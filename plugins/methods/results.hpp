// Results of the library are passed to a host's output functions.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host_mesh.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/measure/report.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// Values per point of a curve.
struct PointField {
  const char* name;
  const char* unit;
  std::vector<double> values;
};

void give(const plugin::Outputs& outputs, const PlacedCurve& curve,
          const std::vector<PointField>& fields = {});
/// `curve`: the curve's number, or -1 for all curves together.
void give(const plugin::Outputs& outputs, std::int64_t curve,
          const std::vector<ReportEntry>& entries);
/// One value per vertex or face of the host's mesh.
void give(const plugin::Outputs& outputs, const char* name, const char* unit,
          const std::vector<double>& values);

using FieldsOf = std::function<std::vector<PointField>(std::size_t curve)>;
/// `curve`: the curve's number, or -1 for all curves together.
using EntriesOf = std::function<std::vector<ReportEntry>(std::int64_t curve)>;
/// Gives the report on all curves, then each curve and its report. All curves and fields are
/// computed before the first output; results that the host does not want are not computed.
void give_curves(const plugin::Outputs& outputs, const HostMesh& mesh,
                 std::span<const SurfaceCurve> curves, const FieldsOf& fields_of,
                 const EntriesOf& entries_of);

}  // namespace talweg::plugins
