// Plugin attributes are the attributes of a file's mesh as they go through a plugin
// (talweg_meshes.h).
#pragma once

#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::driver {

std::vector<host::Attribute> host_attributes(const MeshAttributes& attributes);

/// What a plugin gave for a mesh that it made, as a file has it; what the plugin added comes last,
/// in place of an attribute of that name.
MeshAttributes file_attributes(const MeshAttributes& attributes,
                               const std::vector<host::Attribute>& carried);

}  // namespace talweg::driver
