// VTK legacy polydata: LINES, ascii and binary, versions 1 to 5.
#include <bit>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "talweg/core/formats/byte_cursor.hpp"
#include "talweg/core/formats/curve_formats.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/formats/polylines.hpp"
#include "talweg/core/formats/text_scanner.hpp"

namespace talweg::formats {
namespace {

/// Legacy files are big-endian.
constexpr bool kSwap = std::endian::native == std::endian::little;
constexpr std::uint64_t kMostItems = std::numeric_limits<std::uint32_t>::max();

std::optional<NumberType> scalar_named(std::string_view name) {
  struct Name {
    std::string_view name;
    NumberType type;
  };
  static constexpr Name kNames[] = {
      {"char", NumberType::kInt8},          {"unsigned_char", NumberType::kUint8},
      {"short", NumberType::kInt16},        {"unsigned_short", NumberType::kUint16},
      {"int", NumberType::kInt32},          {"unsigned_int", NumberType::kUint32},
      {"long", NumberType::kInt64},         {"unsigned_long", NumberType::kUint64},
      {"vtktypeint64", NumberType::kInt64}, {"vtktypeuint64", NumberType::kUint64},
      {"vtkIdType", NumberType::kInt32},    {"float", NumberType::kFloat32},
      {"double", NumberType::kFloat64}};
  for (const Name& known : kNames) {
    if (name == known.name) return known.type;
  }
  return std::nullopt;
}

class VtkReader {
 public:
  explicit VtkReader(const Source& source) : source_(source), scanner_(source.path, source.bytes) {}

  std::vector<CurveInput> read() {
    read_header();
    for (std::string_view section = scanner_.word(); !section.empty(); section = scanner_.word()) {
      if (section == "POINT_DATA" || section == "CELL_DATA") break;
      read_section(section);
    }
    if (cells_.empty()) cannot_read(source_.path, "it has no LINES, so it holds no curves");
    check_indices();
    return curves_of(points_, std::move(cells_));
  }

 private:
  void read_header() {
    constexpr std::string_view kMagic = "# vtk DataFile Version ";
    std::string_view first = scanner_.rest_of_line();
    if (first.substr(0, kMagic.size()) != kMagic)
      scanner_.fail("expected '# vtk DataFile Version'");
    first.remove_prefix(kMagic.size());
    split_cells_ = !first.empty() && first[0] >= '5';
    scanner_.next_line();
    scanner_.next_line();
    const std::string_view encoding = scanner_.word_on_line();
    if (encoding != "ASCII" && encoding != "BINARY") scanner_.fail("ASCII or BINARY", encoding);
    ascii_ = encoding == "ASCII";
  }

  void read_section(std::string_view section) {
    if (section == "DATASET") {
      const std::string_view type = scanner_.word_on_line();
      if (type != "POLYDATA") scanner_.fail("POLYDATA", type);
    } else if (section == "POINTS") {
      read_points();
    } else if (section == "LINES") {
      read_cells(true);
    } else if (section == "VERTICES" || section == "POLYGONS" || section == "TRIANGLE_STRIPS") {
      read_cells(false);
    } else if (section == "FIELD") {
      skip_fields();
    } else if (section == "METADATA") {
      while (scanner_.next_line() &&
             scanner_.rest_of_line().find_first_not_of("\r \t") != std::string_view::npos) {
      }
    } else {
      scanner_.fail("POINTS or LINES", section);
    }
  }

  std::uint64_t read_count() {
    return scanner_.count(scanner_.word_on_line(), "a number of items below 2^32", kMostItems);
  }

  NumberType read_type() {
    const std::string_view name = scanner_.word_on_line();
    const std::optional<NumberType> type = scalar_named(name);
    if (!type) scanner_.fail("a VTK data type", name);
    return *type;
  }

  /// So many numbers, from the next line on.
  std::vector<double> read_numbers(std::uint64_t n, NumberType type) {
    scanner_.next_line();
    const std::size_t size = ascii_ ? 1 : size_of(type);
    if (n > (scanner_.remaining() + 1) / size) {
      fail(fmt::format("expected {} numbers, the file ends before", n));
    }
    std::vector<double> numbers(n);
    if (ascii_) {
      for (double& x : numbers) x = scanner_.number(scanner_.word(), "a number");
      return numbers;
    }
    if (n > scanner_.remaining() / size) fail("the data ends too early");
    const char* bytes = scanner_.bytes(n * size).data();
    for (std::size_t k = 0; k < n; ++k) numbers[k] = load_number(type, bytes + k * size, kSwap);
    return numbers;
  }

