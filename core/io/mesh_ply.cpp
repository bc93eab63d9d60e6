// PLY, text and binary: vertex positions and face corners; on request the other numbers of vertices
// and faces.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "talweg/core/io/line_scanner.hpp"
#include "talweg/core/io/ply_header.hpp"
#include "talweg/core/io/triangle_strips.hpp"

namespace talweg {
namespace {

constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);
constexpr std::string_view kStrips = "tristrips";

std::size_t property_index(const PlyElement& element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name == name) return i;
  }
  return kAbsent;
}

std::string numbered(const PlyElement& element, std::size_t index) {
  return element.name + " " + std::to_string(index) + " of " + std::to_string(element.count);
}

/// The columns for an element's numbers other than coordinates and corners.
struct Columns {
  std::vector<std::size_t> of_property;  ///< per property its column; kAbsent: not stored
  std::vector<AttributeColumn>* into = nullptr;
  [[nodiscard]] std::size_t at(std::size_t property) const {
    return of_property.empty() ? kAbsent : of_property[property];
  }
};

/// The elements and properties to read.
struct Plan {
  PlyHeader header;
  std::size_t vertices = 0;
  std::array<std::size_t, 3> coordinate{kAbsent, kAbsent, kAbsent};  ///< properties of a vertex
  std::size_t corners = kAbsent;  ///< property of a face or a strip
  std::size_t texture = kAbsent;  ///< property of a face: texture coordinates of its corners
  Columns vertex_columns, face_columns;
  MeshAttributes* attributes = nullptr;
};

void plan_vertices(const MeshFile& file, const PlyElement& element, Plan& plan) {
  plan.vertices = element.count;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string name(1, "xyz"[k]);
    plan.coordinate[k] = property_index(element, name);
    if (plan.coordinate[k] == kAbsent || element.properties[plan.coordinate[k]].is_list) {
      bad_file(file.path, "the vertices have no coordinate " + name + ".");
    }
  }
}

void plan_corners(const MeshFile& file, const PlyElement& element, Plan& plan) {
  plan.corners = property_index(element, "vertex_indices");
  if (plan.corners == kAbsent) plan.corners = property_index(element, "vertex_index");
  if (plan.corners == kAbsent || !element.properties[plan.corners].is_list) {
    bad_file(file.path, fmt::format("the {} have no list vertex_indices.",
                                    element.name == "face" ? "faces" : "triangle strips"));
  }
  if (element.properties[plan.corners].type >= NumberType::kFloat32) {
    bad_file(file.path, "the list vertex_indices must hold whole numbers.");
  }
}

Plan make_plan(const MeshFile& file) {
  Plan plan;
  plan.header = read_ply_header(file);
  std::size_t vertex_elements = 0, face_elements = 0, strip_elements = 0, faces = 0;
  for (const PlyElement& element : plan.header.elements) {
    if (element.name == "vertex") {
      ++vertex_elements;
      plan_vertices(file, element, plan);
    } else if (element.name == "face") {
      ++face_elements;
      faces += element.count;
      if (strip_elements == 0) plan_corners(file, element, plan);
    } else if (element.name == kStrips && element.count > 0) {
      ++strip_elements;
      plan_corners(file, element, plan);
    }
  }
  if (vertex_elements != 1 || face_elements > 1) {
    bad_file(file.path, "the PLY header must announce vertices once and faces at most once.");
  }
  if (strip_elements > 1 || (strip_elements == 1 && faces > 0)) {
    bad_file(file.path, "the PLY header must announce either faces or triangle strips, and once.");
  }
  return plan;
}

/// Makes columns for the numbers of an element, at most 64. The numbers of a polygon are stored
/// once per triangle of its fan, so without a limit a short file could fill the memory.
Columns make_columns(const PlyElement& element, std::span<const std::size_t> taken,
                     std::vector<AttributeColumn>& into, std::vector<std::string>& left_out) {
  constexpr std::size_t kMost = 64;
  Columns columns{std::vector<std::size_t>(element.properties.size(), kAbsent), &into};
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (std::find(taken.begin(), taken.end(), i) != taken.end()) continue;
    if (property.is_list || property.name.empty() || into.size() >= kMost ||
        property_index(element, property.name) != i) {
      if (left_out.size() < kMost) {
        left_out.push_back(fmt::format("{} '{}' of element '{}'",
                                       property.is_list ? "list" : "property", property.name,
                                       element.name));
      }
      continue;
    }
    columns.of_property[i] = into.size();
    into.push_back({property.name, property.type, {}});
  }
  return columns;
}

