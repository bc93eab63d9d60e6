# Tests of drawing, fairing, lifting and smoothing use the front door: of the library they include only
# talweg/talweg.hpp, so that they stay valid when the code behind it changes. A test of an algorithm with its
# own contract also includes the algorithm's header; so do tests that use such an algorithm to measure
# results. cmake -D ROOT=project -P check_front.cmake
cmake_minimum_required(VERSION 3.25)
set(algorithms
  drawing/better_fit drawing/canonical_order drawing/capping drawing/curve_embedding drawing/drawn_legs
  drawing/edge_landmarks drawing/even_points
  drawing/path_contacts drawing/surface_normals
  drawing/marked_points
  fairing/band_solver fairing/chain_curve fairing/chain_parts fairing/curve_fairing fairing/drawn_line
  fairing/near_points fairing/saddle_passing
  lifting/bump_convolution lifting/corridor smoothing/corridor_width smoothing/curve_gaps
  smoothing/drawing_change fairing/joined_curves lifting/potential
  smoothing/refined_mesh lifting/relaxation lifting/touched_edges
  smoothing/unrolled_mesh drawing/straight_lines)
set(instruments core/drawing/crossings intrinsic/exact_distance/polyline_distance)
# Headers that such a test needs to make the algorithm's input, or to compare with.
set(drawing/curve_embedding_needs intrinsic/flips/signpost_triangulation)
set(drawing/edge_landmarks_needs core/drawing/edge_dijkstra core/mesh/surface_mesh)
set(drawing/path_contacts_needs core/drawing/curve_embedding intrinsic/flips/signpost_triangulation)
set(drawing/straight_lines_needs core/drawing/snapped_drawing)
set(fairing/drawn_line_needs core/fairing/drawn_band)
set(lifting/potential_needs core/lifting/lifted_lengths)
set(lifting/touched_edges_needs core/lifting/corridor core/smoothing/corridor_width
    core/lifting/lifted_lengths core/strokes/stroke_slack)
set(smoothing/corridor_width_needs core/strokes/stroke_slack)

set(wrong "")
set(looked 0)
foreach(room drawing fairing lifting smoothing)
  file(GLOB files RELATIVE ${ROOT}/tests/core ${ROOT}/tests/core/${room}/*_test.cpp)
  foreach(file IN LISTS files)
    math(EXPR looked "${looked} + 1")
    string(REPLACE "_test.cpp" "" name ${file})
    set(may talweg openmesh ${instruments})
    if(name IN_LIST algorithms)
      list(APPEND may core/${name} ${${name}_needs})
    endif()
    file(STRINGS ${ROOT}/tests/core/${file} includes REGEX "^#include \"talweg/")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE ".*\"talweg/(.*)\\.hp*\".*" "\\1" header "${line}")
      if(NOT header IN_LIST may)
        string(APPEND wrong "  tests/core/${file} includes talweg/${header}.hpp\n")
      endif()
    endforeach()
  endforeach()
endforeach()
foreach(name IN LISTS algorithms)
  if(NOT EXISTS ${ROOT}/tests/core/${name}_test.cpp)
    string(APPEND wrong "  tests/core/${name}_test.cpp is listed and not there\n")
  endif()
endforeach()
if(looked LESS 40)
  message(FATAL_ERROR "Only ${looked} tests were looked at.")
endif()
if(wrong)
  message(FATAL_ERROR "Tests that do not go through the front door (talweg/talweg.hpp):\n${wrong}")
endif()
message(STATUS "${looked} tests go through the front door")
