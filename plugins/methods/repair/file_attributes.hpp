// File attributes are those of a mesh file as hosts know them (talweg_mesh_files.h): columns that
// belong together are one attribute.
#pragma once

#include <string>
#include <vector>

#include "methods/host_attributes.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"

namespace talweg::plugins {

/// Names of faces become attributes of faces: places in the lists of names.
std::vector<HostAttribute> grouped(const MeshAttributes& attributes);

/// The other way round. Attributes of corners that files do not have are described in `left_out`.
MeshAttributes in_columns(const std::vector<HostAttribute>& attributes,
                          std::vector<std::string>& left_out);

}  // namespace talweg::plugins
