// glTF 2.0 (Khronos, "glTF 2.0 Specification"), .gltf and .glb: the triangles of the default scene,
// placed by the transforms of the nodes. Coordinates are metres with y up, and stay so.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "talweg/core/io/face_naming.hpp"
#include "talweg/core/io/gltf_data.hpp"
#include "talweg/core/io/mesh_file.hpp"

namespace talweg {
namespace {

using formats::GltfData;
using formats::GltfNumbers;
using formats::JsonPlace;
using Place = Eigen::Affine3d;

enum Mode : std::uint32_t { kTriangleList = 4, kStrip = 5, kFan = 6 };

/// Numbers of a vertex beside its position: one attribute of the file, several columns.
struct VertexNumbers {
  const char* name;
  std::string_view type;
  std::vector<const char*> columns;
  double missing;  ///< for primitives without the attribute
};

const std::vector<VertexNumbers>& vertex_numbers() {
  static const std::vector<VertexNumbers> kAll{
      {"NORMAL", "VEC3", {"nx", "ny", "nz"}, 0},
      {"COLOR_0", "VEC3 VEC4", {"red", "green", "blue", "alpha"}, 255},
      {"TEXCOORD_0", "VEC2", {"s", "t"}, 0}};
  return kAll;
}

/// A node to be read, and the transform of its parent.
struct Waiting {
  std::uint32_t node;
  Place place;
};

std::vector<double> number_list(const JsonPlace& place, std::size_t count) {
  if (place.size() != count) place.fail(fmt::format("expected {} numbers", count));
  std::vector<double> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(place.element(k).number());
  return all;
}

/// The transform of a node relative to its parent: a matrix, or translation, rotation and scale.
Place place_of(const JsonPlace& node) {
  Place place = Place::Identity();
  if (node.has("matrix")) {
    const std::vector<double> m = number_list(node.member("matrix"), 16);
    place.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
    return place;
  }
  if (node.has("translation")) {
    const std::vector<double> t = number_list(node.member("translation"), 3);
    place.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  }
  if (node.has("rotation")) {
    const std::vector<double> q = number_list(node.member("rotation"), 4);
    const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
    if (rotation.norm() > 0) place.rotate(rotation.normalized());
  }
  if (node.has("scale")) {
    const std::vector<double> s = number_list(node.member("scale"), 3);
    place.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  }
  return place;
}

class GltfReader {
 public:
  GltfReader(const MeshFile& file, MeshAttributes* attributes)
      : file_(file), data_(file), attributes_(attributes) {}

  MeshLists read() {
    lists_.unit = LengthUnit::named("m");
    for (const std::uint32_t node : root_nodes()) walk(node);
    if (lists_.triangles.empty()) {
      bad_file(file_.path, "its scene has no triangles, so it holds no surface.");
    }
    lists_.single_precision = std::all_of(
        lists_.points.begin(), lists_.points.end(),
        [](const Point& p) { return (p.array() == p.cast<float>().cast<double>().array()).all(); });
    tell();
    return std::move(lists_);
  }

 private:
  std::vector<std::uint32_t> indices_of(const JsonPlace& list) const {
    std::vector<std::uint32_t> all;
    for (std::size_t k = 0; k < list.size(); ++k) all.push_back(list.element(k).index());
    return all;
  }

  /// The root nodes of the scene that the file names, or of its first scene. Without scenes, all
  /// nodes without a parent.
  std::vector<std::uint32_t> root_nodes() {
    const JsonPlace root = data_.root();
    if (!root.has("nodes")) bad_file(file_.path, "it has no nodes, so it holds no surface.");
    const std::size_t count = root.member("nodes").size();
    if (root.has("scenes") && root.member("scenes").size() > 0) {
      const JsonPlace scenes = root.member("scenes");
      const std::uint32_t scene = root.has("scene") ? root.member("scene").index() : 0;
      if (scene >= scenes.size()) scenes.fail(fmt::format("there is no scene {}", scene));
      if (scenes.size() > 1) {
        lists_.notes.push_back(fmt::format("{} of the {} scenes of the file were left out.",
                                           scenes.size() - 1, scenes.size()));
      }
      if (!scenes.element(scene).has("nodes")) return {};
      return indices_of(scenes.element(scene).member("nodes"));
    }
    std::vector<bool> has_parent(count, false);
    for (std::size_t k = 0; k < count; ++k) {
      const JsonPlace node = root.member("nodes").element(k);
      if (!node.has("children")) continue;
      for (const std::uint32_t child : indices_of(node.member("children"))) {
        if (child < count) has_parent[child] = true;
      }
    }
    std::vector<std::uint32_t> roots;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (!has_parent[k]) roots.push_back(k);
    }
    return roots;
  }

