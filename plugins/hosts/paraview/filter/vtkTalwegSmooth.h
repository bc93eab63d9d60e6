/**
 * @class vtkTalwegSmooth
 * @brief smooths curves on a triangle mesh while they stay close to what was drawn
 *
 * Input 0 is the mesh; the drawing is input 1 (lines, or points in their order), or points, or
 * numbers of vertices. Output 0 is the smoothed curves, output 1 the mesh with the distance to the
 * drawing. Parameters go by their ids to the plugin talweg.smooth, which does the work; it is kept
 * between runs, so that a new tau costs what moving tau costs.
 */
#ifndef vtkTalwegSmooth_h
#define vtkTalwegSmooth_h

#include <memory>  // for std::unique_ptr

#include <vtkPolyDataAlgorithm.h>

#include "TalwegFiltersModule.h"  // for the export macro

class TALWEGFILTERS_EXPORT vtkTalwegSmooth : public vtkPolyDataAlgorithm {
 public:
  static vtkTalwegSmooth* New();
  vtkTypeMacro(vtkTalwegSmooth, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Values of talweg.smooth's parameters. Optional numbers are not given below 0; vertices are
  /// numbers from 0, separated by spaces or commas; numbers of curves are separated so, too, one
  /// for each, and none is none at all; a field is the name of a point array of the mesh, or None.
  /// What is wrong with a value is told by the next run.
  void SetNumber(const char* id, double value);
  void SetChoice(const char* id, const char* value);
  void SetVertices(const char* id, const char* numbers);
  void SetCurveNumbers(const char* id, const char* numbers);
  void SetField(const char* id, const char* array);
  ///@}

  /// A point array of input 1 with vertices of the mesh, used instead of its positions; None: none.
  void SetCurveIds(const char* array);

  ///@{
  /// The drawing without input 1: points of space in their order, joined to the first if closed.
  void SetNumberOfPoints(int count);
  void SetPoint(int index, double x, double y, double z);
  void SetClosed(int closed);
  ///@}

  /// Vertices of the mesh, used instead of the points; closed if the first is repeated at the end.
  void SetPointIds(const char* numbers);

  /// Whether output 1 has the point array "distance" (off by default).
  void SetDistanceField(int on);

  ///@{
  /// How often each stage was done.
  int GetMeshesOpened();
  int GetCurvesSet();
  int GetRuns();
  ///@}

 protected:
  vtkTalwegSmooth();
  ~vtkTalwegSmooth() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

 private:
  vtkTalwegSmooth(const vtkTalwegSmooth&) = delete;
  void operator=(const vtkTalwegSmooth&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
