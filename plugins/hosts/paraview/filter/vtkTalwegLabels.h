/**
 * @class vtkTalwegLabels
 * @brief smooths all borders of a segmentation together
 *
 * Input 0 is the mesh with labels of cells or points. Output 0 is the smoothed borders, output 1
 * the mesh with new labels of its cells, output 2 the mesh cut along the borders, with exact
 * labels, output 3 a table with the report on each border. The plugin talweg.labels does the work.
 */
#ifndef vtkTalwegLabels_h
#define vtkTalwegLabels_h

#include "TalwegFiltersModule.h"  // for the export macro
#include "vtkTalwegFilter.h"

class TALWEGFILTERS_EXPORT vtkTalwegLabels : public vtkTalwegFilter {
 public:
  static vtkTalwegLabels* New();
  vtkTypeMacro(vtkTalwegLabels, vtkTalwegFilter);

 protected:
  vtkTalwegLabels();
  ~vtkTalwegLabels() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
            vtkInformationVector& outputs) override;

 private:
  vtkTalwegLabels(const vtkTalwegLabels&) = delete;
  void operator=(const vtkTalwegLabels&) = delete;
};

#endif
