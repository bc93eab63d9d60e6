#include "talweg/core/repair/inspection_report.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "talweg/core/repair/vertex_welding.hpp"
#include "talweg/core/repair/weld_hint.hpp"
#include "talweg/core/space/message_numbers.hpp"

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

/// The words for a kind of defect, before its places: "1 face of zero area: face 3".
struct KindWords {
  const char* one;
  const char* several;
  const char* place;  ///< the noun of the places
};

/// Calls `visit(key, words, defect, blocks)` for every kind of defect. Reports, `talweg info` and
/// the page list these kinds, in this order.
template <class Visit>
void for_each_defect(const MeshInspection& m, Visit visit) {
  constexpr bool kBlocks = true, kHarmless = false;
  visit("indices_out_of_range",
        KindWords{"face with vertices that do not exist", "faces with vertices that do not exist",
                  "face"},
        m.indices_out_of_range, kBlocks);
  visit("non_finite_vertices",
        KindWords{"vertex with coordinates that are not finite or too large",
                  "vertices with coordinates that are not finite or too large", "vertex"},
        m.non_finite_vertices, kBlocks);
  visit("repeated_vertex_faces",
        KindWords{"face that uses a vertex twice", "faces that use a vertex twice", "face"},
        m.repeated_vertex_faces, kBlocks);
  visit("duplicate_faces",
        KindWords{"face that repeats another face", "faces that repeat another face", "face"},
        m.duplicate_faces, kBlocks);
  visit("non_manifold_edges",
        KindWords{"edge with more than two faces", "edges with more than two faces", "vertices"},
        m.non_manifold_edges, kBlocks);
  visit("misoriented_edges",
        KindWords{"edge between faces of opposite orientation",
                  "edges between faces of opposite orientation", "vertices"},
        m.misoriented_edges, kBlocks);
  visit("non_manifold_vertices",
        KindWords{"vertex where parts of the surface touch without a common edge (bow-tie)",
                  "vertices where parts of the surface touch without a common edge (bow-ties)",
                  "vertex"},
        m.non_manifold_vertices, kBlocks);
  visit("isolated_vertices",
        KindWords{"vertex without a face", "vertices without a face", "vertex"},
        m.isolated_vertices, kHarmless);
  visit("stray_vertices",
        KindWords{"vertex without a face, with coordinates that are not finite or too large",
                  "vertices without a face, with coordinates that are not finite or too large",
                  "vertex"},
        m.stray_vertices, kHarmless);
  visit("duplicate_positions",
        KindWords{"vertex at the position of another vertex",
                  "vertices at the position of another vertex", "vertex"},
        m.duplicate_positions, kHarmless);
  visit("zero_area_faces", KindWords{"face of zero area", "faces of zero area", "face"},
        m.zero_area_faces, kHarmless);
  visit("needle_faces",
        KindWords{"needle face (an angle below 1 degree)", "needle faces (an angle below 1 degree)",
                  "face"},
        m.needle_faces, kHarmless);
}

std::string face_ids(const std::vector<std::uint32_t>& list) {
  return fmt::format("{}", fmt::join(list, ", "));
}

std::string place_words(std::uint32_t id) { return fmt::format("{}", id); }
std::string place_words(const RepeatPlace& p) {
  return fmt::format("{} (repeats {})", p.element, p.earlier);
}
std::string place_words(const FaceIndexPlace& p) {
  return fmt::format("{} (vertex {})", p.face, p.vertex);
}
std::string place_words(const EdgePlace& p) {
  return fmt::format("{}-{} (faces {})", p.vertices[0], p.vertices[1], face_ids(p.faces));
}

template <class Place>
std::string places_words(const Defect<Place>& defect) {
  std::vector<std::string> places;
  for (const Place& place : defect.first) places.push_back(place_words(place));
  return fmt::format("{}{}", fmt::join(places, ", "), defect.count > places.size() ? ", ..." : "");
}

std::vector<std::string> defect_lines(const std::vector<DefectWords>& defects) {
  std::vector<std::string> lines;
  lines.reserve(defects.size());
  for (const DefectWords& defect : defects) {
    lines.push_back(fmt::format("{} {}", count_text(defect.count), defect.words));
  }
  return lines;
}

}  // namespace

const char* to_string(MeshVerdict verdict) {
  constexpr std::array kNames = {"usable", "repairable", "not_usable"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::vector<DefectWords> found_defects(const MeshInspection& m) {
  std::vector<DefectWords> found;
  for_each_defect(m, [&](const char*, const KindWords& kind, const auto& defect, bool blocks) {
    if (!defect.found()) return;
    found.push_back({defect.count,
                     fmt::format("{}: {} {}", defect.count == 1 ? kind.one : kind.several,
                                 kind.place, places_words(defect)),
                     blocks});
  });
  return found;
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
  for_each_defect(m, [&](const char* key, const KindWords&, const auto& defect, bool) {
    add_defect(entries, std::string("defects.") + key, defect);
  });
  entries.push_back({"defects_found", defect_lines(found_defects(m))});
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
