#include "results.hpp"

#include <cstdio>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

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

/// Every curve has the same fields.
void add_point_fields(const host::Results& results, vtkPolyData& out) {
  if (results.curves.empty()) return;
  for (std::size_t f = 0; f < results.curves.front().fields.size(); ++f) {
    const auto array = named<vtkDoubleArray>(results.curves.front().fields[f].name.c_str());
    for (const host::Curve& curve : results.curves) {
      for (const double value : curve.fields.at(f).values) array->InsertNextValue(value);
    }
    out.GetPointData()->AddArray(array);
  }
}

}  // namespace

void give(const host::Results& results, vtkPolyData& out, const char* group) {
  out.Initialize();
  add_points(results, out);
  add_lines(results, out);
  add_point_fields(results, out);
  give_reports_of_curves(results, group, out.GetNumberOfCells(), *out.GetCellData());
  give_report(results, *out.GetFieldData());
}

namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

std::string summary(const host::Results& results) {
  char text[400];
  std::snprintf(text, sizeof text,
                "length %.6g to %.6g, curvature %.3g to %.3g rad, bending %.3g to %.3g, "
                "turn in one edge %.0f to %.0f degrees, largest deviation %.3g: %s",
                results.number("length_before"), results.number("length_after"),
                results.number("curvature_before"), results.number("curvature_after"),
                results.number("bending_before"), results.number("bending_after"),
                degrees(results.number("window_turning_before")),
                degrees(results.number("window_turning_after")),
                results.number("deviation_to_drawn_max"), results.text("termination").c_str());
  return text;
}

}  // namespace talweg::paraview
