#include "talweg/core/io/vtk_xml.hpp"

#include <bit>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/number_text.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"
#include "talweg/core/io/xml_text.hpp"

namespace talweg::formats {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 31U;

std::optional<NumberType> xml_type(std::string_view name) {
  static constexpr std::string_view kNames[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                                "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  for (std::size_t k = 0; k < std::size(kNames); ++k) {
    if (name == kNames[k]) return static_cast<NumberType>(k);
  }
  return std::nullopt;
}

}  // namespace

VtkXml::VtkXml(const Source& source) : source_(source) {
  parse();
  const pugi::xml_node root = document_.child("VTKFile");
  if (!root || std::string_view(root.attribute("type").value()) != "PolyData") {
    fail(root, "expected <VTKFile type=\"PolyData\">");
  }
  read_encoding(root);
}

/// Raw appended data is not XML, so it is cut out first.
void VtkXml::parse() {
  xml_ = source_.bytes;
  const std::size_t tag = xml_.find("<AppendedData");
  if (tag != xml_.npos) {
    const std::size_t start = xml_.find('>', tag);
    const std::size_t underscore = start == xml_.npos ? start : xml_.find('_', start);
    if (underscore == xml_.npos) {
      cannot_read(source_.path, fmt::format("line {}: expected '_' in <AppendedData>",
                                            line_of(source_.bytes, tag)));
    }
    encoding_.appended = source_.bytes.substr(underscore + 1);
    const std::size_t end = encoding_.appended.rfind("</AppendedData");
    encoding_.appended = encoding_.appended.substr(0, end);
    const std::string_view opening(source_.bytes.data() + tag, start - tag);
    encoding_.appended_base64 = opening.find("base64") != opening.npos;
    xml_.resize(tag);
    xml_ += "</VTKFile>";
  }
  load_xml(document_, source_.path, xml_);
}

void VtkXml::read_encoding(const pugi::xml_node& root) {
  const std::string_view order = root.attribute("byte_order").as_string("LittleEndian");
  const std::string_view header = root.attribute("header_type").as_string("UInt32");
  const std::string_view compressor = root.attribute("compressor").value();
  if (order != "LittleEndian" && order != "BigEndian") {
    fail(root, "expected the byte_order LittleEndian or BigEndian");
  }
  if (header != "UInt32" && header != "UInt64") {
    fail(root, "expected the header_type UInt32 or UInt64");
  }
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
    fail(root, "only vtkZLibDataCompressor is read, not '" + printable(compressor) +
                   "': save the file with zlib or no compression");
  }
  encoding_.swap = (order == "BigEndian") != (std::endian::native == std::endian::big);
  encoding_.wide_header = header == "UInt64";
  encoding_.compressed = !compressor.empty();
}

pugi::xml_node VtkXml::named(const pugi::xml_node& among, const char* name) const {
  const pugi::xml_node array = among.find_child_by_attribute("DataArray", "Name", name);
  if (!array) fail(among, fmt::format("expected a <DataArray Name=\"{}\">", name));
  return array;
}

PatientSpace VtkXml::space() const {
  const pugi::xml_node data = document_.child("VTKFile").child("PolyData").child("FieldData");
  const pugi::xml_node array = data.find_child_by_attribute("Array", "Name", "SPACE");
  if (!array) return PatientSpace::kNotSaid;
  std::string note = "SPACE=";
  for (const double code : read_array(array)) {
    if (code > 0 && code < 128) note += static_cast<char>(code);
  }
  return space_in(note);
}

std::optional<NumberType> VtkXml::number_type(const pugi::xml_node& array) {
  return xml_type(array.attribute("type").value());
}

std::vector<double> VtkXml::read_array(const pugi::xml_node& array) const {
  const std::string_view format = array.attribute("format").as_string("ascii");
  // A string is stored as the codes of its letters, with 0 at the end.
  const bool is_text = std::string_view(array.attribute("type").value()) == "String";
  const auto type = is_text ? NumberType::kInt8 : number_type(array);
  if (!type) fail(array, "expected a type such as Float64 or Int32");
  if (format == "ascii") return read_ascii(array);
  if (format != "binary" && format != "appended") {
    fail(array, "expected the format ascii, binary or appended");
  }
  std::string_view stored(array.child_value());
  if (format == "appended") {
    const std::uint64_t offset = array.attribute("offset").as_ullong();
    if (offset >= encoding_.appended.size()) fail(array, "its offset is beyond the appended data");
    stored = encoding_.appended.substr(static_cast<std::size_t>(offset));
  }
  try {
    const bool base64 = format == "binary" || encoding_.appended_base64;
    const std::string block = decoded_block(encoding_, stored, base64);
    // Arrays may name the same data any number of times.
    unpacked_ += block.size();
    if (unpacked_ > kMostBytes) {
      throw std::runtime_error("the arrays unpack to more than 2 GiB together");
    }
    return numbers_of(block, *type, encoding_.swap);
  } catch (const std::runtime_error& error) {
    fail(array, error.what());
  }
}

std::vector<double> VtkXml::read_ascii(const pugi::xml_node& array) const {
  WordScanner scanner(source_.path, array.child_value());
  std::vector<double> numbers;
  for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
    double value = 0;
    const char* end = word.data() + word.size();
    const auto parsed = from_text(word.data(), end, value);
    if (parsed.ec == std::errc::invalid_argument || parsed.ptr != end) {
      fail(array, "expected a number, found '" + printable(word) + "'");
    }
    if (parsed.ec != std::errc{}) static_cast<void>(talweg::parse(word, value));  // 1e-400 is 0
    numbers.push_back(value);
  }
  return numbers;
}

void VtkXml::fail(const pugi::xml_node& node, const std::string& what) const {
  const std::ptrdiff_t offset = node ? node.offset_debug() : 0;
  const std::size_t at = offset > 0 ? static_cast<std::size_t>(offset) : 0;
  cannot_read(source_.path,
              fmt::format("line {}, <{}>: {}", line_of(xml_, at), printable(node.name()), what));
}

}  // namespace talweg::formats
