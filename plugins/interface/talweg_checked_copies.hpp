// Checked copies of a plugin's results, since a plugin by others may return nonsense. A wrong
// result is thrown as plugin::Failure.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "talweg_arrays.hpp"
#include "talweg_cut_plan.h"
#include "talweg_results.hpp"
#include "talweg_way_points.h"

namespace talweg::host::detail {

/// Upper bounds of the indices in results: the numbers of vertices and triangles of the plugin's
/// mesh, and the number of curves. The curves are the set curves or the curves returned so far,
/// whichever are more.
struct Limits {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t curves = 0;
};

[[noreturn]] inline void nonsense(const std::string& what, const std::string& problem) {
  throw plugin::Failure(TALWEG_INTERNAL, what + " " + problem + ".");
}

inline std::string text_of(const char* text, const char* what) {
  if (text == nullptr) nonsense(what, "is null");
  return text;
}

inline void check_rows(std::size_t rows, std::size_t expected, const std::string& what) {
  if (rows == expected) return;
  nonsense(what, "has " + std::to_string(rows) + " rows, not " + std::to_string(expected));
}

/// Whether an index may be TALWEG_NO_VERTEX (or TALWEG_NO_TRIANGLE, TALWEG_NO_ENTRY).
enum class None { kIsAllowed, kIsNonsense };

inline void check_index(std::uint32_t index, std::uint64_t count, const char* what, std::size_t row,
                        None none = None::kIsNonsense) {
  if (index < count || (none == None::kIsAllowed && index == UINT32_MAX)) return;
  nonsense(what, "has " + std::to_string(index) + " in row " + std::to_string(row) +
                     ", but there are " + std::to_string(count));
}
inline void check_indices(const std::vector<std::uint32_t>& rows, std::uint64_t count,
                          const char* what, None none = None::kIsNonsense) {
  for (std::size_t k = 0; k < rows.size(); ++k) check_index(rows[k], count, what, k, none);
}
inline void check_indices(const std::vector<std::array<std::uint32_t, 3>>& rows,
                          std::uint64_t count, const char* what, None none = None::kIsNonsense) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const std::uint32_t index : rows[k]) check_index(index, count, what, k, none);
  }
}

inline void check_finite(const std::vector<std::array<double, 3>>& rows, const char* what) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (std::isfinite(rows[k][0]) && std::isfinite(rows[k][1]) && std::isfinite(rows[k][2])) {
      continue;
    }
    nonsense(what, "has a number in row " + std::to_string(k) + " that is not finite");
  }
}

/// Each weight must be 0 or more, and each row must have the sum 1, or `or_sum`, up to rounding.
inline void check_weights(const std::vector<std::array<double, 3>>& rows, const char* what,
                          double or_sum = 1) {
  constexpr double kRounding = 1e-6;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& [a, b, c] = rows[k];
    const double sum = a + b + c;
    const bool near = std::abs(sum - 1) <= kRounding || std::abs(sum - or_sum) <= kRounding;
    if (near && a >= -kRounding && b >= -kRounding && c >= -kRounding) continue;
    nonsense(what,
             "has weights that are negative or do not add up to 1, in row " + std::to_string(k));
  }
}

template <std::size_t n>
std::vector<std::array<double, n>> rows_of(const talweg_array& array, const char* what) {
  plugin::check_array(array, n, what);
  std::vector<std::array<double, n>> rows(plugin::count_of(array, 1));
  if (!rows.empty()) plugin::copy_numbers(array, n, what, rows.front().data());
  return rows;
}

template <class Row>
std::vector<Row> index_rows_of(const talweg_array& array, const char* what) {
  constexpr auto kColumns = static_cast<std::uint32_t>(sizeof(Row) / sizeof(std::uint32_t));
  plugin::check_array(array, kColumns, what);
  if (array.rows > 0 && array.type != TALWEG_UINT32) nonsense(what, "is not of type uint32");
  const std::uint64_t stride = array.stride == 0 ? sizeof(Row) : array.stride;
  std::vector<Row> rows(plugin::count_of(array, 1));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::memcpy(&rows[k], static_cast<const char*>(array.data) + k * stride, sizeof(Row));
  }
  return rows;
}
/// Both functions accept TALWEG_NO_VERTEX as an index.
inline std::vector<std::uint32_t> vertices_of(const talweg_array& array) {
  return index_rows_of<std::uint32_t>(array, "A list of indices");
}
inline std::vector<std::array<std::uint32_t, 3>> triples_of(const talweg_array& array) {
  return index_rows_of<std::array<std::uint32_t, 3>>(array, "A list of triples");
}

