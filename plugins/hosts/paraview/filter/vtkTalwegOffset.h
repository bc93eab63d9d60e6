/**
 * @class vtkTalwegOffset
 * @brief curves at a distance along the surface from given curves
 *
 * Input 0 is the mesh, input 1 the curves. Output 0 is the offset curves, with cell arrays of their
 * distance, side and the number of the given curve, output 1 a table with the report on each. The
 * plugin talweg.offset does the work.
 */
#ifndef vtkTalwegOffset_h
#define vtkTalwegOffset_h

#include "TalwegFiltersModule.h"  // for the export macro
#include "vtkTalwegFilter.h"

class TALWEGFILTERS_EXPORT vtkTalwegOffset : public vtkTalwegFilter {
 public:
  static vtkTalwegOffset* New();
  vtkTypeMacro(vtkTalwegOffset, vtkTalwegFilter);

 protected:
  vtkTalwegOffset();
  ~vtkTalwegOffset() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
            vtkInformationVector& outputs) override;

 private:
  vtkTalwegOffset(const vtkTalwegOffset&) = delete;
  void operator=(const vtkTalwegOffset&) = delete;
};

#endif