void plan_attributes(MeshAttributes& attributes, Plan& plan) {
  plan.attributes = &attributes;
  attributes.references = plan.header.textures;
  for (const PlyElement& element : plan.header.elements) {
    if (element.name == "vertex") {
      plan.vertex_columns =
          make_columns(element, plan.coordinate, attributes.vertices, attributes.left_out);
    } else if (element.name == "face" && element.count > 0) {
      plan.texture = property_index(element, "texcoord");
      if (plan.texture != kAbsent && !element.properties[plan.texture].is_list)
        plan.texture = kAbsent;
      const std::array<std::size_t, 2> taken{plan.corners, plan.texture};
      plan.face_columns = make_columns(element, taken, attributes.faces, attributes.left_out);
    } else if (element.count > 0 && element.name != kStrips) {
      attributes.left_out.push_back(fmt::format("element '{}'", element.name));
    }
  }
}

/// Collects the numbers of one face and repeats them for each of its triangles.
class FaceNumbers {
 public:
  FaceNumbers(const Plan& plan, const MeshLists& lists)
      : plan_(plan), lists_(lists), values_(plan.attributes ? plan.attributes->faces.size() : 0) {}
  void set(std::size_t column, double value) { values_[column] = value; }
  std::vector<double>& texture() { return texture_; }
  void end() {
    if (plan_.attributes == nullptr) return;
    const std::size_t now = lists_.triangles.size();
    for (std::size_t c = 0; c < values_.size(); ++c) {
      plan_.attributes->faces[c].values.resize(now, values_[c]);
    }
    if (plan_.texture != kAbsent) end_texture(now);
  }

 private:
  void end_texture(std::size_t now) {
    CornerAttribute& to = plan_.attributes->texture;
    to.dimension = 2;
    const std::size_t first = to.values.size() / 2, triangles = now - to.corners.size();
    // Lists of another length are ignored: some writers leave empty lists.
    const bool fits = texture_.size() == 2 * (triangles + 2);
    if (fits) to.values.insert(to.values.end(), texture_.begin(), texture_.end());
    for (std::size_t k = 0; k < triangles; ++k) {
      const auto at = [&](std::size_t corner) {
        return fits ? static_cast<std::uint32_t>(first + corner) : CornerAttribute::kNone;
      };
      to.corners.push_back({at(0), at(k + 1), at(k + 2)});
    }
    texture_.clear();
  }

  const Plan& plan_;
  const MeshLists& lists_;
  std::vector<double> values_, texture_;
};

/// Adds faces; counts and indices are checked here for text and binary alike.
class FaceSink {
 public:
  FaceSink(const MeshFile& file, const Plan& plan, MeshLists& lists)
      : file_(file), vertices_(static_cast<std::int64_t>(plan.vertices)), lists_(lists) {}

  void begin(std::size_t face, std::int64_t corners) {
    face_ = face;
    corners_.clear();
    if (corners < 3) {
      bad_file(file_.path, "face " + std::to_string(face) + " has " + std::to_string(corners) +
                               " corners, but a face needs three or more.");
    }
  }
  void add(std::int64_t vertex) {
    if (vertex < 0 || vertex >= vertices_) {
      bad_file(file_.path, "face " + std::to_string(face_) + " refers to vertex " +
                               std::to_string(vertex) + ", but the file has " +
                               std::to_string(vertices_) + " vertices.");
    }
    corners_.push_back(static_cast<std::uint32_t>(vertex));
  }
  void end() { add_polygon(lists_, corners_); }

 private:
  const MeshFile& file_;
  std::int64_t vertices_;
  MeshLists& lists_;
  std::size_t face_ = 0;
  std::vector<std::uint32_t> corners_;
};

class TextBody {
 public:
  TextBody(const MeshFile& file, const Plan& plan, MeshLists& lists)
      : file_(file),
        plan_(plan),
        lists_(lists),
        lines_(file, '\0', plan.header.body, plan.header.lines),
        faces_(file, plan, lists),
        strips_(file, plan.vertices, lists),
        face_numbers_(plan, lists) {}

  void read() {
    for (const PlyElement& element : plan_.header.elements) {
      for (std::size_t i = 0; i < element.count; ++i) {
        if (!lines_.next_line()) lines_.need_line(numbered(element, i));
        if (element.name == "vertex") {
          read_vertex(element);
        } else if (element.name == "face") {
          read_face(element, i);
        } else if (element.name == kStrips) {
          read_strips(element);
        }
      }
    }
    if (lines_.next_line()) lines_.fail("the file goes on after all that its header announces.");
    strays_.check(file_, lists_);
  }

