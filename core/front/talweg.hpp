// The front door is the header that programs include to use the library. The comment behind each
// header lists the names that users call; docs/api.md describes them. The other names in the
// headers are internal.
#pragma once

// Meshes: reading, repair, opening.
#include "talweg/core/io/mesh_reader.hpp"        // read_mesh
#include "talweg/core/io/mesh_writer.hpp"        // write_mesh
#include "talweg/core/mesh/closest_point.hpp"    // ClosestPoint
#include "talweg/core/mesh/mesh_inspection.hpp"  // inspect
#include "talweg/core/mesh/mesh_lists.hpp"       // MeshLists
#include "talweg/core/mesh/opened_mesh.hpp"      // OpenedMesh
#include "talweg/core/mesh/surface_mesh.hpp"     // SurfaceMesh
#include "talweg/core/repair/mesh_repair.hpp"    // repair
#include "talweg/intrinsic/surface/surface.hpp"  // Surface

// Curves: drawing, snapping, files.
#include "talweg/core/drawing/curve_through.hpp"       // curve_through
#include "talweg/core/drawing/draw.hpp"                // draw, Drawing, DrawOptions
#include "talweg/core/drawing/edge_dijkstra.hpp"       // draw_edge_path, EdgeDijkstra
#include "talweg/core/drawing/placed_curve.hpp"        // place
#include "talweg/core/drawing/snapping.hpp"            // snap
#include "talweg/core/drawing/straight_lines.hpp"      // StraightLines
#include "talweg/core/io/curve_file.hpp"               // read_curves, write_curves
#include "talweg/core/strokes/loop_closing.hpp"        // closed_loop
#include "talweg/intrinsic/surface/surface_point.hpp"  // SurfaceCurve, SurfacePoint

// Smoothing, for one tau after another.
#include "talweg/core/smoothing/curve_smoother.hpp"     // CurveSmoother, smooth_curve
#include "talweg/core/smoothing/max_deviation.hpp"      // smooth_within
#include "talweg/core/smoothing/slack_field.hpp"        // slack_along
#include "talweg/core/smoothing/smoothing_options.hpp"  // CurveOptions, SmoothingOptions, WayPoint
#include "talweg/core/smoothing/smoothing_result.hpp"   // SmoothingResult

// Measures and reports.
#include "talweg/core/measure/curve_measurement.hpp"  // measure_curves
#include "talweg/core/measure/deviation.hpp"          // deviation
#include "talweg/core/measure/measures.hpp"           // curve_length, measure_curve
#include "talweg/core/measure/report.hpp"             // SmoothingReport, Outcome, to_json
#include "talweg/core/measure/self_contacts.hpp"      // self_contacts
#include "talweg/core/measure/surface_deviation.hpp"  // DeviationMeter
#include "talweg/heat/curve_sources.hpp"              // curve_sources
#include "talweg/heat/heat_distance.hpp"              // HeatDistance

// Uses of a result: the mesh cut along curves, and curves at a distance from them.
#include "talweg/core/cutting/attribute_transfer.hpp"  // carried_to, picked
#include "talweg/core/cutting/loop_filling.hpp"        // add_lids
#include "talweg/core/cutting/mesh_cutting.hpp"        // cut_along
#include "talweg/core/cutting/mesh_parts.hpp"          // take_apart, origins_of
#include "talweg/core/cutting/seam_opening.hpp"        // open_seams, piece_of
#include "talweg/core/offset/offset_curves.hpp"        // offset_curves, OffsetOptions, OffsetResult

// The borders of a segmentation, and general types.
#include "talweg/core/io/border_file.hpp"        // write_borders
#include "talweg/core/io/label_file.hpp"         // read_label_file
#include "talweg/core/labels/label_network.hpp"  // smooth_labels
#include "talweg/core/version.hpp"               // version
#include "talweg/intrinsic/budget.hpp"           // Budget
#include "talweg/intrinsic/error.hpp"            // Error
#include "talweg/intrinsic/progress.hpp"         // Progress
