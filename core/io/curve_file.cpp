#include "talweg/core/io/curve_file.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/other_formats.hpp"
#include "talweg/core/io/text_encoding.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace formats {

bool has_marks(std::span<const PlacedCurve> curves) {
  return std::any_of(curves.begin(), curves.end(), [](const PlacedCurve& curve) {
    return std::any_of(curve.exact.begin(), curve.exact.end(),
                       [](double mark) { return is_mark(mark) && mark != kNotSaid; });
  });
}

std::vector<double> all_marks(std::span<const PlacedCurve> curves) {
  std::vector<double> marks;
  for (const PlacedCurve& curve : curves) {
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      const double mark = curve.exact.empty() ? kNotSaid : curve.exact[k];
      marks.push_back(is_mark(mark) ? mark : kNotSaid);
    }
  }
  return marks;
}

}  // namespace formats
namespace {

constexpr const char* kKnown = "known are .obj .ply .vtp .vtk .mrk.json .txt .json";

std::string curve_extension(const std::filesystem::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name.ends_with(".mrk.json") ? ".mrk.json"
                                     : std::filesystem::path(name).extension().string();
}

using CurveReader = std::vector<CurveInput> (*)(const formats::Source&);

CurveReader curve_reader_of(const std::filesystem::path& path) {
  const std::string extension = curve_extension(path);
  if (extension == ".obj") return formats::read_obj;
  if (extension == ".ply") return formats::read_ply;
  if (extension == ".vtp") return formats::read_vtp;
  if (extension == ".vtk") return formats::read_vtk;
  if (extension == ".txt") return formats::read_txt;
  if (extension == ".json" || extension == ".mrk.json") return formats::read_json;
  cannot_read(path, fmt::format("no curve format has the extension '{}'{}; {}", extension,
                                instead_of(path), kKnown));
}

}  // namespace

std::vector<CurveInput> read_curves(const std::filesystem::path& path,
                                    const LengthUnit& mesh_unit) {
  static_cast<void>(curve_reader_of(path));  // checks the extension before the file is read
  return read_curves(path, read_file(path), mesh_unit);
}

std::vector<CurveInput> read_curves(const std::filesystem::path& path, std::string_view bytes,
                                    const LengthUnit& mesh_unit) {
  const CurveReader reader = curve_reader_of(path);
  if (bytes.empty()) cannot_read(path, "the file is empty");
  formats::check_encoding(path, bytes);
  if (reader != formats::read_json && reader != formats::read_vtp) {
    formats::check_line_ends(path, bytes);
  }
  if (reader == formats::read_obj || reader == formats::read_txt) {
    formats::check_no_nul(path, bytes);
  }
  return reader({path, bytes, mesh_unit});
}

namespace {

using Writer = std::string (*)(std::span<const PlacedCurve>, formats::Sides);

/// The writer of a format that holds only positions of points and no unit, otherwise null.
Writer writer_of(const std::string& extension) {
  if (extension == ".obj") return formats::write_obj;
  if (extension == ".ply") return formats::write_ply;
  if (extension == ".vtp") return formats::write_vtp;
  if (extension == ".vtk") return formats::write_vtk;
  if (extension == ".json") return formats::write_json;
  return nullptr;
}

std::string bytes_with(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                       formats::Sides sides, const LengthUnit& mesh_unit) {
  check_curve_name(name);
  if (curves.empty()) throw Error(ErrorCode::kBadCurve, "There is no curve to write.");
  const std::string extension = curve_extension(name);
  if (extension == ".txt") return formats::write_txt(name, curves);
  if (extension == ".mrk.json") return formats::write_slicer(curves, mesh_unit);
  return writer_of(extension)(curves, sides);
}

}  // namespace

bool holds_way_points(const std::filesystem::path& name) {
  const std::string extension = curve_extension(name);
  return extension == ".json" || extension == ".vtp" || extension == ".vtk";
}

void check_curve_name(const std::filesystem::path& name) {
  const std::string extension = curve_extension(name);
  if (writer_of(extension) != nullptr || extension == ".txt" || extension == ".mrk.json") return;
  cannot_write(name, "no curve format has the extension '" + extension + "'; " + kKnown);
}

std::string curve_bytes(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                        const LengthUnit& mesh_unit) {
  return bytes_with(name, curves, {}, mesh_unit);
}
std::string border_bytes(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                         std::span<const SideLabels> sides, const LengthUnit& mesh_unit) {
  if (sides.size() != curves.size()) {
    throw Error(ErrorCode::kBadUsage, "There must be as many sides as curves.");
  }
  return bytes_with(name, curves, sides, mesh_unit);
}

void write_curves(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                  const LengthUnit& mesh_unit) {
  write_file(path, curve_bytes(path, curves, mesh_unit));
}
void write_borders(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                   std::span<const SideLabels> sides, const LengthUnit& mesh_unit) {
  write_file(path, border_bytes(path, curves, sides, mesh_unit));
}

void write_curves(const std::filesystem::path& path, const SurfaceMesh& mesh,
                  std::span<const SurfaceCurve> curves, const LengthUnit& mesh_unit) {
  std::vector<PlacedCurve> ready;
  for (const SurfaceCurve& curve : curves) ready.push_back(place(mesh, curve, ready.size()));
  write_curves(path, ready, mesh_unit);
}

}  // namespace talweg
