#include "talweg/core/cutting/cut_report.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "talweg/core/version.hpp"

namespace talweg {

namespace {

class Entries {
 public:
  template <class Value>
  void add(std::string key, Value value) {
    entries_.push_back({std::move(key), value});
  }
  void count(std::string key, std::size_t n) { add(std::move(key), std::uint64_t{n}); }

  void add_cut(const SurfaceMesh& mesh, const CutNumbers& cut) {
    add("version", std::string(version()));
    count("faces", mesh.surface().face_count());
    count("vertices", mesh.surface().vertex_count());
    count("cut_faces", cut.cut_faces);
    count("new_vertices", cut.new_vertices);
    count("crossings", cut.crossings);
    count("merged", cut.merged);
    add("merged_by_at_most", cut.largest_move);
  }
  /// `separates` is empty if no seam was opened.
  void add_separation(const std::vector<bool>& separates) {
    for (std::size_t c = 0; c < separates.size(); ++c) {
      add("separates." + std::to_string(c), static_cast<bool>(separates[c]));
    }
  }
  void add_pieces(std::size_t pieces, std::size_t between) {
    count("pieces", pieces);
    count("pieces_between", between);
  }
  void add_part(std::size_t k, std::size_t vertices, std::size_t faces, const Lids& lids) {
    const std::string prefix = "parts." + std::to_string(k) + ".";
    count(prefix + "vertices", vertices);
    count(prefix + "faces", faces);
    count(prefix + "lids", lids.filled);
    count(prefix + "lids_planar", lids.planar);
    count(prefix + "lids_faces", lids.triangles);
    count(prefix + "lids_with_points", lids.with_inner);
    add(prefix + "lids_moved_by_at_most", lids.sunk_by);
    count(prefix + "rims_open", lids.left_open);
  }
  std::vector<ReportEntry> take(const std::vector<std::string>& warnings, double ms) {
    add("warnings", warnings);
    add("time_ms.cut", ms);
    return std::move(entries_);
  }

 private:
  std::vector<ReportEntry> entries_;
};

}  // namespace

std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const CutMesh& cut,
                                    const MeshParts& made, const std::vector<std::string>& warnings,
                                    double ms) {
  Entries entries;
  entries.add_cut(mesh, cut);
  entries.add_pieces(made.pieces, made.between);
  entries.add_separation(made.separates);
  for (std::size_t k = 0; k < made.parts.size(); ++k) {
    const MeshPart& part = made.parts[k];
    entries.add_part(k, part.lists.points.size(), part.lists.triangles.size(), part.lids);
  }
  std::vector<std::string> all = warnings;
  all.insert(all.end(), made.notes.begin(), made.notes.end());
  return entries.take(all, ms);
}

std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const CutPlan& plan,
                                    const std::vector<std::string>& warnings, double ms) {
  const Surface& surface = mesh.surface();
  Entries entries;
  entries.add_cut(mesh, plan);
  entries.add_pieces(1, 0);
  entries.add_part(0, surface.vertex_count() + plan.new_vertices,
                   surface.face_count() - plan.cut_faces + plan.triangles.size(), {});
  return entries.take(warnings, ms);
}

}  // namespace talweg
