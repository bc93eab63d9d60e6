// PLY: vertices and edges, ascii and binary.
#include <algorithm>
#include <bit>
#include <limits>

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/ply_header.hpp"
#include "talweg/core/io/polylines.hpp"
#include "talweg/core/io/space_note.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {
namespace {

class PlyReader {
 public:
  explicit PlyReader(const Source& source)
      : source_(source),
        header_(read_ply_header({source.path, source.bytes})),
        scanner_(source.path, source.bytes, header_.body, header_.lines + 1),
        ascii_(header_.encoding == PlyEncoding::kText),
        swap_((header_.encoding == PlyEncoding::kBigEndian) !=
              (std::endian::native == std::endian::big)) {}

  std::vector<CurveInput> read() {
    need_one("vertex");
    need_one("edge");
    std::size_t to_come = 2;
    for (const PlyElement& element : header_.elements) {
      check_size(element);
      if (element.name == "vertex") {
        read_rows(element, {"x", "y", "z"}, [this](const Row& row) { add_vertex(row); });
        --to_come;
      } else if (element.name == "edge") {
        read_rows(element, {"vertex1", "vertex2"},
                  [this](const Row& row) { edges_.push_back(row); });
        --to_come;
      } else {
        read_rows(element, {}, [](const Row&) {});
      }
      if (to_come == 0) break;
    }
    std::vector<CurveInput> curves = curves_of(points_, lines());
    turn_to(source_.frame, header_.space, source_.path, curves);
    return curves;
  }

 private:
  using Row = std::array<double, 3>;

  void need_one(std::string_view name) const {
    const auto count =
        std::count_if(header_.elements.begin(), header_.elements.end(),
                      [name](const PlyElement& element) { return element.name == name; });
    if (count == 1) return;
    cannot_read(source_.path, fmt::format("its header has {} element '{}'",
                                          count == 0 ? "no" : "more than one", name));
  }

  /// The header's counts are checked against the size of the file.
  void check_size(const PlyElement& element) {
    std::size_t smallest = 0;
    for (const PlyProperty& property : element.properties) {
      smallest += ascii_ ? 1 : size_of(property.is_list ? property.count_type : property.type);
    }
    if (smallest > 0 && element.count > (scanner_.remaining() + 1) / smallest) {
      fail(fmt::format("the header announces {} elements '{}', but the file ends earlier",
                       element.count, printable(element.name)));
    }
  }

  template <class Take>
  void read_rows(const PlyElement& element, std::vector<std::string_view> wanted, Take take) {
    std::vector<std::size_t> column(element.properties.size(), wanted.size());
    for (std::size_t w = 0; w < wanted.size(); ++w) {
      const auto at =
          std::find_if(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) { return p.name == wanted[w] && !p.is_list; });
      if (at == element.properties.end()) {
        cannot_read(source_.path, fmt::format("its element '{}' has no scalar property '{}'",
                                              element.name, wanted[w]));
      }
      column[static_cast<std::size_t>(at - element.properties.begin())] = w;
    }
    if (column.empty()) return;
    for (row_ = 0; row_ < element.count; ++row_) {
      Row row{};
      for (std::size_t k = 0; k < column.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (property.is_list) {
          skip_list(property);
        } else {
          const double value = read_value(property.type);
          if (column[k] < wanted.size()) row[column[k]] = value;
        }
      }
      take(row);
    }
  }

  double read_value(NumberType type) {
    if (ascii_) {
      const std::string_view word = scanner_.word();
      // A value that is not used may be nan.
      if (word == "nan" || word == "-nan" || word == "inf" || word == "-inf") {
        return std::numeric_limits<double>::quiet_NaN();
      }
      return scanner_.number(word, "a number");
    }
    if (scanner_.remaining() < size_of(type)) fail("the data ends too early");
    return load_number(type, scanner_.bytes(size_of(type)).data(), swap_);
  }

  void skip_list(const PlyProperty& property) {
    const double count = read_value(property.count_type);
    const std::size_t size = ascii_ ? 1 : size_of(property.type);
    const std::size_t most = scanner_.remaining() / size;
    if (!(count >= 0 && count <= static_cast<double>(most))) {
      fail("a list is longer than the file");
    }
    if (!ascii_) {
      scanner_.bytes(static_cast<std::size_t>(count) * size);
      return;
    }
    for (double k = 0; k < count; ++k) read_value(property.type);
  }

  void add_vertex(const Row& row) {
    for (const double x : row) {
      if (std::isfinite(x)) continue;
      fail(fmt::format("vertex {} has a coordinate that is not finite", row_));
    }
    points_.emplace_back(row[0], row[1], row[2]);
  }

  std::vector<Line> lines() const {
    if (edges_.empty()) cannot_read(source_.path, "it has no edges, so it holds no curves");
    std::vector<Line> result;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      Line line;
      for (std::size_t side = 0; side < 2; ++side) {
        const auto index = index_below(edges_[k][side], points_.size());
        if (!index) {
          cannot_read(source_.path,
                      fmt::format("edge {}: there is no vertex {:.17g} (the file has {})", k,
                                  edges_[k][side], points_.size()));
        }
        line.push_back(*index);
      }
      if (line[0] == line[1]) {
        cannot_read(source_.path, fmt::format("edge {} joins vertex {} with itself", k, line[0]));
      }
      result.push_back(std::move(line));
    }
    return result;
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (ascii_) scanner_.fail(what);
    cannot_read(source_.path, fmt::format("byte {}: {}", scanner_.position(), what));
  }

  const Source& source_;
  PlyHeader header_;
  WordScanner scanner_;
  bool ascii_;
  bool swap_;
  std::size_t row_ = 0;
  std::vector<Point> points_;
  std::vector<Row> edges_;
};

}  // namespace

std::vector<CurveInput> read_ply(const Source& source) { return PlyReader(source).read(); }

std::string write_ply(std::span<const PlacedCurve> curves, Sides /*sides*/, PatientSpace space) {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  for (const PlacedCurve& curve : curves) {
    vertices += curve.positions.size();
    edges += curve.positions.size() - (curve.closed ? 0 : 1);
  }
  const bool with_normals = has_normals(curves);
  fmt::memory_buffer out;
  fmt::format_to(
      fmt::appender(out),
      "ply\nformat ascii 1.0\n{}element vertex {}\nproperty double x\nproperty double y\n"
      "property double z\n{}element edge {}\nproperty int vertex1\nproperty int vertex2\n"
      "end_header\n",
      space_line("comment ", space), vertices,
      with_normals ? "property double nx\nproperty double ny\nproperty double nz\n" : "", edges);
  for (const PlacedCurve& curve : curves) {
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      const Point& p = curve.positions[k];
      fmt::format_to(fmt::appender(out), "{:.17g} {:.17g} {:.17g}", p.x(), p.y(), p.z());
      if (with_normals) {
        const Point& n = curve.normals[k];
        fmt::format_to(fmt::appender(out), " {:.17g} {:.17g} {:.17g}", n.x(), n.y(), n.z());
      }
      out.push_back('\n');
    }
  }
  std::size_t first = 0;
  for (const PlacedCurve& curve : curves) {
    const std::size_t n = curve.positions.size();
    for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
      fmt::format_to(fmt::appender(out), "{} {}\n", first + k, first + (k + 1) % n);
    }
    first += n;
  }
  return fmt::to_string(out);
}

}  // namespace talweg::formats
