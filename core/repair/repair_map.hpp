// A repair map converts vertices, faces and curves between a file and its repaired mesh.
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

/// Made by repair(). Vertices of the file keep their numbers, even without a face; copies are
/// numbered after the last vertex of the file. The kept faces are in the order of the file. Making
/// the map and converting values is O(vertices + faces), converting a curve O(points). A curve
/// through a split vertex costs O(mesh), and at each point the cube of the number of copies.
class RepairMap {
 public:
  static constexpr std::uint32_t kDropped = std::numeric_limits<std::uint32_t>::max();

  /// The face of the repaired mesh that a face of the file became.
  struct FaceImage {
    std::uint32_t face = kDropped;                ///< for a repeated face, the face that stays
    std::array<std::uint8_t, 3> corner{0, 1, 2};  ///< per corner in the file, the corner of `face`
  };

  RepairMap() = default;
  /// `vertex_to_file`, `face_to_file`: one entry per vertex and face of the repaired mesh.
  /// `images`: one per face of the file. `pairs`: (vertex of the file, repaired vertex), sorted,
  /// with every vertex of the file at least once.
  RepairMap(std::vector<std::uint32_t> vertex_to_file, std::vector<std::uint32_t> face_to_file,
            std::vector<FaceImage> images,
            const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);

  [[nodiscard]] std::size_t file_vertex_count() const { return first_.size() - 1; }
  [[nodiscard]] std::size_t file_face_count() const { return images_.size(); }
  [[nodiscard]] std::size_t vertex_count() const {
    return to_file_.size();
  }  ///< of the repaired mesh
  [[nodiscard]] std::size_t face_count() const { return face_to_file_.size(); }
  [[nodiscard]] VertexId file_vertex(VertexId v) const { return VertexId{to_file_[v.index()]}; }
  [[nodiscard]] FaceId file_face(FaceId f) const { return FaceId{face_to_file_[f.index()]}; }
  [[nodiscard]] const FaceImage& image(FaceId file_face) const {
    return images_[file_face.index()];
  }
  /// The repaired vertices of a vertex of the file: itself, the vertex that it was welded onto, or
  /// several if it was split.
  [[nodiscard]] std::span<const std::uint32_t> images(VertexId file_vertex) const;

  /// Converts values per vertex or face of the file to values per vertex or face of the repaired
  /// mesh.
  template <class Value>
  [[nodiscard]] std::vector<Value> of_vertices(const std::vector<Value>& values) const {
    return picked(values, to_file_);
  }
  template <class Value>
  [[nodiscard]] std::vector<Value> of_faces(const std::vector<Value>& values) const {
    return picked(values, face_to_file_);
  }

  /// Converts values per repaired vertex to values per file vertex; a split vertex gets the value
  /// of its first image.
  template <class Value>
  [[nodiscard]] std::vector<Value> to_file_vertices(const std::vector<Value>& values) const {
    std::vector<Value> result;
    result.reserve(file_vertex_count());
    for (std::size_t v = 0; v < file_vertex_count(); ++v) {
      result.push_back(values[images(VertexId{v}).front()]);
    }
    return result;
  }
  /// Converts values per repaired face to values per file face; a dropped face f gets dropped(f).
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

  /// Converts a curve from the file's numbers to numbers of the repaired mesh. At a split vertex,
  /// the curve takes the copy that is a neighbour of the previous and next points, or at least lies
  /// on the same component. A curve of positions is unchanged. Throws Error(kBadCurve) with the
  /// place in the curve for a vertex or face that does not exist or a face that was dropped.
  [[nodiscard]] CurveInput to_repaired(const CurveInput& curve, const Surface& repaired) const;
  /// Corrects points on the repaired mesh that were found by position: points at a split vertex
  /// move to the copy that to_repaired() would take.
  [[nodiscard]] std::vector<SurfacePoint> on_one_sheet(std::vector<SurfacePoint> points,
                                                       bool closed, const Surface& repaired) const;
  /// Converts a curve on the repaired mesh to numbers of the file.
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
  std::vector<std::uint32_t> first_{
      0};  ///< per vertex of the file, the index of its first image in became_
  std::vector<std::uint32_t> became_;
};

}  // namespace talweg
