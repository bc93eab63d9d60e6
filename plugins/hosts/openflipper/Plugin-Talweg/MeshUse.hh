// Changes of a host's mesh by smoothed curves: cuts, separation into parts, and the faces inside
// curves. The geometry comes from talweg.cut; these functions handle only the host's data.
#pragma once

#include <functional>
#include <vector>

#include "HostMesh.hh"
#include "talweg/core/openmesh/plan_application.hpp"
#include "talweg/editing/workplace.hpp"

namespace talweg::openflipper {

/// Makes the curves edges of the mesh, in place; the mesh keeps all its properties. `arrays` are
/// the mesh's arrays. Throws host::Error or PlanError; the mesh is unchanged then.
AppliedPlan cut_mesh(const editing::Plugins& plugins, TriMesh& mesh,
                     const editing::MeshArrays& arrays, const std::vector<host::Curve>& curves);

/// A drawn point on the mesh after the cut, at the same place.
editing::Point moved(const editing::MeshArrays& before, const TriMesh& mesh, const AppliedPlan& cut,
                     const editing::Point& point);

/// The faces enclosed by the closed chains of a cut: for each chain the side of smaller area.
/// Throws editing::Error if no chain is closed, or if a closed chain does not divide the mesh.
std::vector<TriMesh::FaceHandle> faces_inside(const TriMesh& mesh, const AppliedPlan& cut,
                                              const std::vector<host::Curve>& curves);

/// The parts of the mesh between the curves as separate meshes, with the mesh's properties and
/// selections. `say` gets a sentence on each property that cannot be copied. Throws host::Error.
std::vector<TriMesh> parts_of_mesh(const editing::Plugins& plugins, const TriMesh& mesh,
                                   const std::vector<host::Curve>& curves, bool lids,
                                   const std::function<void(const QString&)>& say);

/// Edges between a selected face and another, or between faces of different colours. Throws
/// editing::Error if there are none.
std::vector<editing::OrderedVertices> border_of_selection(const TriMesh& mesh);
std::vector<editing::OrderedVertices> borders_of_colours(const TriMesh& mesh);

}  // namespace talweg::openflipper
