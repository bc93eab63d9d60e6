#include "results.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "carried_arrays.hpp"
#include "report_output.hpp"

namespace talweg::paraview {
namespace {

template <class Array>
vtkSmartPointer<Array> named(const char* name, int components = 1) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

void add_points(const host::Results& results, vtkPolyData& out) {
  const auto places = named<vtkDoubleArray>("Points", 3);
  const auto faces = named<vtkIdTypeArray>("face");
  const auto barycentrics = named<vtkDoubleArray>("barycentric", 3);
  const auto vertices = named<vtkIdTypeArray>("vertex");
  for (const host::Curve& curve : results.curves) {
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      places->InsertNextTuple(curve.positions[k].data());
      faces->InsertNextValue(curve.faces[k]);
      barycentrics->InsertNextTuple(curve.barycentrics[k].data());
      const std::uint32_t v = curve.vertices[k];
      vertices->InsertNextValue(v == TALWEG_NO_VERTEX ? -1 : static_cast<vtkIdType>(v));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  out.SetPoints(points);
  for (vtkDataArray* array :
       {static_cast<vtkDataArray*>(faces), static_cast<vtkDataArray*>(barycentrics),
        static_cast<vtkDataArray*>(vertices)}) {
    out.GetPointData()->AddArray(array);
  }
}

void add_lines(const host::Results& results, vtkPolyData& out) {
  vtkNew<vtkCellArray> lines;
  vtkIdType first = 0;
  for (const host::Curve& curve : results.curves) {
    const auto count = static_cast<vtkIdType>(curve.positions.size());
    lines->InsertNextCell(static_cast<int>(count + (curve.closed ? 1 : 0)));
    for (vtkIdType k = 0; k < count; ++k) lines->InsertCellPoint(first + k);
    if (curve.closed) lines->InsertCellPoint(first);
    first += count;
  }
  out.SetLines(lines);
}

/// Adds a point array for each field; all curves have the same fields. The field of turns at points
/// is not called curvature, which ParaView's users expect to be per length.
void add_point_fields(const host::Results& results, vtkPolyData& out) {
  if (results.curves.empty()) return;
  for (std::size_t f = 0; f < results.curves.front().fields.size(); ++f) {
    const std::string& name = results.curves.front().fields[f].name;
    const auto array = named<vtkDoubleArray>(name == "curvature" ? "turning" : name.c_str());
    for (const host::Curve& curve : results.curves) {
      for (const double value : curve.fields.at(f).values) array->InsertNextValue(value);
    }
    out.GetPointData()->AddArray(array);
  }
}

void add_arc_lengths(const host::Results& results, vtkPolyData& out) {
  const auto lengths = named<vtkDoubleArray>("arc_length");
  for (const host::Curve& curve : results.curves) {
    double length = 0;
    for (std::size_t k = 0; k < curve.positions.size(); ++k) {
      const auto& here = curve.positions[k];
      const auto& before = curve.positions[k == 0 ? 0 : k - 1];
      length += std::hypot(here[0] - before[0], here[1] - before[1], here[2] - before[2]);
      lengths->InsertNextValue(length);
    }
  }
  out.GetPointData()->AddArray(lengths);
}

void add_numbers_of_curves(const host::Results& results, vtkPolyData& out) {
  const auto numbers = named<vtkIdTypeArray>("curve");
  for (std::size_t c = 0; c < results.curves.size(); ++c) {
    numbers->InsertNextValue(static_cast<vtkIdType>(c));
  }
  out.GetCellData()->AddArray(numbers);
}

/// The origin of the curves' points: between the corners of their faces.
host::Origin origin_of(const host::Results& results, const MeshInput& mesh) {
  host::Origin origin;
  for (const host::Curve& curve : results.curves) {
    for (std::size_t k = 0; k < curve.faces.size(); ++k) {
      origin.vertices.push_back(mesh.corners().at(curve.faces[k]));
      origin.weights.push_back(curve.barycentrics[k]);
    }
  }
  return origin;
}

std::vector<vtkIdType> cells_of(const host::Results& results, const MeshInput& mesh) {
  std::vector<vtkIdType> cells;
  for (const host::Curve& curve : results.curves) {
    for (const std::uint32_t face : curve.faces) cells.push_back(mesh.cells().at(face));
  }
  return cells;
}

/// Adds the mesh's arrays. If a point array and a cell array have the same name, the point array is
/// used.
void add_arrays_of_mesh(const host::Results& results, const MeshInput& mesh, vtkPolyData& out) {
  vtkPointData& points = *out.GetPointData();
  carry_points(mesh.arrays(), origin_of(results, mesh), points);
  vtkNew<vtkPointData> of_cells;
  carry_cells(mesh.cell_arrays(), cells_of(results, mesh), *of_cells);
  for (int k = 0; k < of_cells->GetNumberOfArrays(); ++k) {
    vtkAbstractArray* array = of_cells->GetAbstractArray(k);
    if (array->GetName() != nullptr && !points.HasArray(array->GetName())) points.AddArray(array);
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type) {
    points.SetActiveAttribute(-1, type);
  }
}

}  // namespace

void give(const host::Results& results, const MeshInput& mesh, vtkPolyData& out) {
  out.Initialize();
  add_arrays_of_mesh(results, mesh, out);  // first, so that the curve's own arrays replace arrays
                                           // of the same name
  add_points(results, out);
  add_lines(results, out);
  add_arc_lengths(results, out);
  add_point_fields(results, out);
  add_numbers_of_curves(results, out);
  give_report(results, *out.GetFieldData());
}

namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// The decisive warnings, by which the result may be of no use.
std::string decisive_sentences(const host::Results& results) {
  std::string all;
  if (const host::ReportEntry* entry = results.find("decisive")) {
    for (const std::string& sentence : entry->texts) all += sentence + " ";
  }
  return all;
}

/// The word for a bound: the distance along the surface may be larger than through space.
const char* bound_word(const host::Results& results) {
  return std::isfinite(results.number("farthest_at_most")) ? "at most" : "at least";
}

}  // namespace

std::string outcome(const host::Results& results) {
  const auto number = [&](const char* key) { return results.number(key); };
  const auto larger = [&](const char* one, const char* other) {
    return std::max(number(one), number(other));
  };
  char text[600];
  int size = std::snprintf(
      text, sizeof text,
      "Deviation from the drawing, both ways: %s %.4g, on average %.4g. "
      "Length: %.6g, drawn %.6g. "
      "Largest turn in one edge: %.0f degrees, drawn %.0f.",
      bound_word(results),
      std::isfinite(number("farthest_at_most")) ? number("farthest_at_most") : number("farthest"),
      larger("deviation_to_drawn_mean", "deviation_from_drawn_mean"), number("length_after"),
      number("length_before"), degrees(number("window_turning_after")),
      degrees(number("window_turning_before")));
  const std::string ended = results.text("termination");
  std::string all = decisive_sentences(results);
  all.append(text, static_cast<std::size_t>(size));
  if (number("slack") > 0) {
    std::snprintf(text, sizeof text, " Slack: %.4g.", number("slack"));
    all += text;
  }
  if (ended != "converged") all += " Ended early: " + ended + ".";
  return all;
}

std::string summary(const host::Results& results) {
  char text[400];
  std::snprintf(text, sizeof text,
                "length %.6g to %.6g, curvature %.3g to %.3g rad, bending %.3g to %.3g, "
                "turn in one edge %.0f to %.0f degrees, largest deviation %.3g: %s",
                results.number("length_before"), results.number("length_after"),
                results.number("curvature_before"), results.number("curvature_after"),
                results.number("bending_before"), results.number("bending_after"),
                degrees(results.number("window_turning_before")),
                degrees(results.number("window_turning_after")), results.number("farthest"),
                results.text("termination").c_str());
  return text;
}

}  // namespace talweg::paraview
