#include "talweg/core/cutting/attribute_transfer.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "talweg/core/cutting/loop_filling.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

constexpr std::uint32_t kNoValue = CornerAttribute::kNone;

/// Whether a column's name is that of a colour component: "red", "r" or "diffuse_red".
bool is_colour(std::string_view name) {
  if (name == "r" || name == "g" || name == "b" || name == "a") return true;
  name.remove_prefix(name.rfind('_') + 1);  // removes nothing if there is no '_'
  return std::find(kColours.begin(), kColours.end(), name) != kColours.end();
}

bool is_real(NumberType type) {
  return type == NumberType::kFloat32 || type == NumberType::kFloat64;
}

/// The value of a colour component in white.
double white(NumberType type) {
  switch (type) {
    case NumberType::kInt8:
      return 127;
    case NumberType::kUint8:
      return 255;
    case NumberType::kInt16:
      return 32767;
    case NumberType::kUint16:
      return 65535;
    case NumberType::kFloat32:
    case NumberType::kFloat64:
      return 1;
    default:
      return 255;
  }
}

using Corners = std::array<std::uint32_t, 3>;
using Parts = std::array<double, 3>;

std::size_t nearest(const Parts& parts) {
  return static_cast<std::size_t>(std::max_element(parts.begin(), parts.end()) - parts.begin());
}

template <class Value>
double interpolated(const Parts& parts, Value value_of_corner) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (parts[k] > 0) sum += parts[k] * value_of_corner(k);  // values of weight 0 may be NaN
  }
  return sum;
}

/// The value between three corners; directions are not normalised.
template <class Value>
double between(Carry rule, const Parts& parts, Value value_of_corner) {
  if (rule == Carry::kNearest) return value_of_corner(nearest(parts));
  const double value = interpolated(parts, value_of_corner);
  return rule == Carry::kRounded ? std::round(value) : value;
}

using Direction = std::array<AttributeColumn*, 3>;

/// The triples of columns that are directions: by their `carry`, and normals by their names.
std::vector<Direction> directions_among(std::vector<AttributeColumn>& columns) {
  std::vector<Direction> directions;
  Direction normal{};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    AttributeColumn& column = columns[c];
    if (column.carry == Carry::kDirection && c + 2 < columns.size()) {
      directions.push_back({&column, &columns[c + 1], &columns[c + 2]});
      c += 2;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const bool by_name = column.carry == Carry::kByName && is_real(column.type);
      if (by_name && column.name == kNormals[k]) normal[k] = &column;
    }
  }
  const bool has_normals = std::all_of(normal.begin(), normal.end(), [](auto* n) { return n; });
  if (has_normals) directions.push_back(normal);
  return directions;
}

/// Normalises a vector unless it is zero.
void normalize(std::array<double*, 3> normal) {
  const double length = std::hypot(*normal[0], *normal[1], *normal[2]);
  if (!(length > 0) || !std::isfinite(length)) return;
  for (double* x : normal) *x /= length;
}

void check_sizes(const MeshAttributes& attributes, std::size_t vertices, std::size_t faces) {
  const auto check = [](const std::vector<AttributeColumn>& columns, std::size_t count) {
    for (const AttributeColumn& column : columns) {
      if (column.values.size() == count) continue;
      throw Error(ErrorCode::kBadUsage, "The attribute " + column.name + " has " +
                                            std::to_string(column.values.size()) +
                                            " values instead of " + std::to_string(count) + ".");
    }
  };
  check(attributes.vertices, vertices);
  check(attributes.faces, faces);
}

/// Interpolates the columns at the new vertices.
void extend_vertices(const CutMesh& cut, const Surface& old,
                     std::vector<AttributeColumn>& columns) {
  if (columns.empty()) return;
  const std::vector<Direction> directions = directions_among(columns);
  std::vector<Carry> rules;
  rules.reserve(columns.size());
  for (const AttributeColumn& column : columns) rules.push_back(carry_of(column));
  for (std::size_t v = old.vertex_count(); v < cut.vertex_from.size(); ++v) {
    const SurfacePoint& point = cut.vertex_from[v];
    const FaceCoordinates at = coordinates_in(old, point, any_face(old, point));
    const auto corners = old.corners(at.face);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto value = [&](std::size_t k) { return columns[c].values[corners[k].index()]; };
      columns[c].values.push_back(between(rules[c], at.barycentric, value));
    }
    for (const Direction& d : directions) {
      normalize({&d[0]->values[v], &d[1]->values[v], &d[2]->values[v]});
    }
  }
}

