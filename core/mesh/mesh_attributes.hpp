// Mesh attributes are what a file says beside its geometry: normals, colours, labels, ...
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

/// How the value of a point between corners follows from theirs.
enum class Carry : std::uint8_t {
  kByName,    ///< as carried_to() says
  kLinear,    ///< interpolated
  kRounded,   ///< interpolated, and rounded to a whole number
  kNearest,   ///< that of the nearest corner
  kDirection  ///< three numbers, interpolated and made as long as one
};

/// A number for every vertex, or for every face.
struct AttributeColumn {
  std::string name;                        ///< "nx", "red", "quality", ...; printable, no blanks
  NumberType type = NumberType::kFloat32;  ///< how it is stored
  std::vector<double> values;
  Carry carry = Carry::kByName;  ///< three columns of a direction follow each other
  std::optional<double> fill;    ///< of elements that come from nowhere; default: by its name
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
