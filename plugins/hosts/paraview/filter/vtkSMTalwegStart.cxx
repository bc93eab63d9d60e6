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

/// Where the camera of the active view looks; 0 without one.
std::array<double, 3> direction_of_view(vtkSMSessionProxyManager& manager) {
  vtkSMProxySelectionModel* active = manager.GetSelectionModel("ActiveView");
  vtkSMProxy* view = active == nullptr ? nullptr : active->GetCurrentProxy();
  std::array<double, 3> direction = {};
  if (view == nullptr || view->GetProperty("CameraPosition") == nullptr) return direction;
  const vtkSMPropertyHelper from(view, "CameraPosition"), to(view, "CameraFocalPoint");
  for (unsigned k = 0; k < 3; ++k) direction[k] = to.GetAsDouble(k) - from.GetAsDouble(k);
  return direction;
}

/// The filter, which may be on a server, looks at its mesh.
std::vector<double> start_points(vtkSMProxy& filter) {
  const auto d = direction_of_view(*filter.GetSessionProxyManager());
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(&filter) << "StartPoints" << d[0] << d[1]
         << d[2] << vtkClientServerStream::End;
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
  if (vtkSMPropertyHelper(property).GetNumberOfElements() > 0) return;  // they were given
  proxy->UpdateVTKObjects();  // so that the filter has its input
  const std::vector<double> points = start_points(*proxy);
  if (points.empty()) return;
  vtkSMPropertyHelper(property).Set(points.data(), static_cast<unsigned int>(points.size()));
}
