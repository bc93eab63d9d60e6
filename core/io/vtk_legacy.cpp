#include "talweg/core/io/vtk_legacy.hpp"

#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/percent_escapes.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {
namespace {

/// Legacy files are big-endian.
constexpr bool kSwap = std::endian::native == std::endian::little;

std::optional<NumberType> legacy_type(std::string_view name) {
  struct Name {
    std::string_view name;
    NumberType type;
  };
  static constexpr Name kNames[] = {{"char", NumberType::kInt8},
                                    {"unsigned_char", NumberType::kUint8},
                                    {"short", NumberType::kInt16},
                                    {"unsigned_short", NumberType::kUint16},
                                    {"int", NumberType::kInt32},
                                    {"unsigned_int", NumberType::kUint32},
                                    {"long", NumberType::kInt64},
                                    {"unsigned_long", NumberType::kUint64},
                                    {"vtktypeint64", NumberType::kInt64},
                                    {"vtktypeuint64", NumberType::kUint64},
                                    {"vtktypeint32", NumberType::kInt32},
                                    {"vtktypeuint32", NumberType::kUint32},
                                    {"vtktypeint16", NumberType::kInt16},
                                    {"vtktypeuint16", NumberType::kUint16},
                                    {"vtktypeint8", NumberType::kInt8},
                                    {"vtktypeuint8", NumberType::kUint8},
                                    {"signed_char", NumberType::kInt8},
                                    {"vtktypefloat32", NumberType::kFloat32},
                                    {"vtktypefloat64", NumberType::kFloat64},
                                    {"vtkIdType", NumberType::kInt32},
                                    {"float", NumberType::kFloat32},
                                    {"double", NumberType::kFloat64}};
  for (const Name& known : kNames) {
    if (name == known.name) return known.type;
  }
  return std::nullopt;
}

}  // namespace

VtkLegacy::VtkLegacy(const Source& source, bool any_number)
    : source_(source), scanner_(source.path, source.bytes), any_number_(any_number) {
  constexpr std::string_view kMagic = "# vtk DataFile Version ";
  std::string_view first = scanner_.rest_of_line();
  if (first.substr(0, kMagic.size()) != kMagic) scanner_.fail("expected '# vtk DataFile Version'");
  first.remove_prefix(kMagic.size());
  split_cells_ = !first.empty() && first[0] >= '5';
  scanner_.next_line();
  space_ = space_in(scanner_.rest_of_line());  // the title may name the space
  scanner_.next_line();
  const std::string_view encoding = scanner_.word_on_line();
  if (encoding != "ASCII" && encoding != "BINARY") scanner_.fail("ASCII or BINARY", encoding);
  ascii_ = encoding == "ASCII";
}

std::uint64_t VtkLegacy::read_count() {
  return scanner_.count(scanner_.word_on_line(), "a number of items below 2^32", kMostItems);
}

NumberType VtkLegacy::read_type() {
  const std::string_view name = scanner_.word_on_line();
  const std::optional<NumberType> type = legacy_type(name);
  if (!type) scanner_.fail("a VTK data type", name);
  return *type;
}

std::vector<double> VtkLegacy::read_numbers(std::uint64_t count, NumberType type) {
  scanner_.next_line();
  const std::size_t size = ascii_ ? 1 : size_of(type);
  if (count > (scanner_.remaining() + 1) / size) {
    fail(fmt::format("expected {} numbers, but the file ends earlier", count));
  }
  const auto n = static_cast<std::size_t>(count);
  std::vector<double> numbers(n);
  if (ascii_) {
    for (double& x : numbers) {
      const std::string_view word = scanner_.word();
      if (!any_number_ || !parse(word, x)) x = scanner_.number(word, "a number");
    }
    return numbers;
  }
  if (n > scanner_.remaining() / size) fail("the data ends too early");
  const char* bytes = scanner_.bytes(n * size).data();
  for (std::size_t k = 0; k < n; ++k) numbers[k] = load_number(type, bytes + k * size, kSwap);
  return numbers;
}

std::vector<double> VtkLegacy::read_part(std::string_view name, std::uint64_t n) {
  const std::string_view word = scanner_.word();
  if (word != name) scanner_.fail(std::string(name), word);
  const NumberType type = read_type();
  return read_numbers(n, type);
}

std::vector<VtkLegacy::Array> VtkLegacy::read_fields() {
  scanner_.word_on_line();
  const std::uint64_t count = read_count();
  std::vector<Array> arrays;
  for (std::uint64_t k = 0; k < count; ++k) {
    Array array;
    array.name = without_escapes(scanner_.word());
    while (array.name == "METADATA") {  // of the previous array
      skip_metadata();
      array.name = without_escapes(scanner_.word());
    }
    if (array.name.empty()) scanner_.fail("the name of a field", {});
    array.components = read_count();
    const std::uint64_t tuples = read_count();
    array.type = read_type();
    array.numbers = read_numbers(array.components * tuples, array.type);
    arrays.push_back(std::move(array));
  }
  return arrays;
}

std::vector<VtkLegacy::Array> VtkLegacy::read_attribute(std::string_view kind,
                                                        std::uint64_t count) {
  if (kind == "FIELD") return read_fields();
  if (kind == "SCALARS") return {read_scalars(count)};
  if (kind == "METADATA") {
    skip_metadata();
  } else if (kind == "LOOKUP_TABLE") {
    word_on_line();
    const std::uint64_t n = read_count();
    read_numbers(4 * n, ascii_ ? NumberType::kFloat32 : NumberType::kUint8);
  } else if (kind == "COLOR_SCALARS") {
    Array array{without_escapes(word_on_line()), read_count(), {}, NumberType::kUint8};
    array.numbers =
        read_numbers(array.components * count, ascii_ ? NumberType::kFloat32 : NumberType::kUint8);
    if (ascii_) {  // text has fractions of 1
      for (double& x : array.numbers) x = std::round(255 * x);
    }
    return {std::move(array)};
  } else if (kind == "TEXTURE_COORDINATES") {
    Array array{without_escapes(word_on_line()), read_count(), {}};
    array.type = read_type();
    array.numbers = read_numbers(array.components * count, array.type);
    return {std::move(array)};
  } else if (kind == "VECTORS" || kind == "NORMALS" || kind == "TENSORS") {
    Array array{without_escapes(word_on_line()), kind == "TENSORS" ? 9U : 3U, {}};
    array.type = read_type();
    array.numbers = read_numbers(array.components * count, array.type);
    return {std::move(array)};
  } else {
    fail("SCALARS or FIELD", kind);
  }
  return {};
}

VtkLegacy::Array VtkLegacy::read_scalars(std::uint64_t count) {
  Array array{without_escapes(word_on_line()), 1, {}};
  array.type = read_type();
  const std::string_view given = word_on_line();
  if (given == "2" || given == "3" || given == "4") {
    array.components = static_cast<std::uint64_t>(given[0] - '0');
  } else if (!given.empty() && given != "1") {
    fail("1 to 4 components", given);
  }
  const std::string_view table = word();
  if (table != "LOOKUP_TABLE") fail("LOOKUP_TABLE", table);
  word_on_line();
  array.numbers = read_numbers(array.components * count, array.type);
  return array;
}

void VtkLegacy::skip_metadata() {
  while (scanner_.next_line() &&
         scanner_.rest_of_line().find_first_not_of("\r \t") != std::string_view::npos) {
  }
}

void VtkLegacy::fail(const std::string& what) const {
  if (ascii_) scanner_.fail(what);
  cannot_read(source_.path, fmt::format("byte {}: {}", scanner_.position(), what));
}

}  // namespace talweg::formats
