#include "vtkTalwegLabels.h"

#include <string>
#include <utility>
#include <vector>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include "mesh_output.hpp"
#include "report_output.hpp"
#include "results.hpp"
#include "session.hpp"

using talweg::paraview::Session;

vtkStandardNewMacro(vtkTalwegLabels);

vtkTalwegLabels::vtkTalwegLabels() : vtkTalwegFilter("talweg.labels") {
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(4);
}

int vtkTalwegLabels::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 3 ? "vtkTable" : "vtkPolyData");
  return 1;
}

namespace {

/// Adds the new labels of cells, in the type of the given array.
void add_labels(const std::vector<double>& labels, vtkDataArray& given, vtkPolyData& out) {
  const auto array = vtkSmartPointer<vtkDataArray>::Take(given.NewInstance());
  array->SetName("new_label");
  array->SetNumberOfTuples(static_cast<vtkIdType>(labels.size()));
  for (std::size_t k = 0; k < labels.size(); ++k) {
    array->SetComponent(static_cast<vtkIdType>(k), 0, labels[k]);
  }
  out.GetCellData()->AddArray(array);
  out.GetCellData()->SetActiveScalars("new_label");
}

/// The exact labels, the plugin's own attribute of the cut mesh.
std::vector<double> exact_labels(Session& session) {
  for (talweg::host::Attribute& attribute : session.instance().attributes(0)) {
    if (attribute.element == TALWEG_OF_TRIANGLES && attribute.name == "label") {
      return std::move(attribute.values);
    }
  }
  return {};
}

/// Adds the labels on both sides of each border.
void add_sides(const talweg::host::Results& results, vtkPolyData& borders) {
  for (const char* side : {"left", "right"}) {
    vtkNew<vtkDoubleArray> labels;
    labels->SetName(side);
    for (const double label : talweg::paraview::numbers_of_group(results, "borders", side)) {
      labels->InsertNextValue(label);
    }
    borders.GetCellData()->AddArray(labels);
  }
}

std::string counted(double count, const char* word) {
  return std::to_string(static_cast<long long>(count)) + " " + word + (count == 1 ? "" : "s");
}

std::string outcome(const talweg::host::Results& results) {
  const auto regions = talweg::paraview::numbers_of_group(results, "regions", "label").size();
  return counted(results.number("network.borders"), "border") + " between " +
         counted(static_cast<double>(regions), "region") + ", " +
         counted(results.number("network.junctions"), "junction") + ". " +
         talweg::paraview::outcome(results);
}

}  // namespace

void vtkTalwegLabels::Work(vtkDataSet& mesh, vtkDataObject*, vtkDataObject*,
                           vtkInformationVector& outputs) {
  Session& session = this->GetSession();
  this->TakeMesh(mesh);
  const talweg::host::Results results =
      session.run({.point_fields = true, .vertex_fields = true, .meshes = true});
  vtkDataArray* given = session.array_of("triangle_labels");
  if (given == nullptr) given = session.array_of("vertex_labels");
  vtkPolyData& borders = *vtkPolyData::GetData(&outputs, 0);
  talweg::paraview::give(results, session.mesh(), borders);
  add_sides(results, borders);
  vtkPolyData& relabelled = *vtkPolyData::GetData(&outputs, 1);
  session.mesh().copy_to(relabelled);
  add_labels(results.fields.at(0).values, *given, relabelled);
  vtkPolyData& cut = *vtkPolyData::GetData(&outputs, 2);
  talweg::paraview::give(results.meshes.at(0), session.instance().origin(0), session.mesh(), cut);
  add_labels(exact_labels(session), *given, cut);
  talweg::paraview::give_table(results, *vtkTable::GetData(&outputs, 3), "borders");
  this->Tell(outcome(results));
}
