// Results of the library, given to a host's sink.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "talweg/core/placed_curve.hpp"
#include "talweg/core/report.hpp"
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
/// `curve`: its number, or -1 for all together.
void give(const plugin::Outputs& outputs, std::int64_t curve,
          const std::vector<ReportEntry>& entries);
/// One value per vertex.
void give(const plugin::Outputs& outputs, const char* name, const char* unit,
          const std::vector<double>& values);

}  // namespace talweg::plugins
