#include "talweg/core/io/ply_header.hpp"

#include <map>

#include "talweg/core/io/line_scanner.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg {
namespace {

NumberType read_type(LineScanner& lines) {
  static const std::map<std::string_view, NumberType> kTypes{
      {"char", NumberType::kInt8},      {"int8", NumberType::kInt8},
      {"uchar", NumberType::kUint8},    {"uint8", NumberType::kUint8},
      {"short", NumberType::kInt16},    {"int16", NumberType::kInt16},
      {"ushort", NumberType::kUint16},  {"uint16", NumberType::kUint16},
      {"int", NumberType::kInt32},      {"int32", NumberType::kInt32},
      {"uint", NumberType::kUint32},    {"uint32", NumberType::kUint32},
      {"float", NumberType::kFloat32},  {"float32", NumberType::kFloat32},
      {"double", NumberType::kFloat64}, {"float64", NumberType::kFloat64}};
  const std::string_view word = lines.word();
  const auto found = kTypes.find(word);
  if (found == kTypes.end()) lines.fail(quoted(word) + " is not a PLY number type.");
  return found->second;
}

PlyEncoding read_encoding(LineScanner& lines) {
  const std::string_view word = lines.word();
  if (word == "ascii") return PlyEncoding::kText;
  if (word == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (word == "binary_big_endian") return PlyEncoding::kBigEndian;
  lines.fail(quoted(word) + " is not a PLY encoding.");
}

PlyProperty read_property(LineScanner& lines) {
  PlyProperty property;
  LineScanner ahead = lines;
  property.is_list = ahead.word() == "list";
  if (property.is_list) {
    lines.word();
    property.count_type = read_type(lines);
    if (property.count_type >= NumberType::kFloat32) {
      lines.fail("the length of a list must be a whole number.");
    }
  }
  property.type = read_type(lines);
  property.name = printable(lines.word());
  return property;
}

/// A comment may name a file of textures, or the space of the coordinates.
void read_comment(LineScanner& lines, std::string_view keyword, PlyHeader& header) {
  std::string_view word = lines.word();
  if (word == "TextureFile" && keyword == "comment") {
    header.textures.push_back("comment TextureFile " + printable(lines.word()));
    return;
  }
  for (; !word.empty(); word = lines.word()) {
    const PatientSpace space = formats::space_in(word);
    if (space != PatientSpace::kNotSaid) header.space = space;
  }
}

}  // namespace

PlyHeader read_ply_header(const MeshFile& file) {
  LineScanner lines(file);
  lines.need_line("the word ply");
  if (lines.line() != 1 || lines.word() != "ply") {
    lines.fail("expected the word ply at the beginning of the file.");
  }
  PlyHeader header;
  bool has_format = false;
  while (true) {
    lines.need_line("the header's end (end_header)");
    const std::string_view keyword = lines.word();
    if (keyword == "end_header") break;
    if (keyword == "format") {
      header.encoding = read_encoding(lines);
      has_format = true;
    } else if (keyword == "element") {
      PlyElement element;
      element.name = printable(lines.word());  // printable, because errors name it
      const std::int64_t count = lines.integer("the number of elements");
      if (count < 0) lines.fail("the number of elements is negative.");
      element.count = static_cast<std::size_t>(count);
      header.elements.push_back(element);
    } else if (keyword == "property") {
      if (header.elements.empty()) lines.fail("a property comes before its element.");
      header.elements.back().properties.push_back(read_property(lines));
    } else if (keyword == "comment" || keyword == "obj_info") {
      read_comment(lines, keyword, header);
    } else {
      lines.fail(quoted(keyword) + " is not a word of a PLY header.");
    }
  }
  if (!has_format) bad_file(file.path, "the PLY header names no format.");
  header.body = lines.offset();
  header.lines = lines.line();
  return header;
}

}  // namespace talweg
