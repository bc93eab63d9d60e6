#include "talweg/core/io/gifti.hpp"

#include <bit>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/packed_bytes.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/vtk_data_array.hpp"
#include "talweg/core/io/word_scanner.hpp"
#include "talweg/core/io/xml_text.hpp"

namespace talweg::formats {
namespace {

std::optional<NumberType> nifti_type(std::string_view name) {
  static constexpr std::string_view kNames[] = {"INT8",   "UINT8", "INT16",  "UINT16",  "INT32",
                                                "UINT32", "INT64", "UINT64", "FLOAT32", "FLOAT64"};
  for (std::size_t k = 0; k < std::size(kNames); ++k) {
    if (name.starts_with("NIFTI_TYPE_") && name.substr(11) == kNames[k]) {
      return static_cast<NumberType>(k);
    }
  }
  return std::nullopt;
}

std::string_view name_of(const pugi::xml_node& array) {
  for (const pugi::xml_node entry : array.child("MetaData").children("MD")) {
    if (std::string_view(entry.child_value("Name")) == "Name") return entry.child_value("Value");
  }
  return "";
}

/// Reorders numbers from column after column to row after row.
std::vector<double> by_rows(const std::vector<double>& stored, std::size_t rows) {
  std::vector<double> numbers;
  numbers.reserve(stored.size());
  const std::size_t columns = rows == 0 ? 0 : stored.size() / rows;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) numbers.push_back(stored[j * rows + i]);
  }
  return numbers;
}

}  // namespace

Gifti::Gifti(const Source& source) : source_(source) {
  load_xml(document_, source.path, source.bytes);
  const pugi::xml_node root = document_.child("GIFTI");
  if (!root) fail(root, "expected <GIFTI>");
  for (const pugi::xml_node node : root.children("DataArray")) read_description(node);
}

void Gifti::read_description(const pugi::xml_node& node) {
  GiftiArray array;
  array.intent = node.attribute("Intent").value();
  array.name = name_of(node);
  array.node = node;
  const std::string_view name = node.attribute("DataType").value();
  const auto type = nifti_type(name);
  if (!type) {
    fail(node, fmt::format("expected a DataType such as NIFTI_TYPE_FLOAT32, found '{}'",
                           printable(name)));
  }
  array.type = *type;
  const unsigned dimensions = node.attribute("Dimensionality").as_uint();
  if (dimensions != 1 && dimensions != 2) {
    fail(node, fmt::format("expected the Dimensionality 1 or 2, found {}", dimensions));
  }
  const auto length = [&](const char* key) {
    const std::int64_t given = node.attribute(key).as_llong(-1);
    if (given < 0 || given > std::int64_t{1} << 32U) {
      fail(node, fmt::format("expected a number of elements as {}", key));
    }
    return static_cast<std::size_t>(given);
  };
  array.rows = length("Dim0");
  if (dimensions == 2) array.columns = length("Dim1");
  arrays_.push_back(array);
}

const GiftiArray* Gifti::first(std::string_view intent) const {
  for (const GiftiArray& array : arrays_) {
    if (array.intent == intent) return &array;
  }
  return nullptr;
}

pugi::xml_node Gifti::label_table() const {
  const pugi::xml_node root = document_.child("GIFTI");
  const pugi::xml_node table = root.child("LabelTable");
  return table ? table : root.child("DataArray").child("LabelTable");
}

std::string Gifti::held() const {
  std::string all;
  for (const GiftiArray& array : arrays_) {
    if (all.size() < 100) {
      all += fmt::format("{}{} of {} x {}", all.empty() ? "" : ", ", printable(array.intent),
                         array.rows, array.columns);
    }
  }
  return all.empty() ? "nothing" : all;
}

std::vector<double> Gifti::numbers(const GiftiArray& array) const {
  const std::string_view encoding = array.node.attribute("Encoding").value();
  const std::string_view text = array.node.child_value("Data");
  const std::size_t count = array.rows * array.columns;
  if (array.columns != 0 && count / array.columns != array.rows) {
    fail(array.node, "it has more numbers than can be counted");
  }
  std::vector<double> result;
  if (encoding == "ASCII") {
    result = read_ascii(array, text);
  } else if (encoding == "Base64Binary" || encoding == "GZipBase64Binary") {
    const std::string_view order = array.node.attribute("Endian").as_string("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian") {
      fail(array.node, "expected the Endian LittleEndian or BigEndian");
    }
    const bool swap = (order == "BigEndian") == (std::endian::native == std::endian::little);
    try {
      std::string bytes = from_base64(text);
      // More bytes than the largest file that is read.
      if (count > (std::size_t{1} << 31U)) throw std::runtime_error("the data ends too early");
      const std::size_t size = count * size_of(array.type);
      if (encoding.front() == 'G') bytes = unpacked(bytes, size);
      if (bytes.size() != size) {
        throw std::runtime_error(
            fmt::format("expected {} bytes of data, found {}", size, bytes.size()));
      }
      result = numbers_of(bytes, array.type, swap);
    } catch (const std::runtime_error& error) {
      fail(array.node, error.what());
    }
  } else if (encoding == "ExternalFileBinary") {
    fail(array.node,
         "its numbers are in another file (ExternalFileBinary), which is not read: save it with "
         "the encoding GZipBase64Binary");
  } else {
    fail(array.node, "expected the Encoding ASCII, Base64Binary or GZipBase64Binary, found '" +
                         printable(encoding) + "'");
  }
  const std::string_view order = array.node.attribute("ArrayIndexingOrder").value();
  const bool by_columns = order == "ColumnMajorOrder";
  return by_columns && array.columns > 1 ? by_rows(result, array.rows) : result;
}

std::vector<double> Gifti::read_ascii(const GiftiArray& array, std::string_view text) const {
  WordScanner words(source_.path, text);
  std::vector<double> result;
  const std::size_t count = array.rows * array.columns;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    double value = 0;
    if (!parse(word, value)) fail(array.node, "expected a number, found '" + printable(word) + "'");
    result.push_back(value);
  }
  if (result.size() != count) {
    fail(array.node, fmt::format("expected {} numbers, found {}", count, result.size()));
  }
  return result;
}

void Gifti::fail(const pugi::xml_node& node, const std::string& what) const {
  const std::ptrdiff_t offset = node ? node.offset_debug() : 0;
  const std::size_t at = offset > 0 ? static_cast<std::size_t>(offset) : 0;
  cannot_read(source_.path, fmt::format("line {}, <{}>: {}", line_of(source_.bytes, at),
                                        printable(node.name()), what));
}

}  // namespace talweg::formats
