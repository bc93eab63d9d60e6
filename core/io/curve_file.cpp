#include "talweg/core/io/curve_file.hpp"

#include <algorithm>
#include <array>
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

bool has_normals(std::span<const PlacedCurve> curves) {
  return std::all_of(curves.begin(), curves.end(), [](const PlacedCurve& curve) {
    return curve.normals.size() == curve.positions.size();
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

constexpr const char* kKnown = "known are .obj .ply .vtp .vtk .mrk.json .border .fcsv .txt .json";

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
  if (extension == ".border") return formats::read_workbench;
  if (extension == ".fcsv") return formats::read_fcsv;
  if (extension == ".json" || extension == ".mrk.json") return formats::read_json;
  cannot_read(path, fmt::format("no curve format has the extension '{}'{}; {}", extension,
                                instead_of(path), kKnown));
}

}  // namespace

std::vector<CurveInput> read_curves(const std::filesystem::path& path,
                                    const CoordinateFrame& frame) {
  static_cast<void>(curve_reader_of(path));  // checks the extension before the file is read
  return read_curves(path, read_file(path), frame);
}

std::vector<CurveInput> read_curves(const std::filesystem::path& path, std::string_view bytes,
                                    const CoordinateFrame& frame) {
  const CurveReader reader = curve_reader_of(path);
  if (bytes.empty()) cannot_read(path, "the file is empty");
  formats::check_encoding(path, bytes);
  if (reader != formats::read_json && reader != formats::read_vtp &&
      reader != formats::read_workbench) {
    formats::check_line_ends(path, bytes);
  }
  if (reader == formats::read_obj || reader == formats::read_txt || reader == formats::read_fcsv) {
    formats::check_no_nul(path, bytes);
  }
  return reader({path, bytes, frame});
}

namespace {

/// Whether a format that Talweg writes has the extension.
bool is_written(const std::string& extension) {
  constexpr std::array kWritten = {".obj", ".ply",      ".vtp",  ".vtk",   ".json",
                                   ".txt", ".mrk.json", ".fcsv", ".border"};
  return std::find(kWritten.begin(), kWritten.end(), extension) != kWritten.end();
}

std::string bytes_with(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                       formats::Sides sides, const CoordinateFrame& frame) {
  check_curve_name(name);
  if (curves.empty()) throw Error(ErrorCode::kBadCurve, "There is no curve to write.");
  const std::string extension = curve_extension(name);
  if (extension == ".txt") return formats::write_txt(name, curves);
  if (extension == ".mrk.json") return formats::write_slicer(curves, frame);
  if (extension == ".border") return formats::write_workbench(name, curves, sides);
  if (extension == ".fcsv") return formats::write_fcsv(name, curves, frame);
  if (extension == ".obj") return formats::write_obj(curves, sides, frame.space);
  if (extension == ".ply") return formats::write_ply(curves, sides, frame.space);
  if (extension == ".vtk") return formats::write_vtk(curves, sides, frame.space);
  if (extension == ".vtp") return formats::write_vtp(curves, sides, frame.space);
  return formats::write_json(curves, sides);
}

}  // namespace

bool holds_way_points(const std::filesystem::path& name) {
  const std::string extension = curve_extension(name);
  return extension == ".json" || extension == ".vtp" || extension == ".vtk";
}

void check_curve_name(const std::filesystem::path& name) {
  const std::string extension = curve_extension(name);
  if (is_written(extension)) return;
  cannot_write(name, "no curve format has the extension '" + extension + "'; " + kKnown);
}

std::string curve_bytes(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                        const CoordinateFrame& frame) {
  return bytes_with(name, curves, {}, frame);
}
std::string border_bytes(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                         std::span<const SideLabels> sides, const CoordinateFrame& frame) {
  if (sides.size() != curves.size()) {
    throw Error(ErrorCode::kBadUsage, "There must be as many sides as curves.");
  }
  return bytes_with(name, curves, sides, frame);
}

void write_curves(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                  const CoordinateFrame& frame) {
  write_file(path, curve_bytes(path, curves, frame));
}
void write_borders(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                   std::span<const SideLabels> sides, const CoordinateFrame& frame) {
  write_file(path, border_bytes(path, curves, sides, frame));
}

void write_curves(const std::filesystem::path& path, const SurfaceMesh& mesh,
                  std::span<const SurfaceCurve> curves, const CoordinateFrame& frame) {
  std::vector<PlacedCurve> ready;
  for (const SurfaceCurve& curve : curves) ready.push_back(place(mesh, curve, ready.size()));
  write_curves(path, ready, frame);
}

}  // namespace talweg
