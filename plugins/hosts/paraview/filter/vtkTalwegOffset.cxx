#include "vtkTalwegOffset.h"

#include <cstdint>
#include <cstdio>
#include <string>

#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include "report_output.hpp"
#include "results.hpp"
#include "session.hpp"

using talweg::paraview::Session;

vtkStandardNewMacro(vtkTalwegOffset);

vtkTalwegOffset::vtkTalwegOffset() : vtkTalwegFilter("talweg.offset") {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

int vtkTalwegOffset::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

namespace {

/// Adds the distance, the side and the given curve of each offset curve.
void add_places(const talweg::host::Results& results, vtkPolyData& out) {
  vtkNew<vtkDoubleArray> distances, along;
  vtkNew<vtkStringArray> sides;
  distances->SetName("distance");
  along->SetName("along");
  sides->SetName("side");
  for (std::size_t c = 0; c < results.curves.size(); ++c) {
    const auto curve = static_cast<std::int64_t>(c);
    distances->InsertNextValue(results.number("distance", curve));
    along->InsertNextValue(results.number("along", curve));
    sides->InsertNextValue(results.text("side", curve));
  }
  vtkCellData& cells = *out.GetCellData();
  for (vtkAbstractArray* array : {static_cast<vtkAbstractArray*>(distances),
                                  static_cast<vtkAbstractArray*>(along),
                                  static_cast<vtkAbstractArray*>(sides)}) {
    cells.AddArray(array);
  }
}

std::string outcome(const talweg::host::Results& results) {
  char text[160];
  std::snprintf(text, sizeof text, "%zu %s, length %.6g. Off by at most %.2g between two points.",
                results.curves.size(), results.curves.size() == 1 ? "curve" : "curves",
                results.number("length"), results.number("distance_off_max"));
  return text;
}

}  // namespace

void vtkTalwegOffset::Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject*,
                           vtkInformationVector& outputs) {
  Session& session = this->GetSession();
  this->TakeMesh(mesh);
  this->TakeCurves(curves, nullptr);
  const talweg::host::Results results = session.run({});
  vtkPolyData& offset = *vtkPolyData::GetData(&outputs, 0);
  talweg::paraview::give(results, session.mesh(), offset);
  add_places(results, offset);
  talweg::paraview::give_table(results, *vtkTable::GetData(&outputs, 1));
  this->Tell(outcome(results));
  this->LogWarnings(results);
}
