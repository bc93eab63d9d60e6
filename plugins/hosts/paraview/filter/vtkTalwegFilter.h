/**
 * @class vtkTalwegFilter
 * @brief the base of Talweg's filters
 *
 * Input 0 is a mesh. Parameters are passed by their ids to a plugin. The plugin's instance is kept
 * between runs, so that a change repeats only the stages that depend on it. Errors of the plugin
 * become errors of the filter with the plugin's sentence; the outputs are empty then.
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

// Nested, since VTK's wrapping cannot read the short form.
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
  /// Values of the plugin's parameters. A number below 0 stands for an optional number without a
  /// value. Vertices are numbers from 0, separated by spaces or commas; numbers of curves, one for
  /// each curve, are separated alike, and an empty text stands for none. A field is the name of a
  /// point array of the mesh, a triangle field the name of a cell array, or None. The next run
  /// reports wrong values.
  void SetNumber(const char* id, double value);
  void SetChoice(const char* id, const char* value);
  void SetVertices(const char* id, const char* numbers);
  void SetCurveNumbers(const char* id, const char* numbers);
  void SetField(const char* id, const char* array);
  void SetTriangleField(const char* id, const char* array);
  ///@}

  /// A point array of the curves with vertex indices of the mesh, used instead of positions; None:
  /// no array.
  void SetCurveIds(const char* array);

  /// The text of the last run: the measures of its result, its warnings, or why there is no result.
  const char* GetOutcome();

  ///@{
  /// The number of times that each stage was run.
  int GetMeshesOpened();
  int GetCurvesSet();
  int GetRuns();
  ///@}

 protected:
  /// `plugin` is the id of the plugin.
  explicit vtkTalwegFilter(const char* plugin);
  ~vtkTalwegFilter() override;

  /// Port 0 is the mesh; other ports are curves, optional unless a derived class requires them.
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  /// Runs the filter on its input: a data set, unless a derived class also takes other objects.
  virtual void WorkOn(vtkDataObject& mesh, vtkDataObject* curves, vtkDataObject* others,
                      vtkInformationVector& outputs);
  /// Runs the filter on a data set. `curves` is null on a filter with one input, or without curves;
  /// so is `others` for a third input. Throws exceptions derived from std::exception.
  virtual void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
                    vtkInformationVector& outputs) = 0;

  talweg::paraview::Session& GetSession();
  /// Sets the mesh of the session.
  void TakeMesh(vtkDataSet& mesh);
  /// Sets the curves of a data set, followed by the curves of another, and returns the number of
  /// the latter. Throws std::runtime_error without the first data set.
  int TakeCurves(vtkDataObject* curves, vtkDataObject* others);
  /// Sets the curves of make(), unless the origin equals the last one. The name of the array with
  /// vertices is a part of the origin.
  void TakeDrawing(talweg::paraview::Origin origin,
                   const std::function<std::vector<talweg::host::Curve>()>& make);
  /// The name of the array with vertex indices of the mesh; empty: none.
  const char* GetCurveIds() const;
  /// Shows a warning in ParaView's messages, and other messages in the log. A warning is not
  /// repeated until the mesh or the curves change.
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
