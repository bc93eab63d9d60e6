// 3D Slicer's lists of points (.fcsv): of Slicer 3 (label,x,y,z,sel,vis) and of later versions
// (id,x,y,z,...,lock,label,...), as vtkMRMLMarkupsFiducialStorageNode reads and writes them.
#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {
namespace {

constexpr std::size_t kMostColumns = 64;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The cells of a line. A quoted cell ends at the next quote that is not doubled. Quotes are kept,
/// since only numbers are read.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (cells.size() < kMostColumns) {
    std::size_t end = 0;
    bool quoted = line.starts_with('"');
    if (quoted) {
      for (end = 1; end < line.size() && quoted; ++end) {
        if (line[end] != '"') continue;
        const bool doubled = end + 1 < line.size() && line[end + 1] == '"';
        if (doubled) ++end;
        quoted = doubled;
      }
    }
    end = std::min(line.find(',', end), line.size());
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == line.size()) break;
    line.remove_prefix(end + 1);
  }
  return cells;
}

class FcsvReader {
 public:
  explicit FcsvReader(const Source& source)
      : source_(source), scanner_(source.path, source.bytes) {}

  std::vector<CurveInput> read() {
    CurveInput curve;
    curve.control_points = true;
    std::vector<Point> points;
    do {
      const std::string_view line = trimmed(scanner_.rest_of_line());
      if (line.starts_with('#')) {
        read_comment(trimmed(line.substr(1)));
      } else if (!line.empty()) {
        read_point(line, points, curve);
      }
    } while (scanner_.next_line());
    if (points.empty()) cannot_read(source_.path, "it has no points");
    curve.points = std::move(points);
    std::vector<CurveInput> curves;
    curves.push_back(std::move(curve));
    convert(curves);
    return curves;
  }

 private:
  /// Reads a comment such as "CoordinateSystem = LPS" or "columns = id,x,y,z,...".
  void read_comment(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos) return;
    const std::string_view name = trimmed(text.substr(0, equals));
    const std::string_view value = trimmed(text.substr(equals + 1));
    if (name == "CoordinateSystem") {
      if (value != "RAS" && value != "0" && value != "LPS" && value != "1") {
        scanner_.fail("the coordinate system RAS, LPS, 0 or 1", value);
      }
      space_ = value == "LPS" || value == "1" ? PatientSpace::kLps : PatientSpace::kRas;
    } else if (name == "columns") {
      read_columns(value);
    }
  }

  void read_columns(std::string_view list) {
    const std::vector<std::string_view> names = cells_of(list);
    const auto column = [&](std::string_view name) -> std::optional<std::size_t> {
      const auto at = std::find(names.begin(), names.end(), name);
      if (at == names.end()) return std::nullopt;
      return static_cast<std::size_t>(at - names.begin());
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = column(std::string_view("xyz").substr(k, 1));
      if (!found) scanner_.fail("the columns x, y and z", list);
      columns_[k] = *found;
    }
    lock_ = column("lock");
  }

  void read_point(std::string_view line, std::vector<Point>& points, CurveInput& curve) {
    const std::vector<std::string_view> cells = cells_of(line);
    Point p;
    for (std::size_t k = 0; k < 3; ++k) {
      if (columns_[k] >= cells.size()) scanner_.fail("a point with its x, y and z", line);
      p[static_cast<int>(k)] = scanner_.number(cells[columns_[k]], "a coordinate");
    }
    if (lock_ && *lock_ < cells.size() && cells[*lock_] == "1") {
      curve.pins.push_back(points.size());
    }
    points.push_back(p);
  }

  void convert(std::vector<CurveInput>& curves) const {
    const CoordinateFrame from{LengthUnit(), space_}, to = source_.frame;
    auto& points = std::get<std::vector<Point>>(curves.front().points);
    const double scale = from.unit.in(to.unit), sign = to.turns(space_) ? -scale : scale;
    for (Point& p : points) {
      p = Point(sign * p.x(), sign * p.y(), scale * p.z());
      if (!p.allFinite()) {
        cannot_read(source_.path, "a coordinate is too large in the unit of the mesh");
      }
    }
    std::string note = conversion(source_.path, from, to);
    if (!note.empty()) curves.front().notes.push_back(std::move(note));
  }

  const Source& source_;
  WordScanner scanner_;
  PatientSpace space_ = PatientSpace::kRas;  // of files that name no space
  std::array<std::size_t, 3> columns_{1, 2, 3};
  std::optional<std::size_t> lock_;
};

}  // namespace

std::vector<CurveInput> read_fcsv(const Source& source) { return FcsvReader(source).read(); }

std::string write_fcsv(const std::filesystem::path& path, std::span<const PlacedCurve> curves,
                       const CoordinateFrame& frame) {
  if (curves.size() > 1) {
    cannot_write(path, fmt::format("a .fcsv holds one list of points, and there are {} curves",
                                   curves.size()));
  }
  const double scale = frame.unit.in(LengthUnit());  // the file is in millimetres
  const double sign = frame.turns(PatientSpace::kLps) ? -scale : scale;
  const PlacedCurve& curve = curves.front();
  fmt::memory_buffer out;
  const auto to = fmt::appender(out);
  fmt::format_to(to,
                 "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n"
                 "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n");
  for (std::size_t k = 0; k < curve.positions.size(); ++k) {
    const Point& p = curve.positions[k];
    const bool pinned = std::binary_search(curve.pins.begin(), curve.pins.end(), k);
    fmt::format_to(to, "{0},{1:.17g},{2:.17g},{3:.17g},0,0,0,1,1,1,{4},F-{0},,\n", k + 1,
                   sign * p.x(), sign * p.y(), scale * p.z(), pinned ? 1 : 0);
  }
  return fmt::to_string(out);
}

}  // namespace talweg::formats
