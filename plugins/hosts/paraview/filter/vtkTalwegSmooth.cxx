#include "vtkTalwegSmooth.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include "curve_input.hpp"
#include "mesh_ray.hpp"
#include "number_list.hpp"
#include "property_text.hpp"
#include "report_output.hpp"
#include "results.hpp"
#include "segment_at.hpp"
#include "session.hpp"
#include "start_points.hpp"

using talweg::host::Curve;
using talweg::paraview::Session;
using talweg::paraview::text_of;

struct vtkTalwegSmooth::Internals {
  [[nodiscard]] std::vector<Curve> drawing(vtkDataObject* curve, const char* ids) const {
    if (curve != nullptr) return talweg::paraview::curves_of(*curve, ids);
    const auto vertices = talweg::paraview::vertex_numbers(this->PointIds, "Point Ids");
    if (!vertices.empty()) return {talweg::paraview::curve_through(vertices)};
    if (this->Points.empty()) {
      throw std::runtime_error(this->what_is_missing());
    }
    Curve through;
    through.closed = this->Closed;
    through.positions = this->Points;
    through.exact.assign(this->Points.size(), 0);  // clicked points are way-points
    return {through};
  }

  [[nodiscard]] std::string what_is_missing() const {
    if (this->OffersPoints) return "There are no points to join: click some on the mesh.";
    if (this->OffersVertices) return "There is no drawing: give numbers of vertices as Point Ids.";
    return "No curve is given: choose one for the input Curve (Change Input... in the menu of the "
           "filter).";
  }

  /// Runs the plugin; the distance field is computed once for each drawing.
  talweg::host::Results run(Session& session) {
    session.apply_settings();
    const bool known = !this->Distance.empty() && this->DistanceState == session.state();
    talweg::host::Results results =
        session.run({.point_fields = true, .vertex_fields = this->WithDistance && !known});
    if (!results.fields.empty()) {
      this->Distance = std::move(results.fields.front().values);
      this->DistanceState = session.state();
    }
    return results;
  }

  void give_mesh(Session& session, vtkPolyData& out) const {
    session.mesh().copy_to(out);
    if (!this->WithDistance) return;
    vtkNew<vtkDoubleArray> array;
    array->SetName("distance");
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Distance.size()));
    std::copy(this->Distance.begin(), this->Distance.end(), array->GetPointer(0));
    out.GetPointData()->AddArray(array);
    out.GetPointData()->SetActiveScalars("distance");  // setting the active array would remove it
  }

  void keep_curve(const talweg::host::Results& results) {
    if (!this->OffersPoints || results.curves.size() != 1) return;
    this->Passed = results.curves[0].positions;
    this->PassedEdits = this->Edits;
  }

  std::vector<std::array<double, 3>> Points;
  std::string PointIds;
  bool Closed = false;
  bool WithDistance = false;
  std::uint64_t Edits = 0;  // changes of the drawing
  std::string Start, Picked;
  std::vector<std::array<double, 3>> Passed;  // the points that the last run's curve joins, if it
                                              // was drawn through points
  std::uint64_t PassedEdits = 0;              // changes of the drawing at that run
  talweg::paraview::MeshRay Ray;
  double SlackUsed = 0, DeviationReached = 0;
  bool OffersPoints = false, OffersVertices = false;  // whether the filter has these properties
  std::vector<double> Distance;
  std::uint64_t DistanceState = 0;  // the session's state when the distance was computed
};

vtkStandardNewMacro(vtkTalwegSmooth);

vtkTalwegSmooth::vtkTalwegSmooth()
    : vtkTalwegFilter("talweg.smooth"), Inside(std::make_unique<Internals>()) {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkTalwegSmooth::~vtkTalwegSmooth() = default;

void vtkTalwegSmooth::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
}

namespace {

/// Sets a value, and counts a change.
template <class Value>
bool change(Value& value, const Value& to, std::uint64_t& edits) {
  if (value == to) return false;
  value = to;
  ++edits;
  return true;
}

}  // namespace

void vtkTalwegSmooth::SetPointIds(const char* numbers) {
  this->Inside->OffersVertices = true;
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
  this->Inside->OffersPoints = true;
  if (change(this->Inside->Closed, closed != 0, this->Inside->Edits)) this->Modified();
}

namespace {

/// The coordinates with all digits, each followed by a space.
std::string text_of_place(const std::array<double, 3>& place) {
  char numbers[100];
  std::snprintf(numbers, sizeof numbers, "%.17g %.17g %.17g ", place[0], place[1], place[2]);
  return numbers;
}

}  // namespace