 private:
  void skip(const PlyProperty& property) {
    std::int64_t words = 1;
    if (property.is_list) words = lines_.integer("the length of a list");
    for (std::int64_t k = 0; k < words; ++k) {
      if (lines_.word().empty()) lines_.fail("the line ends before '" + property.name + "'.");
    }
  }

  double number(const PlyProperty& property) {
    const std::string_view word = lines_.word();
    double value = 0;
    if (word.empty()) lines_.fail("the line ends before '" + property.name + "'.");
    if (!parse(word, value)) {
      lines_.fail("expected a number for '" + property.name + "', found " + quoted(word) + ".");
    }
    return value;
  }

  void read_vertex(const PlyElement& element) {
    Point p;
    std::string_view odd;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const auto k =
          static_cast<std::size_t>(std::find(plan_.coordinate.begin(), plan_.coordinate.end(), i) -
                                   plan_.coordinate.begin());
      if (k < 3) {
        p[static_cast<int>(k)] = lines_.coordinate(odd);
      } else if (const std::size_t c = plan_.vertex_columns.at(i); c != kAbsent) {
        plan_.attributes->vertices[c].values.push_back(number(element.properties[i]));
      } else {
        skip(element.properties[i]);
      }
    }
    if (!odd.empty()) strays_.add(lists_.points.size(), lines_.line(), odd);
    lists_.points.push_back(p);
  }

  void read_face(const PlyElement& element, std::size_t face) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (i == plan_.corners) {
        const std::int64_t n = lines_.integer("the number of the face's corners");
        faces_.begin(face, n);
        for (std::int64_t k = 0; k < n; ++k) faces_.add(lines_.integer("the index of a vertex"));
        faces_.end();
      } else if (i == plan_.texture) {
        const std::int64_t n = lines_.integer("the length of a list");
        for (std::int64_t k = 0; k < n; ++k) face_numbers_.texture().push_back(number(property));
      } else if (const std::size_t c = plan_.face_columns.at(i); c != kAbsent) {
        face_numbers_.set(c, number(property));
      } else {
        skip(property);
      }
    }
    face_numbers_.end();
  }

  void read_strips(const PlyElement& element) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (i != plan_.corners) {
        skip(element.properties[i]);
        continue;
      }
      const std::int64_t n = lines_.integer("the length of a list");
      if (n < 0) lines_.fail("a list has a negative length.");
      for (std::int64_t k = 0; k < n; ++k) strips_.add(lines_.integer("the index of a vertex"));
      strips_.end();
    }
  }

  const MeshFile& file_;
  const Plan& plan_;
  MeshLists& lists_;
  StrayVertices strays_;
  LineScanner lines_;
  FaceSink faces_;
  TriangleStrips strips_;
  FaceNumbers face_numbers_;
};

class BinaryBody {
 public:
  BinaryBody(const MeshFile& file, const Plan& plan, MeshLists& lists)
      : file_(file),
        plan_(plan),
        lists_(lists),
        cursor_(file.bytes.substr(plan.header.body)),
        faces_(file, plan, lists),
        strips_(file, plan.vertices, lists),
        face_numbers_(plan, lists),
        swap_((plan.header.encoding == PlyEncoding::kBigEndian) ==
              (std::endian::native == std::endian::little)) {}

  void read() {
    for (const PlyElement& element : plan_.header.elements) {
      if (element.properties.empty()) continue;
      for (std::size_t i = 0; i < element.count; ++i) {
        if (element.name == "vertex") {
          read_vertex(element, i);
        } else {
          read_element(element, i);
        }
      }
    }
    // Some writers end the file with a line break.
    if (cursor_.rest().find_first_not_of("\r\n") != std::string_view::npos || cursor_.left() > 2) {
      bad_file(file_.path, "the file goes on for " + std::to_string(cursor_.left()) +
                               " bytes after all that its header announces.");
    }
  }

 private:
  const char* take(const PlyElement& element, std::size_t index, std::size_t size) {
    const char* at = cursor_.take(size);
    if (at == nullptr) bad_file(file_.path, "the file ends in " + numbered(element, index) + ".");
    return at;
  }

