// VTK XML polydata: its lines.

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/polylines.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/vtk_xml.hpp"

namespace talweg::formats {
namespace {

class VtpReader {
 public:
  explicit VtpReader(const Source& source) : source_(source), xml_(source) {}

  std::vector<CurveInput> read() {
    for (const pugi::xml_node piece : xml_.pieces()) read_piece(piece);
    if (lines_.empty()) cannot_read(source_.path, "it has no lines, so it holds no curves");
    std::vector<CurveInput> curves = curves_of(points_, std::move(lines_), marks_);
    turn_to(source_.frame, xml_.space(), source_.path, curves);
    return curves;
  }

 private:
  void read_piece(const pugi::xml_node& piece) {
    const pugi::xml_node lines = piece.child("Lines");
    if (!lines || piece.attribute("NumberOfLines").as_ullong(1) == 0) return;
    const std::size_t first = points_.size();
    read_points(piece);
    read_marks(piece, points_.size() - first);
    const std::vector<double> connectivity = xml_.read_array(xml_.named(lines, "connectivity"));
    const std::vector<double> offsets = xml_.read_array(xml_.named(lines, "offsets"));
    std::uint32_t from = 0;
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      const auto to = index_below(offsets[k], connectivity.size() + 1);
      if (!to || *to < std::uint64_t{from} + 2) {
        xml_.fail(lines,
                  fmt::format("line {} has fewer than two points or more than there are", k));
      }
      Line line;
      for (std::uint32_t at = from; at < *to; ++at) {
        const auto index = index_below(connectivity[at], points_.size() - first);
        if (!index) {
          xml_.fail(lines, fmt::format("line {}: there is no point {:.17g} (the piece has {})", k,
                                       connectivity[at], points_.size() - first));
        }
        line.push_back(static_cast<std::uint32_t>(first + *index));
      }
      lines_.push_back(std::move(line));
      from = *to;
    }
  }

  void read_points(const pugi::xml_node& piece) {
    const pugi::xml_node array = piece.child("Points").child("DataArray");
    if (!array) xml_.fail(piece, "expected <Points> with a <DataArray>");
    const std::vector<double> x = xml_.read_array(array);
    const std::uint64_t claimed = piece.attribute("NumberOfPoints").as_ullong();
    if (x.size() % 3 != 0 || x.size() / 3 != claimed) {
      xml_.fail(array, fmt::format("expected 3 coordinates for each of {} points, found {} numbers",
                                   claimed, x.size()));
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (!std::isfinite(x[k])) {
        xml_.fail(array, fmt::format("point {} has a coordinate that is not finite", k / 3));
      }
    }
    for (std::size_t k = 0; k < x.size(); k += 3) points_.emplace_back(x[k], x[k + 1], x[k + 2]);
  }

  /// Reads the optional point data `exact` of a piece.
  void read_marks(const pugi::xml_node& piece, std::size_t points) {
    const pugi::xml_node array =
        piece.child("PointData").find_child_by_attribute("DataArray", "Name", "exact");
    std::vector<double> marks(points, kNotSaid);
    if (array) {
      marks = xml_.read_array(array);
      check_marks(marks, points, [&](const std::string& what) { xml_.fail(array, what); });
    }
    marks_.insert(marks_.end(), marks.begin(), marks.end());
  }

  const Source& source_;
  VtkXml xml_;
  std::vector<Point> points_;
  std::vector<double> marks_;  // one for each point
  std::vector<Line> lines_;
};

}  // namespace

std::vector<CurveInput> read_vtp(const Source& source) { return VtpReader(source).read(); }

std::string write_vtp(std::span<const PlacedCurve> curves, Sides sides, PatientSpace space) {
  std::size_t points = 0;
  for (const PlacedCurve& curve : curves) points += curve.positions.size();
  fmt::memory_buffer out;
  const auto to = fmt::appender(out);
  fmt::format_to(to,
                 "<?xml version=\"1.0\"?>\n"
                 "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                 "<PolyData>\n{}<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" "
                 "NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                 space_data(space), points, curves.size());
  const auto open_array = [&](const char* type, const char* name, int components) {
    fmt::format_to(to,
                   "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                   "format=\"ascii\">\n",
                   type, name, components);
  };
  const auto put_triple = [&](const auto& x) {
    fmt::format_to(to, "{:.17g} {:.17g} {:.17g}\n", x[0], x[1], x[2]);
  };
  fmt::format_to(to, "<PointData>\n");
  open_array("Int64", "face", 1);
  for (const PlacedCurve& curve : curves) {
    for (const FaceCoordinates& at : curve.faces) fmt::format_to(to, "{}\n", at.face.index());
  }
  fmt::format_to(to, "</DataArray>\n");
  open_array("Float64", "barycentric", 3);
  for (const PlacedCurve& curve : curves) {
    for (const FaceCoordinates& at : curve.faces) put_triple(at.barycentric);
  }
  fmt::format_to(to, "</DataArray>\n");
  if (has_marks(curves)) {
    open_array("Float64", "exact", 1);
    for (const double mark : all_marks(curves)) fmt::format_to(to, "{:.17g}\n", mark);
    fmt::format_to(to, "</DataArray>\n");
  }
  if (has_normals(curves)) {
    open_array("Float64", "Normals", 3);
    for (const PlacedCurve& curve : curves) {
      for (const Point& normal : curve.normals) put_triple(normal);
    }
    fmt::format_to(to, "</DataArray>\n");
  }
  fmt::format_to(to, "</PointData>\n");
  if (!sides.empty()) {
    fmt::format_to(to, "<CellData>\n");
    open_array("Int64", "left", 1);
    for (const SideLabels& side : sides) fmt::format_to(to, "{}\n", side.left);
    fmt::format_to(to, "</DataArray>\n");
    open_array("Int64", "right", 1);
    for (const SideLabels& side : sides) fmt::format_to(to, "{}\n", side.right);
    fmt::format_to(to, "</DataArray>\n</CellData>\n");
  }
  fmt::format_to(to, "<Points>\n");
  open_array("Float64", "Points", 3);
  for (const PlacedCurve& curve : curves) {
    for (const Point& p : curve.positions) put_triple(p);
  }
  fmt::format_to(to, "</DataArray>\n</Points>\n<Lines>\n");
  open_array("Int64", "connectivity", 1);
  std::size_t first = 0;
  for (const PlacedCurve& curve : curves) {
    const std::size_t n = curve.positions.size();
    for (std::size_t k = 0; k < n; ++k) fmt::format_to(to, "{} ", first + k);
    if (curve.closed) fmt::format_to(to, "{}", first);
    fmt::format_to(to, "\n");
    first += n;
  }
  fmt::format_to(to, "</DataArray>\n");
  open_array("Int64", "offsets", 1);
  std::size_t end = 0;
  for (const PlacedCurve& curve : curves) {
    end += curve.positions.size() + (curve.closed ? 1 : 0);
    fmt::format_to(to, "{}\n", end);
  }
  fmt::format_to(to, "</DataArray>\n</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n");
  return fmt::to_string(out);
}

}  // namespace talweg::formats
