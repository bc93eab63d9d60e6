#include "results.hpp"

#include <type_traits>
#include <variant>

#include "talweg/plugin/talweg_way_points.h"

namespace talweg::plugins {
namespace {

using plugin::view;

/// Makes the entry in C of one value. The entry points to `numbers` or to `texts`.
struct AsEntry {
  talweg_report_entry& entry;
  std::vector<double>& numbers;
  std::vector<const char*>& texts;

  template <class Value>
  void operator()(const Value& value) const {
    if constexpr (std::is_same_v<Value, std::string>) {
      entry.type = TALWEG_VALUE_TEXT;
      texts = {value.c_str()};
    } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
      entry.type = TALWEG_VALUE_TEXT;
      entry.is_list = 1;
      for (const std::string& text : value) texts.push_back(text.c_str());
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      entry.type = TALWEG_VALUE_NUMBER;
      entry.is_list = 1;
      numbers = value;
    } else if constexpr (std::is_same_v<Value, std::vector<std::int64_t>>) {
      entry.type = TALWEG_VALUE_INTEGER;
      entry.is_list = 1;
      numbers.assign(value.begin(), value.end());
    } else {
      entry.type = std::is_same_v<Value, bool> ? TALWEG_VALUE_BOOLEAN
                   : std::is_integral_v<Value> ? TALWEG_VALUE_INTEGER
                                               : TALWEG_VALUE_NUMBER;
      numbers = {static_cast<double>(value)};
    }
  }
};

}  // namespace

void give(const plugin::Outputs& outputs, const PlacedCurve& curve,
          const std::vector<PointField>& fields) {
  if (!outputs.wants_curves()) return;
  const std::size_t n = curve.faces.size();
  std::vector<std::uint32_t> vertices, faces;
  std::vector<double> barycentrics, positions;
  for (std::size_t k = 0; k < n; ++k) {
    const VertexId v = curve.vertices[k];
    vertices.push_back(v.valid() ? static_cast<std::uint32_t>(v.index()) : TALWEG_NO_VERTEX);
    faces.push_back(static_cast<std::uint32_t>(curve.faces[k].face.index()));
    for (const double b : curve.faces[k].barycentric) barycentrics.push_back(b);
    for (const double x : curve.positions[k]) positions.push_back(x);
  }
  std::vector<talweg_field> views;
  std::vector<const talweg_field*> list;
  views.reserve(fields.size() + 1);
  list.reserve(fields.size() + 1);
  for (const PointField& field : fields) {
    views.push_back({sizeof(talweg_field), field.name, field.unit, view(field.values.data(), n)});
  }
  if (!curve.exact.empty()) {
    views.push_back(
        {sizeof(talweg_field), TALWEG_EXACT, "mesh units", view(curve.exact.data(), n)});
  }
  for (const talweg_field& field : views) list.push_back(&field);
  talweg_curve out = {};
  out.closed = curve.closed ? 1 : 0;
  out.vertices = view(vertices.data(), n);
  out.faces = view(faces.data(), n);
  out.barycentrics = view(barycentrics.data(), n, 3);
  out.positions = view(positions.data(), n, 3);
  out.pins = plugin::kNoArray;
  out.field_count = static_cast<std::uint32_t>(list.size());
  out.fields = list.data();
  outputs.curve(out);
}

void give(const plugin::Outputs& outputs, std::int64_t curve,
          const std::vector<ReportEntry>& entries) {
  for (const ReportEntry& source : entries) {
    talweg_report_entry entry = {};
    std::vector<double> numbers;
    std::vector<const char*> texts;
    std::visit(AsEntry{entry, numbers, texts}, source.value);
    entry.size = sizeof entry;
    entry.curve = curve;
    entry.key = source.key.c_str();
    entry.count = static_cast<std::uint32_t>(numbers.size() + texts.size());
    entry.numbers = numbers.data();
    entry.texts = texts.data();
    outputs.entry(entry);
  }
}

void give(const plugin::Outputs& outputs, const char* name, const char* unit,
          const std::vector<double>& values) {
  outputs.field({sizeof(talweg_field), name, unit, view(values.data(), values.size())});
}

void give_curves(const plugin::Outputs& outputs, const HostMesh& mesh,
                 std::span<const SurfaceCurve> curves, const FieldsOf& fields_of,
                 const EntriesOf& entries_of) {
  std::vector<PlacedCurve> placed;
  std::vector<std::vector<PointField>> fields(curves.size());
  for (std::size_t c = 0; outputs.wants_curves() && c < curves.size(); ++c) {
    placed.push_back(mesh.to_host(place(mesh.mesh(), curves[c], c)));
    if (outputs.wants_point_fields()) fields[c] = fields_of(c);
  }
  if (outputs.wants_report()) give(outputs, -1, entries_of(-1));
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (outputs.wants_curves()) give(outputs, placed[c], fields[c]);
    const auto number = static_cast<std::int64_t>(c);
    if (outputs.wants_report()) give(outputs, number, entries_of(number));
  }
}

}  // namespace talweg::plugins
