#include "drawing_file.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/formats/curve_file.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/formats/text_scanner.hpp"
#include "talweg/core/label_borders.hpp"
#include "talweg/core/snapping.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

Drawing DrawingReader::read(std::span<const std::string> paths) {
  Drawing drawing;
  if (!lines_) lines_.emplace(mesh_->surface());
  for (const std::string& path : paths) {
    for (const SnappedCurve& snapped : snap(*mesh_, read_curves(path), closest_)) {
      for (const std::size_t pin : snapped.pins) drawing.pins.push_back(snapped.points[pin]);
      drawing.curves.push_back(lines_->join(snapped.points, snapped.closed));
      drawing.largest_snap_distance =
          std::max(drawing.largest_snap_distance, snapped.largest_snap_distance);
    }
  }
  return drawing;
}

Drawing read_drawing(const std::string& path, const SurfaceMesh& mesh) {
  return DrawingReader(mesh).read(std::span(&path, 1));
}

Drawing drawing_of_labels(const std::string& path, const Surface& surface) {
  const std::string bytes = read_file(path);
  const std::filesystem::path name = path;
  formats::TextScanner words(name, bytes);
  std::vector<std::int64_t> labels;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    labels.push_back(words.integer(word, "a label (a whole number)"));
  }
  Drawing drawing;
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

std::vector<std::string> reading_warnings(double largest_snap_distance, std::size_t polygons) {
  std::vector<std::string> warnings;
  if (largest_snap_distance > 0) {
    warnings.push_back(fmt::format("The curve was moved onto the mesh, by up to {:.3g} mesh units.",
                                   largest_snap_distance));
  }
  if (polygons > 0) {
    warnings.push_back(std::to_string(polygons) +
                       " polygons of the mesh were split into triangles.");
  }
  return warnings;
}

}  // namespace talweg::driver
