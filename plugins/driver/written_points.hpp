// Written points are the points of a result's curve in a file: its own, or resampled at equal
// steps.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "talweg/core/drawing/even_points.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/coordinate_frame.hpp"

namespace talweg::driver {

struct WrittenPoints {
  std::string
      resample;  ///< "50" points, or a spacing: "2.5" mesh units, "2mm"; empty: the curve's own
  bool normals = false;  ///< with normals of the surface
};

/// Adds --resample and --normals.
void add_point_options(CLI::App& app, WrittenPoints& points);
/// Throws Error(kBadUsage) if `resample` is neither a number of points nor a spacing.
void check_points(const WrittenPoints& points);

/// A curve ready to be written.
struct ReadyCurve {
  PlacedCurve curve;
  std::optional<double> spacing;  ///< mesh units, if it was resampled
};

/// Places a curve as place() does, or at equal steps; `frame` is that of the mesh, for a spacing
/// with a unit. Throws Error as place(), resampled() and check_points() do.
ReadyCurve ready(const SurfaceMesh& mesh, const SurfaceCurve& curve, std::size_t number,
                 const WrittenPoints& points, const CoordinateFrame& frame);

/// "50 points, 1.25 mesh units apart".
std::string spacing_text(const ReadyCurve& curve);

}  // namespace talweg::driver
