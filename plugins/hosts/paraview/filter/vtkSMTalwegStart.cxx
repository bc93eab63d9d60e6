#include "vtkSMTalwegStart.h"

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include <vtkClientServerStream.h>
#include <vtkObjectFactory.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMProxySelectionModel.h>
#include <vtkSMSession.h>
#include <vtkSMSessionProxyManager.h>

#include "curve_looks.hpp"

vtkStandardNewMacro(vtkSMTalwegStart);

namespace {

/// The eye and the focus of the active view; equal places without a view. The eye of a parallel
/// projection is moved far away.
struct Camera {
  std::array<double, 3> eye = {}, focus = {};
};

Camera camera_of_view(vtkSMSessionProxyManager& manager) {
  vtkSMProxySelectionModel* active = manager.GetSelectionModel("ActiveView");
  vtkSMProxy* view = active == nullptr ? nullptr : active->GetCurrentProxy();
  Camera camera;
  if (view == nullptr || view->GetProperty("CameraPosition") == nullptr) return camera;
  const bool parallel = vtkSMPropertyHelper(view, "CameraParallelProjection").GetAsInt() != 0;
  const vtkSMPropertyHelper from(view, "CameraPosition"), to(view, "CameraFocalPoint");
  for (unsigned k = 0; k < 3; ++k) {
    camera.focus[k] = to.GetAsDouble(k);
    camera.eye[k] =
        camera.focus[k] + (parallel ? 1000 : 1) * (from.GetAsDouble(k) - camera.focus[k]);
  }
  return camera;
}

/// The filter, which may be on a server, chooses points on its mesh.
std::vector<double> start_points(vtkSMProxy& filter) {
  const auto [eye, focus] = camera_of_view(*filter.GetSessionProxyManager());
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(&filter) << "StartPoints" << eye[0] << eye[1]
         << eye[2] << focus[0] << focus[1] << focus[2] << vtkClientServerStream::End;
  filter.GetSession()->ExecuteStream(filter.GetLocation(), stream, false);
  const char* text = nullptr;
  const vtkClientServerStream& result = filter.GetSession()->GetLastResult(filter.GetLocation());
  if (!result.GetArgument(0, 0, &text) || text == nullptr) return {};
  std::istringstream numbers(text);
  std::vector<double> points;
  for (double number = 0; numbers >> number;) points.push_back(number);
  return points;
}

}  // namespace

void vtkSMTalwegStart::PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType) {
  talweg::paraview::watch_curves(*proxy->GetSessionProxyManager());
  int wanted = 0;
  xml->GetScalarAttribute("start_points", &wanted);
  vtkSMProperty* property = proxy->GetProperty("Points");
  if (wanted == 0 || property == nullptr) return;
  if (vtkSMPropertyHelper(property).GetNumberOfElements() > 0) return;  // the points were set
  proxy->UpdateVTKObjects();  // passes the input to the filter
  const std::vector<double> points = start_points(*proxy);
  if (points.empty()) return;
  vtkSMPropertyHelper(property).Set(points.data(), static_cast<unsigned int>(points.size()));
}