/// Creates the values at corners of the cut mesh's faces. Two faces share a value if their old
/// faces share the values that it is mixed from.
class CornerCarrier {
 public:
  /// `by_name`: the rule for an attribute with Carry::kByName.
  CornerCarrier(const CutMesh& cut, const Surface& old, const CornerAttribute& from, Carry by_name)
      : cut_(cut),
        old_(old),
        from_(from),
        rule_(from.carry == Carry::kByName ? by_name : from.carry),
        result_{from.dimension, from.values, {}, from.carry} {}

  CornerAttribute run() {
    for (std::size_t f = 0; f < cut_.lists.triangles.size(); ++f) {
      const FaceId face{cut_.face_from[f]};
      Corners corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = at(face, cut_.lists.triangles[f][k]);
      result_.corners.push_back(corners);
    }
    return std::move(result_);
  }

 private:
  using Key = std::pair<std::uint32_t, Corners>;  // a vertex, and the entries mixed there

  std::uint32_t at(FaceId face, std::uint32_t vertex) {
    const Corners& own = from_.corners[face.index()];
    if (vertex < old_.vertex_count()) {
      const auto corners = old_.corners(face);
      for (std::size_t k = 0; k < 3; ++k) {
        if (corners[k].index() == vertex) return own[k];
      }
    }
    const Parts parts = coordinates_in(old_, cut_.vertex_from[vertex], face).barycentric;
    Key key{vertex, own};
    for (std::size_t k = 0; k < 3; ++k) {
      if (parts[k] == 0) key.second[k] = kNoValue;
      if (parts[k] > 0 && own[k] == kNoValue) return kNoValue;
    }
    std::sort(key.second.begin(),
              key.second.end());  // neighbouring faces list the entries in another order
    const auto [place, is_new] = known_.try_emplace(key, 0);
    if (is_new) place->second = mix(own, parts);
    return place->second;
  }

  std::uint32_t mix(const Corners& own, const Parts& parts) {
    const std::size_t n = from_.dimension, first = result_.values.size();
    for (std::size_t d = 0; d < n; ++d) {
      result_.values.push_back(
          between(rule_, parts, [&](std::size_t k) { return from_.values[n * own[k] + d]; }));
    }
    if (n == 3 && rule_ == Carry::kDirection) {
      double* const at = &result_.values[first];
      normalize({at, at + 1, at + 2});
    }
    return static_cast<std::uint32_t>(first / n);
  }

  const CutMesh& cut_;
  const Surface& old_;
  const CornerAttribute& from_;
  Carry rule_;
  CornerAttribute result_;
  std::map<Key, std::uint32_t> known_;
};

template <class Value>
std::vector<Value> of_faces(const std::vector<Value>& values, std::span<const std::uint32_t> from,
                            const Value& without) {
  std::vector<Value> result;
  result.reserve(from.size());
  for (const std::uint32_t f : from) result.push_back(f == kNoFace ? without : values[f]);
  return result;
}

/// The attribute of the given faces, with the values that they use, in the order of first use.
CornerAttribute of_faces(const CornerAttribute& from, std::span<const std::uint32_t> faces) {
  CornerAttribute to{from.dimension, {}, {}, from.carry};
  if (from.dimension == 0) return to;
  to.corners = of_faces(from.corners, faces, {kNoValue, kNoValue, kNoValue});
  std::vector<std::uint32_t> number(from.values.size() / from.dimension, kNoValue);
  for (Corners& corners : to.corners) {
    for (std::uint32_t& corner : corners) {
      if (corner == kNoValue) continue;
      if (number[corner] == kNoValue) {
        number[corner] = static_cast<std::uint32_t>(to.values.size() / to.dimension);
        const auto first = from.values.begin() + static_cast<std::ptrdiff_t>(corner * to.dimension);
        to.values.insert(to.values.end(), first, first + static_cast<std::ptrdiff_t>(to.dimension));
      }
      corner = number[corner];
    }
  }
  return to;
}

/// The attributes of faces that are copies of the given old faces.
MeshAttributes with_faces(const MeshAttributes& attributes, std::span<const std::uint32_t> faces) {
  MeshAttributes result;
  result.references = attributes.references;
  result.left_out = attributes.left_out;
  for (const AttributeColumn& column : attributes.faces) {
    result.faces.push_back({column.name, column.type,
                            of_faces(column.values, faces, fill_of(column)), column.carry,
                            column.fill});
  }
  for (const FaceNames& names : attributes.names) {
    result.names.push_back({names.keyword, names.names, of_faces(names.of_face, faces, 0U)});
  }
  return result;
}

}  // namespace

