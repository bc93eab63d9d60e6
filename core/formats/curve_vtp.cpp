// VTK XML polydata: its lines.
#include <bit>
#include <charconv>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "talweg/core/formats/curve_formats.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/formats/polylines.hpp"
#include "talweg/core/formats/text_scanner.hpp"
#include "talweg/core/formats/vtk_data_array.hpp"

namespace talweg::formats {
namespace {

std::optional<NumberType> scalar_named(std::string_view name) {
  static constexpr std::string_view kNames[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                                "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  for (std::size_t k = 0; k < std::size(kNames); ++k) {
    if (name == kNames[k]) return static_cast<NumberType>(k);
  }
  return std::nullopt;
}

class VtpReader {
 public:
  explicit VtpReader(const Source& source) : source_(source) {}

  std::vector<CurveInput> read() {
    parse();
    const pugi::xml_node root = document_.child("VTKFile");
    if (!root || std::string_view(root.attribute("type").value()) != "PolyData") {
      fail(root, "expected <VTKFile type=\"PolyData\">");
    }
    read_encoding(root);
    for (const pugi::xml_node piece : root.child("PolyData").children("Piece")) read_piece(piece);
    if (lines_.empty()) cannot_read(source_.path, "it has no lines, so it holds no curves");
    return curves_of(points_, std::move(lines_));
  }

 private:
  /// Raw appended data is no XML, so it is cut out before.
  void parse() {
    xml_ = source_.bytes;
    const std::size_t tag = xml_.find("<AppendedData");
    if (tag != xml_.npos) {
      const std::size_t start = xml_.find('>', tag);
      const std::size_t underscore = start == xml_.npos ? start : xml_.find('_', start);
      if (underscore == xml_.npos) {
        cannot_read(source_.path, fmt::format("line {}: expected '_' in <AppendedData>",
                                              line_of(source_.bytes, tag)));
      }
      encoding_.appended = source_.bytes.substr(underscore + 1);
      const std::size_t end = encoding_.appended.rfind("</AppendedData");
      encoding_.appended = encoding_.appended.substr(0, end);
      const std::string_view opening(source_.bytes.data() + tag, start - tag);
      encoding_.appended_base64 = opening.find("base64") != opening.npos;
      xml_.resize(tag);
      xml_ += "</VTKFile>";
    }
    const pugi::xml_parse_result result = document_.load_buffer(xml_.data(), xml_.size());
    if (!result) {
      cannot_read(source_.path, fmt::format("line {}: it is not well-formed XML ({})",
                                            line_of(xml_, static_cast<std::size_t>(result.offset)),
                                            result.description()));
    }
  }

  void read_encoding(const pugi::xml_node& root) {
    const std::string_view order = root.attribute("byte_order").as_string("LittleEndian");
    const std::string_view header = root.attribute("header_type").as_string("UInt32");
    const std::string_view compressor = root.attribute("compressor").value();
    if (order != "LittleEndian" && order != "BigEndian") {
      fail(root, "expected the byte_order LittleEndian or BigEndian");
    }
    if (header != "UInt32" && header != "UInt64") {
      fail(root, "expected the header_type UInt32 or UInt64");
    }
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
      fail(root, "only vtkZLibDataCompressor is read, not '" + shown(compressor) +
                     "': save the file with zlib or no compression");
    }
    encoding_.swap = (order == "BigEndian") != (std::endian::native == std::endian::big);
    encoding_.wide_header = header == "UInt64";
    encoding_.compressed = !compressor.empty();
  }

