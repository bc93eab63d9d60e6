// Names of repair steps, and sentences about the changes of a repair.
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/repair/mesh_repair.hpp"
#include "talweg/core/space/message_numbers.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

std::string place_text(std::uint32_t id) { return fmt::format("{}", id); }
std::string place_text(const RepeatPlace& p) {
  return fmt::format("{} as {}", p.element, p.earlier);
}
std::string place_text(const EdgePlace& p) {
  return fmt::format("{}-{}", p.vertices[0], p.vertices[1]);
}

/// "Repair: 40 vertices were split (vertex 4, 7, 8, 9, 11, ...)."
template <class Place>
void tell(std::vector<std::string>& all, const Defect<Place>& what, const char* one,
          const char* several, const char* kind, const std::string& more = "") {
  if (!what.found()) return;
  std::vector<std::string> places;
  for (const Place& place : what.first) places.push_back(place_text(place));
  all.push_back(fmt::format("Repair: {} {}{} ({} {}{}).", count_text(what.count),
                            what.count == 1 ? one : several, more, kind, fmt::join(places, ", "),
                            what.count > places.size() ? ", ..." : ""));
}

constexpr std::string_view kWeldWithin = "weld=";

double tolerance_of(std::string_view text) {
  double tolerance = 0;
  std::istringstream words{std::string(text)};
  words.imbue(std::locale::classic());
  words >> tolerance;
  if (!words || !words.eof() || !(tolerance > 0) || !std::isfinite(tolerance)) {
    throw Error(ErrorCode::kBadUsage,
                fmt::format("The tolerance of weld must be a length above 0 in mesh units, as in "
                            "weld=1e-4, not \"{}\".",
                            text));
  }
  return tolerance;
}

}  // namespace

RepairSteps repair_steps(std::string_view list) {
  RepairSteps steps{false, false, false, false};
  const std::pair<std::string_view, bool*> known[] = {{"weld", &steps.weld},
                                                      {"drop", &steps.drop},
                                                      {"orient", &steps.orient},
                                                      {"split", &steps.split}};
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string_view word = list.substr(begin, end - begin);
    bool found = word.starts_with(kWeldWithin);
    if (found) {
      steps.weld = true;
      steps.weld_tolerance = tolerance_of(word.substr(kWeldWithin.size()));
    }
    for (const auto& [name, step] : known) {
      if (word != name && word != "all") continue;
      *step = true;
      found = true;
    }
    if (!found) {
      throw Error(
          ErrorCode::kBadUsage,
          fmt::format("\"{}\" is not a repair; known are weld, weld=TOLERANCE, drop, orient, "
                      "split and all, separated by commas.",
                      word));
    }
    begin = end + 1;
  }
  return steps;
}

bool MeshChanges::any() const {
  return welded_vertices.found() || collapsed_faces.found() || duplicate_faces.found() ||
         zero_area_faces.found() || turned_faces.found() || split_edges.found() ||
         split_vertices.found();
}

std::vector<std::string> sentences(const MeshChanges& changes) {
  std::vector<std::string> all;
  tell(all, changes.welded_vertices, "vertex was welded onto another",
       "vertices were welded onto others", "vertex",
       ", over at most " + mesh_units_text(changes.weld_distance));
  if (changes.held_apart > 0) {
    all.push_back(fmt::format(
        "Repair: {} vertices within the tolerance of others stay apart, because they are the two "
        "ends of an edge or lie farther apart than half of their shortest edge.",
        count_text(changes.held_apart)));
  }
  tell(all, changes.flattened_faces, "face has no area any more after welding",
       "faces have no area any more after welding", "face");
  tell(all, changes.collapsed_faces, "face with a vertex twice was dropped",
       "faces with a vertex twice were dropped", "face");
  tell(all, changes.duplicate_faces, "face that repeats another was dropped",
       "faces that repeat others were dropped", "face");
  tell(all, changes.zero_area_faces, "face of zero area was dropped",
       "faces of zero area were dropped", "face");
  tell(all, changes.turned_faces, "face was turned around", "faces were turned around", "face");
  tell(all, changes.split_edges, "edge with more than two faces was cut",
       "edges with more than two faces were cut", "vertices");
  tell(all, changes.split_vertices, "vertex was split", "vertices were split", "vertex",
       fmt::format(", {} {} added", count_text(changes.vertex_copies),
                   changes.vertex_copies == 1 ? "was" : "were"));
  return all;
}

}  // namespace talweg
