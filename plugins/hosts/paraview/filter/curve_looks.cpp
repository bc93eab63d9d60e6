#include "curve_looks.hpp"

#include <algorithm>
#include <string_view>

#include <vtkBoundingBox.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkCompositeRepresentation.h>
#include <vtkDataObject.h>
#include <vtkGeometryRepresentation.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPVLODActor.h>
#include <vtkPVXMLElement.h>
#include <vtkRenderer.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxyIterator.h>
#include <vtkSMProxyManager.h>
#include <vtkSMRenderViewProxy.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>

#include "depth_offset.hpp"

namespace talweg::paraview {
namespace {

constexpr double kWidth = 4;                      // pixels
constexpr double kColour[] = {0.86, 0.12, 0.08};  // visible on white, grey and blue

/// The index of the output with curves; -1 if the filter has none, or is not a filter of Talweg.
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

/// Draws the line in front of the mesh by its own width: otherwise half of a line several pixels
/// wide would be hidden by a slope.
void bring_forward(vtkSMProxy& representation, vtkRenderer& renderer) {
  vtkObjectBase* object = representation.GetClientSideObject();
  if (auto* several = vtkCompositeRepresentation::SafeDownCast(object)) {
    object = several->GetActiveRepresentation();
  }
  auto* geometry = vtkGeometryRepresentation::SafeDownCast(object);
  vtkPVLODActor* actor = geometry == nullptr ? nullptr : geometry->GetActor();
  if (actor == nullptr || actor->GetBounds() == nullptr) return;
  double middle[3];
  vtkBoundingBox(actor->GetBounds()).GetCenter(middle);
  const double width = vtkSMPropertyHelper(&representation, "LineWidth", true).GetAsDouble();
  const double units = forward_by(std::max(width, kWidth), middle, renderer);
  // The actor's own GetMapper() returns only the mapper that has data to draw.
  for (vtkMapper* mapper : {actor->vtkActor::GetMapper(), actor->GetLODMapper()}) {
    if (mapper != nullptr) mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, units);
  }
}

/// Draws plain lines instead of tubes, half of which would be below the mesh: ParaView draws lines
/// in front of faces.
void dress(vtkSMProxy& representation) {
  if (representation.GetProperty("LineWidth") == nullptr) return;
  vtkSMPropertyHelper(&representation, "LineWidth").Set(kWidth);
  vtkSMPropertyHelper(&representation, "AmbientColor", true).Set(kColour, 3);
  vtkSMPropertyHelper(&representation, "DiffuseColor", true).Set(kColour, 3);
  // By default ParaView would colour the curve like the mesh, so that it could not be seen.
  vtkSMPVRepresentationProxy::SetScalarColoring(&representation, "", vtkDataObject::POINT);
  representation.UpdateVTKObjects();
}

/// Called before each picture, since the offset depends on the camera.
void rendering(vtkObject* caller, unsigned long, void* manager, void*) {
  vtkNew<vtkSMProxyIterator> all;
  all->SetSessionProxyManager(static_cast<vtkSMSessionProxyManager*>(manager));
  for (all->Begin("representations"); !all->IsAtEnd(); all->Next()) {
    if (shows_curves(*all->GetProxy())) {
      bring_forward(*all->GetProxy(), *static_cast<vtkRenderer*>(caller));
    }
  }
}

void watch_views(vtkSMSessionProxyManager& manager) {
  static vtkNew<vtkCallbackCommand> command;
  command->SetCallback(rendering);
  command->SetClientData(&manager);
  vtkNew<vtkSMProxyIterator> all;
  all->SetSessionProxyManager(&manager);
  for (all->Begin("views"); !all->IsAtEnd(); all->Next()) {
    auto* view = vtkSMRenderViewProxy::SafeDownCast(all->GetProxy());
    vtkRenderer* renderer = view == nullptr ? nullptr : view->GetRenderer();
    if (renderer != nullptr && renderer->HasObserver(vtkCommand::StartEvent, command) == 0) {
      renderer->AddObserver(vtkCommand::StartEvent, command);
    }
  }
}

void registered(vtkObject* caller, unsigned long, void*, void* data) {
  auto* manager = vtkSMSessionProxyManager::SafeDownCast(caller);
  const auto* info = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  if (manager == nullptr || info == nullptr || info->Proxy == nullptr) return;
  const std::string_view group = info->GroupName == nullptr ? "" : info->GroupName;
  if (group != "representations" || !shows_curves(*info->Proxy)) return;
  // A state file has the looks of its curves, but not the offset.
  if (!manager->GetInLoadXMLState()) dress(*info->Proxy);
  watch_views(*manager);
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
