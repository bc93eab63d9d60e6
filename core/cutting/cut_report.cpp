#include "talweg/core/cutting/cut_report.hpp"

#include <cstdint>

#include "talweg/core/version.hpp"

namespace talweg {

std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const CutMesh& cut,
                                    const MeshParts& made, const std::vector<std::string>& warnings,
                                    double ms) {
  std::vector<ReportEntry> entries;
  const auto add = [&](std::string key, auto value) { entries.push_back({std::move(key), value}); };
  const auto count = [&](std::string key, std::size_t n) { add(std::move(key), std::uint64_t{n}); };
  add("version", std::string(version()));
  count("faces", mesh.surface().face_count());
  count("vertices", mesh.surface().vertex_count());
  count("cut_faces", cut.cut_faces);
  count("new_vertices", cut.new_vertices);
  count("crossings", cut.crossings);
  count("merged", cut.merged);
  add("merged_by_at_most", cut.largest_move);
  count("pieces", made.pieces);
  count("pieces_between", made.between);
  for (std::size_t k = 0; k < made.parts.size(); ++k) {
    const MeshPart& part = made.parts[k];
    const std::string prefix = "parts." + std::to_string(k) + ".";
    count(prefix + "vertices", part.lists.points.size());
    count(prefix + "faces", part.lists.triangles.size());
    count(prefix + "lids", part.lids.filled);
    count(prefix + "lids_planar", part.lids.planar);
    count(prefix + "lids_faces", part.lids.triangles);
    count(prefix + "lids_with_points", part.lids.with_inner);
    add(prefix + "lids_moved_by_at_most", part.lids.sunk_by);
    count(prefix + "rims_open", part.lids.left_open);
  }
  add("warnings", warnings);
  add("time_ms.cut", ms);
  return entries;
}

}  // namespace talweg
