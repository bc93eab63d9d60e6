#include "talweg/core/cutting/mesh_cutting.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace talweg {
namespace {

/// Writes the lists of the cut mesh from a plan.
class ListWriter {
 public:
  ListWriter(const SurfaceMesh& mesh, const CutPlan& plan, const Progress& progress)
      : mesh_(mesh), plan_(plan), poller_(progress, "cut", 0.7) {}

  CutMesh run() {
    write_vertices();
    poller_.set_fraction(0.8);
    write_faces();
    static_cast<CutNumbers&>(cut_) = plan_;
    cut_.chains = plan_.chains;
    poller_.set_fraction(1);
    poller_.poll();
    return std::move(cut_);
  }

 private:
  void write_vertices();
  void write_faces();
  /// Reports the copying of row number `rows` to the poller, in blocks.
  void did_rows(std::size_t rows) {
    constexpr std::size_t kBlock = 4096;  // a row takes some ten nanoseconds
    if (rows % kBlock == 0) poller_.add_work(kBlock / 10);
  }
  void add(const Triangle& triangle, std::uint32_t from) {
    cut_.lists.triangles.push_back(triangle);
    cut_.face_from.push_back(from);
  }

  const SurfaceMesh& mesh_;
  const CutPlan& plan_;
  ProgressPoller poller_;
  CutMesh cut_;
};

void ListWriter::write_vertices() {
  const std::size_t old = mesh_.points().size(), count = old + plan_.points.size();
  std::vector<Point>& points = cut_.lists.points;
  points.reserve(count);
  points.assign(mesh_.points().begin(), mesh_.points().end());
  points.insert(points.end(), plan_.points.begin(), plan_.points.end());
  cut_.vertex_from.reserve(count);
  for (std::size_t v = 0; v < old; ++v) {
    cut_.vertex_from.push_back(SurfacePoint::at_vertex(mesh_.surface(), VertexId{v}));
    did_rows(v);
  }
  cut_.vertex_from.insert(cut_.vertex_from.end(), plan_.vertex_from.begin(),
                          plan_.vertex_from.end());
}

void ListWriter::write_faces() {
  const Surface& surface = mesh_.surface();
  const std::size_t count = surface.face_count() - plan_.faces.size() + plan_.triangles.size();
  cut_.lists.triangles.reserve(count);
  cut_.face_from.reserve(count);
  std::size_t next = 0;  // index of the next divided face
  for (std::uint32_t f = 0; f < surface.face_count(); ++f) {
    did_rows(f);
    if (next < plan_.faces.size() && plan_.faces[next] == f) {
      for (const Triangle& part : plan_.parts(next)) add(part, f);
      ++next;
      continue;
    }
    Triangle corners{};
    const auto own = surface.corners(FaceId{f});
    for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(own[k].index());
    add(corners, f);
  }
}

}  // namespace

CutMesh cut_by(const SurfaceMesh& mesh, const CutPlan& plan, const Progress& progress) {
  return ListWriter(mesh, plan, progress).run();
}

CutMesh cut_along(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                  const CutOptions& options, const Progress& progress) {
  return cut_by(mesh, plan_cut(mesh, curves, options, progress), progress);
}

}  // namespace talweg
