// The offset by which lines and points are drawn in front of the mesh on which they lie.
#pragma once

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

namespace talweg::paraview {

/// VTK's depth offset that moves a place towards the camera by the size of so many pixels at this
/// place. A fixed offset would show parts behind the mesh if the view has a long range of depth:
/// close to the mesh, the range begins at the camera.
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
