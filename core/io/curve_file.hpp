// Curve files are read and written by their extension.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/drawing/curve_input.hpp"
#include "talweg/core/drawing/placed_curve.hpp"
#include "talweg/core/mesh/mesh_lists.hpp"
#include "talweg/core/mesh/surface_mesh.hpp"
#include "talweg/core/space/coordinate_frame.hpp"
#include "talweg/intrinsic/surface/ids.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// Reads every curve of a file, in the file's order. The format follows from the extension, in
/// upper or lower case:
///
/// - `.obj`: `v` and `l`. `.ply`: vertices and edges (`vertex1 vertex2`), ascii or binary.
///   `.vtp`, `.vtk`: the lines of polydata (ascii, base64, raw, zlib; legacy ascii and binary).
///   Lines that meet end to end, exactly two at a point, are joined into one curve, which keeps
///   the direction of its first line. A line is closed when it ends at its first point, or (with
///   four points or more) at a copy of that point with the same coordinates.
/// - `.mrk.json`: the Curve and ClosedCurve markups of 3D Slicer (schema 1.0.x), by their control
///   points; a locked control point is a pin, one without a defined position is left out. The mesh
///   is taken to be in LPS, as Slicer itself writes meshes; positions of a markup in RAS get x and
///   y negated. Positions are converted from the markup's `coordinateUnits`, a UCUM code or a coded
///   entry with one (mm where it has none), to `frame`. The other formats name no unit: their
///   positions are in the unit of the mesh.
/// - `.txt`: vertex ids from 0, separated by blanks, commas or ends of lines; `#` starts a comment,
///   a blank line separates curves; a list that repeats its first id at its end is closed.
/// - `.border` of connectome-workbench, version 3: points between the vertices of a surface, each
///   `<BorderPart>` a curve.
/// - `.json`: Talweg's own (below), or Slicer's markups.
///
/// Way-points and painted points are read from Talweg's JSON, `.vtp` and `.vtk` as write_curves()
/// writes them, and pins from Talweg's JSON. Control points of Slicer become way-points when they
/// are snapped, see CurveInput.
///
/// Throws Error(kBadFile) with one sentence that names the file, the place (line, or byte in binary
/// data) and what was expected. The result has at least one curve, every index in it is in range of
/// the file's own points, and every coordinate is finite.
std::vector<CurveInput> read_curves(const std::filesystem::path& path,
                                    const CoordinateFrame& frame = {});

/// Reads from a file's bytes in memory; the path gives the extension and the name in errors.
std::vector<CurveInput> read_curves(const std::filesystem::path& path, std::string_view bytes,
                                    const CoordinateFrame& frame = {});

/// Writes curves by extension, in the formats of read_curves(). Coordinates and barycentrics have
/// 17 digits (doubles in binary). Equal curves give equal files.
///
/// Talweg's JSON: {"format": "talweg-curves", "version": 1, "curves": [{"closed": false, "points":
/// [{"face": 12, "barycentric": [a, b, c], "xyz": [x, y, z]}, ...]}]}. `face` is the face of
/// smallest id that contains the point and the next point; for the last point of an open curve, the
/// point and the previous point. The barycentrics are in the order of Surface::corners(face).
/// Reading gives back the same SurfacePoints, bit for bit. `.vtp` and `.vtk` carry `face` and
/// `barycentric` as point data; `.mrk.json` names the unit of the mesh. `.border` has the vertices
/// of each point's face with weights, and the structure named by the file's name (`lh.`, `.L.`,
/// `hemi-L`; `rh.`, ...; else CORTEX).
///
/// A marked point (PlacedCurve::exact) has the member `exact` in Talweg's JSON: true at a
/// way-point, or its tolerance in mesh units if the tolerance is more than 0; false at a painted
/// point. `.vtp` and `.vtk` then have point data `exact`: a tolerance of 0 or more at way-points,
/// -1 at points without a mark, -2 at painted points. The other formats leave the marks out. A pin
/// (PlacedCurve::pins) has the member `pinned`: true, and is a locked point in `.mrk.json`; the
/// other formats leave pins out.
///
/// Throws Error(kBadFile) if the file cannot be written (an existing file then stays unchanged) or
/// the format cannot hold the curves: `.txt` holds only vertices. Throws Error(kBadCurve) if there
/// is no curve, a curve has no points, or a point and the next lie in no common face.
void write_curves(const std::filesystem::path& path, const SurfaceMesh& mesh,
                  std::span<const SurfaceCurve> curves, const CoordinateFrame& frame = {});
/// Writes curves that place() has placed already.
void write_curves(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                  const CoordinateFrame& frame = {});

/// The bytes that write_curves() would write to a file of this name. Throws as it does.
std::string curve_bytes(const std::filesystem::path& name, std::span<const PlacedCurve> curves,
                        const CoordinateFrame& frame = {});
/// Whether the format of this name marks way-points.
bool holds_way_points(const std::filesystem::path& name);
/// Throws as write_curves() does if the name's extension is not the extension of a curve format.
void check_curve_name(const std::filesystem::path& name);

}  // namespace talweg
