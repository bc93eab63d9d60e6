// The sentences of an inspection: the obstacle to opening the mesh, and the verdict.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/mesh/measurable_point.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"
#include "talweg/core/space/message_numbers.hpp"

namespace talweg {
namespace {

std::string text(std::size_t n) { return std::to_string(n); }

std::string faces_text(const std::vector<std::uint32_t>& faces) {
  std::string result = "faces ";
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i > 0) result += i + 1 == faces.size() ? " and " : ", ";
    result += text(faces[i]);
  }
  return result;
}

/// "1 face has" or "7 faces have": the number with the words for one or for several.
std::string counted(std::size_t n, const char* one, const char* several) {
  return count_text(n) + (n == 1 ? one : several);
}

/// Completes "1 edge has more than two faces" with its place, or "7 edges have ..." with the first
/// place.
std::string placed(std::string sentence, std::size_t count, const std::string& place) {
  return std::move(sentence) + (count == 1 ? " (" : " (first: ") + place + ").";
}

std::string edge_sentence(const Defect<EdgePlace>& defect, const char* one, const char* several) {
  const EdgePlace& edge = defect.first.front();
  return placed(counted(defect.count, one, several), defect.count,
                "between vertices " + text(edge.vertices[0]) + " and " + text(edge.vertices[1]) +
                    ", " + faces_text(edge.faces));
}

std::string element_sentence(const Defect<std::uint32_t>& defect, const char* kind, const char* one,
                             const char* several) {
  return placed(counted(defect.count, one, several), defect.count,
                std::string(kind) + " " + text(defect.first.front()));
}

/// A sentence if the size or an edge is so short that products of lengths underflow; else empty.
std::string too_small(const MeshInspection& m) {
  if (m.size > 0 && m.size < kSmallestSize) {
    return fmt::format(
        "The mesh is only {:.3g} large (the diagonal of its box), and must be {:g} at least: scale "
        "it.",
        m.size, kSmallestSize);
  }
  if (m.edge_length_least > 0 && m.edge_length_least < kShortestEdge) {
    return fmt::format(
        "The shortest edge that is not of length 0 is {:.3g} long, and must be {:g} at least.",
        m.edge_length_least, kShortestEdge);
  }
  return "";
}

std::string beyond_range(const MeshInspection& m) {
  if (!m.non_finite_vertices.found()) return too_small(m);
  const std::string limit =
      fmt::format(" a coordinate that is not a finite number of at most {:g}", kLargestCoordinate);
  const std::string largest =
      std::isfinite(m.coordinate_max) && m.coordinate_max > kLargestCoordinate
          ? fmt::format("; the largest is {:.3g}: scale the mesh", m.coordinate_max)
          : "";
  const Defect<std::uint32_t>& all = m.non_finite_vertices;
  return placed(counted(all.count, " vertex has", " vertices have") + limit, all.count,
                "vertex " + text(all.first.front()) + largest);
}

/// A sentence about a defect that repair() cannot fix; empty if there is none.
std::string fatal(const MeshInspection& m) {
  if (m.vertices == 0) return "The mesh has no vertices.";
  if (m.faces == 0) return "The mesh has vertices but no faces.";
  if (m.indices_out_of_range.found()) {
    const FaceIndexPlace& place = m.indices_out_of_range.first.front();
    return placed(counted(m.indices_out_of_range.count, " face refers", " faces refer") +
                      " to vertices that do not exist",
                  m.indices_out_of_range.count,
                  "face " + text(place.face) + " to vertex " + text(place.vertex) + " of " +
                      text(m.vertices));
  }
  return beyond_range(m);
}

std::string mendable(const MeshInspection& m) {
  if (m.repeated_vertex_faces.found()) {
    return element_sentence(m.repeated_vertex_faces, "face", " face uses a vertex twice",
                            " faces use a vertex twice");
  }
  if (m.duplicate_faces.found()) {
    const RepeatPlace& place = m.duplicate_faces.first.front();
    return placed(counted(m.duplicate_faces.count, " face repeats", " faces repeat") +
                      " the vertices of another face",
                  m.duplicate_faces.count,
                  "face " + text(place.element) + " repeats face " + text(place.earlier));
  }
  if (m.non_manifold_edges.found()) {
    return edge_sentence(m.non_manifold_edges, " edge has more than two faces",
                         " edges have more than two faces");
  }
  if (m.misoriented_edges.found()) {
    return edge_sentence(m.misoriented_edges, " edge joins two faces of opposite orientation",
                         " edges join two faces of opposite orientation");
  }
  if (m.non_manifold_vertices.found()) {
    return element_sentence(m.non_manifold_vertices, "vertex",
                            " vertex joins surface parts that share no edge there (bow-tie)",
                            " vertices join surface parts that share no edge there (bow-tie)");
  }
  return "";
}

/// The repair steps that fix the mesh. Dropping faces at an edge with more than two can leave two
/// of the same direction, so "orient" is added.
std::string needed_steps(const MeshInspection& m) {
  const bool drop = m.repeated_vertex_faces.found() || m.duplicate_faces.found();
  const bool crowded = m.non_manifold_edges.found();
  std::string steps;
  const auto add = [&](bool needed, const char* step) {
    if (needed) steps.append(steps.empty() ? "" : ",").append(step);
  };
  add(drop, "drop");
  add(m.misoriented_edges.found() || (drop && crowded), "orient");
  add(crowded || m.non_manifold_vertices.found(), "split");
  return steps;
}

}  // namespace

std::string obstacle(const MeshInspection& inspection) {
  const std::string reason = fatal(inspection);
  return reason.empty() ? mendable(inspection) : reason;
}

std::string out_of_range(const MeshLists& lists) {
  return all_measurable(lists) && large_enough(lists) ? "" : beyond_range(inspect(lists));
}

void judge(MeshInspection& inspection) {
  inspection.reason = obstacle(inspection);
  const bool nothing_left = inspection.repeated_vertex_faces.count == inspection.faces;
  if (!fatal(inspection).empty() || (nothing_left && !inspection.reason.empty())) {
    inspection.verdict = MeshVerdict::kUnusable;
  } else if (inspection.reason.empty()) {
    inspection.verdict = MeshVerdict::kUsable;
    inspection.reason = "The mesh is a consistently oriented manifold surface.";
  } else if (inspection.repeated_vertex_faces.count + inspection.zero_area_faces.count ==
             inspection.faces) {
    inspection.verdict = MeshVerdict::kUnusable;
    inspection.reason =
        "All faces have zero area within the precision of their coordinates, so a repair may leave "
        "nothing of the mesh: " +
        inspection.reason;
  } else if (!inspection.orientable) {
    inspection.verdict = MeshVerdict::kUnusable;
    inspection.reason = "The surface is one-sided, so its faces cannot be oriented consistently: " +
                        inspection.reason;
  } else {
    inspection.verdict = MeshVerdict::kRepairable;
    inspection.steps = needed_steps(inspection);
  }
}

}  // namespace talweg
