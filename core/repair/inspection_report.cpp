#include "talweg/core/repair/inspection_report.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "talweg/core/repair/vertex_welding.hpp"
#include "talweg/core/repair/weld_hint.hpp"

namespace talweg {
namespace {

using Entries = std::vector<ReportEntry>;
using EntryValue = decltype(ReportEntry::value);

std::vector<double> coordinates(const std::array<double, 3>& p) { return {p.begin(), p.end()}; }

void add_place(Entries& entries, const std::string& key, std::uint32_t id) {
  entries.push_back({key, std::uint64_t{id}});
}
void add_place(Entries& entries, const std::string& key, const RepeatPlace& p) {
  entries.push_back({key + ".id", std::uint64_t{p.element}});
  entries.push_back({key + ".repeats", std::uint64_t{p.earlier}});
}
void add_place(Entries& entries, const std::string& key, const FaceIndexPlace& p) {
  entries.push_back({key + ".face", std::uint64_t{p.face}});
  entries.push_back({key + ".vertex", std::uint64_t{p.vertex}});
}
void add_place(Entries& entries, const std::string& key, const EdgePlace& p) {
  entries.push_back(
      {key + ".vertices", std::vector<std::int64_t>(p.vertices.begin(), p.vertices.end())});
  entries.push_back({key + ".faces", std::vector<std::int64_t>(p.faces.begin(), p.faces.end())});
}

template <class Place>
void add_defect(Entries& entries, const std::string& key, const Defect<Place>& defect) {
  entries.push_back({key + ".count", std::uint64_t{defect.count}});
  const std::string first = key + ".first";
  if (defect.first.empty()) entries.push_back({first, std::vector<double>{}});
  for (std::size_t k = 0; k < defect.first.size(); ++k) {
    add_place(entries, first + "." + std::to_string(k), defect.first[k]);
  }
}

void add_defects(Entries& entries, const MeshInspection& m) {
  add_defect(entries, "defects.indices_out_of_range", m.indices_out_of_range);
  add_defect(entries, "defects.non_finite_vertices", m.non_finite_vertices);
  add_defect(entries, "defects.repeated_vertex_faces", m.repeated_vertex_faces);
  add_defect(entries, "defects.duplicate_faces", m.duplicate_faces);
  add_defect(entries, "defects.non_manifold_edges", m.non_manifold_edges);
  add_defect(entries, "defects.misoriented_edges", m.misoriented_edges);
  add_defect(entries, "defects.non_manifold_vertices", m.non_manifold_vertices);
  add_defect(entries, "defects.isolated_vertices", m.isolated_vertices);
  add_defect(entries, "defects.stray_vertices", m.stray_vertices);
  add_defect(entries, "defects.duplicate_positions", m.duplicate_positions);
  add_defect(entries, "defects.zero_area_faces", m.zero_area_faces);
  add_defect(entries, "defects.needle_faces", m.needle_faces);
}

}  // namespace

const char* to_string(MeshVerdict verdict) {
  constexpr std::array kNames = {"usable", "repairable", "not_usable"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::vector<ReportEntry> entries_of(const MeshInspection& m) {
  Entries entries = {{"faces", std::uint64_t{m.faces}},
                     {"vertices", std::uint64_t{m.vertices}},
                     {"edges", std::uint64_t{m.edges}},
                     {"polygons", std::uint64_t{m.polygons}},
                     {"polygon_shapes.concave", std::uint64_t{m.polygon_shapes.concave}},
                     {"polygon_shapes.crossing", std::uint64_t{m.polygon_shapes.crossing}},
                     {"polygon_shapes.not_plane", std::uint64_t{m.polygon_shapes.not_plane}},
                     {"polygon_shapes.largest_distance", m.polygon_shapes.largest_distance},
                     {"polygon_shapes.largest_face", std::uint64_t{m.polygon_shapes.largest_face}},
                     {"components", std::uint64_t{m.components}},
                     {"boundary_edges", std::uint64_t{m.boundary_edges}},
                     {"boundary_loops", std::uint64_t{m.boundary_loops}},
                     {"euler_characteristic", m.euler_characteristic},
                     {"genus", m.genus ? EntryValue(*m.genus) : EntryValue(HUGE_VAL)},
                     {"orientable", m.orientable},
                     {"single_precision", m.single_precision},
                     {"unit", m.unit ? m.unit->code() : std::string()},
                     {"space", std::string(space_name(m.space))},
                     {"notes", m.notes},
                     {"box_min", coordinates(m.box_min)},
                     {"box_max", coordinates(m.box_max)},
                     {"size", m.size},
                     {"offset", m.offset},
                     {"edge_length_min", m.edge_length_min},
                     {"edge_length_mean", m.edge_length_mean},
                     {"edge_length_max", m.edge_length_max},
                     {"smallest_angle", m.smallest_angle}};
  add_defects(entries, m);
  entries.push_back({"verdict", std::string(to_string(m.verdict))});
  entries.push_back({"reason", m.reason});
  entries.push_back({"repair_steps", m.steps});
  return entries;
}

std::vector<ReportEntry> entries_of(const MeshChanges& c, const MeshInspection& after) {
  Entries entries;
  add_defect(entries, "repair.welded_vertices", c.welded_vertices);
  entries.push_back({"repair.weld_tolerance", c.weld_tolerance});
  entries.push_back({"repair.weld_distance", c.weld_distance});
  entries.push_back({"repair.held_apart", std::uint64_t{c.held_apart}});
  add_defect(entries, "repair.flattened_faces", c.flattened_faces);
  add_defect(entries, "repair.collapsed_faces", c.collapsed_faces);
  add_defect(entries, "repair.duplicate_faces", c.duplicate_faces);
  add_defect(entries, "repair.zero_area_faces", c.zero_area_faces);
  add_defect(entries, "repair.turned_faces", c.turned_faces);
  add_defect(entries, "repair.split_edges", c.split_edges);
  add_defect(entries, "repair.split_vertices", c.split_vertices);
  entries.push_back({"repair.vertex_copies", std::uint64_t{c.vertex_copies}});
  entries.push_back({"repair.changes", sentences(c)});
  entries.push_back({"repair.verdict", std::string(to_string(after.verdict))});
  entries.push_back({"repair.reason", after.reason});
  return entries;
}

std::vector<ReportEntry> entries_of(const NearVertices& near) {
  return {{"near_vertices.count", std::uint64_t{near.count}},
          {"near_vertices.within", near.within},
          {"near_vertices.largest_gap", near.largest_gap}};
}

std::vector<ReportEntry> entries_of(const std::optional<WeldedMesh>& welded,
                                    const MeshInspection& before) {
  if (!welded) return {{"weld", HUGE_VAL}};
  return {{"weld.steps", welded->steps},
          {"weld.tolerance", welded->tolerance},
          {"weld.vertices", std::uint64_t{welded->vertices}},
          {"weld.components", std::uint64_t{welded->after.components}},
          {"weld.boundary_loops", std::uint64_t{welded->after.boundary_loops}},
          {"weld.sentence", weld_sentence(before, *welded)}};
}

}  // namespace talweg
