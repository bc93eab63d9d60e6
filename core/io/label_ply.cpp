// Labels as a property of a PLY file's faces or vertices.
#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/label_formats.hpp"
#include "talweg/core/io/line_scanner.hpp"
#include "talweg/core/io/ply_header.hpp"

namespace talweg::formats {
namespace {

bool is_corners(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Collects the numbers of one property of an element.
class Column {
 public:
  /// Throws Error(kBadFile) if the file has no such property.
  Column(const Source& source, const PlyHeader& header, const std::string& name) {
    std::vector<NamedNumbers> all;
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (std::size_t e = 0; e < header.elements.size(); ++e) {
      const PlyElement& element = header.elements[e];
      if (element.name != "face" && element.name != "vertex") continue;
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (element.properties[i].is_list) continue;
        all.push_back({element.properties[i].name, element.name == "face", {}});
        places.emplace_back(e, i);
      }
    }
    const NamedNumbers& found = chosen(source, all, name);
    std::tie(element_, property_) = places[static_cast<std::size_t>(&found - all.data())];
    values_ = found;
  }
  void put(std::size_t element, std::size_t property, double value) {
    if (element == element_ && property == property_) values_.numbers.push_back(value);
  }
  /// A polygon's value is repeated for each triangle of its fan.
  void end_row(std::size_t element, std::size_t corners) {
    if (element != element_ || corners == 3) return;
    const double value = values_.numbers.back();
    values_.numbers.resize(values_.numbers.size() - 1 + (corners < 3 ? 0 : corners - 2), value);
  }
  [[nodiscard]] const NamedNumbers& values() const { return values_; }

 private:
  std::size_t element_ = 0, property_ = 0;
  NamedNumbers values_;
};

void read_text(const MeshFile& file, const PlyHeader& header, Column& column) {
  LineScanner lines(file, '\0', header.body, header.lines);
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    for (std::size_t row = 0; row < element.count; ++row) {
      lines.need_line(fmt::format("{} {} of {}", element.name, row, element.count));
      std::size_t corners = 3;
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (!property.is_list) {
          column.put(e, i, lines.number("a number"));
          continue;
        }
        const std::int64_t n = lines.integer("the length of a list");
        for (std::int64_t k = 0; k < n; ++k) lines.number("a number");
        if (is_corners(property)) corners = static_cast<std::size_t>(std::max<std::int64_t>(n, 0));
      }
      column.end_row(e, corners);
    }
  }
}

void read_binary(const MeshFile& file, const PlyHeader& header, Column& column) {
  const bool swap =
      (header.encoding == PlyEncoding::kBigEndian) == (std::endian::native == std::endian::little);
  ByteCursor cursor(file.bytes.substr(header.body));
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    if (element.properties.empty()) continue;
    for (std::size_t row = 0; row < element.count; ++row) {
      std::size_t corners = 3;
      const auto take = [&](std::size_t size) {
        const char* at = cursor.take(size);
        if (at != nullptr) return at;
        bad_file(file.path,
                 fmt::format("the file ends in {} {} of {}.", element.name, row, element.count));
      };
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (!property.is_list) {
          const char* at = take(size_of(property.type));
          column.put(e, i, load_number(property.type, at, swap));
          continue;
        }
        const std::int64_t n =
            load_integer(property.count_type, take(size_of(property.count_type)), swap);
        if (n < 0) {
          bad_file(file.path,
                   fmt::format("a list of {} {} has a negative length.", element.name, row));
        }
        take(static_cast<std::size_t>(n) * size_of(property.type));
        if (is_corners(property)) corners = static_cast<std::size_t>(n);
      }
      column.end_row(e, corners);
    }
  }
}

}  // namespace

LabelFile read_ply_labels(const Source& source, const std::string& property) {
  const MeshFile file{source.path, source.bytes};
  const PlyHeader header = read_ply_header(file);
  Column column(source, header, property);
  if (header.encoding == PlyEncoding::kText) {
    read_text(file, header, column);
  } else {
    read_binary(file, header, column);
  }
  return {whole_numbers(source, column.values()), {}};
}

}  // namespace talweg::formats
