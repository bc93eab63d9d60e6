#include "vtkTalwegSmooth.h"

#include <algorithm>
#include <array>
#include <exception>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>

#include "curve_input.hpp"
#include "number_list.hpp"
#include "results.hpp"
#include "session.hpp"

using talweg::host::Curve;
using talweg::paraview::Session;

namespace {

std::string text_of(const char* text) { return text == nullptr ? "" : text; }

/// None: no array.
std::string array_name(const char* text) {
  const std::string name = text_of(text);
  return name == "None" ? "" : name;
}

}  // namespace

struct vtkTalwegSmooth::Internals {
  explicit Internals(vtkTalwegSmooth* filter)
      : Filter(filter),
        Work(
            [this](const char* stage, double done) { return this->go_on(stage, done); },
            [this](std::uint32_t severity, const char* message) { this->log(severity, message); }) {
  }

  bool go_on(const char* stage, double done) const {
    this->Filter->SetProgressText(stage);
    this->Filter->UpdateProgress(done);
    return !this->Filter->GetAbortExecute() && !this->Filter->CheckAbort();
  }

  /// ParaView opens its messages for every warning, so one is not repeated while a slider moves,
  /// and there is none of what happens to nearly every drawing.
  void log(std::uint32_t severity, const std::string& message) {
    const bool usual = message.starts_with("The curve was moved onto the mesh");
    if (severity < TALWEG_LOG_WARNING || usual) {
      vtkLog(INFO, "Talweg: " << message);
    } else if (this->Warned.insert(message).second) {
      vtkWarningWithObjectMacro(this->Filter, << message);
    }
  }

  [[nodiscard]] std::vector<Curve> drawing(vtkDataSet* curve) const {
    if (curve != nullptr) return talweg::paraview::curves_of(*curve, this->CurveIds);
    const auto vertices = talweg::paraview::vertex_numbers(this->PointIds, "Point Ids");
    if (!vertices.empty()) return {talweg::paraview::curve_through(vertices)};
    if (this->Points.empty()) {
      throw std::runtime_error("There is no drawing: give a curve, points or vertex numbers.");
    }
    Curve through;
    through.closed = this->Closed;
    through.positions = this->Points;
    through.exact.assign(this->Points.size(), 0);  // they were clicked
    return {through};
  }

  void give_mesh(vtkPolyData& out) {
    this->Work.mesh().copy_to(out);
    if (!this->WithDistance) return;
    const std::vector<double>& distance = this->Work.distance();
    vtkNew<vtkDoubleArray> array;
    array->SetName("distance");
    array->SetNumberOfTuples(static_cast<vtkIdType>(distance.size()));
    std::copy(distance.begin(), distance.end(), array->GetPointer(0));
    out.GetPointData()->AddArray(array);
    out.GetPointData()->SetActiveScalars("distance");  // setting it would remove the active one
  }

  void run(vtkDataSet& mesh, vtkDataSet* curve, vtkPolyData& curves_out, vtkPolyData& mesh_out) {
    const int before = this->Work.meshes_opened() + this->Work.curves_set();
    this->Work.take_mesh(mesh);
    this->Work.take_curves({curve, curve == nullptr ? 0 : curve->GetMTime(), this->Edits},
                           [this, curve] { return this->drawing(curve); });
    if (this->Work.meshes_opened() + this->Work.curves_set() != before) this->Warned.clear();
    if (!this->Work.mesh().note().empty()) this->log(TALWEG_LOG_WARNING, this->Work.mesh().note());
    const talweg::host::Results results = this->Work.run(this->WithDistance);
    talweg::paraview::give(results, curves_out);
    this->give_mesh(mesh_out);
    this->log(TALWEG_LOG_INFO, talweg::paraview::summary(results));
  }

  vtkTalwegSmooth* Filter;
  Session Work;
  std::vector<std::array<double, 3>> Points;
  std::string PointIds, CurveIds;
  bool Closed = false;
  bool WithDistance = false;
  std::uint64_t Edits = 0;       // of the drawing
  std::set<std::string> Warned;  // since the mesh or the drawing changed
};