  /// Reads a node and its descendants, children in their order. A node with two parents is an
  /// error.
  void walk(std::uint32_t first) {
    std::vector<Waiting> waiting{{first, Place::Identity()}};
    const JsonPlace nodes = data_.root().member("nodes");
    while (!waiting.empty()) {
      const Waiting now = waiting.back();
      waiting.pop_back();
      if (now.node >= nodes.size()) nodes.fail(fmt::format("there is no node {}", now.node));
      const JsonPlace node = nodes.element(now.node);
      if (!visited_.insert(now.node).second)
        node.fail("the node occurs twice in the scene; a node may have one parent");
      const Place place = now.place * place_of(node);
      if (node.has("mesh")) {
        const bool posed = node.has("skin");  // the transform of a skinned node does not apply
        skins_ = skins_ || posed;
        read_mesh_at(node.member("mesh").index(), posed ? Place::Identity() : place, node);
      }
      if (!node.has("children")) continue;
      std::vector<std::uint32_t> children = indices_of(node.member("children"));
      std::reverse(children.begin(), children.end());
      for (const std::uint32_t child : children) waiting.push_back({child, place});
    }
  }

  void read_mesh_at(std::uint32_t index, const Place& place, const JsonPlace& node) {
    const JsonPlace root = data_.root();
    const JsonPlace meshes = root.member("meshes");
    if (index >= meshes.size()) meshes.fail(fmt::format("there is no mesh {}", index));
    const JsonPlace mesh = meshes.element(index);
    const JsonPlace primitives = mesh.member("primitives");
    first_vertex_.clear();
    name_ = node.has("name")   ? node.member("name").string()
            : mesh.has("name") ? mesh.member("name").string()
                               : "";
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      read_primitive(primitives.element(k), place);
    }
  }

  void read_primitive(const JsonPlace& primitive, const Place& place) {
    if (primitive.has("extensions") &&
        primitive.member("extensions").has("KHR_draco_mesh_compression")) {
      primitive.fail(
          "its data are packed by KHR_draco_mesh_compression, which is not read; export "
          "it without compression");
    }
    const std::uint32_t mode =
        primitive.has("mode") ? primitive.member("mode").index() : kTriangleList;
    const JsonPlace attributes = primitive.member("attributes");
    if (mode < kTriangleList || !attributes.has("POSITION")) {
      ++others_;
      return;
    }
    if (mode > kFan) primitive.fail("expected a mode from 0 to 6");
    shapes_ = shapes_ || primitive.has("targets");
    const std::size_t own = add_vertices(primitive, attributes, place);
    std::vector<double> corners;
    if (primitive.has("indices")) {
      corners = data_.numbers(primitive.member("indices").index(), "SCALAR").values;
    } else {
      for (std::size_t k = 0; k < own; ++k) corners.push_back(static_cast<double>(k));
    }
    add_triangles(primitive, corners, mode, own, place.linear().determinant() < 0);
    add_names(primitive);
  }

  /// Adds the vertices of a primitive, unless another primitive of the mesh has added them. Sets
  /// `offset_` to the first vertex. Returns the number of vertices.
  std::size_t add_vertices(const JsonPlace& primitive, const JsonPlace& attributes,
                           const Place& place) {
    const std::uint32_t accessor = attributes.member("POSITION").index();
    const auto known = first_vertex_.find(accessor);
    if (known != first_vertex_.end()) {
      offset_ = known->second.first;
      return known->second.second;
    }
    const GltfNumbers xyz = data_.numbers(accessor, "VEC3");
    offset_ = lists_.points.size();
    const std::size_t own = xyz.count();
    first_vertex_[accessor] = {offset_, own};
    check_size(primitive, offset_ + own);
    lists_.points.reserve(offset_ + own);
    for (std::size_t k = 0; k < own; ++k) {
      const Point p(xyz.real(3 * k), xyz.real(3 * k + 1), xyz.real(3 * k + 2));
      lists_.points.push_back(place * p);
    }
    if (attributes_ != nullptr) add_vertex_numbers(attributes, own, place);
    return own;
  }

  /// Throws if the mesh is too large. A short file can repeat a mesh any number of times.
  void check_size(const JsonPlace& primitive, std::size_t count) {
    constexpr std::size_t kMost = std::size_t{1} << 25U;
    if (count > std::max(kMost, data_.bytes())) {
      primitive.fail(
          fmt::format("with this primitive the scene has {} vertices or triangles, many of them "
                      "repeated; expected at most {}",
                      count, kMost));
    }
  }

  void add_vertex_numbers(const JsonPlace& attributes, std::size_t own, const Place& place) {
    for (const VertexNumbers& kind : vertex_numbers()) {
      if (!attributes.has(kind.name)) continue;
      GltfNumbers numbers = data_.numbers(attributes.member(kind.name).index(), kind.type);
      if (numbers.count() != own) continue;
      if (kind.columns[0] == std::string_view("nx")) turn(numbers, place);
      const bool colours = kind.columns[0] == std::string_view("red");
      for (std::size_t c = 0; c < numbers.components; ++c) {
        AttributeColumn& column = column_named(kind.columns[c], colours, kind.missing);
        column.values.resize(offset_, kind.missing);
        for (std::size_t k = 0; k < own; ++k) {
          const double x = numbers.real(k * numbers.components + c);
          column.values.push_back(colours ? std::round(255 * std::clamp(x, 0.0, 1.0)) : x);
        }
      }
    }
    for (AttributeColumn& column : attributes_->vertices) {
      column.values.resize(lists_.points.size(), column.fill.value_or(0));
    }
  }

