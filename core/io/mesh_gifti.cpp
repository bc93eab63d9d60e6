// GIFTI: surfaces, labels with their table, and values per vertex.
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/field_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/gifti.hpp"
#include "talweg/core/io/label_formats.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg {
namespace formats {
namespace {

constexpr std::string_view kPointsIntent = "NIFTI_INTENT_POINTSET";
constexpr std::string_view kTrianglesIntent = "NIFTI_INTENT_TRIANGLE";
constexpr std::string_view kLabelsIntent = "NIFTI_INTENT_LABEL";

const GiftiArray& array_of_three(const Source& source, const Gifti& file, std::string_view intent) {
  const GiftiArray* array = file.first(intent);
  if (array == nullptr) {
    cannot_read(source.path,
                fmt::format("the file is not a surface: expected an array {}, found {}", intent,
                            file.held()));
  }
  if (array->columns != 3) {
    file.fail(array->node, fmt::format("expected {} x 3 numbers, found {} x {}", array->rows,
                                       array->rows, array->columns));
  }
  return *array;
}

bool is_per_vertex(const GiftiArray& array) { return array.columns == 1 || array.rows == 1; }

void read_label_table(const Gifti& gifti, LabelFile& file) {
  for (const pugi::xml_node label : gifti.label_table().children("Label")) {
    const pugi::xml_attribute given = label.attribute("Key");
    const pugi::xml_attribute key = given ? given : label.attribute("Index");
    std::int64_t number = 0;
    if (!parse(key.value(), number)) gifti.fail(label, "expected a whole number as Key");
    std::string_view name = label.child_value();
    while (!name.empty() && (is_blank(name.front()) || name.front() == '\n')) name.remove_prefix(1);
    while (!name.empty() && (is_blank(name.back()) || name.back() == '\n')) name.remove_suffix(1);
    file.names[number] = printable(name, kLongestName);
    if (!label.attribute("Red")) continue;
    LabelColor& color = file.colors[number];
    static constexpr const char* kParts[] = {"Red", "Green", "Blue", "Alpha"};
    for (std::size_t k = 0; k < 4; ++k) {
      color[k] = label.attribute(kParts[k]).as_double(1);
      if (!(color[k] >= 0 && color[k] <= 1)) {
        gifti.fail(label, fmt::format("expected a {} from 0 to 1", kParts[k]));
      }
    }
  }
}

}  // namespace

LabelFile read_gifti_labels(const Source& source, const std::string& map) {
  const Gifti gifti(source);
  const GiftiArray* found = map.empty() ? gifti.first(kLabelsIntent) : nullptr;
  std::string names;
  for (const GiftiArray& array : gifti.arrays()) {
    if (array.intent != kLabelsIntent) continue;
    if (found == nullptr && array.name == map) found = &array;
    if (names.size() < 100) names += (names.empty() ? "" : ", ") + printable(array.name);
  }
  if (found == nullptr && !names.empty()) {
    cannot_read(source.path,
                fmt::format("it has no map of labels called {}, but {}", printable(map), names));
  }
  if (found == nullptr) {
    cannot_read(source.path, fmt::format("it has no labels: expected an array {}, found {}",
                                         kLabelsIntent, gifti.held()));
  }
  if (!is_per_vertex(*found)) gifti.fail(found->node, "expected one label per vertex");
  LabelFile file;
  file.labels = whole_numbers(source, {"label", false, gifti.numbers(*found)});
  read_label_table(gifti, file);
  return file;
}

std::vector<double> read_gifti_values(const Source& source) {
  const Gifti gifti(source);
  for (const GiftiArray& array : gifti.arrays()) {
    if (array.intent != kPointsIntent && array.intent != kTrianglesIntent && is_per_vertex(array)) {
      return gifti.numbers(array);
    }
  }
  cannot_read(source.path, fmt::format("it has no values: expected an array of one number per "
                                       "vertex (NIFTI_INTENT_SHAPE), found {}",
                                       gifti.held()));
}

}  // namespace formats

MeshLists read_gifti_mesh(const MeshFile& mesh_file, MeshAttributes* attributes) {
  using namespace formats;
  const Source source{mesh_file.path, mesh_file.bytes, {}};
  const Gifti gifti(source);
  const GiftiArray& points = array_of_three(source, gifti, kPointsIntent);
  const GiftiArray& triangles = array_of_three(source, gifti, kTrianglesIntent);
  MeshLists lists;
  lists.unit = LengthUnit::named("mm");
  lists.single_precision = points.type == NumberType::kFloat32;
  const std::vector<double> xyz = gifti.numbers(points);
  for (std::size_t k = 0; k + 2 < xyz.size(); k += 3) lists.points.emplace_back(&xyz[k]);
  const std::vector<double> corners = gifti.numbers(triangles);
  lists.triangles.resize(corners.size() / 3);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double v = corners[k];
    if (!(v >= 0 && v < static_cast<double>(lists.points.size()) && v == std::floor(v))) {
      gifti.fail(triangles.node, fmt::format("face {} refers to vertex {:.17g}, but there are {}",
                                             k / 3, v, lists.points.size()));
    }
    lists.triangles[k / 3][k % 3] = static_cast<std::uint32_t>(v);
  }
  if (attributes == nullptr) return lists;
  for (const GiftiArray& array : gifti.arrays()) {
    if (&array == &points || &array == &triangles) continue;
    if (attributes->left_out.size() == 64) break;
    attributes->left_out.push_back(fmt::format("an array {} (GIFTI)", printable(array.intent)));
  }
  return lists;
}

}  // namespace talweg
