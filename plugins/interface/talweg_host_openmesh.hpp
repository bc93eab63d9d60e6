// For hosts with OpenMesh: a plugin gets the host's TriMesh, and curves, fields and meshes are
// returned as handles, properties and meshes of the host's type. Header-only, on top of
// talweg_host.hpp; needs the library OpenMeshCore.
//
//   talweg::host::Services services("my program", "1.0");
//   talweg::host::OpenMeshInstance<MyMesh> smooth(plugin, services);  // from talweg_loader_find()
//   smooth.set_mesh(mesh);                    // deleted elements need not be collected
//   smooth.set_curves({curve});               // of vertex handles, say
//   smooth.set("tau", 2.0);
//   auto results = smooth.run({.vertex_fields = true});
//   results.curves[0].points[0].face;         // a handle of the mesh
//   smooth.put_fields(results, mesh);         // VProp<double> "distance"
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include "talweg_host.hpp"
#include "talweg_openmesh_attributes.hpp"
#include "talweg_openmesh_curves.hpp"
#include "talweg_openmesh_mesh.hpp"
#include "talweg_openmesh_origin.hpp"
#include "talweg_openmesh_properties.hpp"

namespace talweg::host {

/// Results with curves as handles: curves[k] is raw.curves[k], whose positions and fields have a
/// row for each of its points.
struct OpenMeshResults {
  Results raw;
  std::vector<openmesh::Curve> curves;
};

/// A mesh that a run made. Its properties are the attributes that were set and the plugin's own;
/// talweg:vertex and talweg:face (VProp<int>, FProp<int>) are indices of the original mesh, or -1.
template <class Mesh>
struct MadeTriMesh {
  struct Chain {
    bool closed = false;
    /// The vertices at each place of a curve's chain of edges: one; several at an opened seam; none
    /// if the place is in another mesh.
    std::vector<std::vector<OpenMesh::VertexHandle>> places;
  };

  Mesh mesh;
  std::vector<Chain> chains;
};

/// One workspace of a plugin on a TriMesh, otherwise as Instance. Methods throw Error.
template <class Mesh>
class OpenMeshInstance {
 public:
  OpenMeshInstance(const talweg_plugin& plugin, const Services& services)
      : instance_(plugin, services) {}

  /// The instance behind this object, for all functions without OpenMesh.
  [[nodiscard]] Instance& instance() { return instance_; }

  /// Sets the mesh without its deleted elements; results have the caller's handles. The plugin does
  /// not see later changes of the mesh. Points are not copied by this object if they are contiguous
  /// and none is deleted.
  void set_mesh(const Mesh& mesh) {
    translated([&] {
      openmesh::MeshNumbers numbers(mesh);
      const openmesh::MeshArrays<Mesh> arrays(mesh, numbers);
      instance_.set_mesh(arrays.positions(), arrays.triangles());
      numbers_ = std::move(numbers);
    });
  }
  /// Sets the numeric properties of the same mesh, with its normals, colours and the like, as
  /// attributes. Returns a sentence on each other property.
  std::vector<std::string> set_attributes(const Mesh& mesh) {
    std::vector<std::string> left_out;
    translated([&] {
      check_same(mesh);
      std::vector<openmesh::OwnedAttribute> attributes;
      for (const auto& property : openmesh::properties_of(mesh, numbers_, left_out)) {
        attributes.push_back(openmesh::attribute_of(mesh, numbers_, property));
      }
      std::vector<talweg_attribute> views;
      std::vector<const talweg_attribute*> list;
      views.reserve(attributes.size());
      list.reserve(attributes.size());
      for (const auto& attribute : attributes) views.push_back(attribute.view());
      for (const talweg_attribute& view : views) list.push_back(&view);
      instance_.set_attributes(std::span<const talweg_attribute* const>(list));
    });
    return left_out;
  }
  /// A point at a vertex needs no face.
  void set_curves(const std::vector<openmesh::Curve>& curves) {
    std::vector<Curve> given;
    given.reserve(curves.size());
    for (const openmesh::Curve& curve : curves) given.push_back(numbered(curve, given.size()));
    instance_.set_curves(given);
  }

  void set(const char* id, double value) { instance_.set(id, value); }
  void set(const char* id, const char* value) { instance_.set(id, value); }
  void set(const char* id, const std::string& value) { instance_.set(id, value); }
  void set(const char* id, const std::vector<OpenMesh::VertexHandle>& vertices) {
    std::vector<std::uint32_t> list;
    for (const OpenMesh::VertexHandle v : vertices) list.push_back(number(v, id));
    instance_.set(id, list);
  }
  /// Sets a parameter from a property of the mesh that was set.
  template <class T>
  void set(const char* id, const OpenMesh::PropertyManager<OpenMesh::VPropHandleT<T>>& values) {
    instance_.set(id, numbers(numbers_.vertices, values));
  }
  template <class T>
  void set(const char* id, const OpenMesh::PropertyManager<OpenMesh::FPropHandleT<T>>& values) {
    instance_.set(id, numbers(numbers_.faces, values));
  }

