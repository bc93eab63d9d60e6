// The first looks of curves: ParaView's default, a white line of width 1, cannot be seen on a white
// mesh.
#pragma once

class vtkSMSessionProxyManager;

namespace talweg::paraview {

/// Makes each later representation of Talweg's curves a wide line in a colour of its own. The hint
/// <InitializationHelper curves="PORT"/> of a filter names its output with curves. Looks from a
/// state file or from the user stay.
void watch_curves(vtkSMSessionProxyManager& manager);

}  // namespace talweg::paraview
