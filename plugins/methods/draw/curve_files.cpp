#include "curve_files.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "methods/file_calls.hpp"
#include "methods/host_curves.hpp"
#include "talweg/core/drawing/corner_coordinates.hpp"
#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/plugin/talweg_arrays.hpp"

namespace talweg::plugins {
namespace {

PlacedCurve placed(const talweg_curve* curve) {
  if (curve == nullptr || curve->size < sizeof *curve) bad_call("A curve is null or too small.");
  const std::uint64_t n = curve->faces.rows;
  if (n == 0 || curve->barycentrics.rows != n || curve->positions.rows != n) {
    bad_call("A curve to write needs a face, barycentrics and a position for each of its points.");
  }
  if (curve->vertices.rows != 0 && curve->vertices.rows != n) {
    bad_call("A curve to write has another number of vertices than of points.");
  }
  talweg_curve without_vertices = *curve;
  without_vertices.vertices = plugin::kNoArray;
  CurveInput input = input_of(without_vertices);
  PlacedCurve result;
  result.closed = input.closed;
  result.exact = marks_of(input);
  result.pins = std::move(input.pins);
  std::sort(result.pins.begin(), result.pins.end());
  if (!result.pins.empty() && result.pins.back() >= n) {
    bad_call(
        fmt::format("A curve to write has the pin {}, but only {} points.", result.pins.back(), n));
  }
  result.faces = std::get<std::vector<FaceCoordinates>>(std::move(input.points));
  const auto numbers = plugin::numbers_of(curve->positions, 3, "The curve's positions");
  for (std::size_t k = 0; k < numbers.size(); k += 3) result.positions.emplace_back(&numbers[k]);
  result.vertices.resize(n);
  if (curve->vertices.rows == 0) return result;
  plugin::check_array(curve->vertices, 1, "The curve's vertices");
  if (curve->vertices.type != TALWEG_UINT32 || curve->vertices.stride > sizeof(std::uint32_t)) {
    bad_call("The vertices of a curve to write are not dense and UINT32.");
  }
  const auto* vertices = static_cast<const std::uint32_t*>(curve->vertices.data);
  for (std::size_t k = 0; k < n; ++k) {
    if (vertices[k] != TALWEG_NO_VERTEX) result.vertices[k] = VertexId{vertices[k]};
  }
  return result;
}

CoordinateFrame frame_of(const char* text) { return frame_named(text == nullptr ? "" : text); }

/// The triangles of a mesh, and its number of vertices. Positions are not needed.
class Triangles {
 public:
  explicit Triangles(const talweg_mesh& mesh)
      : vertices_(plugin::checked(&mesh, "The mesh").positions.rows),
        indices_(plugin::indices_of(mesh.triangles, 3, "The mesh's triangles")),
        triangles_(indices_.size() / 3) {
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      triangles_[k / 3][k % 3] = indices_[k];
    }
  }

  [[nodiscard]] std::vector<FaceCoordinates> faces_of(
      const std::vector<CornerCoordinates>& points) const {
    return in_faces(triangles_, vertices_, points);
  }
  /// Adds the corners of its faces to a curve.
  void put_corners(PlacedCurve& curve) const {
    curve.vertex_count = vertices_;
    for (const FaceCoordinates& at : curve.faces) {
      if (at.face.index() >= triangles_.size()) {
        bad_call(fmt::format("A curve to write has the face {}; the mesh has {}.", at.face.index(),
                             triangles_.size()));
      }
      const auto [a, b, c] = triangles_[at.face.index()];
      curve.corners.push_back({VertexId{a}, VertexId{b}, VertexId{c}});
    }
  }

