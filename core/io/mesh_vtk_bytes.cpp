// VTK's polydata, legacy (binary) and XML (raw): polygons, tagged edges as lines before them, and
// all columns as arrays of points and cells.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/mesh_bytes.hpp"
#include "talweg/core/io/space_note.hpp"

namespace talweg::formats {
namespace {

using Columns = std::vector<const AttributeColumn*>;

/// An array of a file, from one or more columns.
struct ArrayOf {
  std::string name;
  NumberType type = NumberType::kFloat64;
  Columns columns;
};

/// The array whose first column is c; the inverse of column_names() in vtk_faces.cpp.
ArrayOf array_at(const std::vector<AttributeColumn>& columns, std::size_t c) {
  const AttributeColumn& first = columns[c];
  const auto follow = [&](std::span<const std::string_view> names) {
    if (c + names.size() > columns.size()) return false;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const AttributeColumn& column = columns[c + k];
      if (column.name != names[k] || column.type != first.type) return false;
    }
    return true;
  };
  const auto array = [&](std::string name, std::size_t count) {
    ArrayOf result{std::move(name), first.type, {}};
    for (std::size_t k = 0; k < count; ++k) result.columns.push_back(&columns[c + k]);
    return result;
  };
  constexpr std::array<std::string_view, 2> kTexture{"s", "t"};
  const bool real = first.type >= NumberType::kFloat32;
  if (real && follow(kNormals)) return array("Normals", 3);
  if (real && follow(kTexture)) return array("TextureCoordinates", 2);
  const std::span<const std::string_view> rgba(kColours);
  if (first.type == NumberType::kUint8 && follow(rgba)) return array("RGBA", 4);
  if (first.type == NumberType::kUint8 && follow(rgba.first(3))) return array("RGB", 3);
  if (!first.name.ends_with("_0")) return array(first.name, 1);
  const std::string name = first.name.substr(0, first.name.size() - 2);
  std::size_t count = 1;
  while (c + count < columns.size() && columns[c + count].type == first.type &&
         columns[c + count].name == fmt::format("{}_{}", name, count)) {
    ++count;
  }
  return count > 1 && !name.empty() ? array(name, count) : array(first.name, 1);
}

std::vector<ArrayOf> arrays_of(const std::vector<AttributeColumn>& columns) {
  std::vector<ArrayOf> all;
  for (std::size_t c = 0; c < columns.size(); c += all.back().columns.size()) {
    all.push_back(array_at(columns, c));
  }
  return all;
}

/// Appends a number, big-endian if `big`, otherwise little-endian.
template <class T>
void put_as(std::string& bytes, double value, bool big) {
  put(bytes, static_cast<T>(value));
  if (big) std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(sizeof(T)), bytes.end());
}

void put_number(std::string& bytes, NumberType type, double value, bool big) {
  switch (type) {
    case NumberType::kInt8:
      return put_as<std::int8_t>(bytes, value, big);
    case NumberType::kUint8:
      return put_as<std::uint8_t>(bytes, value, big);
    case NumberType::kInt16:
      return put_as<std::int16_t>(bytes, value, big);
    case NumberType::kUint16:
      return put_as<std::uint16_t>(bytes, value, big);
    case NumberType::kInt32:
      return put_as<std::int32_t>(bytes, value, big);
    case NumberType::kUint32:
      return put_as<std::uint32_t>(bytes, value, big);
    case NumberType::kInt64:
      return put_as<std::int64_t>(bytes, value, big);
    case NumberType::kUint64:
      return put_as<std::uint64_t>(bytes, value, big);
    case NumberType::kFloat32:
      return put_as<float>(bytes, value, big);
    case NumberType::kFloat64:
      return put_as<double>(bytes, value, big);
  }
}

