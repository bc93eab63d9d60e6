// Mesh attributes are a file's data beside the geometry: normals, colours, labels, ...
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/mesh/number_type.hpp"

namespace talweg {

/// Names of columns that belong together in PLY files.
inline constexpr std::array<std::string_view, 3> kNormals{"nx", "ny", "nz"};
inline constexpr std::array<std::string_view, 4> kColours{"red", "green", "blue", "alpha"};

/// The interpolation of an attribute at a point between corners.
enum class Carry : std::uint8_t {
  kByName,    ///< depends on the name, see carried_to()
  kLinear,    ///< interpolated
  kRounded,   ///< interpolated, and rounded to a whole number
  kNearest,   ///< the value of the nearest corner
  kDirection  ///< three columns, interpolated and normalised
};

/// A number for every vertex, or for every face.
struct AttributeColumn {
  std::string name;                        ///< "nx", "red", "quality", ...; printable, no blanks
  NumberType type = NumberType::kFloat32;  ///< of the numbers in the file
  std::vector<double> values;
  Carry carry = Carry::kByName;  ///< the three columns of a direction are consecutive
  std::optional<double> fill;    ///< value without a source; default: depends on the name
};

/// Numbers at the corners of faces; corners may share them.
struct CornerAttribute {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::size_t dimension = 0;                          ///< 0 if there are none; in files 2 or 3
  std::vector<double> values;                         ///< `dimension` numbers per entry
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< per face: entries; kNone for none
  Carry carry = Carry::kByName;
};

/// Names that an OBJ file gives to groups of faces.
struct FaceNames {
  std::string keyword;                 ///< "o", "g", "usemtl" or "s"
  std::vector<std::string> names{""};  ///< the first applies to faces before any name
  std::vector<std::uint32_t> of_face;  ///< index of names
};

/// Attributes per vertex and per face of the mesh lists, as read_mesh() returns them. The triangles
/// of a polygon have its attributes.
struct MeshAttributes {
  std::vector<AttributeColumn> vertices, faces;
  CornerAttribute texture, normals;
  std::vector<FaceNames> names;
  std::vector<std::string> references;  ///< lines that name texture or material files
  std::vector<std::string> left_out;    ///< descriptions of the file's other attributes
};

}  // namespace talweg