  void read_piece(const pugi::xml_node& piece) {
    const pugi::xml_node lines = piece.child("Lines");
    if (!lines || piece.attribute("NumberOfLines").as_ullong(1) == 0) return;
    const std::size_t first = points_.size();
    read_points(piece);
    const std::vector<double> connectivity = read_array(named(lines, "connectivity"));
    const std::vector<double> offsets = read_array(named(lines, "offsets"));
    std::uint32_t from = 0;
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      const auto to = index_below(offsets[k], connectivity.size() + 1);
      if (!to || *to < std::uint64_t{from} + 2) {
        fail(lines, fmt::format("line {} has fewer than two points or more than there are", k));
      }
      Line line;
      for (std::uint32_t at = from; at < *to; ++at) {
        const auto index = index_below(connectivity[at], points_.size() - first);
        if (!index) {
          fail(lines, fmt::format("line {}: there is no point {:.17g} (the piece has {})", k,
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
    if (!array) fail(piece, "expected <Points> with a <DataArray>");
    const std::vector<double> x = read_array(array);
    const std::uint64_t claimed = piece.attribute("NumberOfPoints").as_ullong();
    if (x.size() % 3 != 0 || x.size() / 3 != claimed) {
      fail(array, fmt::format("expected 3 coordinates for each of {} points, found {} numbers",
                              claimed, x.size()));
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (!std::isfinite(x[k])) {
        fail(array, fmt::format("point {} has a coordinate that is not finite", k / 3));
      }
    }
    for (std::size_t k = 0; k < x.size(); k += 3) points_.emplace_back(x[k], x[k + 1], x[k + 2]);
  }

  pugi::xml_node named(const pugi::xml_node& lines, const char* name) {
    const pugi::xml_node array = lines.find_child_by_attribute("DataArray", "Name", name);
    if (!array) fail(lines, fmt::format("expected a <DataArray Name=\"{}\">", name));
    return array;
  }

  std::vector<double> read_array(const pugi::xml_node& array) {
    const std::string_view format = array.attribute("format").as_string("ascii");
    const auto type = scalar_named(array.attribute("type").value());
    if (!type) fail(array, "expected a type such as Float64 or Int32");
    if (format == "ascii") return read_ascii(array);
    if (format != "binary" && format != "appended") {
      fail(array, "expected the format ascii, binary or appended");
    }
    std::string_view stored(array.child_value());
    if (format == "appended") {
      const std::uint64_t offset = array.attribute("offset").as_ullong();
      if (offset >= encoding_.appended.size())
        fail(array, "its offset is beyond the appended data");
      stored = encoding_.appended.substr(offset);
    }
    try {
      const bool base64 = format == "binary" || encoding_.appended_base64;
      return numbers_of(decoded_block(encoding_, stored, base64), *type, encoding_.swap);
    } catch (const std::runtime_error& error) {
      fail(array, error.what());
    }
  }

  std::vector<double> read_ascii(const pugi::xml_node& array) {
    TextScanner scanner(source_.path, array.child_value());
    std::vector<double> numbers;
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
      double value = 0;
      const char* end = word.data() + word.size();
      const auto parsed = std::from_chars(word.data(), end, value);
      if (parsed.ec == std::errc::invalid_argument || parsed.ptr != end) {
        fail(array, "expected a number, found '" + shown(word) + "'");
      }
      numbers.push_back(parsed.ec == std::errc{} ? value : scanner.number(word, "a number"));
    }
    return numbers;
  }

  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const {
    const std::ptrdiff_t offset = node ? node.offset_debug() : 0;
    const std::size_t at = offset > 0 ? static_cast<std::size_t>(offset) : 0;
    cannot_read(source_.path,
                fmt::format("line {}, <{}>: {}", line_of(xml_, at), shown(node.name()), what));
  }

  const Source& source_;
  std::string xml_;
  pugi::xml_document document_;
  VtkEncoding encoding_;
  std::vector<Point> points_;
  std::vector<Line> lines_;
};

}  // namespace

std::vector<CurveInput> read_vtp(const Source& source) { return VtpReader(source).read(); }

std::string write_vtp(std::span<const PlacedCurve> curves) {
  std::size_t points = 0;
  for (const PlacedCurve& curve : curves) points += curve.positions.size();
  fmt::memory_buffer out;
  const auto to = fmt::appender(out);
  fmt::format_to(to,
                 "<?xml version=\"1.0\"?>\n"
                 "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                 "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" "
                 "NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                 points, curves.size());
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
  fmt::format_to(to, "</DataArray>\n</PointData>\n<Points>\n");
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
