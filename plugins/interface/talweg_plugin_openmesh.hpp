// For authors of plugins with OpenMesh: a base class that provides the host's mesh as a TriMesh
// with the author's traits, and passes a TriMesh as a result. Header-only, on top of
// talweg_plugin.hpp; needs the library OpenMeshCore. docs/openmesh.md shows a plugin made with it.
//
//   class Mine : public talweg::plugin::OpenMeshWorker<MyTraits> {
//    public:
//     using OpenMeshWorker::OpenMeshWorker;
//     static talweg_plugin about();  // and parameters(), outputs(), as talweg_plugin.hpp has it
//     void run(const Parameters& parameters, const Outputs& outputs) {
//       Mesh mesh = this->mesh();                  // a copy to work on
//       for (const Curve& curve : curves()) ...    // vertices, or faces with barycentrics
//       give_mesh(outputs, mesh);                  // with its properties
//     }
//   };
//   TALWEG_PLUGIN_MODULE(Mine)
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include "talweg_openmesh_attributes.hpp"
#include "talweg_openmesh_curves.hpp"
#include "talweg_openmesh_mesh.hpp"
#include "talweg_openmesh_nearest.hpp"
#include "talweg_openmesh_origin.hpp"
#include "talweg_openmesh_properties.hpp"
#include "talweg_plugin.hpp"

namespace talweg::plugin {

/// The part of a plugin class that exchanges data with the host. Indices of the host's vertices and
/// faces are handles of the mesh.
template <class Traits>
class OpenMeshWorker {
 public:
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Curve = openmesh::Curve;

  explicit OpenMeshWorker(const Services& services) : services_(&services) {}

  // For the adapter of talweg_plugin.hpp.
  static constexpr std::uint32_t kTakes = TALWEG_TAKES_ATTRIBUTES;
  void set_mesh(const talweg_mesh& given) {
    auto mesh = std::make_shared<Mesh>();
    openmesh::fill_mesh(*mesh, given.positions, given.triangles);
    if (mesh->n_faces() == 0) throw Failure(TALWEG_BAD_MESH, "The mesh has no faces.");
    openmesh::number_elements(*mesh);
    start(std::move(mesh));
  }
  void share_mesh(const OpenMeshWorker& other) { start(other.bare_); }
  void set_curves(std::span<const talweg_curve* const> given) {
    if (!nearest_) nearest_ = std::make_unique<openmesh::Nearest<Mesh>>(*bare_);
    std::vector<Curve> curves;
    for (const talweg_curve* curve : given) {
      curves.push_back(
          openmesh::detail::CurveReader<Mesh>(*bare_, *nearest_, curves.size()).read(*curve));
    }
    curves_ = std::move(curves);
    made_.clear();
  }
  void set_attributes(std::span<const talweg_attribute* const> given) {
    auto mesh = std::make_shared<Mesh>(*bare_);
    std::vector<openmesh::AttributeProperty> all;
    std::set<std::pair<std::uint32_t, std::string>> names;
    for (const talweg_attribute* attribute : given) {
      all.push_back(openmesh::add_property(*mesh, *attribute));
      if (names.emplace(all.back().element, all.back().name).second) continue;
      openmesh::detail::bad_attribute(all.back().name, "is given twice");
    }
    mesh_ = std::move(mesh);
    attributes_ = std::move(all);
    made_.clear();
  }
  void give_attributes(std::uint64_t number, const TakeAttribute& take) const {
    const Made& made = this->made(number);
    for (const auto& property : made.attributes) {
      take(openmesh::attribute_of(made.mesh, made.numbers, property).view());
    }
  }
  void give_origin(std::uint64_t number, const TakeOrigin& take) const {
    const Made& made = this->made(number);
    take(openmesh::MadeOrigin<Mesh>(made.mesh, made.numbers, curves_).view());
  }
  /// A derived class with its own prepare() must call this one.
  void prepare(const Parameters& /*parameters*/) { made_.clear(); }

 protected:
  ~OpenMeshWorker() = default;

  [[nodiscard]] const Services& services() const { return *services_; }
  /// The host's mesh, with its attributes as properties of their names and types, and the numbers
  /// of its elements (talweg_openmesh_origin.hpp). The mesh is made once for each set_mesh(), and
  /// shared with other instances; only copies may be changed.
  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  [[nodiscard]] const std::vector<Curve>& curves() const { return curves_; }

  /// The value of a parameter of the type TALWEG_VERTICES, as handles.
  [[nodiscard]] std::vector<OpenMesh::VertexHandle> vertices(const Parameters& parameters,
                                                             const char* id) const {
    std::vector<OpenMesh::VertexHandle> handles;
    for (const std::uint32_t v : parameters.vertices(id)) {
      if (v >= mesh_->n_vertices()) {
        throw Failure(TALWEG_BAD_USAGE, std::string(id) + " has vertex " + std::to_string(v) +
                                            ", and the mesh has " +
                                            std::to_string(mesh_->n_vertices()) + ".");
      }
      handles.emplace_back(static_cast<int>(v));
    }
    return handles;
  }
  /// Writes a parameter of the type TALWEG_FIELD to a property of vertices, or one of the type
  /// TALWEG_TRIANGLE_FIELD to a property of faces, of a copy of the mesh. False if the host has set
  /// no value.
  template <class T>
  bool take_field(const Parameters& parameters, const char* id,
                  OpenMesh::PropertyManager<OpenMesh::VPropHandleT<T>>& values) const {
    return take<OpenMesh::VertexHandle>(parameters.field(id), id, mesh_->n_vertices(), values);
  }
  template <class T>
  bool take_field(const Parameters& parameters, const char* id,
                  OpenMesh::PropertyManager<OpenMesh::FPropHandleT<T>>& values) const {
    return take<OpenMesh::FaceHandle>(parameters.field(id), id, mesh_->n_faces(), values);
  }

