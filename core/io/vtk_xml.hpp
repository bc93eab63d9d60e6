// VTK's XML files hold data arrays in a tree; files that are not well-formed are errors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/vtk_data_array.hpp"

namespace talweg::formats {

/// A file of type PolyData. All errors are Error(kBadFile) with the line.
class VtkXml {
 public:
  explicit VtkXml(const Source& source);

  [[nodiscard]] pugi::xml_object_range<pugi::xml_named_node_iterator> pieces() const {
    return document_.child("VTKFile").child("PolyData").children("Piece");
  }
  /// The data array with this name.
  [[nodiscard]] pugi::xml_node named(const pugi::xml_node& among, const char* name) const;
  /// The type of an array's numbers; nothing for texts and bits.
  [[nodiscard]] static std::optional<NumberType> number_type(const pugi::xml_node& array);
  /// An array's numbers, of any type and encoding.
  [[nodiscard]] std::vector<double> read_array(const pugi::xml_node& array) const;
  /// The space of the coordinates that 3D Slicer notes in the field data: a string SPACE.
  [[nodiscard]] PatientSpace space() const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const;

 private:
  void parse();
  void read_encoding(const pugi::xml_node& root);
  [[nodiscard]] std::vector<double> read_ascii(const pugi::xml_node& array) const;

  const Source& source_;
  std::string xml_;
  pugi::xml_document document_;
  VtkEncoding encoding_;
  mutable std::uint64_t unpacked_ = 0;  // bytes of all arrays that were read
};

}  // namespace talweg::formats
