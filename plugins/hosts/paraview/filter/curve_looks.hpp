// How curves look when they are shown first: a white line of width 1 on a white mesh is not seen.
#pragma once

class vtkSMSessionProxyManager;

namespace talweg::paraview {

/// From now on each representation that is made for curves of Talweg is a wide line in a colour of
/// its own. Its filter says by the hint <InitializationHelper curves="PORT"/> which output they
/// are. What a state file or the user says of a line stays.
void watch_curves(vtkSMSessionProxyManager& manager);

}  // namespace talweg::paraview
