// Sentences of an inspection: what is in the way of opening the mesh, and the verdict.
#include <string>
#include <utility>

#include "talweg/core/mesh_inspection.hpp"

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

/// "1 face has" or "7 faces have": the words for one and for several follow the number.
std::string counted(std::size_t n, const char* one, const char* several) {
  return text(n) + (n == 1 ? one : several);
}

/// Closes "1 edge has more than two faces" with its place, or with the first of many.
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

/// What no repair can mend.
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
  if (m.non_finite_vertices.found()) {
    return element_sentence(
        m.non_finite_vertices, "vertex",
        " vertex has a coordinate that is not a finite number of at most 1e152",
        " vertices have a coordinate that is not a finite number of at most 1e152");
  }
  return "";
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

/// The steps that mend it. Faces that go can leave two of the same direction at an edge.
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
        "No face has an area that the precision of its coordinates tells from zero, so nothing may "
        "be left by a repair: " +
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
