// Curve files in the library's formats are read and written for hosts.
#pragma once

#include <string>
#include <vector>

#include "mesh_arrays.hpp"
#include "workplace.hpp"

namespace talweg::editing {

/// Writes result curves with their faces, barycentrics and positions, by extension (.json, .vtp,
/// .obj, ...). Throws host::Error; the file is then unchanged.
void write_curves(const Plugins& plugins, const std::string& path,
                  const std::vector<host::Curve>& curves);

/// All curves of a file, as input for set_curves(). Throws host::Error.
std::vector<host::Curve> read_curves(const Plugins& plugins, const std::string& path);

/// A drawing's own points, for a file from which the drawing can be read again. Throws Error.
std::vector<host::Curve> drawn_curves(const MeshArrays& mesh, const Drawing& drawing);

}  // namespace talweg::editing
