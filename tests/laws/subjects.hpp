// Subjects are the meshes and drawings of the laws: generated surfaces of every kind, and real
// meshes if present.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/generated_meshes.hpp"
#include "core/reference_data.hpp"
#include "core/small_meshes.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/measure/deviation.hpp"
#include "talweg/core/smoothing/curve_smoother.hpp"

namespace talweg::test {

/// A mesh and drawings along its edges. A drawing does not run back beside itself: between two
/// close valleys the smallest difference decides whether a curve takes the short cut.
struct Subject {
  struct Drawing {
    std::vector<VertexId> path;
    bool closed = false;
  };
  MeshLists lists;
  std::vector<Drawing> drawings;
};

/// Displaces a mesh smoothly and without symmetries, so that no two angles are equal; equal angles
/// may be cleared in any order.
inline void disturb(MeshLists& lists, double amount) {
  for (Point& p : lists.points) {
    const Point q = p;
    p += amount * Point(std::sin(1.7 * q.y() + 0.3 * q.z() + 0.1) + 0.3 * std::sin(4.1 * q.x()),
                        std::sin(1.3 * q.z() - 0.8 * q.x() + 0.4) + 0.3 * std::cos(3.7 * q.y()),
                        std::sin(2.1 * q.x() + 1.1 * q.y() + 0.9) + 0.3 * std::sin(5.3 * q.x()));
  }
}

inline MeshLists bumpy_sphere(int levels) {
  MeshLists lists = sphere(levels);
  disturb(lists, 0.12);
  return lists;
}

/// A sheet of hills with boundary.
inline MeshLists hills() {
  MeshLists lists = grid(36, 28);
  for (Point& p : lists.points) p /= 6;
  disturb(lists, 0.17);
  return lists;
}

inline MeshLists bumpy_torus() {
  MeshLists lists = torus(36, 60);
  disturb(lists, 0.1);
  return lists;
}

inline MeshLists bent_tube() {
  MeshLists lists = tube(32, 40, 6);
  disturb(lists, 0.2);
  return lists;
}

/// The vertex at a fraction of the vertex count, so that way-points depend on the mesh alone.
inline VertexId vertex_at(const MeshLists& lists, double fraction) {
  return VertexId{static_cast<std::size_t>(fraction * static_cast<double>(lists.points.size()))};
}

inline Subject::Drawing draw(const MeshLists& lists, std::vector<double> through, bool closed) {
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  std::vector<VertexId> ways;
  for (const double fraction : through) ways.push_back(vertex_at(lists, fraction));
  return {draw_edge_path(mesh.surface(), ways, closed), closed};
}

/// Names of all subjects, generated subjects first.
inline std::vector<std::string> subject_names() {
  return {"sphere", "hills", "torus", "tube", "fandisk_14k", "aneurysm_14k"};
}

/// A closed path around a net with `columns` vertices per row, alternating between `row` and the
/// next row.
inline std::vector<VertexId> band(std::uint32_t columns, std::uint32_t row) {
  std::vector<VertexId> path;
  for (std::uint32_t i = 0; i < columns; ++i) {
    const std::uint32_t up = (i % 8) < 4 ? 0 : 1;
    const std::uint32_t before = ((i + columns - 1) % columns % 8) < 4 ? 0 : 1;
    if (up < before) path.emplace_back((row + before) * columns + i);
    path.emplace_back((row + up) * columns + i);
  }
  return path;
}

/// Makes a subject; its lists are empty if a real mesh is absent.
inline Subject make_subject(const std::string& name) {
  Subject subject;
  if (name == "sphere") {
    subject.lists = bumpy_sphere(4);
    subject.drawings = {draw(subject.lists, {0.001, 0.4, 0.003}, false),
                        draw(subject.lists, {0.02, 0.3, 0.7, 0.9}, true)};
  } else if (name == "hills") {
    subject.lists = hills();
    subject.drawings = {draw(subject.lists, {0.08, 0.4, 0.96}, false)};
  } else if (name == "torus") {
    subject.lists = bumpy_torus();
    subject.drawings = {draw(subject.lists, {0.05, 0.21, 0.44}, false), {band(36, 20), true}};
  } else if (name == "tube") {
    subject.lists = bent_tube();
    subject.drawings = {draw(subject.lists, {0.05, 0.31, 0.9}, false), {band(32, 18), true}};
  } else if (const auto reference = reference_curve(name)) {
    subject.lists = read_mesh(mesh_folder() / (name + ".ply"));
    subject.drawings = {{reference->path, reference->closed}};
  }
  return subject;
}

inline SurfaceCurve curve_of(const Surface& surface, const Subject::Drawing& drawing) {
  return vertex_curve(surface, drawing.path, drawing.closed);
}

/// Options of the paper's method, for which the laws are stated.
inline const CurveOptions kPapers{.method = Method::kPaper};

/// The smoothed curve as positions, and its report.
struct Outcome {
  std::vector<Point> points;
  SmoothingReport report;
};

inline Outcome smooth_drawing(const MeshLists& lists, const Subject::Drawing& drawing, double tau,
                              const CurveOptions& options) {
  const auto opened = OpenedMesh::open(lists);
  const SmoothingResult result =
      smooth_curve(opened, curve_of(opened->surface(), drawing), {.tau = tau}, options);
  return {positions_of(opened->mesh(), result.curve()), result.report()};
}

/// Distance of two curves in space, both ways.
inline double curve_gap(const std::vector<Point>& a, const std::vector<Point>& b, bool closed) {
  const Deviation gap = deviation(a, closed, b, closed);
  return std::max(gap.to_drawn.max, gap.from_drawn.max);
}

inline double diameter_of(const MeshLists& lists) {
  Point low = lists.points.front();
  Point high = low;
  for (const Point& p : lists.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

}  // namespace talweg::test