  void read_vertex(const PlyElement& element, std::size_t index) {
    Point p;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.is_list) {
        pass_list(element, property, index);
        continue;
      }
      const char* at = take(element, index, size_of(property.type));
      for (int k = 0; k < 3; ++k) {
        if (plan_.coordinate[static_cast<std::size_t>(k)] == i) {
          p[k] = load_number(property.type, at, swap_);
        }
      }
      if (const std::size_t c = plan_.vertex_columns.at(i); c != kAbsent) {
        plan_.attributes->vertices[c].values.push_back(load_number(property.type, at, swap_));
      }
    }
    lists_.points.push_back(p);
  }

  void read_element(const PlyElement& element, std::size_t index) {
    const bool is_face = element.name == "face", is_strips = element.name == kStrips;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (is_face && i == plan_.corners) {
        read_corners(element, property, index);
      } else if (is_strips && i == plan_.corners) {
        read_strips(element, property, index);
      } else if (is_face && i == plan_.texture) {
        read_texture(element, property, index);
      } else if (property.is_list) {
        pass_list(element, property, index);
      } else {
        const char* at = take(element, index, size_of(property.type));
        const std::size_t c = is_face ? plan_.face_columns.at(i) : kAbsent;
        if (c != kAbsent) face_numbers_.set(c, load_number(property.type, at, swap_));
      }
    }
    if (is_face) face_numbers_.end();
  }

  std::size_t list_length(const PlyElement& element, const PlyProperty& property,
                          std::size_t index) {
    const char* at = take(element, index, size_of(property.count_type));
    const std::int64_t n = load_integer(property.count_type, at, swap_);
    if (n < 0) {
      bad_file(file_.path, "a list of " + numbered(element, index) + " has a negative length.");
    }
    return static_cast<std::size_t>(n);
  }

  void pass_list(const PlyElement& element, const PlyProperty& property, std::size_t index) {
    take(element, index, list_length(element, property, index) * size_of(property.type));
  }

  void read_corners(const PlyElement& element, const PlyProperty& property, std::size_t index) {
    const std::size_t n = list_length(element, property, index);
    faces_.begin(index, static_cast<std::int64_t>(n));
    const std::size_t step = size_of(property.type);
    const char* at = take(element, index, n * step);
    for (std::size_t k = 0; k < n; ++k)
      faces_.add(load_integer(property.type, at + k * step, swap_));
    faces_.end();
  }

  void read_strips(const PlyElement& element, const PlyProperty& property, std::size_t index) {
    const std::size_t n = list_length(element, property, index);
    const std::size_t step = size_of(property.type);
    const char* at = take(element, index, n * step);
    for (std::size_t k = 0; k < n; ++k) {
      strips_.add(load_integer(property.type, at + k * step, swap_));
    }
    strips_.end();
  }

  void read_texture(const PlyElement& element, const PlyProperty& property, std::size_t index) {
    const std::size_t n = list_length(element, property, index);
    const std::size_t step = size_of(property.type);
    const char* at = take(element, index, n * step);
    for (std::size_t k = 0; k < n; ++k) {
      face_numbers_.texture().push_back(load_number(property.type, at + k * step, swap_));
    }
  }

  const MeshFile& file_;
  const Plan& plan_;
  MeshLists& lists_;
  ByteCursor cursor_;
  FaceSink faces_;
  TriangleStrips strips_;
  FaceNumbers face_numbers_;
  bool swap_;
};

void set_aside(const MeshFile& file, const Plan& plan, MeshLists& lists) {
  // Memory is reserved only for elements that the file has bytes for.
  for (const PlyElement& element : plan.header.elements) {
    if (element.name == "vertex") {
      lists.points.reserve(std::min(element.count, file.bytes.size() / 3));
      lists.single_precision = std::all_of(
          plan.coordinate.begin(), plan.coordinate.end(),
          [&](std::size_t k) { return element.properties[k].type == NumberType::kFloat32; });
    } else if (element.name == "face") {
      lists.triangles.reserve(std::min(element.count, file.bytes.size() / 4));
    }
  }
}

}  // namespace

MeshLists read_ply(const MeshFile& file, MeshAttributes* attributes) {
  Plan plan = make_plan(file);
  if (attributes != nullptr) plan_attributes(*attributes, plan);
  MeshLists lists;
  lists.space = plan.header.space;
  set_aside(file, plan, lists);
  if (plan.header.encoding == PlyEncoding::kText) {
    TextBody(file, plan, lists).read();
  } else {
    BinaryBody(file, plan, lists).read();
  }
  return lists;
}

}  // namespace talweg
