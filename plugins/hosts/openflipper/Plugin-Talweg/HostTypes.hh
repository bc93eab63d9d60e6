// Includes the host's headers of meshes and lines in the order that they need.
#pragma once

// clang-format off
#include <OpenFlipper/common/ObjectTypeDLLDefines.hh>
#include <OpenFlipper/common/Types.hh>
#include <ObjectTypes/TriangleMesh/TriangleMesh.hh>
#include <ObjectTypes/PolyLine/PolyLine.hh>
#include <ObjectTypes/PolyLine/PluginFunctionsPolyLine.hh>
// clang-format on
