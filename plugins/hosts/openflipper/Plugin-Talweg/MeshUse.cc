#include "MeshUse.hh"

#include <algorithm>
#include <utility>

#include <ACG/Geometry/Algorithms.hh>

#include "talweg/plugin/talweg_host_openmesh.hpp"

namespace talweg::openflipper {
namespace {

using Face = TriMesh::FaceHandle;

std::array<double, 3> barycentric_in(const TriMesh& mesh, Face face, const ACG::Vec3d& place) {
  std::array<ACG::Vec3d, 3> corners;
  std::size_t k = 0;
  for (auto v = mesh.cfv_iter(face); v.is_valid() && k < 3; ++v) corners[k++] = mesh.point(*v);
  ACG::Vec3d at(1.0 / 3);
  ACG::Geometry::baryCoord(place, corners[0], corners[1], corners[2], at);
  return {at[0], at[1], at[2]};
}

double area_of(const TriMesh& mesh, Face face) {
  std::array<ACG::Vec3d, 3> corners;
  std::size_t k = 0;
  for (auto v = mesh.cfv_iter(face); v.is_valid() && k < 3; ++v) corners[k++] = mesh.point(*v);
  return ((corners[1] - corners[0]) % (corners[2] - corners[0])).norm() / 2;
}

/// The faces connected to a face without a step across the chain.
std::vector<Face> faces_beside(const TriMesh& mesh, Face start,
                               const std::vector<TriMesh::HalfedgeHandle>& chain) {
  std::vector<bool> on_chain(mesh.n_edges(), false), seen(mesh.n_faces(), false);
  for (const auto h : chain) on_chain[static_cast<std::size_t>(mesh.edge_handle(h).idx())] = true;
  std::vector<Face> found = {start};
  seen[static_cast<std::size_t>(start.idx())] = true;
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (auto h = mesh.cfh_iter(found[k]); h.is_valid(); ++h) {
      const Face next = mesh.face_handle(mesh.opposite_halfedge_handle(*h));
      if (!next.is_valid() || on_chain[static_cast<std::size_t>(mesh.edge_handle(*h).idx())]) {
        continue;
      }
      if (seen[static_cast<std::size_t>(next.idx())]) continue;
      seen[static_cast<std::size_t>(next.idx())] = true;
      found.push_back(next);
    }
  }
  return found;
}

double area_of(const TriMesh& mesh, const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face f : faces) sum += area_of(mesh, f);
  return sum;
}

std::vector<Face> smaller_side(const TriMesh& mesh,
                               const std::vector<TriMesh::HalfedgeHandle>& chain) {
  const Face left = mesh.face_handle(chain.front());
  const Face right = mesh.face_handle(mesh.opposite_halfedge_handle(chain.front()));
  if (!left.is_valid() || !right.is_valid()) {
    throw editing::Error("A curve along the mesh's boundary has no inside.");
  }
  std::vector<Face> a = faces_beside(mesh, left, chain);
  if (std::find(a.begin(), a.end(), right) != a.end()) {
    throw editing::Error("A closed curve does not divide the mesh, so it has no inside.");
  }
  std::vector<Face> b = faces_beside(mesh, right, chain);
  return area_of(mesh, a) <= area_of(mesh, b) ? a : b;
}

/// Copies the selection of the mesh to a part.
void carry_selection(const TriMesh& from, TriMesh& part) {
  OpenMesh::VPropHandleT<int> vertex;
  OpenMesh::FPropHandleT<int> face;
  if (!part.get_property_handle(vertex, openmesh::kVertexNumber) ||
      !part.get_property_handle(face, openmesh::kFaceNumber)) {
    return;
  }
  for (const auto v : part.vertices()) {
    const int old = part.property(vertex, v);
    if (old >= 0) part.status(v).set_selected(from.status(TriMesh::VertexHandle(old)).selected());
  }
  for (const auto f : part.faces()) {
    const int old = part.property(face, f);
    if (old >= 0) part.status(f).set_selected(from.status(Face(old)).selected());
  }
}

template <class Differ>
std::vector<editing::OrderedVertices> borders(const TriMesh& mesh, const Differ& differ) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge_handle(e, 0);
    const Face a = mesh.face_handle(h), b = mesh.face_handle(mesh.opposite_halfedge_handle(h));
    if (!a.is_valid() || !b.is_valid() || !differ(a, b)) continue;
    edges.push_back({static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx()),
                     static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx())});
  }
  return editing::order_between_branches(edges);
}

}  // namespace

