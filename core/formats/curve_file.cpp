#include "talweg/core/formats/curve_file.hpp"

#include <algorithm>
#include <string>

#include "talweg/core/formats/curve_formats.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/formats/text_encoding.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
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
  cannot_read(path, "no curve format has the extension '" + extension + "'; " + kKnown);
}

}  // namespace

std::vector<CurveInput> read_curves(const std::filesystem::path& path) {
  static_cast<void>(curve_reader_of(path));  // no file is read that has an unknown extension
  return read_curves(path, read_file(path));
}

std::vector<CurveInput> read_curves(const std::filesystem::path& path, std::string_view bytes) {
  const CurveReader reader = curve_reader_of(path);
  if (bytes.empty()) cannot_read(path, "the file is empty");
  formats::check_encoding(path, bytes);
  if (reader != formats::read_json && reader != formats::read_vtp) {
    formats::check_line_ends(path, bytes);
  }
  if (reader == formats::read_obj || reader == formats::read_txt) {
    formats::check_no_nul(path, bytes);
  }
  return reader({path, bytes});
}

namespace {

void write_with(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                formats::Sides sides) {
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
  write_file(path, as_ids ? formats::write_txt(path, curves) : writer(curves, sides));
}

}  // namespace

void write_curves(const std::filesystem::path& path, std::span<const PlacedCurve> curves) {
  write_with(path, curves, {});
}
void write_borders(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                   std::span<const CurveSides> sides) {
  if (sides.size() != curves.size()) {
    throw Error(ErrorCode::kBadUsage, "There must be as many sides as curves.");
  }
  write_with(path, curves, sides);
}

void write_curves(const std::filesystem::path& path, const SurfaceMesh& mesh,
                  std::span<const SurfaceCurve> curves) {
  std::vector<PlacedCurve> ready;
  for (const SurfaceCurve& curve : curves) ready.push_back(place(mesh, curve, ready.size()));
  write_curves(path, ready);
}

}  // namespace talweg