 private:
  std::size_t vertices_;
  std::vector<std::uint32_t> indices_;
  std::vector<Triangle> triangles_;
};

talweg_status write_on(const char* path, const char* mesh_unit, const talweg_mesh* mesh,
                       const talweg_curve* const* curves, std::uint64_t count, char* message,
                       std::uint64_t message_size) noexcept {
  return attempt(message, message_size, [&] {
    if (path == nullptr || (curves == nullptr && count > 0))
      bad_call("The path or the curves are null.");
    std::vector<PlacedCurve> ready;
    for (std::uint64_t k = 0; k < count; ++k) ready.push_back(placed(curves[k]));
    if (mesh != nullptr) {
      const Triangles triangles(*mesh);
      for (PlacedCurve& curve : ready) triangles.put_corners(curve);
    }
    write_curves(path, ready, frame_of(mesh_unit));
  });
}

/// The views of a curve for the interface; the object owns the viewed lists.
class Input {
 public:
  explicit Input(const CurveInput& curve) {
    view_.size = sizeof view_;
    view_.closed = curve.closed ? 1 : 0;
    std::visit([this](const auto& points) { this->take(points); }, curve.points);
    for (const std::size_t pin : curve.pins) pins_.push_back(static_cast<std::uint32_t>(pin));
    view_.pins = plugin::view(pins_.data(), pins_.size());
    take_marks(marks_of(curve));
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  [[nodiscard]] const talweg_curve& view() const { return view_; }

 private:
  void take(const std::vector<VertexId>& ids) {
    for (const VertexId v : ids) indices_.push_back(static_cast<std::uint32_t>(v.index()));
    view_.vertices = plugin::view(indices_.data(), indices_.size());
  }
  void take(const std::vector<FaceCoordinates>& points) {
    for (const FaceCoordinates& at : points) {
      indices_.push_back(static_cast<std::uint32_t>(at.face.index()));
      numbers_.insert(numbers_.end(), at.barycentric.begin(), at.barycentric.end());
    }
    view_.faces = plugin::view(indices_.data(), indices_.size());
    view_.barycentrics = plugin::view(numbers_.data(), points.size(), 3);
  }
  void take(const std::vector<Point>& points) {
    for (const Point& p : points) numbers_.insert(numbers_.end(), p.begin(), p.end());
    view_.positions = plugin::view(numbers_.data(), points.size(), 3);
  }
  static void take(const std::vector<CornerCoordinates>& /*points*/) {
    throw plugin::Failure(
        TALWEG_BAD_FILE,
        "The file places its points between vertices of a mesh (.border); read it "
        "together with that mesh.");
  }

  void take_marks(std::vector<double> marks) {
    if (marks.empty()) return;
    marks_ = std::move(marks);
    exact_ = {sizeof exact_, TALWEG_EXACT, "mesh units",
              plugin::view(marks_.data(), marks_.size())};
    view_.field_count = 1;
    view_.fields = &fields_;
  }

  talweg_curve view_ = {};
  talweg_field exact_ = {};
  const talweg_field* fields_ = &exact_;
  std::vector<std::uint32_t> indices_, pins_;
  std::vector<double> numbers_, marks_;
};

/// Converts points between vertices to points in faces.
void place_in_faces(std::vector<CurveInput>& curves, const talweg_mesh& mesh) {
  std::optional<Triangles> triangles;
  for (CurveInput& curve : curves) {
    const auto* between = std::get_if<std::vector<CornerCoordinates>>(&curve.points);
    if (between == nullptr) continue;
    if (!triangles) triangles.emplace(mesh);
    curve.points = triangles->faces_of(*between);
  }
}

talweg_status read_on(const char* path, const char* mesh_unit, const talweg_mesh* mesh,
                      const talweg_sink* sink, char* message, std::uint64_t message_size) noexcept {
  return attempt(message, message_size, [&] {
    if (path == nullptr) bad_call("The path is null.");
    if (sink == nullptr || sink->size < sizeof *sink) bad_call("The sink is null or too small.");
    std::string notes;
    std::vector<CurveInput> curves = read_curves(path, frame_of(mesh_unit));
    if (mesh != nullptr) place_in_faces(curves, *mesh);
    for (const CurveInput& curve : curves) {
      for (const std::string& sentence : curve.notes)
        notes += (notes.empty() ? "" : " ") + sentence;
      if (sink->curve == nullptr) continue;
      const Input input(curve);
      if (sink->curve(sink->context, &input.view()) != TALWEG_OK) {
        throw plugin::Failure(TALWEG_HOST_FAILED, "The host refused a curve.");
      }
    }
    tell(notes.c_str(), message, message_size);
  });
}

talweg_status write_in(const char* path, const char* mesh_unit, const talweg_curve* const* curves,
                       std::uint64_t count, char* message, std::uint64_t message_size) noexcept {
  return write_on(path, mesh_unit, nullptr, curves, count, message, message_size);
}

talweg_status read_in(const char* path, const char* mesh_unit, const talweg_sink* sink,
                      char* message, std::uint64_t message_size) noexcept {
  return read_on(path, mesh_unit, nullptr, sink, message, message_size);
}

talweg_status write(const char* path, const talweg_curve* const* curves, std::uint64_t count,
                    char* message, std::uint64_t message_size) noexcept {
  return write_in(path, nullptr, curves, count, message, message_size);
}

talweg_status read(const char* path, const talweg_sink* sink, char* message,
                   std::uint64_t message_size) noexcept {
  return read_in(path, nullptr, sink, message, message_size);
}

}  // namespace

const talweg_curve_files_3* curve_files_3() {
  static constexpr talweg_curve_files_3 kFiles = {sizeof kFiles, write_on, read_on};
  return &kFiles;
}

const talweg_curve_files_2* curve_files_2() {
  static constexpr talweg_curve_files_2 kFiles = {sizeof kFiles, write_in, read_in};
  return &kFiles;
}

const talweg_curve_files* curve_files() {
  static constexpr talweg_curve_files kFiles = {sizeof kFiles, write, read};
  return &kFiles;
}

}  // namespace talweg::plugins