  OpenMeshResults run(const Wanted& wanted = {}) {
    OpenMeshResults results{instance_.run(wanted), {}};
    for (const Curve& curve : results.raw.curves) results.curves.push_back(in_handles(curve));
    return results;
  }

  /// Writes a run's fields to properties of the mesh that was set, by their names: VProp<double>,
  /// or FProp<double> for fields of triangles. Existing properties are overwritten; elements that
  /// were deleted when the mesh was set keep their values.
  void put_fields(const OpenMeshResults& results, Mesh& mesh) const {
    check_same(mesh);
    for (const Field& field : results.raw.fields) {
      if (is_of_triangles(field.name)) {
        put<OpenMesh::FPropHandleT<double>>(mesh, field, numbers_.faces);
      } else {
        put<OpenMesh::VPropHandleT<double>>(mesh, field, numbers_.vertices);
      }
    }
  }

  /// Mesh `number` of the last run.
  [[nodiscard]] MadeTriMesh<Mesh> made(const OpenMeshResults& results, std::size_t number) const {
    MadeTriMesh<Mesh> made;
    translated([&] {
      const host::Mesh& from = results.raw.meshes.at(number);
      openmesh::fill_mesh(made.mesh, detail::view_of(from.positions), triples(from.triangles));
    });
    const talweg_plugin& plugin = instance_.plugin();
    const auto* extension = static_cast<const talweg_meshes*>(plugin.get_extension(TALWEG_MESHES));
    if (extension == nullptr) return made;
    put_origin(instance_.origin(number), made);
    if ((extension->takes & TALWEG_TAKES_ATTRIBUTES) == 0) return made;
    for (const Attribute& attribute : instance_.attributes(number)) put(attribute, made.mesh);
    return made;
  }

 private:
  static constexpr std::uint32_t kNone = openmesh::Numbers<OpenMesh::VertexHandle>::kNone;

  /// Translates exceptions of the shared headers into Error.
  template <class Body>
  static void translated(const Body& body) {
    try {
      body();
    } catch (const plugin::Failure& failure) {
      throw Error(failure.status(), failure.what());
    }
  }
  [[noreturn]] static void bad(talweg_status status, const std::string& message) {
    throw Error(status, message);
  }

  void check_same(const Mesh& mesh) const {
    const openmesh::MeshNumbers now(mesh);
    if (now.vertices.size() == numbers_.vertices.size() &&
        now.faces.size() == numbers_.faces.size()) {
      return;
    }
    bad(TALWEG_BAD_USAGE, "The mesh has " + std::to_string(now.vertices.size()) + " vertices and " +
                              std::to_string(now.faces.size()) +
                              " faces, but the mesh that was set has " +
                              std::to_string(numbers_.vertices.size()) + " and " +
                              std::to_string(numbers_.faces.size()) + ".");
  }

  [[nodiscard]] std::uint32_t number(OpenMesh::VertexHandle v, const std::string& where) const {
    const std::uint32_t number = numbers_.vertices.number(v);
    if (number != kNone) return number;
    bad(TALWEG_BAD_CURVE, where + " has the vertex handle " + std::to_string(v.idx()) +
                              ", but this vertex of the mesh does not exist or is deleted.");
  }
  [[nodiscard]] std::uint32_t number(OpenMesh::FaceHandle f, const std::string& where) const {
    const std::uint32_t number = numbers_.faces.number(f);
    if (number != kNone) return number;
    bad(TALWEG_BAD_CURVE, where + " has the face handle " + std::to_string(f.idx()) +
                              ", but this face of the mesh does not exist or is deleted.");
  }

  /// A curve by vertices if all points have a vertex; otherwise by faces.
  [[nodiscard]] Curve numbered(const openmesh::Curve& curve, std::size_t which) const {
    const std::string where = "Curve " + std::to_string(which);
    Curve result;
    result.closed = curve.closed;
    result.pins = curve.pins;
    result.exact = curve.exact;
    bool at_vertices = true;
    for (const auto& point : curve.points) at_vertices = at_vertices && point.vertex.is_valid();
    for (const auto& point : curve.points) {
      if (at_vertices) {
        result.vertices.push_back(number(point.vertex, where));
      } else {
        result.faces.push_back(number(point.face, where));
        result.barycentrics.push_back(point.barycentric);
      }
    }
    return result;
  }
  [[nodiscard]] openmesh::Curve in_handles(const Curve& curve) const {
    openmesh::Curve result;
    result.closed = curve.closed;
    result.exact = curve.exact;
    for (std::size_t k = 0; k < curve.faces.size(); ++k) {
      openmesh::CurvePoint& point = result.points.emplace_back();
      point.face = numbers_.faces.handle(curve.faces[k]);
      point.barycentric = curve.barycentrics.at(k);
      if (k >= curve.vertices.size() || curve.vertices[k] == TALWEG_NO_VERTEX) continue;
      point.vertex = numbers_.vertices.handle(curve.vertices[k]);
    }
    return result;
  }