const char* vtkTalwegSmooth::StartPoints(double x, double y, double z, double focus_x,
                                         double focus_y, double focus_z) {
  std::string& text = this->Inside->Start;
  text.clear();
  vtkDataObject* input =
      this->GetNumberOfInputConnections(0) == 0 ? nullptr : this->GetInputDataObject(0, 0);
  if (input == nullptr) return text.c_str();
  for (vtkDataSet* mesh : talweg::paraview::data_sets_of(*input)) {
    for (const auto& point : talweg::paraview::start_points(
             *talweg::paraview::polydata_of(*mesh), {x, y, z}, {focus_x, focus_y, focus_z})) {
      text += text_of_place(point);
    }
    if (!text.empty()) break;
  }
  return text.c_str();
}

const char* vtkTalwegSmooth::Pick(double x0, double y0, double z0, double x1, double y1,
                                  double z1) {
  std::string& text = this->Inside->Picked;
  text.clear();
  vtkDataObject* input =
      this->GetNumberOfInputConnections(0) == 0 ? nullptr : this->GetInputDataObject(0, 0);
  if (input == nullptr) return text.c_str();
  for (vtkDataSet* mesh : talweg::paraview::data_sets_of(*input)) {
    const auto place = this->Inside->Ray.meet(*mesh, {x0, y0, z0}, {x1, y1, z1});
    if (!place) continue;
    text = text_of_place(*place);
    break;
  }
  return text.c_str();
}

int vtkTalwegSmooth::SegmentAt(double x, double y, double z, double within) {
  const Internals& inside = *this->Inside;
  if (inside.Passed.empty() || inside.PassedEdits != inside.Edits) return -1;
  return talweg::paraview::segment_at(inside.Passed, inside.Closed, inside.Points, {x, y, z},
                                      within);
}

double vtkTalwegSmooth::GetSlackUsed() { return this->Inside->SlackUsed; }
double vtkTalwegSmooth::GetDeviationReached() { return this->Inside->DeviationReached; }

void vtkTalwegSmooth::SetDistanceField(int on) {
  if (this->Inside->WithDistance == (on != 0)) return;
  this->Inside->WithDistance = on != 0;
  this->Modified();
}

int vtkTalwegSmooth::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkTable" : "vtkPolyData");
  return 1;
}

namespace {

/// The sentence with rows of the panel's table, counted from 1, instead of positions, counted from
/// 0.
std::string with_rows(const std::string& sentence) {
  unsigned position = 0;
  int end = 0;
  if (std::sscanf(sentence.c_str(), "At position %u of the curve:%n", &position, &end) != 1 ||
      end == 0)
    return sentence;
  return "At point " + std::to_string(position + 1) + ":" + sentence.substr(end);
}

}  // namespace

void vtkTalwegSmooth::Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject*,
                           vtkInformationVector& outputs) {
  Session& session = this->GetSession();
  this->Inside->SlackUsed = this->Inside->DeviationReached = 0;
  this->Inside->Passed.clear();
  this->TakeMesh(mesh);
  talweg::paraview::Origin origin = talweg::paraview::origin_of(curves, nullptr);
  origin.edits = this->Inside->Edits;
  try {
    this->TakeDrawing(origin, [this, curves, &session] {
      return session.along_edges(this->Inside->drawing(curves, this->GetCurveIds()));
    });
  } catch (const talweg::host::Error& error) {
    if (!this->Inside->OffersPoints) throw;
    throw talweg::host::Error(error.status(), with_rows(error.what()));
  }
  const talweg::host::Results results = this->Inside->run(session);
  this->Inside->SlackUsed = results.number("slack");
  this->Inside->DeviationReached = std::max(results.number("deviation_to_drawn_max"),
                                            results.number("deviation_from_drawn_max"));
  this->Tell(talweg::paraview::outcome(results) +
             (this->Inside->WithDistance ? "\nThe distance to the drawing is on the output Mesh: "
                                           "show it instead of the input mesh."
                                         : ""));
  talweg::paraview::give(results, session.mesh(), *vtkPolyData::GetData(&outputs, 0));
  this->Inside->keep_curve(results);
  this->Inside->give_mesh(session, *vtkPolyData::GetData(&outputs, 1));
  talweg::paraview::give_table(results, *vtkTable::GetData(&outputs, 2));
  this->Log(TALWEG_LOG_INFO, talweg::paraview::summary(results).c_str());
}