inline Field copy(const talweg_field& field) {
  Field result{text_of(field.name, "A field's name"), text_of(field.unit, "A field's unit"), {}};
  result.values = plugin::numbers_of(field.values, 1, "The field " + result.name);
  return result;
}

inline std::vector<Field> copy(const talweg_field* const* fields, std::uint32_t count) {
  if (count > 0 && fields == nullptr) nonsense("The list of fields", "is null");
  std::vector<Field> result;
  for (std::uint32_t k = 0; k < count; ++k) {
    result.push_back(copy(plugin::checked(fields[k], "A field")));
  }
  return result;
}

inline Field checked_copy(const talweg_field& field, const Limits& limits) {
  Field result = copy(field);
  if (result.values.size() != limits.triangles) {
    check_rows(result.values.size(), static_cast<std::size_t>(limits.vertices),
               "The field " + result.name);
  }
  return result;
}

/// An unchecked copy of a curve, such as one from a file, which may have only vertices, or only
/// positions.
inline Curve copy(const talweg_curve& curve) {
  Curve result{curve.closed != 0,
               vertices_of(curve.vertices),
               plugin::indices_of(curve.faces, 1, "The faces"),
               rows_of<3>(curve.barycentrics, "The barycentrics"),
               rows_of<3>(curve.positions, "The positions"),
               plugin::indices_of(curve.pins, 1, "The pins"),
               copy(curve.fields, curve.field_count),
               {}};
  for (const Field& field : result.fields) {
    if (field.name == TALWEG_EXACT) result.exact = field.values;
  }
  return result;
}

inline Curve checked_copy(const talweg_curve& curve, const Limits& limits) {
  Curve result = copy(curve);
  const std::size_t points = result.faces.size();
  if (points == 0) nonsense("A curve", "has no points");
  check_rows(result.vertices.size(), points, "A curve's list of vertices");
  check_rows(result.barycentrics.size(), points, "A curve's list of barycentrics");
  check_rows(result.positions.size(), points, "A curve's list of positions");
  check_indices(result.vertices, limits.vertices, "A curve's list of vertices", None::kIsAllowed);
  check_indices(result.faces, limits.triangles, "A curve's list of faces");
  check_weights(result.barycentrics, "A curve's list of barycentrics");
  check_finite(result.positions, "A curve's list of positions");
  for (const Field& field : result.fields) {
    check_rows(field.values.size(), points, "A curve's field " + field.name);
  }
  check_indices(result.pins, points, "A curve's list of pins");
  return result;
}

inline Mesh copy(const talweg_mesh& mesh) {
  Mesh result;
  result.positions = rows_of<3>(mesh.positions, "A mesh's list of positions");
  plugin::check_array(mesh.triangles, 3, "A mesh's list of triangles");
  result.triangles.resize(plugin::count_of(mesh.triangles, 1));
  if (!result.triangles.empty()) {
    plugin::copy_indices(mesh.triangles, 3, "A mesh's list of triangles",
                         result.triangles.front().data());
  }
  result.fields = copy(mesh.fields, mesh.field_count);
  return result;
}

inline Mesh checked_copy(const talweg_mesh& mesh, const Limits& /*limits*/) {
  Mesh result = copy(mesh);
  check_finite(result.positions, "A mesh's list of positions");
  check_indices(result.triangles, result.positions.size(), "A mesh's list of triangles");
  return result;
}

inline ReportEntry checked_copy(const talweg_report_entry& entry, const Limits& limits) {
  ReportEntry result{entry.curve, text_of(entry.key, "A key of the report"),
                     entry.type,  entry.is_list != 0,
                     {},          {}};
  const std::string what = "The report's entry " + result.key;
  if (entry.curve < -1 || (entry.curve >= 0 && std::uint64_t(entry.curve) >= limits.curves)) {
    nonsense(what, "is about curve " + std::to_string(entry.curve) + ", but there are " +
                       std::to_string(limits.curves));
  }
  if (!result.is_list && entry.count != 1) nonsense(what, "has no single value");
  const bool text = entry.type == TALWEG_VALUE_TEXT;
  const void* values = text ? static_cast<const void*>(entry.texts) : entry.numbers;
  if (entry.count > 0 && values == nullptr) nonsense(what, "has no values");
  for (std::uint32_t k = 0; k < entry.count; ++k) {
    if (text) {
      result.texts.push_back(text_of(entry.texts[k], "A text of the report"));
    } else {
      result.numbers.push_back(entry.numbers[k]);
    }
  }
  return result;
}