/// The contents of both kinds of files, as bytes.
class VtkContent {
 public:
  VtkContent(MeshContent& content, bool big)
      : lists_(content.lists),
        edges_(content.edges),
        big_(big),
        points_(arrays_of(content.attributes.vertices)),
        cells_(arrays_of(content.attributes.faces)) {
    const MeshAttributes& a = content.attributes;
    for (const FaceNames& names : a.names) {
      content.left_out.push_back(fmt::format("names of faces ({})", names.keyword));
    }
    if (a.texture.dimension > 0) content.left_out.emplace_back("texture coordinates of corners");
    if (a.normals.dimension > 0) content.left_out.emplace_back("normals of corners");
    for (const std::string& line : a.references) {
      content.left_out.push_back(fmt::format("'{}'", line));
    }
  }

  [[nodiscard]] const MeshLists& lists() const { return lists_; }
  [[nodiscard]] std::span<const TaggedEdge> edges() const { return edges_; }
  [[nodiscard]] const std::vector<ArrayOf>& points() const { return points_; }
  [[nodiscard]] const std::vector<ArrayOf>& cells() const { return cells_; }
  [[nodiscard]] std::size_t cell_count() const { return edges_.size() + lists_.triangles.size(); }

  [[nodiscard]] std::string coordinates() const {
    std::string bytes;
    bytes.reserve(24 * lists_.points.size());
    for (const Point& p : lists_.points) {
      for (const double x : p) put_as<double>(bytes, x, big_);
    }
    return bytes;
  }
  /// The numbers of an array of points or cells; edges have zeros.
  [[nodiscard]] std::string numbers(const ArrayOf& array, bool of_cells) const {
    std::string bytes;
    const std::size_t before = of_cells ? edges_.size() : 0;
    const std::size_t count = array.columns.front()->values.size();
    bytes.reserve((before + count) * array.columns.size() * size_of(array.type));
    for (std::size_t k = 0; k < before * array.columns.size(); ++k) {
      put_number(bytes, array.type, 0, big_);
    }
    for (std::size_t k = 0; k < count; ++k) {
      for (const AttributeColumn* column : array.columns) {
        put_number(bytes, array.type, column->values[k], big_);
      }
    }
    return bytes;
  }
  /// The curve of each edge; -1 for faces.
  [[nodiscard]] std::string curves() const {
    std::string bytes;
    for (const TaggedEdge& edge : edges_) put_as<std::int32_t>(bytes, edge.curve, big_);
    for (std::size_t f = 0; f < lists_.triangles.size(); ++f) put_as<std::int32_t>(bytes, -1, big_);
    return bytes;
  }

 private:
  const MeshLists& lists_;
  std::span<const TaggedEdge> edges_;
  bool big_;
  std::vector<ArrayOf> points_, cells_;
};

/// Names of types by NumberType.
const char* legacy_name(NumberType type) {
  constexpr std::array<const char*, 10> kNames{
      "char",         "unsigned_char", "short",         "unsigned_short", "int",
      "unsigned_int", "vtktypeint64",  "vtktypeuint64", "float",          "double"};
  return kNames[static_cast<std::size_t>(type)];
}

const char* xml_name(NumberType type) {
  constexpr std::array<const char*, 10> kNames{"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                               "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  return kNames[static_cast<std::size_t>(type)];
}

void put_arrays(std::string& bytes, const VtkContent& content, const std::vector<ArrayOf>& arrays,
                bool of_cells) {
  const std::size_t count = of_cells ? content.cell_count() : content.lists().points.size();
  const bool curves = of_cells && !content.edges().empty();
  if (arrays.empty() && !curves) return;
  bytes += fmt::format("{} {}\nFIELD FieldData {}\n", of_cells ? "CELL_DATA" : "POINT_DATA", count,
                       arrays.size() + (curves ? 1 : 0));
  for (const ArrayOf& array : arrays) {
    bytes += fmt::format("{} {} {} {}\n", array.name, array.columns.size(), count,
                         legacy_name(array.type));
    bytes += content.numbers(array, of_cells) + "\n";
  }
  if (curves) bytes += fmt::format("curve 1 {} int\n{}\n", count, content.curves());
}

/// The parts of an XML file: the tree, and the data that it refers to.
class XmlParts {
 public:
  void array(NumberType type, const std::string& name, std::size_t components,
             const std::string& data) {
    tree += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        xml_name(type), escaped(name), components, appended.size());
    put(appended, static_cast<std::uint64_t>(data.size()));
    appended += data;
  }
  void arrays(const VtkContent& content, const std::vector<ArrayOf>& all, bool of_cells) {
    tree += of_cells ? "<CellData>\n" : "<PointData>\n";
    for (const ArrayOf& a : all) {
      array(a.type, a.name, a.columns.size(), content.numbers(a, of_cells));
    }
    if (of_cells && !content.edges().empty()) {
      array(NumberType::kInt32, "curve", 1, content.curves());
    }
    tree += of_cells ? "</CellData>\n" : "</PointData>\n";
  }

  std::string tree, appended;

 private:
  static std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) {
      text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return text;
  }
};

