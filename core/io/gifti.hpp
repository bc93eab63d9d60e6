// A GIFTI file holds arrays of numbers for the vertices and triangles of a surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/mesh/number_type.hpp"

namespace talweg::formats {

/// An array's description; the numbers are read on request.
struct GiftiArray {
  std::string_view intent;  ///< such as NIFTI_INTENT_POINTSET
  std::string_view name;    ///< its metadata Name; may be empty
  NumberType type = NumberType::kFloat32;
  std::size_t rows = 0, columns = 1;
  pugi::xml_node node;
};

/// A GIFTI file, version 1.0 ("Gifti Surface Data Format", 2011): ASCII, Base64Binary and
/// GZipBase64Binary, both byte orders, rows or columns first, arrays of one or two dimensions.
/// Positions stay in the array's own space: its CoordinateSystemTransformMatrix is not applied.
/// All errors are Error(kBadFile) with the line. ExternalFileBinary is refused.
class Gifti {
 public:
  explicit Gifti(const Source& source);

  [[nodiscard]] const std::vector<GiftiArray>& arrays() const { return arrays_; }
  /// The first array of an intent; null if there is none.
  [[nodiscard]] const GiftiArray* first(std::string_view intent) const;
  /// The array's numbers, row after row. O(its bytes).
  [[nodiscard]] std::vector<double> numbers(const GiftiArray& array) const;
  [[nodiscard]] pugi::xml_node label_table() const;
  /// The intents of the arrays, for a message; "nothing" for a file without arrays.
  [[nodiscard]] std::string held() const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const;

 private:
  void read_description(const pugi::xml_node& node);
  [[nodiscard]] std::vector<double> read_ascii(const GiftiArray& array,
                                               std::string_view text) const;

  const Source& source_;
  pugi::xml_document document_;
  std::vector<GiftiArray> arrays_;
};

}  // namespace talweg::formats