  AttributeColumn& column_named(std::string_view name, bool colours, double missing) {
    for (AttributeColumn& column : attributes_->vertices) {
      if (column.name == name) return column;
    }
    const NumberType type = colours ? NumberType::kUint8 : NumberType::kFloat32;
    attributes_->vertices.push_back({std::string(name), type, {}});
    attributes_->vertices.back().fill = missing;
    return attributes_->vertices.back();
  }

  /// Transforms the normals of a node.
  static void turn(GltfNumbers& numbers, const Place& place) {
    const Eigen::Matrix3d linear = place.linear();
    const double determinant = linear.determinant();
    if (determinant == 0) return;
    const Eigen::Matrix3d turned = determinant * linear.inverse().transpose();
    for (std::size_t k = 0; k < numbers.count(); ++k) {
      const Eigen::Vector3d n(numbers.real(3 * k), numbers.real(3 * k + 1),
                              numbers.real(3 * k + 2));
      const Eigen::Vector3d m = (turned * n).stableNormalized() * (determinant < 0 ? -1 : 1);
      for (int d = 0; d < 3; ++d) numbers.values[3 * k + static_cast<std::size_t>(d)] = m[d];
    }
    numbers.normalized = false;
  }

  /// Adds triangles. A mirrored node reverses their orientation, as the specification says.
  void add_triangles(const JsonPlace& primitive, const std::vector<double>& corners,
                     std::uint32_t mode, std::size_t own, bool mirrored) {
    const auto vertex = [&](std::size_t k) {
      if (!(corners[k] >= 0 && corners[k] < static_cast<double>(own))) {
        primitive.fail(fmt::format("corner {} refers to vertex {:.17g}, but there are {}", k,
                                   corners[k], own));
      }
      return static_cast<std::uint32_t>(offset_ + static_cast<std::size_t>(corners[k]));
    };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      lists_.triangles.push_back(mirrored ? Triangle{a, c, b} : Triangle{a, b, c});
    };
    check_size(primitive, lists_.triangles.size() + corners.size());
    if (mode == kTriangleList) {
      if (corners.size() % 3 != 0) {
        primitive.fail(fmt::format("{} corners are not a multiple of 3", corners.size()));
      }
      for (std::size_t k = 0; k < corners.size(); k += 3) {
        add(vertex(k), vertex(k + 1), vertex(k + 2));
      }
      return;
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const std::uint32_t a = mode == kFan ? vertex(0) : vertex(k - 2);
      const std::uint32_t b = vertex(k - 1), c = vertex(k);
      if (a == b || b == c || c == a) continue;  // only continues the strip
      if (mode == kFan || k % 2 == 0) {
        add(a, b, c);
      } else {
        add(b, a, c);
      }
    }
  }

  /// The names of nodes and materials, as OBJ files have them.
  void add_names(const JsonPlace& primitive) {
    if (attributes_ == nullptr) return;
    std::string material;
    const JsonPlace root = data_.root();
    if (primitive.has("material") && root.has("materials")) {
      const std::uint32_t k = primitive.member("material").index();
      const JsonPlace materials = root.member("materials");
      if (k < materials.size() && materials.element(k).has("name")) {
        material = materials.element(k).member("name").string();
      }
    }
    objects_.add(name_, lists_.triangles.size());
    materials_.add(material, lists_.triangles.size());
  }

  void tell() {
    if (others_ > 0) {
      lists_.notes.push_back(
          fmt::format("{} sets of points or lines of the file were left out.", others_));
    }
    if (skins_) lists_.notes.emplace_back("Skinned meshes were read in their bind pose.");
    if (shapes_) lists_.notes.emplace_back("Morph targets of the file were left out.");
    if (attributes_ == nullptr) return;
    objects_.give(*attributes_);
    materials_.give(*attributes_);
  }

  const MeshFile& file_;
  GltfData data_;
  MeshAttributes* attributes_;
  MeshLists lists_;
  std::set<std::uint32_t> visited_;
  std::string name_;  // of the node
  formats::FaceNaming objects_{"o"}, materials_{"usemtl"};
  std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> first_vertex_;  // by accessor
  std::size_t offset_ = 0, others_ = 0;
  bool skins_ = false, shapes_ = false;
};

}  // namespace

MeshLists read_gltf(const MeshFile& file, MeshAttributes* attributes) {
  return GltfReader(file, attributes).read();
}

}  // namespace talweg
