// Plugin attributes are a file's mesh attributes converted for a plugin and back (talweg_meshes.h).
#pragma once

#include <vector>

#include "talweg/core/mesh/mesh_attributes.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::driver {

std::vector<host::Attribute> host_attributes(const MeshAttributes& attributes);

/// The attributes that a plugin gave for a mesh that it made, in the form of a file. Attributes
/// added by the plugin come last and replace attributes of the same name.
MeshAttributes file_attributes(const MeshAttributes& attributes,
                               const std::vector<host::Attribute>& carried);

}  // namespace talweg::driver
