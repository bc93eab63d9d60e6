// Mesh files are read and written through the plugin interface (talweg_mesh_files.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "talweg/editing/mesh_arrays.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::browser {

/// The data of a mesh file that the page keeps.
struct FileMesh {
  std::shared_ptr<const editing::MeshArrays> arrays;
  std::vector<host::Attribute> attributes;
  std::string frame;                  ///< unit and space of the coordinates: "", "mm", "RAS", ...
  std::vector<std::string> left_out;  ///< kinds of data that were not read, a few words each
};

/// The UCUM code of the unit in a frame; empty without one.
std::string unit_in(const std::string& frame);
/// The frame with another unit; an empty unit removes it.
std::string with_unit(const std::string& frame, const std::string& unit);

/// Throws host::Error with the library's sentence.
FileMesh read_mesh(const editing::Plugins& plugins, const std::string& path);

/// Returns a few words for each kind of data that the format cannot hold. Throws host::Error.
std::vector<std::string> write_mesh(const editing::Plugins& plugins, const std::string& path,
                                    const editing::MeshArrays& mesh,
                                    const std::vector<host::Attribute>& attributes,
                                    const std::string& frame = {});

}  // namespace talweg::browser
