// Curves of the interface as handles of an OpenMesh mesh.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "talweg_arrays.hpp"
#include "talweg_openmesh_mesh.hpp"
#include "talweg_openmesh_nearest.hpp"
#include "talweg_plugin.h"
#include "talweg_way_points.h"

namespace talweg::openmesh {

/// A point of a curve: at a vertex, or in a face (or on its edges), or with both given.
struct CurvePoint {
  VertexHandle vertex;                     ///< invalid: no vertex, or not given
  FaceHandle face;                         ///< invalid: only the vertex is given
  std::array<double, 3> barycentric = {};  ///< in the order of corners_of(mesh, face)
};

struct Curve {
  bool closed = false;
  std::vector<CurvePoint> points;
  std::vector<std::uint32_t> pins;  ///< indices of points that must not move
  std::vector<double> exact;        ///< marks of the points (talweg_way_points.h); empty: no marks
};

namespace detail {

/// Reads a host's curve on a mesh whose handles equal the interface's indices.
template <class Mesh>
class CurveReader {
 public:
  /// `number` is the index of the curve, for messages.
  CurveReader(const Mesh& mesh, Nearest<Mesh>& nearest, std::size_t number)
      : mesh_(mesh), nearest_(nearest), name_("Curve " + std::to_string(number)) {}

  Curve read(const talweg_curve& given) const {
    Curve curve;
    if (given.closed > 1) bad(TALWEG_BAD_USAGE, "has a `closed` other than 0 or 1");
    curve.closed = given.closed == 1;
    if (given.vertices.rows > 0) {
      curve.points = at_vertices(given.vertices);
    } else if (given.faces.rows > 0 || given.barycentrics.rows > 0) {
      curve.points = in_faces(given);
    } else {
      curve.points = near(given.positions);
    }
    if (curve.points.empty()) bad(TALWEG_BAD_CURVE, "has no points");
    curve.pins = plugin::indices_of(given.pins, 1, name_ + "'s pins");
    for (const std::uint32_t pin : curve.pins) {
      if (pin < curve.points.size()) continue;
      bad(TALWEG_BAD_CURVE, "has the pin " + std::to_string(pin) + ", and " +
                                std::to_string(curve.points.size()) + " points");
    }
    read_marks(given, curve);
    return curve;
  }

 private:
  [[noreturn]] void bad(talweg_status status, const std::string& problem) const {
    throw plugin::Failure(status, name_ + " " + problem + ".");
  }
  void check(std::uint32_t index, std::size_t count, const char* what, std::size_t point) const {
    if (index < count) return;
    bad(TALWEG_BAD_CURVE, std::string("has ") + what + " " + std::to_string(index) + " at point " +
                              std::to_string(point) + ", and the mesh has " +
                              std::to_string(count));
  }

  [[nodiscard]] std::vector<CurvePoint> at_vertices(const talweg_array& given) const {
    std::vector<CurvePoint> points;
    for (const std::uint32_t v : plugin::indices_of(given, 1, name_ + "'s vertices")) {
      check(v, mesh_.n_vertices(), "vertex", points.size());
      points.push_back({VertexHandle(static_cast<int>(v)), FaceHandle(), {}});
    }
    return points;
  }

  [[nodiscard]] std::vector<CurvePoint> in_faces(const talweg_curve& given) const {
    const auto faces = plugin::indices_of(given.faces, 1, name_ + "'s faces");
    const auto numbers = plugin::numbers_of(given.barycentrics, 3, name_ + "'s barycentrics");
    if (3 * faces.size() != numbers.size()) {
      bad(TALWEG_BAD_USAGE, "has " + std::to_string(faces.size()) + " faces and " +
                                std::to_string(numbers.size() / 3) + " rows of barycentrics");
    }
    std::vector<CurvePoint> points;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      check(faces[k], mesh_.n_faces(), "face", k);
      points.push_back(in_face(FaceHandle(static_cast<int>(faces[k])),
                               {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]}));
      const auto& [a, b, c] = points.back().barycentric;
      if (a >= 0 && b >= 0 && c >= 0 && std::abs(a + b + c - 1) <= 1e-6) continue;
      bad(TALWEG_BAD_CURVE, "has barycentrics at point " + std::to_string(k) +
                                " that are below 0 or do not add up to 1");
    }
    return points;
  }

  [[nodiscard]] std::vector<CurvePoint> near(const talweg_array& given) const {
    const std::vector<double> xyz = plugin::numbers_of(given, 3, name_ + "'s positions");
    std::vector<CurvePoint> points;
    for (std::size_t k = 0; k < xyz.size(); k += 3) {
      const std::array<double, 3> place = {xyz[k], xyz[k + 1], xyz[k + 2]};
      for (const double x : place) {
        if (std::isfinite(x)) continue;
        bad(TALWEG_BAD_CURVE,
            "has a coordinate at point " + std::to_string(k / 3) + " that is not a finite number");
      }
      const auto [face, barycentric] = nearest_.to(place);
      points.push_back(in_face(face, barycentric));
    }
    return points;
  }

  [[nodiscard]] CurvePoint in_face(FaceHandle face, const std::array<double, 3>& at) const {
    CurvePoint point{VertexHandle(), face, at};
    for (std::size_t i = 0; i < 3; ++i) {
      if (at[i] == 1) point.vertex = corners_of(mesh_, face)[i];
    }
    return point;
  }

  void read_marks(const talweg_curve& given, Curve& curve) const {
    if (given.field_count > 0 && given.fields == nullptr) {
      bad(TALWEG_BAD_USAGE, "has fields, but the list of them is null");
    }
    for (std::uint32_t k = 0; k < given.field_count; ++k) {
      const talweg_field& field = plugin::checked(given.fields[k], "A field of a curve");
      if (field.name == nullptr || std::string_view(field.name) != TALWEG_EXACT) continue;
      curve.exact = plugin::numbers_of(field.values, 1, "The field exact");
      if (curve.exact.size() == curve.points.size()) continue;
      bad(TALWEG_BAD_USAGE, "has " + std::to_string(curve.points.size()) + " points, and " +
                                std::to_string(curve.exact.size()) + " marks in the field exact");
    }
  }

  const Mesh& mesh_;
  Nearest<Mesh>& nearest_;
  std::string name_;
};

}  // namespace detail
}  // namespace talweg::openmesh