vtkStandardNewMacro(vtkTalwegSmooth);

vtkTalwegSmooth::vtkTalwegSmooth() : Inside(std::make_unique<Internals>(this)) {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkTalwegSmooth::~vtkTalwegSmooth() = default;

void vtkTalwegSmooth::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshesOpened: " << this->GetMeshesOpened() << "\n"
     << indent << "CurvesSet: " << this->GetCurvesSet() << "\n"
     << indent << "Runs: " << this->GetRuns() << "\n";
}

void vtkTalwegSmooth::SetNumber(const char* id, double value) {
  if (this->Inside->Work.set(id, value)) this->Modified();
}

void vtkTalwegSmooth::SetChoice(const char* id, const char* value) {
  if (this->Inside->Work.set(id, talweg::paraview::Choice{text_of(value)})) this->Modified();
}

void vtkTalwegSmooth::SetVertices(const char* id, const char* numbers) {
  if (this->Inside->Work.set(id, talweg::paraview::VertexList{text_of(numbers)})) this->Modified();
}

void vtkTalwegSmooth::SetCurveNumbers(const char* id, const char* numbers) {
  if (this->Inside->Work.set(id, talweg::paraview::CurveNumbers{text_of(numbers)})) {
    this->Modified();
  }
}

void vtkTalwegSmooth::SetField(const char* id, const char* array) {
  if (this->Inside->Work.set(id, talweg::paraview::FieldName{array_name(array)})) this->Modified();
}

namespace {

/// Counts a change.
template <class Value>
bool change(Value& value, const Value& to, std::uint64_t& edits) {
  if (value == to) return false;
  value = to;
  ++edits;
  return true;
}

}  // namespace

void vtkTalwegSmooth::SetCurveIds(const char* array) {
  if (change(this->Inside->CurveIds, array_name(array), this->Inside->Edits)) this->Modified();
}

void vtkTalwegSmooth::SetPointIds(const char* numbers) {
  if (change(this->Inside->PointIds, text_of(numbers), this->Inside->Edits)) this->Modified();
}

void vtkTalwegSmooth::SetNumberOfPoints(int count) {
  const auto size = static_cast<std::size_t>(count < 0 ? 0 : count);
  if (size == this->Inside->Points.size()) return;
  this->Inside->Points.resize(size);
  ++this->Inside->Edits;
  this->Modified();
}

void vtkTalwegSmooth::SetPoint(int index, double x, double y, double z) {
  auto& points = this->Inside->Points;
  if (index < 0 || static_cast<std::size_t>(index) >= points.size()) {
    vtkErrorMacro(<< "There is no point " << index << "; there are " << points.size() << ".");
    return;
  }
  if (change(points[static_cast<std::size_t>(index)], {x, y, z}, this->Inside->Edits)) {
    this->Modified();
  }
}

void vtkTalwegSmooth::SetClosed(int closed) {
  if (change(this->Inside->Closed, closed != 0, this->Inside->Edits)) this->Modified();
}

void vtkTalwegSmooth::SetDistanceField(int on) {
  if (this->Inside->WithDistance == (on != 0)) return;
  this->Inside->WithDistance = on != 0;
  this->Modified();
}

int vtkTalwegSmooth::GetMeshesOpened() { return this->Inside->Work.meshes_opened(); }
int vtkTalwegSmooth::GetCurvesSet() { return this->Inside->Work.curves_set(); }
int vtkTalwegSmooth::GetRuns() { return this->Inside->Work.runs(); }

int vtkTalwegSmooth::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPointSet");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkTalwegSmooth::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  vtkPolyData* curves = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* mesh = vtkPolyData::GetData(outputs, 1);
  curves->Initialize();
  mesh->Initialize();
  try {
    this->Inside->run(*vtkDataSet::GetData(inputs[0]), vtkDataSet::GetData(inputs[1]), *curves,
                      *mesh);
    return 1;
  } catch (const talweg::host::Error& error) {
    if (error.status() == TALWEG_CANCELLED) return 1;  // nothing wrong, nothing there
    vtkErrorMacro(<< error.what());
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
  }
  return 0;
}