double fill_of(const AttributeColumn& column) {
  return column.fill.value_or(is_colour(column.name) ? white(column.type) : 0);
}

Carry carry_of(const AttributeColumn& column) {
  if (column.carry != Carry::kByName) return column.carry;
  std::string lower = column.name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower.find("label") != lower.npos) return Carry::kNearest;
  if (is_real(column.type)) return Carry::kLinear;
  return is_colour(lower) ? Carry::kRounded : Carry::kNearest;
}

MeshAttributes carried_to(const CutMesh& cut, const Surface& old,
                          const MeshAttributes& attributes) {
  check_sizes(attributes, old.vertex_count(), old.face_count());
  MeshAttributes result = with_faces(attributes, cut.face_from);
  result.vertices = attributes.vertices;
  extend_vertices(cut, old, result.vertices);
  if (attributes.texture.dimension > 0) {
    result.texture = CornerCarrier(cut, old, attributes.texture, Carry::kLinear).run();
  }
  if (attributes.normals.dimension > 0) {
    result.normals = CornerCarrier(cut, old, attributes.normals, Carry::kDirection).run();
  }
  return result;
}

std::vector<double> carried_to(const CutMesh& cut, const Surface& old,
                               std::span<const double> per_vertex) {
  if (per_vertex.size() != old.vertex_count()) {
    throw Error(ErrorCode::kBadUsage, "There are " + std::to_string(per_vertex.size()) +
                                          " values for " + std::to_string(old.vertex_count()) +
                                          " vertices.");
  }
  std::vector<double> result(per_vertex.begin(), per_vertex.end());
  for (std::size_t v = result.size(); v < cut.vertex_from.size(); ++v) {
    const SurfacePoint& point = cut.vertex_from[v];
    const FaceCoordinates at = coordinates_in(old, point, any_face(old, point));
    const auto corners = old.corners(at.face);
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (at.barycentric[k] > 0) value += at.barycentric[k] * per_vertex[corners[k].index()];
    }
    result.push_back(value);
  }
  return result;
}

MeshAttributes picked(const MeshAttributes& attributes, std::span<const std::uint32_t> vertices,
                      std::span<const std::uint32_t> faces) {
  MeshAttributes result = with_faces(attributes, faces);
  for (const AttributeColumn& column : attributes.vertices) {
    AttributeColumn& to = result.vertices.emplace_back(
        AttributeColumn{column.name, column.type, {}, column.carry, column.fill});
    to.values.reserve(vertices.size());
    const double fill = fill_of(column);
    for (const std::uint32_t v : vertices) {
      to.values.push_back(v == kNoVertex ? fill : column.values[v]);
    }
  }
  result.texture = of_faces(attributes.texture, faces);
  result.normals = of_faces(attributes.normals, faces);
  return result;
}

MeshAttributes of_repaired(const MeshAttributes& attributes, const RepairMap& map,
                           std::size_t& differing) {
  check_sizes(attributes, map.file_vertex_count(), map.file_face_count());
  std::vector<std::uint32_t> vertices(map.vertex_count()), faces(map.face_count());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    vertices[v] = static_cast<std::uint32_t>(map.file_vertex(VertexId{v}).index());
  }
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    faces[f] = static_cast<std::uint32_t>(map.file_face(FaceId{f}).index());
  }
  MeshAttributes result = picked(attributes, vertices, faces);
  for (CornerAttribute* attribute : {&result.texture, &result.normals}) {
    for (std::size_t f = 0; f < attribute->corners.size(); ++f) {
      const Corners own = attribute->corners[f];
      const auto& image = map.image(FaceId{faces[f]});
      for (std::size_t k = 0; k < 3; ++k) attribute->corners[f][image.corner[k]] = own[k];
    }
  }
  differing = 0;
  for (std::uint32_t v = 0; v < map.file_vertex_count(); ++v) {
    const std::size_t onto = map.file_vertex(VertexId{map.images(VertexId{v}).front()}).index();
    const bool same = std::all_of(
        attributes.vertices.begin(), attributes.vertices.end(), [&](const AttributeColumn& column) {
          return column.values[v] == column.values[onto] || std::isnan(column.values[v]);
        });
    if (!same) ++differing;
  }
  return result;
}

}  // namespace talweg
