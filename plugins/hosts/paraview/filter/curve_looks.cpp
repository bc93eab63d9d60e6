#include "curve_looks.hpp"

#include <set>
#include <string_view>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCompositeRepresentation.h>
#include <vtkGeometryRepresentation.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPVLODActor.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxyManager.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>

namespace talweg::paraview {
namespace {

constexpr double kWidth = 4;                      // pixels
constexpr double kForward = -400;                 // steps of the depth that the view has
constexpr double kColour[] = {0.86, 0.12, 0.08};  // seen on white, grey and blue

/// The output with curves; -1 if the filter has none, or is not one of ours.
int curve_port(vtkSMProxy& filter) {
  int port = -1;
  vtkPVXMLElement* hints = filter.GetHints();
  vtkPVXMLElement* start =
      hints == nullptr ? nullptr : hints->FindNestedElementByName("InitializationHelper");
  const char* name = start == nullptr ? nullptr : start->GetAttribute("class");
  if (name != nullptr && std::string_view(name) == "vtkSMTalwegStart") {
    start->GetScalarAttribute("curves", &port);
  }
  return port;
}

bool shows_curves(vtkSMProxy& representation) {
  if (representation.GetProperty("Input") == nullptr) return false;
  const vtkSMPropertyHelper input(&representation, "Input");
  vtkSMProxy* filter = input.GetAsProxy();
  return filter != nullptr && curve_port(*filter) == static_cast<int>(input.GetOutputPort());
}

/// Only a little: of a line several pixels wide half would be behind a slope.
void bring_forward(vtkSMProxy& representation) {
  vtkObjectBase* object = representation.GetClientSideObject();
  if (auto* several = vtkCompositeRepresentation::SafeDownCast(object)) {
    object = several->GetActiveRepresentation();
  }
  auto* geometry = vtkGeometryRepresentation::SafeDownCast(object);
  vtkPVLODActor* actor = geometry == nullptr ? nullptr : geometry->GetActor();
  if (actor == nullptr) return;
  // Of its two mappers its own function gives the one that has something to draw.
  for (vtkMapper* mapper : {actor->vtkActor::GetMapper(), actor->GetLODMapper()}) {
    if (mapper != nullptr) mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, kForward);
  }
}

/// No tubes, half of which is below the mesh: ParaView draws lines in front of faces.
void dress(vtkSMProxy& representation) {
  if (representation.GetProperty("LineWidth") == nullptr) return;
  vtkSMPropertyHelper(&representation, "LineWidth").Set(kWidth);
  vtkSMPropertyHelper(&representation, "AmbientColor", true).Set(kColour, 3);
  vtkSMPropertyHelper(&representation, "DiffuseColor", true).Set(kColour, 3);
  representation.UpdateVTKObjects();
}

void registered(vtkObject* caller, unsigned long, void*, void* data) {
  const auto* manager = vtkSMSessionProxyManager::SafeDownCast(caller);
  const auto* info = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  if (manager == nullptr || info == nullptr || info->Proxy == nullptr) return;
  const std::string_view group = info->GroupName == nullptr ? "" : info->GroupName;
  if (group != "representations" || !shows_curves(*info->Proxy)) return;
  // A state file says how curves look, but not this.
  if (!const_cast<vtkSMSessionProxyManager*>(manager)->GetInLoadXMLState()) dress(*info->Proxy);
  bring_forward(*info->Proxy);
}

}  // namespace

void watch_curves(vtkSMSessionProxyManager& manager) {
  static vtkNew<vtkCallbackCommand> command;
  command->SetCallback(registered);
  if (!manager.HasObserver(vtkCommand::RegisterEvent, command)) {
    manager.AddObserver(vtkCommand::RegisterEvent, command);
  }
}

}  // namespace talweg::paraview
