// A host's input and a plugin's results as types that own their memory.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "talweg_meshes.h"
#include "talweg_plugin.h"

namespace talweg::host {

struct Field {
  std::string name, unit;
  std::vector<double> values;
};

/// Input has `vertices`, or `faces` and `barycentrics`, or `positions`. Results have all of them.
struct Curve {
  bool closed = false;
  std::vector<std::uint32_t> vertices;  ///< result: TALWEG_NO_VERTEX if the point is not at a
                                        ///< vertex
  std::vector<std::uint32_t> faces;
  std::vector<std::array<double, 3>> barycentrics;
  std::vector<std::array<double, 3>> positions;
  std::vector<std::uint32_t> pins;  ///< input: indices of points that must not move
  std::vector<Field> fields;        ///< result: values per point
  /// Marks of way-points and painted points, one for each point (talweg_way_points.h); empty: no
  /// marks. In results: the values of the field with this name.
  std::vector<double> exact = {};
};

struct Mesh {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Field> fields;
};

/// Values at vertices, triangles or corners of a mesh (talweg_meshes.h).
struct Attribute {
  std::string name;
  std::uint32_t element = TALWEG_OF_VERTICES;
  std::uint32_t carry = TALWEG_CARRY_LINEAR;
  double fill = 0;
  std::uint32_t columns = 1;
  std::vector<double> values;                         ///< dense rows
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< for shared entries; otherwise empty
  std::uint32_t type = TALWEG_FLOAT64;                ///< result: type of the plugin's numbers
};

/// The origin of a mesh that a run made; as talweg_origin.
struct Origin {
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::array<double, 3>> weights;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> closed, lengths;
  std::vector<std::array<std::uint32_t, 3>> chains;
};

/// The changes that a cut makes; as talweg_cut_plan.
struct CutPlan {
  std::uint64_t vertex_count = 0, triangle_count = 0;
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::array<double, 3>> weights, positions;
  std::vector<std::uint32_t> divided, parts;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> closed, lengths, chains;
};

struct ReportEntry {
  std::int64_t curve = -1;
  std::string key;
  std::uint32_t type = TALWEG_VALUE_NUMBER;
  bool is_list = false;
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

struct Results {
  std::vector<Curve> curves;
  std::vector<Field> fields;  ///< per vertex or triangle of the mesh
  std::vector<ReportEntry> report;
  std::vector<Mesh> meshes;

  /// Null if there is no such entry. `curve` -1: the entry for all curves.
  [[nodiscard]] const ReportEntry* find(std::string_view key, std::int64_t curve = -1) const {
    for (const ReportEntry& entry : report) {
      if (entry.curve == curve && entry.key == key) return &entry;
    }
    return nullptr;
  }
  /// The entry's only value, or the default if there is none.
  [[nodiscard]] double number(std::string_view key, std::int64_t curve = -1,
                              double otherwise = 0) const {
    const ReportEntry* entry = find(key, curve);
    return entry == nullptr || entry->numbers.empty() ? otherwise : entry->numbers.front();
  }
  [[nodiscard]] std::string text(std::string_view key, std::int64_t curve = -1) const {
    const ReportEntry* entry = find(key, curve);
    return entry == nullptr || entry->texts.empty() ? "" : entry->texts.front();
  }
};

}  // namespace talweg::host
