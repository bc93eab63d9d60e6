/**
 * @class vtkTalwegSmooth
 * @brief smooths curves on a triangle mesh, close to their drawing
 *
 * Input 0 is the mesh; the drawing is input 1 (lines, or points in their order), or the property of
 * points, or the property of vertex indices. Output 0 is the smoothed curves, output 1 the mesh
 * with the distance to the drawing, output 2 a table with the report on each curve. The plugin
 * talweg.smooth does the work.
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
  /// The drawing without input 1: points in space in their order, and whether the last is joined
  /// to the first.
  void SetNumberOfPoints(int count);
  void SetPoint(int index, double x, double y, double z);
  void SetClosed(int closed);
  ///@}

  /// Vertices of the mesh, used instead of the points; closed if the first vertex is repeated at
  /// the end.
  void SetPointIds(const char* numbers);

  /// Three points on the input mesh for a new drawing, as nine numbers in a text: points that are
  /// visible from the eye at x, y, z, which looks at the focus; from any direction if eye and focus
  /// are equal. Empty without a mesh.
  const char* StartPoints(double x, double y, double z, double focus_x, double focus_y,
                          double focus_z);

  /// The first point of the input mesh on the segment between two places, as three numbers in a
  /// text; empty if the segment does not meet the mesh.
  const char* Pick(double x0, double y0, double z0, double x1, double y1, double z1);

  /// The index k such that the last run's curve passes this place between its points k and k + 1,
  /// within a distance. -1 if it does not pass the place, or if the points have changed since.
  int SegmentAt(double x, double y, double z, double within);

  ///@{
  /// Lengths of the last run, mesh units; 0 before the first run, and for lengths that it does
  /// not have.
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
