// PLY: vertices and edges, ascii and binary.
#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "talweg/core/formats/curve_formats.hpp"
#include "talweg/core/formats/file_bytes.hpp"
#include "talweg/core/formats/polylines.hpp"
#include "talweg/core/formats/scalar.hpp"
#include "talweg/core/formats/text_scanner.hpp"

namespace talweg::formats {
namespace {

struct Property {
  std::string_view name;
  Scalar type = Scalar::kFloat32;
  std::optional<Scalar> list_count;  ///< the type of a list's count
};

struct Element {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

std::optional<Scalar> scalar_named(std::string_view name) {
  struct Name {
    std::string_view old_name, new_name;
    Scalar type;
  };
  static constexpr Name kNames[] = {
      {"char", "int8", Scalar::kInt8},        {"uchar", "uint8", Scalar::kUInt8},
      {"short", "int16", Scalar::kInt16},     {"ushort", "uint16", Scalar::kUInt16},
      {"int", "int32", Scalar::kInt32},       {"uint", "uint32", Scalar::kUInt32},
      {"float", "float32", Scalar::kFloat32}, {"double", "float64", Scalar::kFloat64}};
  for (const Name& known : kNames) {
    if (name == known.old_name || name == known.new_name) return known.type;
  }
  return std::nullopt;
}

class PlyReader {
 public:
  explicit PlyReader(const Source& source) : source_(source), scanner_(source.path, source.bytes) {}

  std::vector<CurveInput> read() {
    read_header();
    if (!has("vertex")) cannot_read(source_.path, "its header has no element 'vertex'");
    if (!has("edge")) {
      cannot_read(source_.path, "its header has no element 'edge', so it holds no curves");
    }
    std::size_t to_come = 2;
    for (const Element& element : elements_) {
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
    return curves_of(points_, lines());
  }

 private:
  using Row = std::array<double, 3>;

  bool has(std::string_view name) const {
    return std::any_of(elements_.begin(), elements_.end(),
                       [name](const Element& element) { return element.name == name; });
  }

  void read_header() {
    if (scanner_.word_on_line() != "ply") scanner_.fail("expected 'ply'");
    for (bool more = scanner_.next_line(); more; more = scanner_.next_line()) {
      const std::string_view keyword = scanner_.word_on_line();
      if (keyword == "end_header") {
        scanner_.next_line();
        if (!has_format_) scanner_.fail("the header has no line 'format'");
        return;
      }
      if (keyword == "format") read_format();
      if (keyword == "element") read_element();
      if (keyword == "property") read_property();
    }
    scanner_.fail("expected 'end_header', found the end of the file");
  }

  void read_format() {
    const std::string_view format = scanner_.word_on_line();
    ascii_ = format == "ascii";
    big_endian_ = format == "binary_big_endian";
    if (!ascii_ && !big_endian_ && format != "binary_little_endian") {
      scanner_.fail("ascii, binary_little_endian or binary_big_endian", format);
    }
    has_format_ = true;
  }

  void read_element() {
    Element element;
    element.name = scanner_.word_on_line();
    if (has(element.name)) scanner_.fail("the element '" + shown(element.name) + "' comes twice");
    element.count = scanner_.count(scanner_.word_on_line(), "a number of elements below 2^32",
                                   std::numeric_limits<std::uint32_t>::max());
    elements_.push_back(element);
  }

  Scalar read_type(std::string_view name) {
    const std::optional<Scalar> type = scalar_named(name);
    if (!type) scanner_.fail("a PLY scalar type", name);
    return *type;
  }

  void read_property() {
    if (elements_.empty()) scanner_.fail("a property comes before the first element");
    Property property;
    std::string_view type = scanner_.word_on_line();
    if (type == "list") {
      property.list_count = read_type(scanner_.word_on_line());
      type = scanner_.word_on_line();
    }
    property.type = read_type(type);
    property.name = scanner_.word_on_line();
    if (property.name.empty()) scanner_.fail("the name of a property", {});
    elements_.back().properties.push_back(property);
  }

  /// The header's counts are only believed as far as there are bytes.
  void check_size(const Element& element) {
    std::size_t smallest = 0;
    for (const Property& property : element.properties) {
      smallest += ascii_ ? 1 : size_of(property.list_count.value_or(property.type));
    }
    if (smallest > 0 && element.count > (scanner_.remaining() + 1) / smallest) {
      fail(fmt::format("the header says {} elements '{}', the file ends before", element.count,
                       shown(element.name)));
    }
  }

  template <class Take>
  void read_rows(const Element& element, std::vector<std::string_view> wanted, Take take) {
    std::vector<std::size_t> column(element.properties.size(), wanted.size());
    for (std::size_t w = 0; w < wanted.size(); ++w) {
      const auto at =
          std::find_if(element.properties.begin(), element.properties.end(),
                       [&](const Property& p) { return p.name == wanted[w] && !p.list_count; });
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
        const Property& property = element.properties[k];
        if (property.list_count) {
          skip_list(property);
        } else {
          const double value = read_value(property.type);
          if (column[k] < wanted.size()) row[column[k]] = value;
        }
      }
      take(row);
    }
  }

  double read_value(Scalar type) {
    if (ascii_) {
      const std::string_view word = scanner_.word();
      // A value that nobody wants may be nan.
      if (word == "nan" || word == "-nan" || word == "inf" || word == "-inf") {
        return std::numeric_limits<double>::quiet_NaN();
      }
      return scanner_.number(word, "a number");
    }
    if (scanner_.remaining() < size_of(type)) fail("the data ends too early");
    return load_number(type, scanner_.bytes(size_of(type)).data(), big_endian_);
  }

  void skip_list(const Property& property) {
    const double count = read_value(*property.list_count);
    const std::size_t size = ascii_ ? 1 : size_of(property.type);
    if (!(count >= 0 && count <= static_cast<double>(scanner_.remaining() / size))) {
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
      if (!std::isfinite(x))
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
  TextScanner scanner_;
  bool has_format_ = false;
  bool ascii_ = true;
  bool big_endian_ = false;
  std::uint64_t row_ = 0;
  std::vector<Element> elements_;
  std::vector<Point> points_;
  std::vector<Row> edges_;
};

}  // namespace

std::vector<CurveInput> read_ply(const Source& source) { return PlyReader(source).read(); }

std::string write_ply(std::span<const WrittenCurve> curves) {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  for (const WrittenCurve& curve : curves) {
    vertices += curve.positions.size();
    edges += curve.positions.size() - (curve.closed ? 0 : 1);
  }
  fmt::memory_buffer out;
  fmt::format_to(fmt::appender(out),
                 "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
                 "property double z\nelement edge {}\nproperty int vertex1\nproperty int vertex2\n"
                 "end_header\n",
                 vertices, edges);
  for (const WrittenCurve& curve : curves) {
    for (const Point& p : curve.positions) {
      fmt::format_to(fmt::appender(out), "{:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
    }
  }
  std::size_t first = 0;
  for (const WrittenCurve& curve : curves) {
    const std::size_t n = curve.positions.size();
    for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
      fmt::format_to(fmt::appender(out), "{} {}\n", first + k, first + (k + 1) % n);
    }
    first += n;
  }
  return fmt::to_string(out);
}

}  // namespace talweg::formats