AppliedPlan cut_mesh(const editing::Plugins& plugins, TriMesh& mesh,
                     const editing::MeshArrays& arrays, const std::vector<host::Curve>& curves) {
  const host::Services services("OpenFlipper", "Plugin-Talweg");
  host::Instance cut(plugins.find("talweg.cut"), services);
  editing::set_mesh(cut, arrays);
  cut.set_curves(editing::courses(curves));
  cut.run();
  return apply_plan(mesh, division_from(cut.cut_plan()));
}

editing::Point moved(const editing::MeshArrays& before, const TriMesh& mesh, const AppliedPlan& cut,
                     const editing::Point& point) {
  const ACG::Vec3d place = vector_at(before, point);
  Face best(static_cast<int>(point.face));
  std::array<double, 3> best_at = barycentric_in(mesh, best, place);
  const auto least = [](const std::array<double, 3>& b) { return std::min({b[0], b[1], b[2]}); };
  for (std::size_t k = 0; k < cut.faces.size(); ++k) {
    if (cut.face_from[k].idx() != static_cast<int>(point.face)) continue;
    const std::array<double, 3> at = barycentric_in(mesh, cut.faces[k], place);
    if (least(at) <= least(best_at)) continue;
    best = cut.faces[k];
    best_at = at;
  }
  editing::Point result = editing::picked(static_cast<std::uint32_t>(best.idx()), best_at);
  result.pinned = point.pinned;
  result.exact = point.exact;
  return result;
}

std::vector<TriMesh::FaceHandle> faces_inside(const TriMesh& mesh, const AppliedPlan& cut,
                                              const std::vector<host::Curve>& curves) {
  std::vector<Face> inside;
  bool any = false;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!curves[c].closed || cut.chains[c].empty()) continue;
    any = true;
    const std::vector<Face> side = smaller_side(mesh, cut.chains[c]);
    inside.insert(inside.end(), side.begin(), side.end());
  }
  if (!any) throw editing::Error("Only a closed curve has an inside, and there is none.");
  return inside;
}

std::vector<TriMesh> parts_of_mesh(const editing::Plugins& plugins, const TriMesh& mesh,
                                   const std::vector<host::Curve>& curves, bool lids,
                                   const std::function<void(const QString&)>& say) {
  const host::Services services("OpenFlipper", "Plugin-Talweg");
  host::OpenMeshInstance<TriMesh> cut(plugins.find("talweg.cut"), services);
  cut.set_mesh(mesh);
  for (const std::string& left_out : cut.set_attributes(mesh)) {
    say(QString::fromStdString(left_out));
  }
  cut.instance().set_curves(editing::courses(curves));
  cut.set("split", 1.0);
  cut.set("cap", lids ? "auto" : "none");
  host::Wanted wanted;
  wanted.meshes = true;
  const host::OpenMeshResults results = cut.run(wanted);
  if (const host::ReportEntry* warnings = results.raw.find("warnings")) {
    for (const std::string& sentence : warnings->texts) say(QString::fromStdString(sentence));
  }
  std::vector<TriMesh> parts;
  for (std::size_t k = 0; k < results.raw.meshes.size(); ++k) {
    TriMesh part = cut.made(results, k).mesh;
    part.request_vertex_status();
    part.request_edge_status();
    part.request_face_status();
    carry_selection(mesh, part);
    part.update_normals();
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<editing::OrderedVertices> border_of_selection(const TriMesh& mesh) {
  auto found = borders(
      mesh, [&](Face a, Face b) { return mesh.status(a).selected() != mesh.status(b).selected(); });
  if (found.empty()) throw editing::Error("Select some faces of the mesh first, and not all.");
  return found;
}

std::vector<editing::OrderedVertices> borders_of_colours(const TriMesh& mesh) {
  if (!mesh.has_face_colors()) throw editing::Error("The faces of the mesh have no colours.");
  auto found = borders(mesh, [&](Face a, Face b) { return mesh.color(a) != mesh.color(b); });
  if (found.empty()) throw editing::Error("All faces of the mesh have one colour.");
  return found;
}

}  // namespace talweg::openflipper
