// A PLY header names the elements of a file and the types of their properties.
#pragma once

#include <string>
#include <vector>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/mesh_file.hpp"

namespace talweg {

struct PlyProperty {
  std::string name;
  NumberType type{};
  bool is_list = false;
  NumberType count_type{};  ///< for a list, the type of its length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding{};
  std::vector<PlyElement> elements;
  std::size_t body = 0;                         ///< the byte where the data begins
  std::size_t lines = 0;                        ///< number of lines before the data
  std::vector<std::string> textures;            ///< comments that name texture files, unchanged
  PatientSpace space = PatientSpace::kNotSaid;  ///< that a comment names
};

/// Throws Error(kBadFile) naming a line that cannot be understood.
PlyHeader read_ply_header(const MeshFile& file);

}  // namespace talweg
