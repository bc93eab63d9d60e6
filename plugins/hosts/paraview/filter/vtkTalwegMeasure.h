/**
 * @class vtkTalwegMeasure
 * @brief measures curves on a mesh
 *
 * Input 0 is the mesh, input 1 the curves, input 2 curves for a comparison (optional). The output
 * is a table: a row for each curve, and one for all. The plugin talweg.measure does the work.
 */
#ifndef vtkTalwegMeasure_h
#define vtkTalwegMeasure_h

#include "TalwegFiltersModule.h"  // for the export macro
#include "vtkTalwegFilter.h"

class TALWEGFILTERS_EXPORT vtkTalwegMeasure : public vtkTalwegFilter {
 public:
  static vtkTalwegMeasure* New();
  vtkTypeMacro(vtkTalwegMeasure, vtkTalwegFilter);

 protected:
  vtkTalwegMeasure();
  ~vtkTalwegMeasure() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
            vtkInformationVector& outputs) override;

 private:
  vtkTalwegMeasure(const vtkTalwegMeasure&) = delete;
  void operator=(const vtkTalwegMeasure&) = delete;
};

#endif
