#include "start_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <vtkBoundingBox.h>
#include <vtkGenericCell.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include "mesh_ray.hpp"

namespace talweg::paraview {
namespace {

using Vector = std::array<double, 3>;

constexpr double kMiddle = 0.3;  // the preference for a row in the middle over a row of equal depth

Vector along(const Vector& from, const Vector& direction, double step) {
  return {from[0] + step * direction[0], from[1] + step * direction[1],
          from[2] + step * direction[2]};
}

/// The part with the most cells: a curve cannot join different parts.
vtkSmartPointer<vtkPolyData> largest_part(vtkPolyData& mesh) {
  vtkNew<vtkPolyData> faces;  // without lines and single points
  faces->SetPoints(mesh.GetPoints());
  faces->SetPolys(mesh.GetPolys());
  faces->SetStrips(mesh.GetStrips());
  vtkNew<vtkPolyDataConnectivityFilter> parts;
  parts->SetInputData(faces);
  parts->SetExtractionModeToLargestRegion();
  parts->Update();
  return parts->GetOutput();
}

/// The direction of view, and the directions right and up: right is the longest side of the box
/// that is not nearly parallel to the view.
struct View {
  Vector forwards, right, up;
};

Vector axis(int k) {
  Vector unit = {};
  unit[static_cast<std::size_t>(k)] = 1;
  return unit;
}

View view_of(const vtkBoundingBox& box, Vector forwards) {
  double sides[3];
  box.GetLengths(sides);
  if (vtkMath::Norm(forwards.data()) == 0) {
    forwards = along({}, axis(static_cast<int>(std::min_element(sides, sides + 3) - sides)), -1);
  }
  vtkMath::Normalize(forwards.data());
  Vector right = {};
  double longest = -1;
  for (int k = 0; k < 3; ++k) {
    const Vector side = along(axis(k), forwards, -forwards[static_cast<std::size_t>(k)]);
    const double length = sides[k] * vtkMath::Norm(side.data());
    if (length > longest) right = side;
    longest = std::max(longest, length);
  }
  vtkMath::Normalize(right.data());
  Vector up = {};
  vtkMath::Cross(right.data(), forwards.data(), up.data());
  return {forwards, right, up};
}

/// Finds the first point of the mesh on a ray; without one, the mesh's nearest point, which may be
/// on the far side.
class Sight {
 public:
  Sight(vtkPolyData& mesh, const Vector& eye, const Vector& forwards, double reach)
      : eye_(eye), forwards_(forwards), reach_(reach) {
    locator_->SetDataSet(&mesh);
    locator_->BuildLocator();
  }

  [[nodiscard]] std::optional<Vector> meet(const Vector& place) {
    Vector ray = along(place, eye_, -1);
    if (vtkMath::Normalize(ray.data()) == 0) return std::nullopt;
    const Vector to = along(place, ray, reach_);
    Vector found = {};
    double t = 0, parametric[3] = {};
    int part = 0;
    if (locator_->IntersectWithLine(eye_.data(), to.data(), within_, t, found.data(), parametric,
                                    part) == 0)
      return std::nullopt;
    return found;
  }

  [[nodiscard]] Vector nearest(const Vector& place) {
    Vector found = {};
    vtkIdType cell = 0;
    int part = 0;
    double squared = 0;
    vtkNew<vtkGenericCell> face;
    locator_->FindClosestPoint(place.data(), found.data(), face, cell, part, squared);
    return found;
  }

  /// The range of the points' depths.
  [[nodiscard]] double depth(const std::vector<Vector>& points) const {
    double least = 0, most = 0;
    for (const Vector& point : points) {
      const double behind = vtkMath::Dot(point.data(), forwards_.data()) -
                            vtkMath::Dot(points[0].data(), forwards_.data());
      least = std::min(least, behind);
      most = std::max(most, behind);
    }
    return most - least;
  }

 private:
  vtkNew<vtkStaticCellLocator> locator_;
  Vector eye_, forwards_;
  double reach_;
  double within_ = kNoGap * reach_;
};

double half_length(const vtkBoundingBox& box, const Vector& direction) {
  double length = 0;
  for (int k = 0; k < 3; ++k) {
    length += std::abs(direction[static_cast<std::size_t>(k)]) * box.GetLength(k) / 2;
  }
  return length;
}

/// Three places in a row, the middle one a little higher.
std::vector<Vector> places_at(const Vector& centre, const View& view, double reach, double height) {
  std::vector<Vector> places;
  for (const double step : {-0.5, 0.0, 0.5}) {
    const Vector beside = along(centre, view.right, step * reach);
    places.push_back(along(beside, view.up, height + (step == 0 ? 0.1 * reach : 0.0)));
  }
  return places;
}

}  // namespace

std::vector<Vector> start_points(vtkPolyData& mesh, const Vector& eye, const Vector& focus) {
  if (mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0) return {};
  const vtkSmartPointer<vtkPolyData> part = largest_part(mesh);
  const vtkBoundingBox box(part->GetBounds());
  const View view = view_of(box, along(focus, eye, -1));
  Vector centre = {};
  box.GetCenter(centre.data());
  const double size = box.GetDiagonalLength();
  Sight sight(*part, eye == focus ? along(centre, view.forwards, -1000 * size) : eye, view.forwards,
              size);
  const double width = half_length(box, view.right), height = half_length(box, view.up);
  // Seven rows of three places in the view are tried, because a mesh may have gaps and branches. In
  // the best row all three places meet the mesh; it has a small range of depth and is near the
  // middle.
  std::vector<Vector> points;
  double best = std::numeric_limits<double>::infinity();
  for (const double row : {0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6}) {
    std::vector<Vector> met;
    for (const Vector& place : places_at(centre, view, width, row * height)) {
      if (const std::optional<Vector> point = sight.meet(place)) met.push_back(*point);
    }
    const double cost = sight.depth(met) / size + kMiddle * std::abs(row);
    if (met.size() < 3 || !(cost < best)) continue;
    best = cost;
    points = met;
  }
  if (points.empty()) {
    for (const Vector& place : places_at(centre, view, width, 0)) {
      points.push_back(sight.meet(place).value_or(sight.nearest(place)));
    }
  }
  const bool apart = points[0] != points[1] && points[1] != points[2] && points[0] != points[2];
  return apart ? points : std::vector<Vector>{};
}

}  // namespace talweg::paraview
