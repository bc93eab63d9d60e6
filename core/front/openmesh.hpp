// The header for programs that use OpenMesh: their meshes, in single or double precision, are
// opened and changed in place.
#pragma once

#include "talweg/core/openmesh/close_seam.hpp"        // close_seam
#include "talweg/core/openmesh/curve_sides.hpp"       // sides_of
#include "talweg/core/openmesh/embed_curves.hpp"      // embed_curves
#include "talweg/core/openmesh/open_seam.hpp"         // open_seam
#include "talweg/core/openmesh/openmesh_adaptor.hpp"  // open_mesh, surface_of, lists_of, OpenMeshIds
#include "talweg/core/openmesh/openmesh_changes.hpp"  // stamp_of, reopen, kept_stretches
#include "talweg/core/openmesh/openmesh_drawings.hpp"  // curve_of, curves_of, edges_where, selected_edges, feature_edges, labels_of
#include "talweg/core/openmesh/openmesh_points.hpp"  // handle_point, handle_points, surface_point, HandlePoint
#include "talweg/core/openmesh/openmesh_properties.hpp"  // vertex_property, face_property
#include "talweg/core/openmesh/plan_application.hpp"     // apply_plan, division_from
#include "talweg/core/openmesh/split_along.hpp"          // split_along
#include "talweg/talweg.hpp"
