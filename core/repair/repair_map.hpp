// A repair map leads from the numbers of a file's vertices and faces to the repaired mesh's, and
// back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Made by repair(). Vertices of the file keep their numbers, even if no face uses them any more;
/// copies are numbered after the last one. The remaining faces keep the file's order. O(vertices +
/// faces) to make and to convert values, O(points) for a curve. Worse: each curve through a vertex
/// that was split costs O(mesh), and the copies of its vertices cubed.
class RepairMap {
 public:
  static constexpr std::uint32_t kDropped = std::numeric_limits<std::uint32_t>::max();

  /// The face that a face of the file became.
  struct FaceImage {
    std::uint32_t face = kDropped;  ///< of the repaired mesh; for a repeated face the first one
    std::array<std::uint8_t, 3> corner{0, 1, 2};  ///< its corner for each corner here
  };

  RepairMap() = default;
  /// `vertex_to_file`: for every vertex of the repaired mesh. `face_to_file`: for every face of it.
  /// `images`: for every face of the file. `pairs`: (vertex of the file, vertex it became), sorted,
  /// with every vertex of the file at least once.
  RepairMap(std::vector<std::uint32_t> vertex_to_file, std::vector<std::uint32_t> face_to_file,
            std::vector<FaceImage> images,
            const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);

  [[nodiscard]] std::size_t file_vertex_count() const { return first_.size() - 1; }
  [[nodiscard]] std::size_t file_face_count() const { return images_.size(); }
  [[nodiscard]] std::size_t vertex_count() const { return to_file_.size(); }  ///< repaired
  [[nodiscard]] std::size_t face_count() const { return face_to_file_.size(); }
  [[nodiscard]] VertexId file_vertex(VertexId v) const { return VertexId{to_file_[v.index()]}; }
  [[nodiscard]] FaceId file_face(FaceId f) const { return FaceId{face_to_file_[f.index()]}; }
  [[nodiscard]] const FaceImage& image(FaceId file_face) const {
    return images_[file_face.index()];
  }
  /// The vertices that a vertex of the file became: itself, the one it was welded onto, or several
  /// where it was split.
  [[nodiscard]] std::span<const std::uint32_t> images(VertexId file_vertex) const;

  /// Values at the file's vertices or faces, converted to those of the repaired mesh.
  template <class Value>
  [[nodiscard]] std::vector<Value> of_vertices(const std::vector<Value>& values) const {
    return picked(values, to_file_);
  }
  template <class Value>
  [[nodiscard]] std::vector<Value> of_faces(const std::vector<Value>& values) const {
    return picked(values, face_to_file_);
  }

  /// A value for each vertex of the file: that of the vertex it became, the first one of several.
  template <class Value>
  [[nodiscard]] std::vector<Value> to_file_vertices(const std::vector<Value>& values) const {
    std::vector<Value> result;
    result.reserve(file_vertex_count());
    for (std::size_t v = 0; v < file_vertex_count(); ++v) {
      result.push_back(values[images(VertexId{v}).front()]);
    }
    return result;
  }
  /// A value for each face of the file: that of the face it became, and dropped(f) for a face f
  /// that was dropped.
  template <class Value, class Dropped>
  [[nodiscard]] std::vector<Value> to_file_faces(const std::vector<Value>& values,
                                                 Dropped dropped) const {
    std::vector<Value> result;
    result.reserve(images_.size());
    for (std::size_t f = 0; f < images_.size(); ++f) {
      const std::uint32_t face = images_[f].face;
      result.push_back(face == kDropped ? dropped(f) : values[face]);
    }
    return result;
  }

  /// Converts a curve from the file's numbers to those of the repaired mesh. For a vertex that was
  /// split, the copy is chosen that is a neighbour of the points before and after, or else lies on
  /// the same part of the surface. Positions stay as they are. Throws Error(kBadCurve) naming the
  /// position in the curve where there is no such vertex or face, or the face was dropped.
  [[nodiscard]] CurveInput to_repaired(const CurveInput& curve, const Surface& repaired) const;
  /// Corrects points on the repaired mesh that were found by their positions: points at a vertex
  /// that was split are moved to the copy that suits the points before and after, as above.
  [[nodiscard]] std::vector<SurfacePoint> on_one_sheet(std::vector<SurfacePoint> points,
                                                       bool closed, const Surface& repaired) const;
  /// Converts a curve on the repaired mesh to the file's numbers.
  [[nodiscard]] PlacedCurve to_file(PlacedCurve curve) const;

 private:
  template <class Value>
  static std::vector<Value> picked(const std::vector<Value>& values,
                                   const std::vector<std::uint32_t>& from) {
    std::vector<Value> result;
    result.reserve(from.size());
    for (const std::uint32_t i : from) result.push_back(values[i]);
    return result;
  }
  [[nodiscard]] std::vector<FaceCoordinates> moved(std::vector<FaceCoordinates> points) const;
  [[nodiscard]] std::vector<CornerCoordinates> moved(std::vector<CornerCoordinates> points,
                                                     const Surface& repaired) const;
  [[nodiscard]] std::vector<VertexId> moved(const std::vector<VertexId>& ids, bool closed,
                                            const Surface& repaired) const;

  std::vector<std::uint32_t> to_file_;
  std::vector<std::uint32_t> face_to_file_;
  std::vector<FaceImage> images_;
  std::vector<std::uint32_t> first_{0};  ///< index in became_ for each vertex of the file
  std::vector<std::uint32_t> became_;
};

}  // namespace talweg
