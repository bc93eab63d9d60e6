#include "direction_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace talweg::plugins {
namespace {

/// The function's values on the face, scaled so that the largest has absolute value 1.
std::array<double, 3> values_of(const Surface& surface, FaceId f, const ScaledField& u) {
  const auto corners = surface.corners(f);
  std::int32_t stage = u.stage[corners[0].index()];
  for (const VertexId v : corners) stage = std::min(stage, u.stage[v.index()]);
  std::array<double, 3> values{};
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t v = corners[k].index();
    values[k] = std::ldexp(u.value[v], -ScaledField::kStageBits * (u.stage[v] - stage));
    largest = std::max(largest, std::abs(values[k]));
  }
  if (largest > 0) {
    for (double& value : values) value /= largest;
  }
  return values;
}

/// The gradients of the three hat functions of a face.
struct FaceGradients {
  std::array<Point, 3> hat;  ///< of each corner's hat function, in 1 / mesh units
  double area = 0;           ///< 0 if there are no gradients
};

FaceGradients gradients_of(const SurfaceMesh& mesh, FaceId f) {
  const auto corners = mesh.surface().corners(f);
  const Point &p = mesh.point(corners[0]), &q = mesh.point(corners[1]), &r = mesh.point(corners[2]);
  const Point normal = (q - p).cross(r - p);
  const double squared = normal.squaredNorm();
  FaceGradients g{{Point::Zero(), Point::Zero(), Point::Zero()}, 0};
  if (!(squared > 0) || !std::isfinite(1 / squared)) return g;
  g.area = std::sqrt(squared) / 2;
  g.hat = {normal.cross(r - q) / squared, normal.cross(p - r) / squared,
           normal.cross(q - p) / squared};
  return g;
}

Point unit(const Point& v) {
  const double norm = v.norm();
  return norm > 0 && std::isfinite(norm) ? Point(v / norm) : Point(Point::Zero());
}

Point sum_beside(const Surface& surface, const DirectionField& field, std::size_t f) {
  Point sum = field[f];
  HalfedgeId h = surface.halfedge(FaceId{f});
  for (int k = 0; k < 3; ++k, h = surface.next(h)) {
    if (surface.has_face(twin(h))) sum += field[surface.face(twin(h)).index()];
  }
  return sum;
}

}  // namespace

DirectionField gradient_directions(const SurfaceMesh& mesh, const ScaledField& u,
                                   const std::vector<char>& side,
                                   const std::vector<char>& skipped) {
  DirectionField field(side.size(), Point::Zero());
  for (std::size_t f = 0; f < field.size(); ++f) {
    if (skipped[f] != 0) continue;
    const std::array<double, 3> value = values_of(mesh.surface(), FaceId{f}, u);
    const FaceGradients g = gradients_of(mesh, FaceId{f});
    // Differences of values make the gradient of a constant function exactly 0.
    const Point gradient =
        unit((value[1] - value[0]) * g.hat[1] + (value[2] - value[0]) * g.hat[2]);
    field[f] = side[f] != 0 ? Point(-gradient) : gradient;
  }
  return field;
}

std::size_t fill_directions(const Surface& surface, DirectionField& field) {
  std::vector<std::size_t> empty;
  for (std::size_t f = 0; f < field.size(); ++f) {
    if (field[f].isZero(0)) empty.push_back(f);
  }
  const std::size_t count = empty.size();
  for (bool again = true; again && !empty.empty();) {
    std::vector<Point> found;
    found.reserve(empty.size());
    for (const std::size_t f : empty) found.push_back(unit(sum_beside(surface, field, f)));
    std::vector<std::size_t> still;
    for (std::size_t k = 0; k < empty.size(); ++k) {
      field[empty[k]] = found[k];
      if (found[k].isZero(0)) still.push_back(empty[k]);
    }
    again = still.size() < empty.size();
    empty = std::move(still);
  }
  return count;
}

void smooth_directions(const Surface& surface, DirectionField& field, int passes) {
  DirectionField next(field.size());
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t f = 0; f < field.size(); ++f) next[f] = unit(sum_beside(surface, field, f));
    field.swap(next);
  }
}

std::vector<double> divergence(const SurfaceMesh& mesh, const DirectionField& field,
                               bool area_weights) {
  std::vector<double> result(mesh.surface().vertex_count(), 0.0);
  for (std::size_t f = 0; f < field.size(); ++f) {
    const FaceGradients g = gradients_of(mesh, FaceId{f});
    const auto corners = mesh.surface().corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k) {
      result[corners[k].index()] += (area_weights ? g.area : 1.0) * field[f].dot(g.hat[k]);
    }
  }
  return result;
}

}  // namespace talweg::plugins
