// The front door for OpenMesh tools opens their meshes, in single or double precision.
#pragma once

#include "talweg/core/openmesh/openmesh_adaptor.hpp"  // open_mesh, surface_of, lists_of, OpenMeshIds
#include "talweg/talweg.hpp"
