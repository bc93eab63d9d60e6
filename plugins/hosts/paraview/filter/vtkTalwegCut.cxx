#include "vtkTalwegCut.h"

#include <string>
#include <vector>

#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "mesh_output.hpp"
#include "report_output.hpp"
#include "session.hpp"

using talweg::paraview::Session;

vtkStandardNewMacro(vtkTalwegCut);

vtkTalwegCut::vtkTalwegCut() : vtkTalwegFilter("talweg.cut") {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

int vtkTalwegCut::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkPolyData");
  return 1;
}

void vtkTalwegCut::Work(vtkDataSet& mesh, vtkDataSet* curves, vtkDataSet*,
                        vtkInformationVector& outputs) {
  Session& session = this->GetSession();
  this->TakeMesh(mesh);
  this->TakeCurves(curves, nullptr);
  const talweg::host::Results results = session.run({.meshes = true});
  auto& pieces = *vtkMultiBlockDataSet::GetData(&outputs, 0);
  std::vector<talweg::host::Origin> origins;
  for (std::size_t m = 0; m < results.meshes.size(); ++m) {
    origins.push_back(session.instance().origin(m));
    vtkNew<vtkPolyData> piece;
    talweg::paraview::give(results.meshes[m], origins.back(), session.mesh(), *piece);
    const auto block = static_cast<unsigned int>(m);
    pieces.SetBlock(block, piece);
    const std::string name = "piece " + std::to_string(m);
    pieces.GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
  talweg::paraview::give_report(results, *pieces.GetFieldData());
  talweg::paraview::give_chains(results.meshes, origins, *vtkPolyData::GetData(&outputs, 1));
}
