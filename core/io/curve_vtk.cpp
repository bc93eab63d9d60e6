// VTK legacy polydata: LINES, ascii and binary, versions 1 to 5.
#include <cmath>

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/polylines.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/vtk_legacy.hpp"

namespace talweg::formats {
namespace {

class VtkReader {
 public:
  explicit VtkReader(const Source& source) : source_(source), file_(source) {}

  std::vector<CurveInput> read() {
    std::string_view section = file_.word();
    for (; !section.empty(); section = file_.word()) {
      if (section == "POINT_DATA" || section == "CELL_DATA") break;
      read_section(section);
    }
    // Data are read only for marks, so data of unknown kinds are not an error in other files.
    if (source_.bytes.find("exact") != std::string_view::npos) read_data(section);
    if (cells_.empty()) cannot_read(source_.path, "it has no LINES, so it holds no curves");
    check_indices();
    std::vector<CurveInput> curves = curves_of(points_, std::move(cells_), marks_);
    turn_to(source_.frame, file_.space(), source_.path, curves);
    return curves;
  }

 private:
  void read_section(std::string_view section) {
    if (section == "DATASET") {
      const std::string_view type = file_.word_on_line();
      if (type != "POLYDATA") file_.fail("POLYDATA", type);
    } else if (section == "POINTS") {
      read_points();
    } else if (section == "LINES") {
      read_cells(true);
    } else if (section == "VERTICES" || section == "POLYGONS" || section == "TRIANGLE_STRIPS") {
      read_cells(false);
    } else if (section == "FIELD") {
      file_.read_fields();
    } else if (section == "METADATA") {
      file_.skip_metadata();
    } else {
      file_.fail("POINTS or LINES", section);
    }
  }

  void read_data(std::string_view section) {
    bool of_points = false;
    std::uint64_t count = 0;
    for (; !section.empty(); section = file_.word()) {
      if (section == "POINT_DATA" || section == "CELL_DATA") {
        of_points = section == "POINT_DATA";
        count = file_.read_count();
        continue;
      }
      for (VtkLegacy::Array& array : file_.read_attribute(section, count)) {
        if (!of_points || array.name != "exact") continue;
        marks_ = std::move(array.numbers);
        check_marks(marks_, points_.size(), [&](const std::string& what) { file_.fail(what); });
      }
    }
  }

  void read_points() {
    if (!points_.empty()) file_.fail("POINTS comes twice");
    const std::uint64_t n = file_.read_count();
    const NumberType type = file_.read_type();
    const std::vector<double> x = file_.read_numbers(3 * n, type);
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (!std::isfinite(x[k]))
        file_.fail(fmt::format("point {} has a coordinate that is not finite", k / 3));
    }
    for (std::size_t k = 0; k < n; ++k) points_.emplace_back(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
  }

  void read_cells(bool are_lines) {
    const std::uint64_t n = file_.read_count();
    const std::uint64_t size = file_.read_count();
    if (file_.splits_cells()) {
      const std::vector<double> offsets = file_.read_part("OFFSETS", n);
      const std::vector<double> connectivity = file_.read_part("CONNECTIVITY", size);
      for (std::size_t k = 1; are_lines && k < offsets.size(); ++k) {
        add_cell(offsets[k - 1], offsets[k], connectivity);
      }
      return;
    }
    const std::vector<double> list = file_.read_numbers(size, NumberType::kInt32);
    std::size_t at = 0;
    for (std::uint64_t k = 0; are_lines && k < n; ++k) {
      if (at >= list.size()) file_.fail(fmt::format("line {} is missing", k));
      const double from = static_cast<double>(at) + 1;
      add_cell(from, from + list[at], list);
      at += cells_.back().size() + 1;
    }
  }

  void add_cell(double from, double to, const std::vector<double>& list) {
    const auto first = index_below(from, list.size() + 1);
    const auto last = index_below(to, list.size() + 1);
    if (!first || !last || *last < *first + std::uint64_t{2}) {
      file_.fail(
          fmt::format("line {} has fewer than two points or more than there are", cells_.size()));
    }
    Line cell;
    for (std::uint32_t k = *first; k < *last; ++k) {
      const auto index = index_below(list[k], VtkLegacy::kMostItems);
      if (!index)
        file_.fail(fmt::format("line {} has the point index {:.17g}", cells_.size(), list[k]));
      cell.push_back(*index);
    }
    cells_.push_back(std::move(cell));
  }

