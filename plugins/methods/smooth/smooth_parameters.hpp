// The parameters of talweg.smooth are described here, with what they mean to the library.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/drawing/marked_points.hpp"
#include "talweg/core/repair/repair_map.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"
#include "talweg/plugin/talweg_parameters.hpp"

namespace talweg::plugins {

const std::vector<talweg_parameter>& smooth_parameters();
/// The parameter with this id; it must exist.
const talweg_parameter& smooth_parameter(std::string_view id);

/// The potential to which a parameter belongs; empty if it belongs to both.
std::string potential_of(std::string_view id);

/// The options without pins. Throws plugin::Failure(TALWEG_BAD_USAGE) for parameters that
/// contradict each other.
CurveOptions curve_options_of(const plugin::Parameters& parameters);

/// Sets the curves, with the distance if one is given. If the mesh was repaired, `map` converts the
/// distance from the given mesh's vertices to the repaired mesh's. False when cancelled. Throws as
/// CurveSmoother::set_curves() does.
bool set_curves(CurveSmoother& smoother, std::span<const SurfaceCurve> curves,
                const plugin::Parameters& parameters, const CurveOptions& options,
                const Progress& progress, const RepairMap* map = nullptr);

/// The options for curves that are set on a surface.
SmoothingOptions smoothing_options_of(const plugin::Parameters& parameters, const Surface& surface,
                                      std::span<const SurfaceCurve> drawn,
                                      const RepairMap* map = nullptr);

/// The meaning of a choice of the parameter `points`.
PointMeaning point_meaning(std::string_view choice);
/// The reading of the drawing's points; `exact` are the points of the parameter "exact".
PointOptions point_options(const plugin::Parameters& parameters, std::vector<SurfacePoint> exact);

/// A sentence on the set parameters that do not apply because the drawing is `free` (see
/// only_way_points()); none if all apply.
std::vector<std::string> idle_parameters(const plugin::Parameters& parameters, bool free);

/// Smooths, within the largest deviation if one is set and the drawing is not `free`. Throws as
/// smooth_within() and CurveSmoother::smooth() do.
SmoothingResult smooth_by(const plugin::Parameters& parameters, CurveSmoother& smoother,
                          const SmoothingOptions& options, bool free, const Progress& progress);

}  // namespace talweg::plugins
