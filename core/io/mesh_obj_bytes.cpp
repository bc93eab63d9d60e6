// Wavefront OBJ: positions and corners, with colours, texture coordinates, normals, names of faces
// and lines.
#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "talweg/core/io/mesh_bytes.hpp"
#include "talweg/core/io/space_note.hpp"

namespace talweg::formats {
namespace {

using Columns = std::vector<const AttributeColumn*>;

/// The value of a colour component at full intensity.
double full(NumberType type) {
  if (type == NumberType::kUint8) return 255;
  return type == NumberType::kUint16 ? 65535 : 1;
}

class ObjWriter {
 public:
  explicit ObjWriter(MeshContent& content)
      : content_(content), lists_(content.lists), attributes_(content.attributes) {
    colours_ = columns({"red", "green", "blue"});
    normals_ = columns({kNormals[0], kNormals[1], kNormals[2]});
    texture_ = columns({"s", "t"});
    if (texture_.empty()) texture_ = columns({"u", "v"});
    if (texture_.empty()) texture_ = columns({"texture_u", "texture_v"});
    if (attributes_.normals.dimension > 0) normals_.clear();
    if (attributes_.texture.dimension > 0) texture_.clear();
    say_what_is_left_out();
  }

  std::string bytes() {
    text_ = space_line("# ", lists_.space);
    for (const std::string& line : attributes_.references) {
      if (line.starts_with("mtllib")) text_ += line + "\n";
    }
    const auto out = std::back_inserter(text_);
    for (std::size_t v = 0; v < lists_.points.size(); ++v) {
      const Point& p = lists_.points[v];
      fmt::format_to(out, "v {} {} {}", p.x(), p.y(), p.z());
      for (const AttributeColumn* c : colours_) {
        fmt::format_to(out, " {}", c->values[v] / full(c->type));
      }
      text_ += '\n';
    }
    corner_values("vt", attributes_.texture, texture_);
    corner_values("vn", attributes_.normals, normals_);
    for (std::size_t f = 0; f < content_.face_count(); ++f) face(f);
    for (const TaggedEdge& edge : content_.edges) {
      fmt::format_to(out, "l {} {}\n", std::uint64_t{edge.from} + 1, std::uint64_t{edge.to} + 1);
    }
    return std::move(text_);
  }

 private:
  /// The columns with these names; empty if a column is missing.
  [[nodiscard]] Columns columns(std::initializer_list<std::string_view> names) const {
    Columns found;
    for (const std::string_view name : names) {
      const auto at = std::find_if(attributes_.vertices.begin(), attributes_.vertices.end(),
                                   [&](const AttributeColumn& c) { return c.name == name; });
      if (at == attributes_.vertices.end()) return {};
      found.push_back(&*at);
    }
    return found;
  }

  void say_what_is_left_out() {
    for (const AttributeColumn& column : attributes_.vertices) {
      const auto has = [&](const Columns& of) {
        return std::find(of.begin(), of.end(), &column) != of.end();
      };
      if (has(colours_) || has(normals_) || has(texture_)) continue;
      content_.left_out.push_back(fmt::format("'{}' of vertices", column.name));
    }
    for (const AttributeColumn& column : attributes_.faces) {
      content_.left_out.push_back(fmt::format("'{}' of faces", column.name));
    }
    for (const std::string& line : attributes_.references) {
      if (!line.starts_with("mtllib")) content_.left_out.push_back(fmt::format("'{}'", line));
    }
  }

  void corner_values(const char* keyword, const CornerAttribute& of_corners, const Columns& of) {
    const auto out = std::back_inserter(text_);
    for (std::size_t i = 0; i < of_corners.values.size(); i += of_corners.dimension) {
      text_ += keyword;
      for (std::size_t d = 0; d < of_corners.dimension; ++d) {
        fmt::format_to(out, " {}", of_corners.values[i + d]);
      }
      text_ += '\n';
    }
    if (of.empty()) return;
    for (std::size_t v = 0; v < lists_.points.size(); ++v) {
      text_ += keyword;
      for (const AttributeColumn* c : of) {
        // Writes the digits of the type: 0.1, not 0.10000000149.
        if (c->type == NumberType::kFloat32) {
          fmt::format_to(out, " {}", static_cast<float>(c->values[v]));
        } else {
          fmt::format_to(out, " {}", c->values[v]);
        }
      }
      text_ += '\n';
    }
  }

  /// Writes "o", "g", "usemtl" and "s" where they change.
  void names(std::uint32_t triangle) {
    for (const FaceNames& names : attributes_.names) {
      const std::uint32_t now = names.of_face[triangle];
      if (now == (last_ == kNoTriangle ? 0 : names.of_face[last_])) continue;
      if (now > 0) {
        text_ += names.keyword + " " + names.names[now] + "\n";
      } else if (names.keyword == "g") {
        text_ += "g default\n";
      } else if (names.keyword == "s") {
        text_ += "s off\n";
      }  // the format cannot return to no object or no material
    }
    last_ = triangle;
  }

  /// The index of the entry of a corner; kNone if the corner has no entry.
  [[nodiscard]] std::uint32_t entry(const PolygonCorner& at, const CornerAttribute& of_corners,
                                    const Columns& of) const {
    if (!of.empty()) return content_.vertex(at);
    if (of_corners.dimension == 0) return CornerAttribute::kNone;
    return of_corners.corners[at.triangle][at.corner];
  }

  void face(std::size_t f) {
    constexpr std::uint32_t kNone = CornerAttribute::kNone;
    const auto corners = content_.face(f, own_);
    names(corners.front().triangle);
    const auto out = std::back_inserter(text_);
    // Either all corners of a face have the attribute, or none has.
    const auto have = [&](const CornerAttribute& of_corners, const Columns& of) {
      return std::all_of(corners.begin(), corners.end(), [&](const PolygonCorner& at) {
        return entry(at, of_corners, of) != kNone;
      });
    };
    const bool texture = have(attributes_.texture, texture_);
    const bool normals = have(attributes_.normals, normals_);
    text_ += 'f';
    for (const PolygonCorner& at : corners) {
      fmt::format_to(out, " {}", std::uint64_t{content_.vertex(at)} + 1);
      if (texture) {
        fmt::format_to(out, "/{}", std::uint64_t{entry(at, attributes_.texture, texture_)} + 1);
      }
      if (normals) {
        fmt::format_to(out, "{}{}", texture ? "/" : "//",
                       std::uint64_t{entry(at, attributes_.normals, normals_)} + 1);
      }
    }
    text_ += '\n';
  }

  static constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFU;
  MeshContent& content_;
  const MeshLists& lists_;
  const MeshAttributes& attributes_;
  Columns colours_, normals_, texture_;
  std::uint32_t last_ = kNoTriangle;  // last triangle whose names were written
  std::array<PolygonCorner, 3> own_;
  std::string text_;
};

}  // namespace

std::string obj_bytes(MeshContent& content) { return ObjWriter(content).bytes(); }

}  // namespace talweg::formats
