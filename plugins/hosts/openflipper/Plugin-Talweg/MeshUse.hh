// What can be made of a host's mesh with smoothed curves: cut it, take it apart, find what lies
// inside. All through talweg.cut; here is only what belongs to the host.
#pragma once

#include <functional>
#include <vector>

#include "HostMesh.hh"
#include "talweg/core/openmesh/plan_application.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::openflipper {

/// Makes the curves edges of the mesh, in place; all that the mesh knows is kept. `arrays` are
/// those of the mesh. Throws host::Error or PlanError, and the mesh is then as it was.
AppliedPlan cut_mesh(const editing::Plugins& plugins, TriMesh& mesh,
                     const editing::MeshArrays& arrays, const std::vector<host::Curve>& curves);

/// A drawn point on the mesh after the cut, at the same place.
editing::Point moved(const editing::MeshArrays& before, const TriMesh& mesh, const AppliedPlan& cut,
                     const editing::Point& point);

/// The faces that the closed chains of a cut enclose: of each the side of smaller area. Throws
/// editing::Error if no chain is closed, or one does not divide the mesh.
std::vector<TriMesh::FaceHandle> faces_inside(const TriMesh& mesh, const AppliedPlan& cut,
                                              const std::vector<host::Curve>& curves);

/// The parts that the curves leave, as meshes of their own with the mesh's properties and
/// selections. `say` gets a sentence on each property that cannot go over. Throws host::Error.
std::vector<TriMesh> parts_of_mesh(const editing::Plugins& plugins, const TriMesh& mesh,
                                   const std::vector<host::Curve>& curves, bool lids,
                                   const std::function<void(const QString&)>& say);

/// Edges between faces of which one is selected and one is not, or between faces of different
/// colours. Throws editing::Error if there are none.
std::vector<editing::OrderedVertices> border_of_selection(const TriMesh& mesh);
std::vector<editing::OrderedVertices> borders_of_colours(const TriMesh& mesh);

}  // namespace talweg::openflipper
