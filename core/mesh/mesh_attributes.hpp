// Mesh attributes are what a file says beside its geometry: normals, colours, labels, ...
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/mesh/number_type.hpp"

namespace talweg {

/// Names of columns that belong together in PLY files.
inline constexpr std::array<std::string_view, 3> kNormals{"nx", "ny", "nz"};
inline constexpr std::array<std::string_view, 4> kColours{"red", "green", "blue", "alpha"};

/// A number for every vertex, or for every face.
struct AttributeColumn {
  std::string name;                        ///< "nx", "red", "quality", ...; printable, no blanks
  NumberType type = NumberType::kFloat32;  ///< how it is stored
  std::vector<double> values;
};

/// Numbers at the corners of faces; corners may share them.
struct CornerAttribute {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::size_t dimension = 0;                          ///< 2 or 3; 0 if the file has none
  std::vector<double> values;                         ///< `dimension` numbers per entry
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< per face: entries; kNone for none
};

/// Names that an OBJ file gives to groups of faces.
struct FaceNames {
  std::string keyword;                 ///< "o", "g", "usemtl" or "s"
  std::vector<std::string> names{""};  ///< the first applies to faces before any name
  std::vector<std::uint32_t> of_face;  ///< index of names
};

/// Made by read_mesh(), for as many vertices and faces as the lists have. The triangles of one
/// polygon have the polygon's attributes.
struct MeshAttributes {
  std::vector<AttributeColumn> vertices, faces;
  CornerAttribute texture, normals;
  std::vector<FaceNames> names;
  std::vector<std::string> references;  ///< lines that name texture or material files
  std::vector<std::string> left_out;    ///< descriptions of the file's other attributes
};

}  // namespace talweg
