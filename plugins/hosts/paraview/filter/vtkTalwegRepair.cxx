#include "vtkTalwegRepair.h"

#include <stdexcept>
#include <string>

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "mesh_output.hpp"
#include "report_output.hpp"
#include "session.hpp"

using talweg::paraview::Session;

vtkStandardNewMacro(vtkTalwegRepair);

vtkTalwegRepair::vtkTalwegRepair() : vtkTalwegFilter("talweg.repair") {
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

int vtkTalwegRepair::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

namespace {

/// A line for each change of the repair.
std::string outcome(const talweg::host::Results& results) {
  const talweg::host::ReportEntry* changes = results.find("repair.changes");
  if (changes == nullptr) {
    return "Not repaired. " + results.text("reason");
  }
  if (changes->texts.empty()) return "The mesh needs no repair.";
  std::string all;
  for (const std::string& change : changes->texts) all += (all.empty() ? "" : "\n") + change;
  return all;
}

}  // namespace

void vtkTalwegRepair::Work(vtkDataSet& mesh, vtkDataObject*, vtkDataObject*,
                           vtkInformationVector& outputs) {
  Session& session = this->GetSession();
  this->TakeMesh(mesh);
  const talweg::host::Results results = session.run({.meshes = true});
  vtkPolyData& out = *vtkPolyData::GetData(&outputs, 0);
  if (!results.meshes.empty()) {
    talweg::paraview::give(results.meshes.front(), session.instance().origin(0), session.mesh(),
                           out);
  } else if (session.number("repair", 1) == 0) {
    session.mesh().copy_to(out);  // without changes the mesh was only inspected
  } else {
    throw std::runtime_error("The mesh cannot be repaired: " + results.text("reason"));
  }
  talweg::paraview::give_report(results, *out.GetFieldData());
  this->Tell(outcome(results));
  const talweg::host::ReportEntry* changes = results.find("repair.changes");
  if (changes == nullptr) return;
  for (const std::string& change : changes->texts) this->Log(TALWEG_LOG_INFO, change.c_str());
}
