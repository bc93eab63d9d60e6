/**
 * @class vtkTalwegSmooth
 * @brief smooths curves on a triangle mesh while they stay close to what was drawn
 *
 * Input 0 is the mesh; the drawing is input 1 (lines, or points in their order), or points, or
 * numbers of vertices. Output 0 is the smoothed curves, output 1 the mesh with the distance to the
 * drawing, output 2 a table with the report on each curve. The plugin talweg.smooth does the work.
 */
#ifndef vtkTalwegSmooth_h
#define vtkTalwegSmooth_h

#include <memory>  // for std::unique_ptr

#include "TalwegFiltersModule.h"  // for the export macro
#include "vtkTalwegFilter.h"

class TALWEGFILTERS_EXPORT vtkTalwegSmooth : public vtkTalwegFilter {
 public:
  static vtkTalwegSmooth* New();
  vtkTypeMacro(vtkTalwegSmooth, vtkTalwegFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The drawing without input 1: points of space in their order, joined to the first if closed.
  void SetNumberOfPoints(int count);
  void SetPoint(int index, double x, double y, double z);
  void SetClosed(int closed);
  ///@}

  /// Vertices of the mesh, used instead of the points; closed if the first is repeated at the end.
  void SetPointIds(const char* numbers);

  /// Three points on the mesh that comes in, as nine numbers in a text, to begin a drawing with:
  /// those that an eye at x, y, z sees, which looks at the focus; from anywhere if these are one
  /// place. Empty if there is no mesh yet.
  const char* StartPoints(double x, double y, double z, double focus_x, double focus_y,
                          double focus_z);

  /// Where the mesh that comes in is met first between two places, as three numbers in a text;
  /// empty if it is not between them.
  const char* Pick(double x0, double y0, double z0, double x1, double y1, double z1);

  /// Between which of the points of the last run its curve passes this place, within a distance: 0
  /// behind the first point. -1 if it does not, or if the points have changed since.
  int SegmentAt(double x, double y, double z, double within);

  ///@{
  /// Of the last run, in mesh units; 0 before one, and where there is none.
  double GetSlackUsed();
  double GetDeviationReached();
  ///@}

  /// Whether output 1 has the point array "distance" (off by default).
  void SetDistanceField(int on);

 protected:
  vtkTalwegSmooth();
  ~vtkTalwegSmooth() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
            vtkInformationVector& outputs) override;

 private:
  vtkTalwegSmooth(const vtkTalwegSmooth&) = delete;
  void operator=(const vtkTalwegSmooth&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