  void read_points() {
    if (!points_.empty()) scanner_.fail("POINTS comes twice");
    const std::uint64_t n = read_count();
    const NumberType type = read_type();
    const std::vector<double> x = read_numbers(3 * n, type);
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (!std::isfinite(x[k]))
        fail(fmt::format("point {} has a coordinate that is not finite", k / 3));
    }
    for (std::size_t k = 0; k < n; ++k) points_.emplace_back(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
  }

  void read_cells(bool are_lines) {
    const std::uint64_t n = read_count();
    const std::uint64_t size = read_count();
    if (split_cells_) {
      const std::vector<double> offsets = read_part("OFFSETS", n);
      const std::vector<double> connectivity = read_part("CONNECTIVITY", size);
      for (std::size_t k = 1; are_lines && k < offsets.size(); ++k) {
        add_cell(offsets[k - 1], offsets[k], connectivity);
      }
      return;
    }
    const std::vector<double> list = read_numbers(size, NumberType::kInt32);
    std::size_t at = 0;
    for (std::uint64_t k = 0; are_lines && k < n; ++k) {
      if (at >= list.size()) fail(fmt::format("line {} is missing", k));
      const double from = static_cast<double>(at) + 1;
      add_cell(from, from + list[at], list);
      at += cells_.back().size() + 1;
    }
  }

  std::vector<double> read_part(std::string_view name, std::uint64_t n) {
    const std::string_view word = scanner_.word();
    if (word != name) scanner_.fail(std::string(name), word);
    const NumberType type = read_type();
    return read_numbers(n, type);
  }

  void add_cell(double from, double to, const std::vector<double>& list) {
    const auto first = index_below(from, list.size() + 1);
    const auto last = index_below(to, list.size() + 1);
    if (!first || !last || *last < *first + std::uint64_t{2}) {
      fail(fmt::format("line {} has fewer than two points or more than there are", cells_.size()));
    }
    Line cell;
    for (std::uint32_t k = *first; k < *last; ++k) {
      const auto index = index_below(list[k], kMostItems);
      if (!index) fail(fmt::format("line {} has the point index {:.17g}", cells_.size(), list[k]));
      cell.push_back(*index);
    }
    cells_.push_back(std::move(cell));
  }

  void skip_fields() {
    scanner_.word_on_line();
    const std::uint64_t arrays = read_count();
    for (std::uint64_t k = 0; k < arrays; ++k) {
      if (scanner_.word().empty()) scanner_.fail("the name of a field", {});
      const std::uint64_t components = read_count();
      const std::uint64_t tuples = read_count();
      const NumberType type = read_type();
      read_numbers(components * tuples, type);
    }
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

  [[noreturn]] void fail(const std::string& what) const {
    if (ascii_) scanner_.fail(what);
    cannot_read(source_.path, fmt::format("byte {}: {}", scanner_.position(), what));
  }

  const Source& source_;
  TextScanner scanner_;
  bool ascii_ = true;
  bool split_cells_ = false;  // offsets and connectivity apart, since version 5
  std::vector<Point> points_;
  std::vector<Line> cells_;
};

}  // namespace

std::vector<CurveInput> read_vtk(const Source& source) { return VtkReader(source).read(); }

std::string write_vtk(std::span<const PlacedCurve> curves) {
  std::size_t points = 0;
  std::size_t indices = 0;
  for (const PlacedCurve& curve : curves) {
    points += curve.positions.size();
    indices += curve.positions.size() + (curve.closed ? 2 : 1);
  }
  fmt::memory_buffer out;
  const auto to = fmt::appender(out);
  fmt::format_to(to, "# vtk DataFile Version 3.0\ntalweg curves\nASCII\nDATASET POLYDATA\n");
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
  fmt::format_to(to, "POINT_DATA {}\nFIELD FieldData 2\nface 1 {} int\n", points, points);
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
  return fmt::to_string(out);
}

}  // namespace talweg::formats