  template <class Handle, class Values>
  static std::vector<double> numbers(const openmesh::Numbers<Handle>& elements,
                                     const Values& values) {
    std::vector<double> result;
    for (std::size_t k = 0; k < elements.size(); ++k) {
      result.push_back(static_cast<double>(values[elements.handle(k)]));
    }
    return result;
  }

  [[nodiscard]] bool is_of_triangles(const std::string& name) const {
    const talweg_plugin& plugin = instance_.plugin();
    for (std::uint32_t k = 0; k < plugin.output_count; ++k) {
      const talweg_output& output = *plugin.outputs[k];
      if (output.kind == TALWEG_OUTPUT_TRIANGLE_FIELD && name == output.name) return true;
    }
    return false;
  }
  template <class Property, class Elements>
  static void put(Mesh& mesh, const Field& field, const Elements& elements) {
    Property property;
    if (!mesh.get_property_handle(property, field.name)) mesh.add_property(property, field.name);
    for (std::size_t k = 0; k < elements.size(); ++k) {
      mesh.property(property, elements.handle(k)) = field.values.at(k);
    }
  }

  static talweg_array triples(const std::vector<std::array<std::uint32_t, 3>>& rows) {
    return view(rows.empty() ? nullptr : rows.front().data(), rows.size(), 3);
  }
  void put_origin(const Origin& origin, MadeTriMesh<Mesh>& made) const {
    openmesh::number_elements(made.mesh);
    OpenMesh::VPropHandleT<int> vertex;
    OpenMesh::FPropHandleT<int> face;
    made.mesh.get_property_handle(vertex, openmesh::kVertexNumber);
    made.mesh.get_property_handle(face, openmesh::kFaceNumber);
    for (std::size_t k = 0; k < origin.vertices.size(); ++k) {
      made.mesh.property(vertex, OpenMesh::VertexHandle(static_cast<int>(k))) =
          old_vertex(origin.vertices[k], origin.weights.at(k));
    }
    for (std::size_t k = 0; k < origin.triangles.size(); ++k) {
      const std::uint32_t from = origin.triangles[k];
      made.mesh.property(face, OpenMesh::FaceHandle(static_cast<int>(k))) =
          from == TALWEG_NO_TRIANGLE ? -1 : numbers_.faces.handle(from).idx();
    }
    for (std::size_t c = 0; c < origin.lengths.size(); ++c) {
      made.chains.push_back({origin.closed.at(c) != 0, {}});
      made.chains.back().places.resize(origin.lengths[c]);
    }
    for (const auto& [curve, place, v] : origin.chains) {
      made.chains.at(curve).places.at(place).emplace_back(static_cast<int>(v));
    }
  }
  [[nodiscard]] int old_vertex(const std::array<std::uint32_t, 3>& from,
                               const std::array<double, 3>& weights) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 1) return numbers_.vertices.handle(from[i]).idx();
    }
    return -1;
  }
  /// The entry of a corner. A corner without an entry gets 0 for whole numbers and NaN for real
  /// numbers.
  static std::uint32_t with_none(std::uint32_t entry, openmesh::OwnedAttribute& of) {
    if (entry != TALWEG_NO_ENTRY || openmesh::detail::is_real(of.type)) return entry;
    const auto row = static_cast<std::size_t>(of.columns * plugin::detail::size_of(of.type));
    of.values.resize(of.values.size() + row, 0);
    return static_cast<std::uint32_t>(of.values.size() / row - 1);
  }
  static void put(const Attribute& attribute, Mesh& mesh) {
    openmesh::OwnedAttribute typed{attribute.name,
                                   attribute.element,
                                   attribute.carry,
                                   attribute.fill,
                                   attribute.columns,
                                   attribute.type,
                                   {},
                                   {}};
    for (const double value : attribute.values) {
      openmesh::detail::append_number(value, attribute.type, typed.values);
    }
    for (const auto& corners : attribute.corners) {
      for (const std::uint32_t entry : corners) typed.corners.push_back(with_none(entry, typed));
    }
    translated([&] { openmesh::add_property(mesh, typed.view()); });
  }

  Instance instance_;
  openmesh::MeshNumbers numbers_;  // of the mesh that was set
};

}  // namespace talweg::host
