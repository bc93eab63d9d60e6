#include "host_curves.hpp"

#include <utility>

#include <fmt/format.h>

#include "talweg/plugin/talweg_arrays.hpp"

namespace talweg::plugins {
namespace {

std::vector<FaceCoordinates> coordinates_of(const talweg_curve& curve) {
  if (curve.faces.rows != curve.barycentrics.rows) {
    throw plugin::Failure(TALWEG_BAD_USAGE,
                          fmt::format("A curve has {} faces and {} rows of barycentrics.",
                                      curve.faces.rows, curve.barycentrics.rows));
  }
  const auto faces = plugin::indices_of(curve.faces, 1, "The curve's faces");
  const auto numbers = plugin::numbers_of(curve.barycentrics, 3, "The curve's barycentrics");
  std::vector<FaceCoordinates> result;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const double* at = &numbers[3 * k];
    result.push_back({FaceId{faces[k]}, {at[0], at[1], at[2]}});
  }
  return result;
}

}  // namespace

CurveInput input_of(const talweg_curve& curve) {
  CurveInput result;
  if (curve.closed > 1) throw plugin::Failure(TALWEG_BAD_USAGE, "A curve's closed is not 0 or 1.");
  result.closed = curve.closed == 1;
  if (curve.vertices.rows > 0) {
    std::vector<VertexId> ids;
    for (const std::uint32_t v : plugin::indices_of(curve.vertices, 1, "The curve's vertices")) {
      ids.emplace_back(v);
    }
    result.points = std::move(ids);
  } else if (curve.faces.rows > 0 || curve.barycentrics.rows > 0) {
    result.points = coordinates_of(curve);
  } else if (curve.positions.rows > 0) {
    const auto numbers = plugin::numbers_of(curve.positions, 3, "The curve's positions");
    std::vector<Point> points;
    for (std::size_t k = 0; k < numbers.size(); k += 3) points.emplace_back(&numbers[k]);
    result.points = std::move(points);
  } else {
    throw plugin::Failure(TALWEG_BAD_CURVE, "A curve has no points.");
  }
  for (const std::uint32_t pin : plugin::indices_of(curve.pins, 1, "The curve's pins")) {
    result.pins.push_back(pin);
  }
  return result;
}

SnappedDrawing drawing_of(const SurfaceMesh& mesh, StraightLines& lines,
                          std::span<const talweg_curve* const> curves, const SnapOptions& options) {
  std::vector<CurveInput> inputs;
  for (const talweg_curve* curve : curves) inputs.push_back(input_of(*curve));
  SnappedDrawing drawing;
  drawing.add(mesh, snap(mesh, inputs, options), lines);
  return drawing;
}

}  // namespace talweg::plugins
