// A named measure is a measure of a curve with its key in reports and its total of several curves.
#pragma once

#include <algorithm>
#include <array>

#include "talweg/core/measure/measures.hpp"

namespace talweg {

/// How the measures of several curves become one.
enum class TotalOf { kSum, kLargest };

struct NamedMeasure {
  const char* name;  ///< a key of `talweg measure`; of `talweg smooth` with _before and _after
  double CurveMeasures::*value;
  TotalOf total;
};

/// The measures that all reports have, in their order.
inline constexpr std::array kNamedMeasures = {
    NamedMeasure{"length", &CurveMeasures::length, TotalOf::kSum},
    NamedMeasure{"curvature", &CurveMeasures::total_curvature, TotalOf::kSum},
    NamedMeasure{"curvature_max", &CurveMeasures::max_curvature, TotalOf::kLargest},
    NamedMeasure{"bending", &CurveMeasures::bending, TotalOf::kSum},
    NamedMeasure{"window_turning", &CurveMeasures::window_turning, TotalOf::kLargest},
    NamedMeasure{"window_turning_2", &CurveMeasures::window_turning_2, TotalOf::kLargest},
    NamedMeasure{"tortuosity", &CurveMeasures::tortuosity, TotalOf::kLargest},
};

/// Adds the measures of a curve to the totals. `max_at` has no meaning in totals and stays.
inline void add(CurveMeasures& total, const CurveMeasures& curve) {
  for (const NamedMeasure& measure : kNamedMeasures) {
    double& all = total.*measure.value;
    const double own = curve.*measure.value;
    all = measure.total == TotalOf::kSum ? all + own : std::max(all, own);
  }
  total.signed_curvature += curve.signed_curvature;
}

}  // namespace talweg
