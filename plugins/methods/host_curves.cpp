#include "host_curves.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/plugin/talweg_arrays.hpp"
#include "talweg/plugin/talweg_way_points.h"

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

/// The marks of a curve's points, if the curve has the field of marks.
void read_marks(const talweg_curve& curve, CurveInput& input) {
  if (curve.field_count > 0 && curve.fields == nullptr) {
    throw plugin::Failure(TALWEG_BAD_USAGE, "A curve has fields, but the list of them is null.");
  }
  for (std::uint32_t f = 0; f < curve.field_count; ++f) {
    const talweg_field& field = plugin::checked(curve.fields[f], "A field of a curve");
    if (field.name == nullptr || std::string_view(field.name) != TALWEG_EXACT) continue;
    const std::vector<double> marks = plugin::numbers_of(field.values, 1, "The field exact");
    if (marks.size() != point_count(input)) {
      throw plugin::Failure(
          TALWEG_BAD_USAGE,
          fmt::format("The field exact has {} values, but the curve has {} points.", marks.size(),
                      point_count(input)));
    }
    for (std::size_t k = 0; k < marks.size(); ++k) {
      if (is_mark(marks[k]) || marks[k] == kControl) continue;
      throw plugin::Failure(
          TALWEG_BAD_USAGE,
          fmt::format("The field exact has {} at point {}; expected a tolerance of 0 or more, -1 "
                      "(no mark), -2 (painted) or -3 (control point).",
                      marks[k], k));
    }
    set_marks(input, marks);
  }
}

}  // namespace

CurveInput input_of(const talweg_curve& curve) {
  CurveInput result;
  if (curve.closed > 1)
    throw plugin::Failure(TALWEG_BAD_USAGE, "The member `closed` of a curve is not 0 or 1.");
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
  read_marks(curve, result);
  return result;
}

const talweg_way_points* way_points_extension() {
  static constexpr talweg_way_points kWayPoints = {sizeof kWayPoints, 1};
  return &kWayPoints;
}

std::vector<SnappedCurve> snapped_on(const HostMesh& mesh, const std::vector<CurveInput>& curves,
                                     const SnapOptions& options) {
  std::vector<SnappedCurve> all = snap(mesh.mesh(), curves, options);
  for (std::size_t i = 0; mesh.map() != nullptr && i < all.size(); ++i) {
    if (!std::holds_alternative<std::vector<Point>>(curves[i].points)) continue;
    all[i].points = mesh.map()->on_one_sheet(all[i].points, all[i].closed, mesh.mesh().surface());
  }
  return all;
}

SnappedDrawing drawing_of(const HostMesh& mesh, StraightLines& lines,
                          const std::vector<CurveInput>& curves) {
  SnappedDrawing drawing;
  drawing.add(mesh.mesh(), snapped_on(mesh, curves), lines);
  return drawing;
}

}  // namespace talweg::plugins
