// PLY, binary: positions, corners, and all columns in their types.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "talweg/core/io/mesh_bytes.hpp"
#include "talweg/core/io/space_note.hpp"

namespace talweg::formats {
namespace {

const char* ply_name(NumberType type) {
  switch (type) {
    case NumberType::kInt8:
      return "char";
    case NumberType::kUint8:
      return "uchar";
    case NumberType::kInt16:
      return "short";
    case NumberType::kUint16:
      return "ushort";
    case NumberType::kInt32:
      return "int";
    case NumberType::kUint32:
      return "uint";
    case NumberType::kFloat32:
      return "float";
    default:
      return "double";
  }
}

void put_number(std::string& bytes, NumberType type, double value) {
  switch (type) {
    case NumberType::kInt8:
      return put(bytes, static_cast<std::int8_t>(value));
    case NumberType::kUint8:
      return put(bytes, static_cast<std::uint8_t>(value));
    case NumberType::kInt16:
      return put(bytes, static_cast<std::int16_t>(value));
    case NumberType::kUint16:
      return put(bytes, static_cast<std::uint16_t>(value));
    case NumberType::kInt32:
      return put(bytes, static_cast<std::int32_t>(value));
    case NumberType::kUint32:
      return put(bytes, static_cast<std::uint32_t>(value));
    case NumberType::kFloat32:
      return put(bytes, static_cast<float>(value));
    default:
      return put(bytes, value);
  }
}

/// Normals of corners as three columns of vertices; none if a vertex has several normals.
std::vector<AttributeColumn> normals_of_vertices(const MeshLists& lists,
                                                 const CornerAttribute& normals) {
  constexpr std::uint32_t kNone = CornerAttribute::kNone;
  std::vector<std::uint32_t> of_vertex(lists.points.size(), kNone);
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t own = normals.corners[f][k];
      std::uint32_t& there = of_vertex[lists.triangles[f][k]];
      if (own != kNone && there != kNone && own != there) return {};
      if (own != kNone) there = own;
    }
  }
  std::vector<AttributeColumn> columns;
  for (std::size_t d = 0; d < 3; ++d) {
    AttributeColumn& column = columns.emplace_back();
    column.name = kNormals[d];
    for (const std::uint32_t n : of_vertex) {
      column.values.push_back(n == kNone ? 0 : normals.values[3 * std::size_t{n} + d]);
    }
  }
  return columns;
}

class PlyWriter {
 public:
  explicit PlyWriter(MeshContent& content)
      : content_(content), lists_(content.lists), attributes_(content.attributes) {
    for (const AttributeColumn& column : attributes_.vertices) vertices_.push_back(&column);
    for (std::size_t f = 0; f < content.face_count() && content.outlines != nullptr; ++f) {
      long_lists_ |= content.outlines->face(f).size() > 255 / 2;
    }
    if (attributes_.normals.dimension == 0) return;
    normals_ = normals_of_vertices(lists_, attributes_.normals);
    for (const AttributeColumn& column : normals_) vertices_.push_back(&column);
    if (normals_.empty()) content_.left_out.emplace_back("normals that differ between corners");
  }

  std::string bytes() {
    header();
    bytes_.reserve(bytes_.size() + (24 + 8 * vertices_.size()) * lists_.points.size() +
                   (13 + 8 * attributes_.faces.size()) * lists_.triangles.size());
    for (std::size_t v = 0; v < lists_.points.size(); ++v) {
      for (const double x : lists_.points[v]) put(bytes_, x);
      for (const AttributeColumn* column : vertices_) {
        put_number(bytes_, column->type, column->values[v]);
      }
    }
    for (std::size_t f = 0; f < content_.face_count(); ++f) face(f);
    for (const TaggedEdge& edge : content_.edges) {
      put(bytes_, edge.from);
      put(bytes_, edge.to);
      put(bytes_, edge.curve);
    }
    return std::move(bytes_);
  }

 private:
  void header() {
    bytes_ = "ply\nformat binary_little_endian 1.0\n" + space_line("comment ", lists_.space);
    for (const std::string& line : attributes_.references) {
      if (line.starts_with("comment ")) {
        bytes_ += line + "\n";
      } else {
        content_.left_out.push_back(fmt::format("'{}'", line));
      }
    }
    for (const FaceNames& names : attributes_.names) {
      content_.left_out.push_back(fmt::format("names of faces ({})", names.keyword));
    }
    const char* const index = lists_.points.size() <= 0x80000000U ? "int" : "uint";
    const auto property = [this](const AttributeColumn& column) {
      bytes_ += fmt::format("property {} {}\n", ply_name(column.type), column.name);
    };
    bytes_ +=
        fmt::format("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
                    lists_.points.size());
    for (const AttributeColumn* column : vertices_) property(*column);
    // Some readers do not know uint, and few readers expect lists with more than 255 entries.
    const char* const length = long_lists_ ? "int" : "uchar";
    bytes_ += fmt::format("element face {}\nproperty list {} {} vertex_indices\n",
                          content_.face_count(), length, index);
    if (attributes_.texture.dimension > 0) {
      bytes_ += fmt::format("property list {} float texcoord\n", length);
    }
    for (const AttributeColumn& column : attributes_.faces) property(column);
    if (!content_.edges.empty()) {
      bytes_ += fmt::format(
          "element edge {}\nproperty {} vertex1\nproperty {} vertex2\n"
          "property int curve\n",
          content_.edges.size(), index, index);
    }
    bytes_ += "end_header\n";
  }

  void face(std::size_t f) {
    const auto corners = content_.face(f, own_);
    put_length(corners.size());
    for (const PolygonCorner& at : corners) put(bytes_, content_.vertex(at));
    if (attributes_.texture.dimension > 0) {
      put_length(2 * corners.size());
      for (const PolygonCorner& at : corners) {
        const std::uint32_t c = attributes_.texture.corners[at.triangle][at.corner];
        for (std::size_t d = 0; d < 2; ++d) {
          const bool none = c == CornerAttribute::kNone;
          put(bytes_,
              none ? 0.0F : static_cast<float>(attributes_.texture.values[2 * std::size_t{c} + d]));
        }
      }
    }
    for (const AttributeColumn& column : attributes_.faces) {
      put_number(bytes_, column.type, column.values[corners.front().triangle]);
    }
  }

  void put_length(std::size_t n) {
    if (long_lists_) {
      put(bytes_, static_cast<std::int32_t>(n));
    } else {
      put(bytes_, static_cast<std::uint8_t>(n));
    }
  }

  MeshContent& content_;
  const MeshLists& lists_;
  const MeshAttributes& attributes_;
  std::vector<AttributeColumn> normals_;
  std::vector<const AttributeColumn*> vertices_;
  bool long_lists_ = false;
  std::array<PolygonCorner, 3> own_;
  std::string bytes_;
};

}  // namespace

std::string ply_bytes(MeshContent& content) { return PlyWriter(content).bytes(); }

}  // namespace talweg::formats
