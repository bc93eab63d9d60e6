#include "talweg/core/drawing/corner_coordinates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

[[noreturn]] void bad_point(std::size_t k, const std::string& what) {
  throw Error(ErrorCode::kBadCurve, fmt::format("At position {} of the curve: {}.", k, what));
}

/// The faces of a surface at its vertices.
class SurfaceFaces {
 public:
  explicit SurfaceFaces(const Surface& surface) : surface_(surface) {}
  [[nodiscard]] std::size_t vertex_count() const { return surface_.vertex_count(); }
  [[nodiscard]] auto corners(FaceId face) const { return surface_.corners(face); }
  [[nodiscard]] std::vector<FaceId> at(VertexId v) const {
    if (!surface_.halfedge(v).valid()) return {};
    return faces_at(surface_, SurfacePoint::at_vertex(surface_, v));
  }

 private:
  const Surface& surface_;
};

/// The triangles of a list at its vertices.
class ListedFaces {
 public:
  ListedFaces(std::span<const Triangle> triangles, std::size_t vertices)
      : triangles_(triangles), ends_(vertices), faces_(3 * triangles.size()) {
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      for (const std::uint32_t v : triangles[f]) ++ends_[checked(v, f)];
    }
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    for (std::size_t f = triangles.size(); f-- > 0;) {
      for (const std::uint32_t v : triangles[f]) faces_[--ends_[v]] = FaceId{f};
    }
  }
  [[nodiscard]] std::size_t vertex_count() const { return ends_.size(); }
  [[nodiscard]] std::array<VertexId, 3> corners(FaceId face) const {
    const auto [a, b, c] = triangles_[face.index()];
    return {VertexId{a}, VertexId{b}, VertexId{c}};
  }
  [[nodiscard]] std::span<const FaceId> at(VertexId v) const {
    const std::size_t i = v.index();
    const std::size_t end = i + 1 < ends_.size() ? ends_[i + 1] : faces_.size();
    return std::span(faces_).subspan(ends_[i], end - ends_[i]);
  }

 private:
  [[nodiscard]] std::uint32_t checked(std::uint32_t v, std::size_t face) const {
    if (v < ends_.size()) return v;
    throw Error(ErrorCode::kBadMesh,
                fmt::format("Face {} has the vertex {}; the mesh has {}.", face, v, ends_.size()));
  }

  std::span<const Triangle> triangles_;
  std::vector<std::size_t> ends_;  // per vertex, the end of its faces, later their beginning
  std::vector<FaceId> faces_;
};

/// Whether all vertices with a weight are among the corners.
bool has_all(const std::array<VertexId, 3>& corners, const CornerCoordinates& at) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (at.weights[c] != 0 &&
        std::find(corners.begin(), corners.end(), at.corners[c]) == corners.end()) {
      return false;
    }
  }
  return true;
}

void check(std::size_t vertices, const CornerCoordinates& at, std::size_t k) {
  for (const VertexId v : at.corners) {
    if (v.index() >= vertices) {
      bad_point(k, fmt::format("there is no vertex {}; the mesh has {}, counted from 0", v.index(),
                               vertices));
    }
  }
  const auto& w = at.weights;
  const bool fine = std::all_of(w.begin(), w.end(), [](double x) { return x >= 0; });
  if (!fine || !(w[0] + w[1] + w[2] > 0) || !std::isfinite(w[0] + w[1] + w[2])) {
    bad_point(k, fmt::format("the weights {}, {} and {} are not those of a point between vertices",
                             w[0], w[1], w[2]));
  }
}

template <class Faces>
FaceId first_face(const Faces& faces, const CornerCoordinates& at) {
  FaceId best;
  const auto weighted =
      std::find_if(at.weights.begin(), at.weights.end(), [](double w) { return w != 0; });
  if (weighted == at.weights.end()) return best;
  const VertexId corner = at.corners[static_cast<std::size_t>(weighted - at.weights.begin())];
  for (const FaceId face : faces.at(corner)) {
    if ((!best.valid() || face.index() < best.index()) && has_all(faces.corners(face), at)) {
      best = face;
    }
  }
  return best;
}

/// The point in the face with these corners.
FaceCoordinates placed(FaceId face, const std::array<VertexId, 3>& corners,
                       const CornerCoordinates& at) {
  const double sum = at.weights[0] + at.weights[1] + at.weights[2];
  const bool exact = std::abs(sum - 1) < 1e-15;
  FaceCoordinates found{face};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto to = std::find(corners.begin(), corners.end(), at.corners[c]);
    if (to == corners.end()) continue;  // the corner's weight is 0
    found.barycentric[static_cast<std::size_t>(to - corners.begin())] +=
        exact ? at.weights[c] : at.weights[c] / sum;
  }
  return found;
}

template <class Faces>
std::vector<FaceCoordinates> all_in_faces(const Faces& faces,
                                          const std::vector<CornerCoordinates>& points) {
  std::vector<FaceCoordinates> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CornerCoordinates& at = points[k];
    check(faces.vertex_count(), at, k);
    const FaceId face = first_face(faces, at);
    if (!face.valid()) {
      bad_point(k,
                fmt::format("no face of the mesh has the vertices {}, {} and {}; does the "
                            "curve belong to this mesh?",
                            at.corners[0].index(), at.corners[1].index(), at.corners[2].index()));
    }
    result.push_back(placed(face, faces.corners(face), at));
  }
  return result;
}

}  // namespace

FaceId any_face(const Surface& surface, const CornerCoordinates& at) {
  return first_face(SurfaceFaces(surface), at);
}

std::vector<FaceCoordinates> in_faces(const Surface& surface,
                                      const std::vector<CornerCoordinates>& points) {
  return all_in_faces(SurfaceFaces(surface), points);
}

std::vector<FaceCoordinates> in_faces(std::span<const Triangle> triangles, std::size_t vertices,
                                      const std::vector<CornerCoordinates>& points) {
  return all_in_faces(ListedFaces(triangles, vertices), points);
}

}  // namespace talweg
