// Each curve format has its own two functions behind curve_file.hpp: bytes to curves and back.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/io/border_file.hpp"
#include "talweg/core/io/curve_file.hpp"

namespace talweg::formats {

/// The input of a reader: the bytes, and the path for its messages.
struct Source {
  const std::filesystem::path& path;
  std::string_view bytes;
  CoordinateFrame frame;  ///< of the mesh
};

/// Readers and writers take one pass, O(bytes), except read_json(): see parsed_json().
std::vector<CurveInput> read_obj(const Source& source);
std::vector<CurveInput> read_ply(const Source& source);
std::vector<CurveInput> read_vtp(const Source& source);
std::vector<CurveInput> read_vtk(const Source& source);
std::vector<CurveInput> read_txt(const Source& source);
/// Border files of connectome-workbench, version 3: points between vertices (specified by
/// BorderFile.cxx and Border.cxx of the program). Names and colors are not kept.
std::vector<CurveInput> read_workbench(const Source& source);
std::vector<CurveInput> read_fcsv(const Source& source);
/// Reads Talweg's JSON, or Slicer's if the file has `markups`.
std::vector<CurveInput> read_json(const Source& source);

/// The labels beside each curve, or none; formats without a place for them leave them out.
using Sides = std::span<const SideLabels>;

/// Whether a point of the curves has a mark.
bool has_marks(std::span<const PlacedCurve> curves);
/// Whether all points of all curves have a normal.
bool has_normals(std::span<const PlacedCurve> curves);
/// The marks of all points of all curves (point_marks.hpp).
std::vector<double> all_marks(std::span<const PlacedCurve> curves);

std::string write_obj(std::span<const PlacedCurve> curves, Sides sides = {},
                      PatientSpace space = {});
std::string write_ply(std::span<const PlacedCurve> curves, Sides sides = {},
                      PatientSpace space = {});
std::string write_vtp(std::span<const PlacedCurve> curves, Sides sides = {},
                      PatientSpace space = {});
std::string write_vtk(std::span<const PlacedCurve> curves, Sides sides = {},
                      PatientSpace space = {});
/// Throws Error(kBadFile) if a point is not a vertex.
std::string write_txt(const std::filesystem::path& path, std::span<const PlacedCurve> curves);
/// Throws Error(kBadFile) if the curves' mesh is not known. The file's name gives the structure
/// (lh., .L., hemi-L, and so on; else CORTEX).
std::string write_workbench(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                            Sides sides = {});
/// In LPS and millimetres. Throws Error(kBadFile) if there are several curves.
std::string write_fcsv(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                       const CoordinateFrame& frame);
std::string write_json(std::span<const PlacedCurve> curves, Sides sides = {});
/// In LPS, whatever the space of the mesh is.
std::string write_slicer(std::span<const PlacedCurve> curves, const CoordinateFrame& frame);

}  // namespace talweg::formats
