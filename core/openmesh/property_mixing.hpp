// Property mixing interpolates the values of new elements.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Core/Utils/vector_traits.hh>

namespace talweg {

/// The kind of interpolation of a property.
enum class Mixing { kLinear, kDirection };  // weighted mean; normalised weighted mean

/// Converts to the number type of a property; integers are rounded and clamped to their range.
template <class Number>
Number mixed_number(double value) {
  if constexpr (std::is_integral_v<Number>) {
    const auto least = static_cast<double>(std::numeric_limits<Number>::lowest());
    const auto most = static_cast<double>(std::numeric_limits<Number>::max());
    const double whole = std::round(value);
    return static_cast<Number>(whole < least ? least : whole > most ? most : whole);
  } else {
    return static_cast<Number>(value);
  }
}

/// The weighted mean of up to three values, numbers or vectors. Values of weight 0 are not read.
template <class Value, class Values>
Value mixed_value(const Values& values, const std::array<int, 3>& from,
                  const std::array<double, 3>& weights, Mixing mixing) {
  const auto mean = [&](auto component) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (weights[k] > 0) sum += weights[k] * static_cast<double>(component(values[from[k]]));
    }
    return sum;
  };
  if constexpr (std::is_arithmetic_v<Value>) {
    return mixed_number<Value>(mean([](const Value& value) { return value; }));
  } else {
    using Traits = OpenMesh::vector_traits<Value>;
    std::array<double, Traits::size_> means{};
    double squares = 0;
    for (std::size_t c = 0; c < Traits::size_; ++c) {
      means[c] = mean([c](const Value& value) { return value[c]; });
      squares += means[c] * means[c];
    }
    const bool scales = mixing == Mixing::kDirection && squares > 0 && std::isfinite(squares);
    Value result;
    for (std::size_t c = 0; c < Traits::size_; ++c) {
      result[c] = mixed_number<typename Traits::value_type>(scales ? means[c] / std::sqrt(squares)
                                                                   : means[c]);
    }
    return result;
  }
}

/// Calls `take` with the values of each standard vertex property that the mesh has: normals,
/// colours and texture coordinates.
template <class Mesh, class Take>
void each_mixed_of_vertices(Mesh& mesh, Take take) {
  const auto give = [&](bool has, auto handle, Mixing mixing) {
    if (has) take(mesh.property(handle), mixing);
  };
  give(mesh.has_vertex_normals(), mesh.vertex_normals_pph(), Mixing::kDirection);
  give(mesh.has_vertex_colors(), mesh.vertex_colors_pph(), Mixing::kLinear);
  give(mesh.has_vertex_texcoords1D(), mesh.vertex_texcoords1D_pph(), Mixing::kLinear);
  give(mesh.has_vertex_texcoords2D(), mesh.vertex_texcoords2D_pph(), Mixing::kLinear);
  give(mesh.has_vertex_texcoords3D(), mesh.vertex_texcoords3D_pph(), Mixing::kLinear);
}
/// The same for halfedges. A value belongs to the corner of the halfedge's face at its head.
template <class Mesh, class Take>
void each_mixed_of_halfedges(Mesh& mesh, Take take) {
  const auto give = [&](bool has, auto handle, Mixing mixing) {
    if (has) take(mesh.property(handle), mixing);
  };
  give(mesh.has_halfedge_normals(), mesh.halfedge_normals_pph(), Mixing::kDirection);
  give(mesh.has_halfedge_colors(), mesh.halfedge_colors_pph(), Mixing::kLinear);
  give(mesh.has_halfedge_texcoords1D(), mesh.halfedge_texcoords1D_pph(), Mixing::kLinear);
  give(mesh.has_halfedge_texcoords2D(), mesh.halfedge_texcoords2D_pph(), Mixing::kLinear);
  give(mesh.has_halfedge_texcoords3D(), mesh.halfedge_texcoords3D_pph(), Mixing::kLinear);
}

}  // namespace talweg
