#include "vtkTalwegMeasure.h"

#include <cstdio>
#include <string>

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

namespace {

std::string outcome(const talweg::host::Results& results, vtkIdType curves) {
  char text[100];
  std::snprintf(text, sizeof text, "%lld %s, length %.6g. The rest is in the table.",
                static_cast<long long>(curves), curves == 1 ? "curve" : "curves",
                results.number("length"));
  return text;
}

}  // namespace

void vtkTalwegMeasure::Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
                            vtkInformationVector& outputs) {
  Session& session = this->GetSession();
  this->TakeMesh(mesh);
  const int count = this->TakeCurves(curves, others);
  session.set("others", static_cast<double>(count));
  const talweg::host::Results results = session.run({});
  vtkTable& table = *vtkTable::GetData(&outputs, 0);
  talweg::paraview::give_table(results, table);
  this->Tell(outcome(results, table.GetNumberOfRows() - 1));
  this->LogWarnings(results);
}
