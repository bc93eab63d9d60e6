#include "sight.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace talweg::editing {
namespace {

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Moeller and Trumbore's intersection: how far along `way` it meets the triangle; -1 if not.
double meets(const Vector& start, const Vector& way, const Vector& a, const Vector& b,
             const Vector& c) {
  const Vector ab = minus(b, a), ac = minus(c, a);
  const Vector normal = cross(way, ac);
  const double det = dot(ab, normal);
  if (det == 0) return -1;
  const Vector from_a = minus(start, a);
  const double u = dot(from_a, normal) / det;
  if (u < 0 || u > 1) return -1;
  const Vector q = cross(from_a, ab);
  const double v = dot(way, q) / det;
  if (v < 0 || u + v > 1) return -1;
  return dot(ac, q) / det;
}

}  // namespace

bool is_hidden(const MeshArrays& mesh, const Point& point, const std::array<double, 3>& from) {
  const Vector start = position_of(mesh, point);
  const Vector way = minus(from, start);
  std::vector<std::uint32_t> own;  // the corners between which the point lies
  for (std::size_t k = 0; k < 3; ++k) {
    if (point.barycentric[k] > 0) own.push_back(mesh.triangles[point.face][k]);
  }
  const auto touches = [&own](const std::array<std::uint32_t, 3>& t) {
    return std::all_of(own.begin(), own.end(), [&t](std::uint32_t vertex) {
      return std::find(t.begin(), t.end(), vertex) != t.end();
    });
  };
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    const double at =
        meets(start, way, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
    return at > 0 && at < 1 && !touches(t);
  });
}

}  // namespace talweg::editing
