#include "vtkTalwegMeasure.h"

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

#include "report_output.hpp"
#include "session.hpp"

using talweg::paraview::Session;

vtkStandardNewMacro(vtkTalwegMeasure);

vtkTalwegMeasure::vtkTalwegMeasure() : vtkTalwegFilter("talweg.measure") {
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(1);
}

int vtkTalwegMeasure::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkTalwegMeasure::Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
                            vtkInformationVector& outputs) {
  Session& session = this->GetSession();
  this->TakeMesh(mesh);
  const int count = this->TakeCurves(curves, others);
  session.set("others", static_cast<double>(count));
  const talweg::host::Results results = session.run({});
  talweg::paraview::give_table(results, *vtkTable::GetData(&outputs, 0));
  this->LogWarnings(results);
}