/// Corners of the cells, and where each cell ends.
void put_cells(XmlParts& parts, const char* kind, const std::string& corners, std::size_t cells,
               std::size_t each) {
  std::string ends;
  ends.reserve(8 * cells);
  for (std::size_t k = 1; k <= cells; ++k) put(ends, static_cast<std::int64_t>(each * k));
  parts.tree += fmt::format("<{}>\n", kind);
  parts.array(NumberType::kUint32, "connectivity", 1, corners);
  parts.array(NumberType::kInt64, "offsets", 1, ends);
  parts.tree += fmt::format("</{}>\n", kind);
}

}  // namespace

std::string vtk_bytes(MeshContent& mesh) {
  const VtkContent content(mesh, true);
  const MeshLists& lists = content.lists();
  std::string bytes = "# vtk DataFile Version 3.0\n";
  bytes += lists.space == PatientSpace::kNotSaid ? "mesh by Talweg\n"
                                                 : space_line("mesh by Talweg. ", lists.space);
  bytes += "BINARY\nDATASET POLYDATA\n";
  bytes += fmt::format("POINTS {} double\n", lists.points.size()) + content.coordinates() + "\n";
  const std::size_t edges = content.edges().size(), faces = lists.triangles.size();
  const auto corner = [&](std::uint32_t v) { put_as<std::int32_t>(bytes, v, true); };
  if (edges > 0) bytes += fmt::format("LINES {} {}\n", edges, 3 * edges);
  for (const TaggedEdge& edge : content.edges()) {
    for (const std::uint32_t v : {2U, edge.from, edge.to}) corner(v);
  }
  bytes += fmt::format("{}POLYGONS {} {}\n", edges > 0 ? "\n" : "", faces, 4 * faces);
  bytes.reserve(bytes.size() + 16 * faces);
  for (const Triangle& t : lists.triangles) {
    for (const std::uint32_t v : {3U, t[0], t[1], t[2]}) corner(v);
  }
  bytes += "\n";
  put_arrays(bytes, content, content.cells(), true);
  put_arrays(bytes, content, content.points(), false);
  return bytes;
}

std::string vtp_bytes(MeshContent& mesh) {
  const VtkContent content(mesh, false);
  const MeshLists& lists = content.lists();
  XmlParts parts;
  parts.arrays(content, content.points(), false);
  parts.arrays(content, content.cells(), true);
  parts.tree += "<Points>\n";
  parts.array(NumberType::kFloat64, "Points", 3, content.coordinates());
  parts.tree += "</Points>\n";
  std::string corners;
  for (const TaggedEdge& edge : content.edges()) {
    put(corners, edge.from);
    put(corners, edge.to);
  }
  if (!corners.empty()) put_cells(parts, "Lines", corners, content.edges().size(), 2);
  corners.clear();
  corners.reserve(12 * lists.triangles.size());
  for (const Triangle& t : lists.triangles) {
    for (const std::uint32_t v : t) put(corners, v);
  }
  put_cells(parts, "Polys", corners, lists.triangles.size(), 3);
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n{}"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n{}</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_{}\n"
      "</AppendedData>\n</VTKFile>\n",
      space_data(lists.space), lists.points.size(), content.edges().size(), lists.triangles.size(),
      parts.tree, parts.appended);
}

}  // namespace talweg::formats
