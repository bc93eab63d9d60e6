/**
 * @class vtkTalwegFilter
 * @brief what the filters of Talweg have in common
 *
 * Input 0 is a mesh. Parameters go by their ids to the plugin that does the work; it is kept
 * between runs, so that only what a change concerns is done again. What the plugin refuses arrives
 * as an error with its sentence, and the outputs are empty.
 */
#ifndef vtkTalwegFilter_h
#define vtkTalwegFilter_h

#include <functional>  // for std::function
#include <memory>      // for std::unique_ptr
#include <string>      // for std::string
#include <vector>      // for std::vector

#include <vtkDataObjectAlgorithm.h>

#include "TalwegFiltersModule.h"  // for the export macro

class vtkDataSet;

// Nested as VTK's wrapping can read it.
namespace talweg {
namespace host {
struct Curve;
struct Results;
}  // namespace host
namespace paraview {
class Session;
struct Origin;
}  // namespace paraview
}  // namespace talweg

class TALWEGFILTERS_EXPORT vtkTalwegFilter : public vtkDataObjectAlgorithm {
 public:
  vtkTypeMacro(vtkTalwegFilter, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Values of the plugin's parameters. Optional numbers are not given below 0; vertices are
  /// numbers from 0, separated by spaces or commas; numbers of curves are separated so, too, one
  /// for each, and none is none at all; a field is the name of a point array of the mesh, a
  /// triangle field that of a cell array, or None. What is wrong with a value is told by the next
  /// run.
  void SetNumber(const char* id, double value);
  void SetChoice(const char* id, const char* value);
  void SetVertices(const char* id, const char* numbers);
  void SetCurveNumbers(const char* id, const char* numbers);
  void SetField(const char* id, const char* array);
  void SetTriangleField(const char* id, const char* array);
  ///@}

  /// A point array of the curves with vertices of the mesh, used instead of their positions; None:
  /// none.
  void SetCurveIds(const char* array);

  /// What the last run says of itself: what it reached, its warnings, or why there is no result.
  const char* GetOutcome();

  ///@{
  /// How often each stage was done.
  int GetMeshesOpened();
  int GetCurvesSet();
  int GetRuns();
  ///@}

 protected:
  /// `plugin`: the id of the one that does the work.
  explicit vtkTalwegFilter(const char* plugin);
  ~vtkTalwegFilter() override;

  /// Port 0 is the mesh; others are curves, optional unless a class says otherwise.
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  /// Does the work on what comes in: a data set, unless a class takes others, too.
  virtual void WorkOn(vtkDataObject& mesh, vtkDataObject* curves, vtkDataObject* others,
                      vtkInformationVector& outputs);
  /// Does the work. `curves` is null on a filter with one input, or if there are none; so is
  /// `others` for a third input. Throws what std::exception is.
  virtual void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
                    vtkInformationVector& outputs) = 0;

  talweg::paraview::Session& GetSession();
  /// Gives the session the mesh.
  void TakeMesh(vtkDataSet& mesh);
  /// Gives the session the curves of a data set, and behind them those of another; says how many
  /// these are. Throws std::runtime_error without the first.
  int TakeCurves(vtkDataObject* curves, vtkDataObject* others);
  /// Gives the session curves that are made unless they come from where they last came from. The
  /// name of an array with vertices belongs to the origin.
  void TakeDrawing(talweg::paraview::Origin origin,
                   const std::function<std::vector<talweg::host::Curve>()>& make);
  /// The name of the array with vertices of the mesh; empty: none.
  const char* GetCurveIds() const;
  /// In ParaView's messages if it is a warning, else in the log. A warning is not repeated until
  /// the mesh or the curves change.
  void Log(unsigned int severity, const char* message);
  /// Puts a text before the warnings in GetOutcome().
  void Tell(const std::string& text);
  /// A sentence of the plugin with the names of this filter's panel.
  virtual std::string InWordsOfPanel(const std::string& sentence);
  /// The warnings of a report, for plugins that do not log them.
  void LogWarnings(const talweg::host::Results& results);

 private:
  vtkTalwegFilter(const vtkTalwegFilter&) = delete;
  void operator=(const vtkTalwegFilter&) = delete;

  bool GoOn(const char* stage, double done);
  template <class Value>
  void Give(const char* id, Value value);

  struct Internals;
  std::unique_ptr<Internals> Common;
};

#endif
