// VTK's legacy files consist of sections with words, numbers and arrays.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {

/// Reads the header on construction, then the parts that are requested; ascii or binary, versions 1
/// to 5. All errors are Error(kBadFile) with the line, or the byte.
class VtkLegacy {
 public:
  static constexpr std::uint64_t kMostItems = std::numeric_limits<std::uint32_t>::max();

  /// Numbers in text must be finite unless `any_number`; binary numbers may be any.
  explicit VtkLegacy(const Source& source, bool any_number = false);

  /// word() gives the next word on any line, word_on_line() on this line; empty at the end.
  std::string_view word() { return scanner_.word(); }
  std::string_view word_on_line() { return scanner_.word_on_line(); }
  std::uint64_t read_count();
  NumberType read_type();
  /// Reads n numbers, from the next line on.
  std::vector<double> read_numbers(std::uint64_t n, NumberType type);
  /// Reads n numbers after a line with the name of the part and a type.
  std::vector<double> read_part(std::string_view name, std::uint64_t n);
  /// One array of a field: its name, components and numbers.
  struct Array {
    std::string name;
    std::uint64_t components = 0;
    std::vector<double> numbers;
    NumberType type = NumberType::kFloat64;
  };
  /// Reads the arrays of a field, after the word FIELD.
  std::vector<Array> read_fields();
  /// Reads an attribute of `count` points or cells, after the word for its kind (SCALARS, FIELD,
  /// ...): the arrays that have a name.
  std::vector<Array> read_attribute(std::string_view kind, std::uint64_t count);
  /// Skips to the next blank line.
  void skip_metadata();

  /// The space of the coordinates that the title names (space_note.hpp).
  [[nodiscard]] PatientSpace space() const { return space_; }
  [[nodiscard]] bool is_ascii() const { return ascii_; }
  /// Whether cells have separate offsets and connectivity, as since version 5.
  [[nodiscard]] bool splits_cells() const { return split_cells_; }
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
    scanner_.fail(expected, found);
  }

 private:
  Array read_scalars(std::uint64_t count);
  const Source& source_;
  WordScanner scanner_;
  bool any_number_ = false;
  bool ascii_ = true;
  bool split_cells_ = false;
  PatientSpace space_ = PatientSpace::kNotSaid;
};

}  // namespace talweg::formats
