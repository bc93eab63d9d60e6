// Curve files are read and written for hosts in all formats of the library.
#pragma once

#include <string>
#include <vector>

#include "mesh_arrays.hpp"
#include "workplace.hpp"

namespace talweg::editing {

/// Writes curves of the mesh with their faces, barycentrics and positions. The path's extension
/// (.json, .vtp, .border, ...) chooses the format. `frame` describes the coordinates of the mesh's
/// file (talweg_mesh_files.h). Throws host::Error; the file is then unchanged.
void write_curves(const Plugins& plugins, const std::string& path, const MeshArrays& mesh,
                  const std::vector<host::Curve>& curves, const std::string& frame = {});

/// Reads all curves of a file for the mesh, as input for host::Instance::set_curves(). Throws
/// host::Error.
std::vector<host::Curve> read_curves(const Plugins& plugins, const std::string& path,
                                     const MeshArrays& mesh, const std::string& frame = {});

/// The curves of a drawing with their positions, for a file from which read_curves() restores the
/// drawing. Throws Error.
std::vector<host::Curve> drawn_curves(const MeshArrays& mesh, const Drawing& drawing);

}  // namespace talweg::editing
