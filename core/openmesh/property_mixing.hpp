// Property mixing gives a new element values between those of old ones.
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

/// What a mixed value is.
enum class Mixing { kLinear, kDirection };  // between the old ones; and then made as long as one

/// A number of the type that a property has; whole ones are rounded.
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

/// The mean of three values of a number or vector type, of those whose weight is not 0.
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

/// Hands over each property of vertices that a mesh has of its own and that can be mixed, but for
/// the points.
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
/// The same of halfedges, whose values belong to the corner of their face at their head.
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
