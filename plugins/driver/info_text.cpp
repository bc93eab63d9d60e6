#include "info_text.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/repair/inspection_report.hpp"
#include "talweg/core/repair/vertex_welding.hpp"
#include "talweg/core/repair/weld_hint.hpp"
#include "talweg/core/space/message_numbers.hpp"

namespace talweg::driver {
namespace {

std::string ids(const std::vector<std::uint32_t>& list) {
  return fmt::format("{}", fmt::join(list, ", "));
}

std::string place_text(std::uint32_t id) { return fmt::format("{}", id); }
std::string place_text(const RepeatPlace& p) {
  return fmt::format("{} (as {})", p.element, p.earlier);
}
std::string place_text(const FaceIndexPlace& p) {
  return fmt::format("{} (vertex {})", p.face, p.vertex);
}
std::string place_text(const EdgePlace& p) {
  return fmt::format("{}-{} (faces {})", p.vertices[0], p.vertices[1], ids(p.faces));
}

/// Calls `visit(words, defect, blocking)` for every defect, in the order of the report.
template <class Visit>
void for_each_defect(const MeshInspection& m, Visit visit) {
  visit("faces with vertices that do not exist: face", m.indices_out_of_range, true);
  visit("vertices with coordinates that are not finite or too large: vertex", m.non_finite_vertices,
        true);
  visit("faces that use a vertex twice: face", m.repeated_vertex_faces, true);
  visit("faces that repeat another face: face", m.duplicate_faces, true);
  visit("edges with more than two faces: vertices", m.non_manifold_edges, true);
  visit("edges between faces of opposite orientation: vertices", m.misoriented_edges, true);
  visit("vertices where parts of the surface touch without a common edge (bow-ties): vertex",
        m.non_manifold_vertices, true);
  visit("vertices without a face: vertex", m.isolated_vertices, false);
  visit("of these, with coordinates that are not finite or too large: vertex", m.stray_vertices,
        false);
  visit("vertices at the position of another vertex: vertex", m.duplicate_positions, false);
  visit("faces of zero area: face", m.zero_area_faces, false);
  visit("needle faces (an angle below 1 degree): face", m.needle_faces, false);
}

const char* verdict_words(MeshVerdict verdict) {
  switch (verdict) {
    case MeshVerdict::kUsable:
      return "usable";
    case MeshVerdict::kRepairable:
      return "usable with repair";
    case MeshVerdict::kUnusable:
      return "not usable";
  }
  return "";
}

std::string line(const char* label, const std::string& value) {
  return fmt::format("{:<18}{}\n", label, value);
}

/// The counts of polygons: "22,117, 3 of them concave, 12 not plane (by up to 0.02 of their size,
/// face 7)"
std::string polygon_line(const MeshInspection& m) {
  if (m.polygons == 0) return "";
  const PolygonShapes& shapes = m.polygon_shapes;
  std::string text = count_text(m.polygons);
  if (shapes.concave > 0) text += fmt::format(", {} of them concave", count_text(shapes.concave));
  if (shapes.not_plane > 0) {
    text += fmt::format(", {} not planar (by up to {:.3g} of their size, face {} of the file)",
                        count_text(shapes.not_plane), shapes.largest_distance, shapes.largest_face);
  }
  if (shapes.crossing > 0) {
    text += fmt::format(", {} cross themselves or have no area (first: face {} of the file)",
                        count_text(shapes.crossing), shapes.crossing_face);
  }
  return line("polygons", text);
}

std::string size_lines(const MeshInspection& m) {
  const auto extent = [&](std::size_t k) { return m.box_max[k] - m.box_min[k]; };
  std::string text =
      line("size", fmt::format("{:.6g} x {:.6g} x {:.6g}", extent(0), extent(1), extent(2)));
  if (m.offset > m.size) {
    text += line("distance", fmt::format("{:.6g} from the origin", m.offset));
  }
  text +=
      line("edge length", fmt::format("{:.4g} (shortest {:.4g}, longest {:.4g})",
                                      m.edge_length_mean, m.edge_length_min, m.edge_length_max));
  text += line("smallest angle",
               fmt::format("{:.3g} degrees", m.smallest_angle * 180 / std::numbers::pi));
  text += line("coordinates", m.single_precision ? "single precision" : "double precision");
  if (m.unit) text += line("unit", m.unit->code());
  if (m.space != PatientSpace::kNotSaid) text += line("space", std::string(space_name(m.space)));
  return text;
}

std::string repair_text(const InfoRepair& repair) {
  std::string text = "\n";
  for (const std::string& sentence : sentences(repair.changes)) text += sentence + "\n";
  if (!repair.changes.any()) text += "Repair: nothing to do.\n";
  return text + fmt::format("After the repair: {}. {}\n", verdict_words(repair.after.verdict),
                            repair.after.reason);
}

}  // namespace

std::string info_text(const MeshInspection& m, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair,
                      const std::optional<WeldedMesh>& welded, const NearVertices& near) {
  std::string text = line("faces", count_text(m.faces));
  if (m.polygons > 0) {
    text.pop_back();
    text += fmt::format(" (after cutting {} polygons into triangles)\n", count_text(m.polygons));
  }
  text += polygon_line(m) + line("vertices", count_text(m.vertices));
  text += line("edges", count_text(m.edges));
  text += line("parts", count_text(m.components));
  text += line("boundary loops",
               m.boundary_loops == 0 ? "none (closed)" : count_text(m.boundary_loops));
  text += line("genus (handles)",
               m.genus ? std::to_string(*m.genus) : "unknown (not an oriented manifold)");
  text += size_lines(m);
  text +=
      line("time", fmt::format("{:.0f} ms to read the file, {:.0f} ms to look for defects{}",
                               times.load, times.inspect,
                               times.open ? fmt::format(", {:.0f} ms to open", *times.open) : ""));

  for (const std::string& note : m.notes) text += line("note", note);

  for (const bool blocking : {true, false}) {
    std::string list;
    for_each_defect(m, [&](const char* words, const auto& defect, bool blocks) {
      if (blocks != blocking || !defect.found()) return;
      std::vector<std::string> places;
      for (const auto& place : defect.first) places.push_back(place_text(place));
      list += fmt::format("  {:>9} {} {}{}\n", count_text(defect.count), words,
                          fmt::join(places, ", "), defect.count > places.size() ? ", ..." : "");
    });
    if (!blocking && near.count > 0) {
      list += fmt::format("  {:>9} vertices that nearly coincide with others, up to {:.3g} apart\n",
                          count_text(near.count), near.largest_gap);
    }
    if (!list.empty())
      text += (blocking ? "\nDefects:\n" : "\nNo obstacle, but good to know:\n") + list;
  }
  const std::string steps = m.steps.empty() ? "" : fmt::format(" (--repair={})", m.steps);
  const std::string weld = welded ? " But " + weld_sentence(m, *welded, kRepairOption) : "";
  text += fmt::format("\nVerdict: {}{}. {}{}\n", verdict_words(m.verdict), steps, m.reason, weld);
  return repair ? text + repair_text(*repair) : text;
}

std::string info_json(const MeshInspection& m, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair,
                      const std::optional<WeldedMesh>& welded, const NearVertices& near) {
  std::vector<ReportEntry> entries = entries_of(m);
  append(entries, "",
         {{"time_ms.load", times.load},
          {"time_ms.inspect", times.inspect},
          {"time_ms.open", times.open.value_or(HUGE_VAL)}});
  append(entries, "", entries_of(near));
  append(entries, "", entries_of(welded, m));
  if (repair) append(entries, "", entries_of(repair->changes, repair->after));
  return to_json(entries, {});
}

}  // namespace talweg::driver
