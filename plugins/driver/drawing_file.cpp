#include "drawing_file.hpp"

#include <cstdint>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/drawing/snapping.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/labels/label_borders.hpp"
#include "talweg/core/repair/weld_hint.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

SnappedDrawing DrawingReader::read(std::span<const std::string> paths, const CoordinateFrame& frame,
                                   const Progress& progress) {
  SnappedDrawing drawing;
  if (!lines_) lines_.emplace(mesh_->surface());
  for (const std::string& path : paths) {
    std::vector<CurveInput> inputs = read_curves(path, frame);
    for (CurveInput& input : inputs) {
      if (map_ != nullptr) input = map_->to_repaired(input, mesh_->surface());
    }
    try {
      add(inputs, drawing, progress);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kBadCurve) throw;
      if (!weld_hint_) weld_hint_ = weld_hint(*mesh_, kRepairOption);
      throw Error(error.code(), error.what() + *weld_hint_);
    }
  }
  drawing = with_loops_closed(*mesh_, std::move(drawing), *lines_, ends_);
  if (extended_) drawing = with_ends_at_border(*mesh_, std::move(drawing), *lines_, *extended_);
  return drawing;
}

void DrawingReader::add(const std::vector<CurveInput>& inputs, SnappedDrawing& drawing,
                        const Progress& progress) {
  std::vector<SnappedCurve> all = snap(*mesh_, inputs, closest_, {}, progress);
  for (std::size_t i = 0; i < all.size(); ++i) {
    SnappedCurve& snapped = all[i];
    if (map_ != nullptr && std::holds_alternative<std::vector<Point>>(inputs[i].points)) {
      snapped.points = map_->on_one_sheet(snapped.points, snapped.closed, mesh_->surface());
    }
  }
  drawing.add(*mesh_, all, *lines_, progress);
}

SnappedDrawing read_drawing(const std::string& path, const SurfaceMesh& mesh, const RepairMap* map,
                            const CoordinateFrame& frame) {
  return DrawingReader(mesh, map).read(std::span(&path, 1), frame);
}

namespace {

/// Converts the labels of a file to those of the repaired mesh.
std::vector<std::int64_t> on_repaired(const RepairMap& map, const std::vector<std::int64_t>& labels,
                                      const std::string& path) {
  if (labels.size() == map.file_face_count()) return map.of_faces(labels);
  if (labels.size() == map.file_vertex_count()) return map.of_vertices(labels);
  throw Error(ErrorCode::kBadFile,
              fmt::format("{}: {} labels, but the mesh has {} faces and {} vertices.", path,
                          labels.size(), map.file_face_count(), map.file_vertex_count()));
}

}  // namespace

ReadLabels read_labels(const std::string& path, const Surface& surface, const RepairMap* map,
                       const std::string& property) {
  LabelFileOptions options;
  options.property = property;
  options.vertex_count = map != nullptr ? map->file_vertex_count() : surface.vertex_count();
  ReadLabels read{read_label_file(path, options), {}};
  if (map != nullptr) {
    read.of_file = std::move(read.labels);
    read.labels = on_repaired(*map, read.of_file, path);
  }
  return read;
}

SnappedDrawing drawing_of_labels(const std::string& path, const Surface& surface,
                                 const RepairMap* map) {
  const std::vector<std::int64_t> labels = read_labels(path, surface, map).labels;
  SnappedDrawing drawing;
  try {
    for (LabelBorder& border : label_borders(surface, labels)) {
      drawing.pins.insert(drawing.pins.end(), border.fixed.begin(), border.fixed.end());
      drawing.curves.push_back(std::move(border.curve));
    }
  } catch (const Error& error) {
    throw Error(ErrorCode::kBadFile, path + ": " + error.what());
  }
  return drawing;
}

std::vector<std::string> reading_warnings(const SnappedDrawing& drawing, std::size_t polygons) {
  std::vector<std::string> warnings = drawing.warnings();
  if (polygons > 0) {
    warnings.push_back(std::to_string(polygons) +
                       " polygons of the mesh were split into triangles.");
  }
  return warnings;
}

void lead_with_far_move(const SnappedDrawing& drawing, bool quiet) {
  if (drawing.far && !quiet) std::fprintf(stderr, "talweg: warning: %s\n", drawing.moved.c_str());
}

}  // namespace talweg::driver
