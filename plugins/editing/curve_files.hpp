// Curve files in the library's formats are read and written for hosts.
#pragma once

#include <string>
#include <vector>

#include "mesh_arrays.hpp"
#include "workplace.hpp"

namespace talweg::editing {

/// Writes curves of the mesh with their faces, barycentrics and positions, by extension (.json,
/// .vtp, .border, ...). `frame` is what the mesh's file says of its coordinates
/// (talweg_mesh_files.h). Throws host::Error; the file is then unchanged.
void write_curves(const Plugins& plugins, const std::string& path, const MeshArrays& mesh,
                  const std::vector<host::Curve>& curves, const std::string& frame = {});

/// All curves of a file for the mesh, as input for set_curves(). Throws host::Error.
std::vector<host::Curve> read_curves(const Plugins& plugins, const std::string& path,
                                     const MeshArrays& mesh, const std::string& frame = {});

/// A drawing's own points, for a file from which the drawing can be read again. Throws Error.
std::vector<host::Curve> drawn_curves(const MeshArrays& mesh, const Drawing& drawing);

}  // namespace talweg::editing
