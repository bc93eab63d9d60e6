#include "start_points.hpp"

#include <algorithm>
#include <cmath>

#include <vtkBoundingBox.h>
#include <vtkGenericCell.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

namespace talweg::paraview {
namespace {

using Vector = std::array<double, 3>;

Vector along(const Vector& from, const Vector& direction, double step) {
  return {from[0] + step * direction[0], from[1] + step * direction[1],
          from[2] + step * direction[2]};
}

/// Points of different parts cannot be joined.
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

/// The direction of view, and what is to the right of and above it: right along the longest side of
/// the box that is not seen from its end.
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

/// Where a ray through this place meets the mesh first, else the mesh's nearest point.
Vector on_mesh(vtkStaticCellLocator& locator, const Vector& place, const Vector& forwards,
               double reach) {
  const Vector from = along(place, forwards, -reach), to = along(place, forwards, reach);
  Vector found = {};
  double t = 0, parametric[3] = {};
  int part = 0;
  if (locator.IntersectWithLine(from.data(), to.data(), 0, t, found.data(), parametric, part) != 0)
    return found;
  vtkIdType cell = 0;
  double squared = 0;
  vtkNew<vtkGenericCell> face;
  locator.FindClosestPoint(place.data(), found.data(), face, cell, part, squared);
  return found;
}

}  // namespace

std::vector<Vector> start_points(vtkPolyData& mesh, const Vector& direction) {
  if (mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0) return {};
  const vtkSmartPointer<vtkPolyData> part = largest_part(mesh);
  const vtkBoundingBox box(part->GetBounds());
  const View view = view_of(box, direction);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(part);
  locator->BuildLocator();
  Vector centre = {};
  box.GetCenter(centre.data());
  const double size = box.GetDiagonalLength();
  double reach = 0;  // of the box to the right of its centre
  for (std::size_t k = 0; k < 3; ++k) {
    reach += std::abs(view.right[k]) * box.GetLength(static_cast<int>(k)) / 2;
  }
  std::vector<Vector> points;
  for (const double step : {-0.5, 0.0, 0.5}) {
    const Vector beside = along(centre, view.right, step * reach);
    const Vector place = along(beside, view.up, step == 0 ? 0.1 * reach : 0.0);
    points.push_back(on_mesh(*locator, place, view.forwards, size));
  }
  const bool apart = points[0] != points[1] && points[1] != points[2] && points[0] != points[2];
  return apart ? points : std::vector<Vector>{};
}

}  // namespace talweg::paraview
