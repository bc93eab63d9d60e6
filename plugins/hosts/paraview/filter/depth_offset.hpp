// How far lines and points are drawn before the mesh that they lie on.
#pragma once

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

namespace talweg::paraview {

/// VTK's offset of depth that brings what is at a place forward by so many pixels of the view, as
/// long as they are there. A fixed one would show what is behind the mesh where the view's range of
/// depth is long: near the mesh it begins at the camera.
inline double forward_by(double pixels, const double place[3], vtkRenderer& renderer) {
  constexpr double kSteps = 65000;  // of the depth from 0 to 1, in VTK's shaders
  vtkCamera& camera = *renderer.GetActiveCamera();
  const double height = std::max(1, renderer.GetSize()[1]);
  double range[2];
  camera.GetClippingRange(range);
  const double depth = std::max(range[1] - range[0], 1e-300);
  if (camera.GetParallelProjection() != 0) {
    return -kSteps * pixels * 2 * camera.GetParallelScale() / height / depth;
  }
  double eye[3], forwards[3], there[3];
  camera.GetPosition(eye);
  camera.GetDirectionOfProjection(forwards);
  vtkMath::Subtract(place, eye, there);
  const double away = std::clamp(vtkMath::Dot(there, forwards), range[0], range[1]);
  const double pixel =
      2 * away * std::tan(vtkMath::RadiansFromDegrees(camera.GetViewAngle()) / 2) / height;
  return -kSteps * pixels * pixel * range[0] * range[1] / (depth * away * away);
}

}  // namespace talweg::paraview