inline Attribute copy(const talweg_attribute& attribute) {
  return {text_of(attribute.name, "An attribute's name"),
          attribute.element,
          attribute.carry,
          attribute.fill,
          attribute.values.columns,
          plugin::numbers_of(attribute.values, attribute.values.columns, "An attribute"),
          triples_of(attribute.corners),
          attribute.values.type};
}

inline Attribute checked_copy(const talweg_attribute& attribute, const Limits& /*limits*/) {
  return copy(attribute);
}

/// The sum of the lengths of the curves' chains, which must be consistent.
inline std::uint64_t check_chains(const std::vector<std::uint32_t>& closed,
                                  const std::vector<std::uint32_t>& lengths, std::uint32_t curves) {
  check_rows(closed.size(), curves, "The list of closed curves");
  check_rows(lengths.size(), curves, "The list of lengths of chains");
  std::uint64_t sum = 0;
  for (const std::uint32_t length : lengths) sum += length;
  return sum;
}

inline Origin checked_copy(const talweg_origin& origin, const Limits& limits) {
  Origin result{triples_of(origin.vertices),   rows_of<3>(origin.weights, "The weights"),
                vertices_of(origin.triangles), vertices_of(origin.closed),
                vertices_of(origin.lengths),   triples_of(origin.chains)};
  check_rows(result.weights.size(), result.vertices.size(), "The weights of an origin");
  check_indices(result.vertices, limits.vertices, "The vertices of an origin", None::kIsAllowed);
  check_weights(result.weights, "The weights of an origin", 0);
  check_indices(result.triangles, limits.triangles, "The triangles of an origin", None::kIsAllowed);
  check_chains(result.closed, result.lengths, origin.curve_count);
  for (std::size_t k = 0; k < result.chains.size(); ++k) {
    const auto& [curve, place, vertex] = result.chains[k];
    check_index(curve, result.lengths.size(), "The chains of an origin", k);
    check_index(place, result.lengths[curve], "The chains of an origin", k);
    check_index(vertex, result.vertices.size(), "The chains of an origin", k);
  }
  return result;
}

inline CutPlan checked_copy(const talweg_cut_plan& plan, const Limits& limits) {
  CutPlan result{plan.vertex_count,
                 plan.triangle_count,
                 triples_of(plan.vertices),
                 rows_of<3>(plan.weights, "The weights"),
                 rows_of<3>(plan.positions, "The positions"),
                 vertices_of(plan.divided),
                 vertices_of(plan.parts),
                 triples_of(plan.triangles),
                 vertices_of(plan.closed),
                 vertices_of(plan.lengths),
                 vertices_of(plan.chains)};
  if (plan.vertex_count != limits.vertices || plan.triangle_count != limits.triangles) {
    nonsense("A plan of a cut", "does not have the vertices and triangles of the set mesh");
  }
  const std::uint64_t vertices = limits.vertices + result.vertices.size();
  check_rows(result.weights.size(), result.vertices.size(), "The weights of a plan");
  check_rows(result.positions.size(), result.vertices.size(), "The positions of a plan");
  check_rows(result.parts.size(), result.divided.size(), "The parts of a plan");
  check_indices(result.vertices, limits.vertices, "The vertices of a plan", None::kIsAllowed);
  check_weights(result.weights, "The weights of a plan");
  check_finite(result.positions, "The positions of a plan");
  check_indices(result.divided, limits.triangles, "The divided triangles of a plan");
  check_indices(result.triangles, vertices, "The triangles of a plan");
  check_indices(result.chains, vertices, "The chains of a plan");
  const std::uint64_t places = check_chains(result.closed, result.lengths, plan.curve_count);
  if (places != result.chains.size()) {
    nonsense("A plan of a cut", "has chains that do not have the given lengths");
  }
  std::uint64_t parts = 0;
  for (const std::uint32_t number : result.parts) parts += number;
  if (parts != result.triangles.size()) {
    nonsense("A plan of a cut", "has triangles that do not add up to the given parts");
  }
  return result;
}

}  // namespace talweg::host::detail
