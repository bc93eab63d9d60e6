// Mesh files are read and written through the plugin interface (talweg_mesh_files.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "talweg/editing/mesh_arrays.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::browser {

/// What the page keeps of a file.
struct FileMesh {
  std::shared_ptr<const editing::MeshArrays> arrays;
  std::vector<host::Attribute> attributes;
  std::string frame;                  ///< what it says of its coordinates: "", "mm", "RAS", ...
  std::vector<std::string> left_out;  ///< what of the file is not read, a few words each
};

/// The UCUM code of the unit in a frame; empty without one.
std::string unit_in(const std::string& frame);
/// The frame with another unit; an empty one takes it away.
std::string with_unit(const std::string& frame, const std::string& unit);

/// Throws host::Error with the library's sentence.
FileMesh read_mesh(const editing::Plugins& plugins, const std::string& path);

/// Gives what the format does not hold, a few words each. Throws host::Error.
std::vector<std::string> write_mesh(const editing::Plugins& plugins, const std::string& path,
                                    const editing::MeshArrays& mesh,
                                    const std::vector<host::Attribute>& attributes,
                                    const std::string& frame = {});

}  // namespace talweg::browser