  /// Passes a field to the host: the property's values on the mesh, or on a copy that still has its
  /// handles.
  template <class T>
  void give_field(const Outputs& outputs, const char* name, const char* unit,
                  const OpenMesh::PropertyManager<OpenMesh::VPropHandleT<T>>& values) const {
    give<OpenMesh::VertexHandle>(outputs, name, unit, mesh_->n_vertices(), values);
  }
  template <class T>
  void give_field(const Outputs& outputs, const char* name, const char* unit,
                  const OpenMesh::PropertyManager<OpenMesh::FPropHandleT<T>>& values) const {
    give<OpenMesh::FaceHandle>(outputs, name, unit, mesh_->n_faces(), values);
  }

  /// Passes a mesh to the host, without deleted elements, which need not be collected. Its
  /// attributes are first the host's, from the properties that a copy of mesh() has, then other
  /// named properties; the host's log gets a sentence on each property that cannot be an attribute.
  /// Its origin is read from the properties of talweg_openmesh_origin.hpp, which such a copy also
  /// has.
  void give_mesh(const Outputs& outputs, const Mesh& mesh) {
    if (!outputs.wants_meshes()) return;
    Made& made = made_.emplace_back(mesh);
    list_attributes(made);
    const openmesh::MeshArrays<Mesh> arrays(made.mesh, made.numbers);
    const std::vector<double> xyz = numbers_of(arrays.positions(), 3, "The positions");
    talweg_mesh given = {};
    given.positions = view(xyz.data(), xyz.size() / 3, 3);
    given.triangles = arrays.triangles();
    outputs.mesh(given);
  }

 private:
  struct Made {
    explicit Made(const Mesh& given) : mesh(given), numbers(mesh) {}
    Mesh mesh;
    openmesh::MeshNumbers numbers;
    std::vector<openmesh::AttributeProperty> attributes;
  };

  void start(std::shared_ptr<const Mesh> mesh) {
    bare_ = std::move(mesh);
    mesh_ = bare_;
    nearest_.reset();
    curves_.clear();
    attributes_.clear();
    made_.clear();
  }

  [[nodiscard]] const Made& made(std::uint64_t number) const {
    if (number < made_.size()) return made_[static_cast<std::size_t>(number)];
    throw Failure(TALWEG_BAD_USAGE, "There is no mesh " + std::to_string(number) + ": " +
                                        std::to_string(made_.size()) +
                                        " were made by the last run that gave meshes.");
  }

  /// Lists the host's attributes, then the plugin's own. OpenMesh's normals, colours and the like
  /// are listed only if the host set them.
  void list_attributes(Made& made) const {
    std::vector<std::string> said;
    for (const openmesh::AttributeProperty& property : attributes_) {
      if (openmesh::detail::find_property(made.mesh, property.element, property.name,
                                          *property.access) == nullptr) {
        said.push_back("The new mesh does not have the property \"" + property.name +
                       "\"; all values of this attribute are " + std::to_string(property.fill) +
                       ".");
      }
      made.attributes.push_back(property);
    }
    for (auto& own : openmesh::properties_of(made.mesh, made.numbers, said)) {
      const bool of_openmesh = own.name.size() > 2 && own.name[1] == ':';
      if (!of_openmesh && !is_host_s(own)) made.attributes.push_back(std::move(own));
    }
    for (const std::string& sentence : said) services_->log(TALWEG_LOG_WARNING, sentence);
  }
  [[nodiscard]] bool is_host_s(const openmesh::AttributeProperty& own) const {
    for (const auto& property : attributes_) {
      if (property.element == own.element && property.name == own.name) return true;
    }
    return false;
  }

  template <class Handle, class Values>
  static bool take(const std::vector<double>& numbers, const char* id, std::size_t count,
                   Values& values) {
    if (numbers.empty()) return false;
    if (numbers.size() != count) {
      throw Failure(TALWEG_BAD_USAGE,
                    std::string(id) + " has " + std::to_string(numbers.size()) +
                        " values, but the mesh has " + std::to_string(count) +
                        (std::is_same_v<Handle, OpenMesh::FaceHandle> ? " faces." : " vertices."));
    }
    for (std::size_t k = 0; k < count; ++k) {
      auto& value = values[Handle(static_cast<int>(k))];
      value = static_cast<std::remove_reference_t<decltype(value)>>(numbers[k]);
    }
    return true;
  }
  template <class Handle, class Values>
  static void give(const Outputs& outputs, const char* name, const char* unit, std::size_t count,
                   const Values& values) {
    std::vector<double> numbers;
    numbers.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
      numbers.push_back(static_cast<double>(values[Handle(static_cast<int>(k))]));
    }
    outputs.field({sizeof(talweg_field), name, unit, view(numbers.data(), numbers.size())});
  }

  const Services* services_;
  std::shared_ptr<const Mesh> bare_, mesh_;  // without and with the host's attributes
  std::unique_ptr<openmesh::Nearest<Mesh>> nearest_;
  std::vector<Curve> curves_;
  std::vector<openmesh::AttributeProperty> attributes_;
  std::deque<Made> made_;  // meshes of the last run
};

}  // namespace talweg::plugin
