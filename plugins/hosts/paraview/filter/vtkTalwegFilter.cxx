#include "vtkTalwegFilter.h"

#include <exception>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkLogger.h>

#include "curve_input.hpp"
#include "panel_names.hpp"
#include "property_text.hpp"
#include "session.hpp"

using talweg::host::Curve;
using talweg::paraview::array_name;
using talweg::paraview::Session;
using talweg::paraview::text_of;

struct vtkTalwegFilter::Internals {
  Internals(vtkTalwegFilter* filter, const char* plugin)
      : Work(
            plugin, [filter](const char* stage, double done) { return filter->GoOn(stage, done); },
            [filter](std::uint32_t severity, const char* message) {
              filter->Log(severity, message);
            }) {}

  Session Work;
  std::string CurveIds;
  std::uint64_t Edits = 0;       // changes of the name of the curves' array
  std::size_t Others = 0;        // curves of the last drawing
  std::set<std::string> Warned;  // warnings since the last change of the mesh, and those that still
                                 // hold
  std::set<std::string> Before;  // warnings of the run before this one
  std::set<std::string> Now;     // warnings of this run
  std::string Told, Warnings;    // of the last run
  std::string Outcome;           // both, as the text that GetOutcome() returned
};

vtkTalwegFilter::vtkTalwegFilter(const char* plugin)
    : Common(std::make_unique<Internals>(this, plugin)) {}

vtkTalwegFilter::~vtkTalwegFilter() = default;

void vtkTalwegFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshesOpened: " << this->GetMeshesOpened() << "\n"
     << indent << "CurvesSet: " << this->GetCurvesSet() << "\n"
     << indent << "Runs: " << this->GetRuns() << "\n";
}

template <class Value>
void vtkTalwegFilter::Give(const char* id, Value value) {
  if (this->Common->Work.set(id, std::move(value))) this->Modified();
}

void vtkTalwegFilter::SetNumber(const char* id, double value) { this->Give(id, value); }

void vtkTalwegFilter::SetChoice(const char* id, const char* value) {
  this->Give(id, talweg::paraview::Choice{text_of(value)});
}

void vtkTalwegFilter::SetVertices(const char* id, const char* numbers) {
  this->Give(id, talweg::paraview::VertexList{text_of(numbers)});
}

void vtkTalwegFilter::SetCurveNumbers(const char* id, const char* numbers) {
  this->Give(id, talweg::paraview::CurveNumbers{text_of(numbers)});
}

void vtkTalwegFilter::SetField(const char* id, const char* array) {
  this->Give(id, talweg::paraview::FieldName{array_name(array)});
}

void vtkTalwegFilter::SetTriangleField(const char* id, const char* array) {
  this->Give(id, talweg::paraview::FieldName{array_name(array), true});
}

void vtkTalwegFilter::SetCurveIds(const char* array) {
  const std::string name = array_name(array);
  if (name == this->Common->CurveIds) return;
  this->Common->CurveIds = name;
  ++this->Common->Edits;
  this->Modified();
}

const char* vtkTalwegFilter::GetCurveIds() const { return this->Common->CurveIds.c_str(); }

int vtkTalwegFilter::GetMeshesOpened() { return this->Common->Work.meshes_opened(); }
int vtkTalwegFilter::GetCurvesSet() { return this->Common->Work.curves_set(); }
int vtkTalwegFilter::GetRuns() { return this->Common->Work.runs(); }

Session& vtkTalwegFilter::GetSession() { return this->Common->Work; }

bool vtkTalwegFilter::GoOn(const char* stage, double done) {
  this->SetProgressText(stage);
  this->UpdateProgress(done);
  return !this->GetAbortExecute() && !this->CheckAbort();
}

void vtkTalwegFilter::Tell(const std::string& text) { this->Common->Told = text; }

const char* vtkTalwegFilter::GetOutcome() {
  Internals& common = *this->Common;
  common.Outcome = common.Told + common.Warnings;
  return common.Outcome.c_str();
}

namespace {

/// Whether a message is about a normal property of good drawings, which needs no change.
bool is_usual(const std::string& message) {
  return message.starts_with("The curve was moved onto the mesh") ||
         message.starts_with("The exact deviation was not measured");
}

}  // namespace

/// ParaView opens its window of messages for every warning. A warning is therefore not repeated
/// while a slider moves, and usual messages are not shown there.
void vtkTalwegFilter::Log(unsigned int severity, const char* sentence) {
  const std::string message = this->InWordsOfPanel(sentence);
  if (severity >= TALWEG_LOG_WARNING) {
    this->Common->Now.insert(message);
    std::string& all = this->Common->Warnings;
    if (all.find(message) == std::string::npos) all += std::string("\nNote: ") + message;
  }
  if (severity < TALWEG_LOG_WARNING || is_usual(message)) {
    vtkLog(INFO, "Talweg: " << message);
  } else if (this->Common->Warned.insert(message).second) {
    vtkWarningMacro(<< message);
  }
}

