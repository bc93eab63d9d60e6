#include "talweg/core/formats/curve_file.hpp"

#include <algorithm>
#include <string>

#include "talweg/core/formats/curve_formats.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using formats::WrittenCurve;

constexpr const char* kKnown = "known are .obj .ply .vtp .vtk .mrk.json .txt .json";

std::string curve_extension(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name.ends_with(".mrk.json") ? ".mrk.json"
                                     : std::filesystem::path(name).extension().string();
}

using Reader = std::vector<CurveInput> (*)(const formats::Source&);

Reader reader_of(const std::filesystem::path& path) {
  const std::string extension = curve_extension(path);
  if (extension == ".obj") return formats::read_obj;
  if (extension == ".ply") return formats::read_ply;
  if (extension == ".vtp") return formats::read_vtp;
  if (extension == ".vtk") return formats::read_vtk;
  if (extension == ".txt") return formats::read_txt;
  if (extension == ".json" || extension == ".mrk.json") return formats::read_json;
  cannot_read(path, "no curve format has the extension '" + extension + "'; " + kKnown);
}

/// Barycentrics that SurfacePoint::on_edge gives back bit for bit: 1 - t is taken once.
FaceCoordinates exact_coordinates(const Surface& surface, const SurfacePoint& point, FaceId face) {
  FaceCoordinates at = coordinates_in(surface, point, face);
  if (const auto* edge = std::get_if<OnEdge>(&point.where())) {
    const HalfedgeId h = halfedge_of(edge->edge);
    const auto corners = surface.corners(face);
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] == surface.tail(h)) at.barycentric[k] = 1 - edge->t;
      if (corners[k] == surface.head(h)) at.barycentric[k] = edge->t;
    }
  }
  return at;
}

WrittenCurve placed(const SurfaceMesh& mesh, const SurfaceCurve& curve, std::size_t number) {
  const std::string name = "Curve " + std::to_string(number);
  const std::size_t n = curve.points.size();
  if (n < 2) throw Error(ErrorCode::kBadCurve, name + " has fewer than two points.");
  WrittenCurve result{curve.closed, curve.points, {}, positions_of(mesh, curve)};
  for (std::size_t k = 0; k < n; ++k) {
    const bool last = k + 1 == n && !curve.closed;
    const SurfacePoint& next = last ? curve.points[k - 1] : curve.points[(k + 1) % n];
    const FaceId face = common_face(mesh.surface(), curve.points[k], next);
    if (!face.valid()) {
      throw Error(ErrorCode::kBadCurve,
                  name + ": point " + std::to_string(k) + " and the next lie in no common face.");
    }
    result.faces.push_back(exact_coordinates(mesh.surface(), curve.points[k], face));
  }
  return result;
}

}  // namespace

std::vector<CurveInput> read_curves(const std::filesystem::path& path) {
  const Reader reader = reader_of(path);
  const std::string bytes = read_file(path);
  return reader({path, bytes});
}

std::vector<CurveInput> read_curves(const std::filesystem::path& path, std::string_view bytes) {
  const Reader reader = reader_of(path);
  if (bytes.empty()) cannot_read(path, "the file is empty");
  return reader({path, bytes});
}

void write_curves(const std::filesystem::path& path, const SurfaceMesh& mesh,
                  std::span<const SurfaceCurve> curves) {
  const std::string extension = curve_extension(path);
  const auto writer = extension == ".obj"        ? formats::write_obj
                      : extension == ".ply"      ? formats::write_ply
                      : extension == ".vtp"      ? formats::write_vtp
                      : extension == ".vtk"      ? formats::write_vtk
                      : extension == ".json"     ? formats::write_json
                      : extension == ".mrk.json" ? formats::write_slicer
                                                 : nullptr;
  const bool as_ids = extension == ".txt";
  if (writer == nullptr && !as_ids) {
    cannot_write(path, "no curve format has the extension '" + extension + "'; " + kKnown);
  }
  if (curves.empty()) throw Error(ErrorCode::kBadCurve, "There is no curve to write.");
  std::vector<WrittenCurve> ready;
  for (const SurfaceCurve& curve : curves) ready.push_back(placed(mesh, curve, ready.size()));
  write_file(path, as_ids ? formats::write_txt(path, ready) : writer(ready));
}

}  // namespace talweg