  void check_indices() const {
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      for (const std::uint32_t index : cells_[k]) {
        if (index < points_.size()) continue;
        cannot_read(source_.path,
                    fmt::format("line {} of LINES: there is no point {} (the file has {})", k,
                                index, points_.size()));
      }
    }
  }

  const Source& source_;
  VtkLegacy file_;
  std::vector<Point> points_;
  std::vector<Line> cells_;
  std::vector<double> marks_;  // one for each point, or none
};

}  // namespace

std::vector<CurveInput> read_vtk(const Source& source) { return VtkReader(source).read(); }

std::string write_vtk(std::span<const PlacedCurve> curves, Sides sides, PatientSpace space) {
  std::size_t points = 0;
  std::size_t indices = 0;
  for (const PlacedCurve& curve : curves) {
    points += curve.positions.size();
    indices += curve.positions.size() + (curve.closed ? 2 : 1);
  }
  fmt::memory_buffer out;
  const auto to = fmt::appender(out);
  fmt::format_to(
      to, "# vtk DataFile Version 3.0\ntalweg curves{}\nASCII\nDATASET POLYDATA\n",
      space == PatientSpace::kNotSaid ? "" : fmt::format(" SPACE={}", space_name(space)));
  fmt::format_to(to, "POINTS {} double\n", points);
  for (const PlacedCurve& curve : curves) {
    for (const Point& p : curve.positions) {
      fmt::format_to(to, "{:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
    }
  }
  fmt::format_to(to, "LINES {} {}\n", curves.size(), indices);
  std::size_t first = 0;
  for (const PlacedCurve& curve : curves) {
    const std::size_t n = curve.positions.size();
    fmt::format_to(to, "{}", n + (curve.closed ? 1 : 0));
    for (std::size_t k = 0; k < n; ++k) fmt::format_to(to, " {}", first + k);
    if (curve.closed) fmt::format_to(to, " {}", first);
    fmt::format_to(to, "\n");
    first += n;
  }
  const bool marked = has_marks(curves), with_normals = has_normals(curves);
  fmt::format_to(to, "POINT_DATA {}\nFIELD FieldData {}\nface 1 {} int\n", points,
                 2 + (marked ? 1 : 0) + (with_normals ? 1 : 0), points);
  for (const PlacedCurve& curve : curves) {
    for (const FaceCoordinates& at : curve.faces) fmt::format_to(to, "{}\n", at.face.index());
  }
  fmt::format_to(to, "barycentric 3 {} double\n", points);
  for (const PlacedCurve& curve : curves) {
    for (const FaceCoordinates& at : curve.faces) {
      const auto& b = at.barycentric;
      fmt::format_to(to, "{:.17g} {:.17g} {:.17g}\n", b[0], b[1], b[2]);
    }
  }
  if (marked) {
    fmt::format_to(to, "exact 1 {} double\n", points);
    for (const double mark : all_marks(curves)) fmt::format_to(to, "{:.17g}\n", mark);
  }
  if (with_normals) {
    fmt::format_to(to, "Normals 3 {} double\n", points);
    for (const PlacedCurve& curve : curves) {
      for (const Point& n : curve.normals) {
        fmt::format_to(to, "{:.17g} {:.17g} {:.17g}\n", n.x(), n.y(), n.z());
      }
    }
  }
  if (!sides.empty()) {
    fmt::format_to(to, "CELL_DATA {0}\nFIELD FieldData 2\nleft 1 {0} long\n", sides.size());
    for (const SideLabels& side : sides) fmt::format_to(to, "{}\n", side.left);
    fmt::format_to(to, "right 1 {} long\n", sides.size());
    for (const SideLabels& side : sides) fmt::format_to(to, "{}\n", side.right);
  }
  return fmt::to_string(out);
}

}  // namespace talweg::formats