std::string vtkTalwegFilter::InWordsOfPanel(const std::string& sentence) {
  return talweg::paraview::in_words_of_panel(sentence, this->GetSession().plugin());
}

void vtkTalwegFilter::LogWarnings(const talweg::host::Results& results) {
  const talweg::host::ReportEntry* warnings = results.find("warnings");
  if (warnings == nullptr) return;
  for (const std::string& warning : warnings->texts) {
    this->Log(TALWEG_LOG_WARNING, warning.c_str());
  }
}

void vtkTalwegFilter::TakeMesh(vtkDataSet& mesh) {
  if (this->GetSession().take_mesh(mesh)) this->Common->Warned.clear();
}

void vtkTalwegFilter::TakeDrawing(talweg::paraview::Origin origin,
                                  const std::function<std::vector<Curve>()>& make) {
  origin.edits += this->Common->Edits;
  const bool changed = this->Common->Work.take_curves(origin, make);
  // A new click makes another drawing: warnings from before it are not repeated.
  if (changed) this->Common->Warned = this->Common->Before;
}

int vtkTalwegFilter::TakeCurves(vtkDataObject* curves, vtkDataObject* others) {
  if (curves == nullptr)
    throw std::runtime_error(
        "No curves are given: choose some for the input Curve (Change Input... in the menu of the "
        "filter).");
  Internals& common = *this->Common;
  this->TakeDrawing(talweg::paraview::origin_of(curves, others), [&] {
    std::vector<Curve> all = talweg::paraview::curves_of(*curves, common.CurveIds);
    common.Others = 0;
    if (others == nullptr) return all;
    std::vector<Curve> more = talweg::paraview::curves_of(*others, "");
    common.Others = more.size();
    all.insert(all.end(), more.begin(), more.end());
    return all;
  });
  return static_cast<int>(common.Others);
}

/// Blocks of curves are not meshes, so the filter must not run once for each.
int vtkTalwegFilter::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPointSet");
  if (port == 0) return 1;
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkTalwegFilter::WorkOn(vtkDataObject& mesh, vtkDataObject* curves, vtkDataObject* others,
                             vtkInformationVector& outputs) {
  auto* data = vtkDataSet::SafeDownCast(&mesh);
  if (data == nullptr) throw std::runtime_error("The input is not a data set.");
  this->Work(*data, curves, others, outputs);
}

namespace {

/// Advice for a mesh that was refused.
std::string advice_on_mesh(Session& session) {
  if (session.mesh().corners().empty()) {
    return " Mesh must be a surface of triangles or polygons; Change Input... (right button, in "
           "the Pipeline Browser) chooses another.";
  }
  const bool tick = session.number("repair", 0) == 0 && session.can_be_repaired();
  return tick ? " Tick Repair to repair the mesh; a message then lists the changes." : "";
}

/// The plugin's sentence, with advice for ParaView's user.
std::string advice(std::string sentence, std::int32_t status, Session& session) {
  if (status == TALWEG_BAD_MESH) return sentence + advice_on_mesh(session);
  if (sentence.find("in another unit or place") == std::string::npos) return sentence;
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence +
         ". Bring it there with the filter Transform, or click points on the mesh. Each block of a "
         "mesh is given the whole drawing; the filter Merge Blocks makes one mesh of them.";
}

}  // namespace

int vtkTalwegFilter::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  const auto clear = [&] {
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port) {
      vtkDataObject::GetData(outputs, port)->Initialize();
    }
  };
  const auto input = [&](int port) {
    return port < this->GetNumberOfInputPorts() ? vtkDataObject::GetData(inputs[port]) : nullptr;
  };
  clear();
  this->Common->Before = std::exchange(this->Common->Now, {});
  this->Common->Told.clear();
  this->Common->Warnings.clear();
  try {
    this->WorkOn(*vtkDataObject::GetData(inputs[0]), input(1), input(2), *outputs);
    const std::string& note = this->GetSession().mesh().note();
    if (!note.empty()) this->Log(TALWEG_LOG_WARNING, note.c_str());
  } catch (const talweg::host::Error& error) {
    clear();
    const bool cancelled = error.status() == TALWEG_CANCELLED;  // a cancelled run is not an error, and
                                                                // has no result
    const std::string sentence =
        advice(this->InWordsOfPanel(error.what()), error.status(), this->GetSession());
    this->Tell(cancelled ? "Stopped. Change any value and press Apply to run the filter again."
                         : "No result: " + sentence);
    if (!cancelled) vtkErrorMacro(<< sentence);
  } catch (const std::exception& error) {
    clear();
    this->Tell(std::string("No result: ") + error.what());
    vtkErrorMacro(<< error.what());
  }
  // Never 0: ParaView would add a message of its own, and views would keep showing the last result.
  return 1;
}
