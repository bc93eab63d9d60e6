#include "info_text.hpp"

#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "weld_hint.hpp"

namespace talweg::driver {
namespace {

using nlohmann::ordered_json;

/// 1,234,567
std::string grouped(std::size_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t k = digits.size(); k > 3; k -= 3) digits.insert(k - 3, 1, ',');
  return digits;
}

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

ordered_json place_json(std::uint32_t id) { return id; }
ordered_json place_json(const RepeatPlace& p) {
  return {{"id", p.element}, {"repeats", p.earlier}};
}
ordered_json place_json(const FaceIndexPlace& p) {
  return {{"face", p.face}, {"vertex", p.vertex}};
}
ordered_json place_json(const EdgePlace& p) {
  return {{"vertices", p.vertices}, {"faces", p.faces}};
}

/// Calls `visit(key, words, defect, blocking)` for every defect, in the order of the report.
template <class Visit>
void for_each_defect(const MeshInspection& m, Visit visit) {
  visit("indices_out_of_range", "faces with vertices that do not exist: face",
        m.indices_out_of_range, true);
  visit("non_finite_vertices", "vertices with coordinates that are not finite or too large: vertex",
        m.non_finite_vertices, true);
  visit("repeated_vertex_faces", "faces that use a vertex twice: face", m.repeated_vertex_faces,
        true);
  visit("duplicate_faces", "faces that are there twice: face", m.duplicate_faces, true);
  visit("non_manifold_edges", "edges with more than two faces: vertices", m.non_manifold_edges,
        true);
  visit("misoriented_edges", "edges between faces of opposite orientation: vertices",
        m.misoriented_edges, true);
  visit("non_manifold_vertices", "vertices where surface parts only touch (bow-ties): vertex",
        m.non_manifold_vertices, true);
  visit("isolated_vertices", "vertices without a face: vertex", m.isolated_vertices, false);
  visit("duplicate_positions", "vertices at the place of another one: vertex",
        m.duplicate_positions, false);
  visit("zero_area_faces", "faces of zero area: face", m.zero_area_faces, false);
  visit("needle_faces", "needle faces (an angle below 1 degree): face", m.needle_faces, false);
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

const char* verdict_key(MeshVerdict verdict) {
  switch (verdict) {
    case MeshVerdict::kUsable:
      return "usable";
    case MeshVerdict::kRepairable:
      return "repairable";
    case MeshVerdict::kUnusable:
      return "not_usable";
  }
  return "";
}

std::string line(const char* label, const std::string& value) {
  return fmt::format("{:<18}{}\n", label, value);
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
  return text;
}

std::string repair_text(const InfoRepair& repair) {
  std::string text = "\n";
  for (const std::string& sentence : sentences(repair.changes)) text += sentence + "\n";
  if (!repair.changes.any()) text += "Repair: nothing to do.\n";
  return text + fmt::format("After the repair: {}. {}\n", verdict_words(repair.after.verdict),
                            repair.after.reason);
}

template <class Place>
ordered_json defect_json(const Defect<Place>& defect) {
  ordered_json places = ordered_json::array();
  for (const Place& place : defect.first) places.push_back(place_json(place));
  return {{"count", defect.count}, {"first", places}};
}

ordered_json repair_json(const InfoRepair& repair) {
  const MeshChanges& c = repair.changes;
  return {{"welded_vertices", defect_json(c.welded_vertices)},
          {"weld_tolerance", c.weld_tolerance},
          {"weld_distance", c.weld_distance},
          {"collapsed_faces", defect_json(c.collapsed_faces)},
          {"duplicate_faces", defect_json(c.duplicate_faces)},
          {"zero_area_faces", defect_json(c.zero_area_faces)},
          {"turned_faces", defect_json(c.turned_faces)},
          {"split_edges", defect_json(c.split_edges)},
          {"split_vertices", defect_json(c.split_vertices)},
          {"vertex_copies", c.vertex_copies},
          {"verdict", verdict_key(repair.after.verdict)},
          {"reason", repair.after.reason}};
}

}  // namespace

std::string info_text(const MeshInspection& m, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair,
                      const std::optional<WeldedMesh>& welded) {
  std::string text = line("faces", grouped(m.faces));
  if (m.polygons > 0) {
    text.pop_back();
    text += fmt::format(" (after cutting {} polygons into triangles)\n", grouped(m.polygons));
  }
  text += line("vertices", grouped(m.vertices));
  text += line("edges", grouped(m.edges));
  text += line("parts", grouped(m.components));
  text +=
      line("boundary loops", m.boundary_loops == 0 ? "none (closed)" : grouped(m.boundary_loops));
  text += line("genus (handles)",
               m.genus ? std::to_string(*m.genus) : "unknown (not an oriented manifold)");
  text += size_lines(m);
  text +=
      line("time", fmt::format("{:.0f} ms to read the file, {:.0f} ms to look for defects{}",
                               times.load, times.inspect,
                               times.open ? fmt::format(", {:.0f} ms to open", *times.open) : ""));

  for (const bool blocking : {true, false}) {
    std::string list;
    for_each_defect(m, [&](const char*, const char* words, const auto& defect, bool blocks) {
      if (blocks != blocking || !defect.found()) return;
      std::vector<std::string> places;
      for (const auto& place : defect.first) places.push_back(place_text(place));
      list += fmt::format("  {:>9} {} {}{}\n", grouped(defect.count), words,
                          fmt::join(places, ", "), defect.count > places.size() ? ", ..." : "");
    });
    if (!list.empty())
      text += (blocking ? "\nDefects:\n" : "\nNo obstacle, but good to know:\n") + list;
  }
  const std::string steps = m.steps.empty() ? "" : fmt::format(" (--repair={})", m.steps);
  const std::string weld = welded ? " But " + weld_sentence(m, *welded) : "";
  text += fmt::format("\nVerdict: {}{}. {}{}\n", verdict_words(m.verdict), steps, m.reason, weld);
  return repair ? text + repair_text(*repair) : text;
}

std::string info_json(const MeshInspection& m, const InfoTimes& times,
                      const std::optional<InfoRepair>& repair,
                      const std::optional<WeldedMesh>& welded) {
  ordered_json json{{"faces", m.faces},
                    {"vertices", m.vertices},
                    {"edges", m.edges},
                    {"polygons", m.polygons},
                    {"components", m.components},
                    {"boundary_edges", m.boundary_edges},
                    {"boundary_loops", m.boundary_loops},
                    {"euler_characteristic", m.euler_characteristic},
                    {"genus", nullptr},
                    {"orientable", m.orientable},
                    {"single_precision", m.single_precision},
                    {"box_min", m.box_min},
                    {"box_max", m.box_max},
                    {"size", m.size},
                    {"offset", m.offset},
                    {"edge_length_min", m.edge_length_min},
                    {"edge_length_mean", m.edge_length_mean},
                    {"edge_length_max", m.edge_length_max},
                    {"smallest_angle", m.smallest_angle}};
  if (m.genus) json["genus"] = *m.genus;
  ordered_json defects = ordered_json::object();
  for_each_defect(m, [&](const char* key, const char*, const auto& defect, bool) {
    defects[key] = defect_json(defect);
  });
  json["defects"] = defects;
  json["time_ms"] = {{"load", times.load}, {"inspect", times.inspect}, {"open", nullptr}};
  if (times.open) json["time_ms"]["open"] = *times.open;
  json["verdict"] = verdict_key(m.verdict);
  json["reason"] = m.reason;
  json["repair_steps"] = m.steps;
  json["weld"] = nullptr;
  if (welded) {
    json["weld"] = {{"steps", welded->steps},
                    {"vertices", welded->vertices},
                    {"components", welded->after.components},
                    {"boundary_loops", welded->after.boundary_loops},
                    {"sentence", weld_sentence(m, *welded)}};
  }
  if (repair) json["repair"] = repair_json(*repair);
  return json.dump(2) + "\n";
}

}  // namespace talweg::driver
