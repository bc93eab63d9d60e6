#include "vtkTalwegCut.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <vtkAppendPolyData.h>
#include <vtkCompositeDataIterator.h>
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
#include <vtkSmartPointer.h>

#include "mesh_output.hpp"
#include "report_output.hpp"
#include "session.hpp"

using talweg::paraview::Session;

vtkStandardNewMacro(vtkTalwegCut);

vtkTalwegCut::vtkTalwegCut() : vtkTalwegCut("talweg.cut") {}

vtkTalwegCut::vtkTalwegCut(const char* plugin) : vtkTalwegFilter(plugin) {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

int vtkTalwegCut::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkPolyData");
  return 1;
}

int vtkTalwegCut::FillInputPortInformation(int port, vtkInformation* info) {
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 0) info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

namespace {

void add_block(vtkMultiBlockDataSet& blocks, vtkDataObject& block, const std::string& name) {
  const unsigned int number = blocks.GetNumberOfBlocks();
  blocks.SetBlock(number, &block);
  blocks.GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

std::string pieces_told(unsigned int count) {
  return count == 1 ? "One piece." : std::to_string(count) + " pieces.";
}

}  // namespace

void vtkTalwegCut::Cut(vtkDataSet& mesh, vtkDataObject* curves, vtkMultiBlockDataSet& pieces,
                       vtkPolyData& chains) {
  Session& session = this->GetSession();
  this->TakeMesh(mesh);
  const bool takes_curves = (session.instance().plugin().flags & TALWEG_TAKES_CURVES) != 0;
  if (takes_curves) this->TakeCurves(curves, nullptr);
  const talweg::host::Results results = session.run({.meshes = true});
  this->LogWarnings(results);
  std::vector<talweg::host::Origin> origins;
  for (std::size_t m = 0; m < results.meshes.size(); ++m) {
    origins.push_back(session.instance().origin(m));
    vtkNew<vtkPolyData> piece;
    talweg::paraview::give(results.meshes[m], origins.back(), session.mesh(), *piece);
    add_block(pieces, *piece, "piece " + std::to_string(m));
  }
  talweg::paraview::give_report(results, *pieces.GetFieldData());
  talweg::paraview::give_chains(results.meshes, origins, chains);
}

void vtkTalwegCut::Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject*,
                        vtkInformationVector& outputs) {
  auto& pieces = *vtkMultiBlockDataSet::GetData(&outputs, 0);
  this->Cut(mesh, curves, pieces, *vtkPolyData::GetData(&outputs, 1));
  this->Tell(pieces_told(pieces.GetNumberOfBlocks()));
}

void vtkTalwegCut::WorkOn(vtkDataObject& mesh, vtkDataObject* curves, vtkDataObject* others,
                          vtkInformationVector& outputs) {
  auto* composite = vtkCompositeDataSet::SafeDownCast(&mesh);
  if (composite == nullptr) return this->Superclass::WorkOn(mesh, curves, others, outputs);
  auto& blocks = *vtkMultiBlockDataSet::GetData(&outputs, 0);
  vtkNew<vtkAppendPolyData> all_chains;
  unsigned int count = 0;
  const auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem()) {
    auto* data = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
    if (data == nullptr || data->GetNumberOfCells() == 0) continue;
    vtkNew<vtkMultiBlockDataSet> pieces;
    vtkNew<vtkPolyData> chains;
    this->Cut(*data, curves, *pieces, *chains);
    count += pieces->GetNumberOfBlocks();
    add_block(blocks, *pieces, "mesh " + std::to_string(blocks.GetNumberOfBlocks()));
    all_chains->AddInputData(chains);
  }
  if (blocks.GetNumberOfBlocks() == 0) throw std::runtime_error("The input has no mesh.");
  this->Tell(pieces_told(count));
  all_chains->Update();
  vtkPolyData::GetData(&outputs, 1)->ShallowCopy(all_chains->GetOutput());
}
