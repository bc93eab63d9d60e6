/**
 * @class vtkTalwegRepair
 * @brief repairs a mesh to a surface
 *
 * Input 0 is the mesh. The output is the repaired mesh with all arrays; its field data have the
 * defects and the changes. The plugin talweg.repair does the work.
 */
#ifndef vtkTalwegRepair_h
#define vtkTalwegRepair_h

#include "TalwegFiltersModule.h"  // for the export macro
#include "vtkTalwegFilter.h"

class TALWEGFILTERS_EXPORT vtkTalwegRepair : public vtkTalwegFilter {
 public:
  static vtkTalwegRepair* New();
  vtkTypeMacro(vtkTalwegRepair, vtkTalwegFilter);

 protected:
  vtkTalwegRepair();
  ~vtkTalwegRepair() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
            vtkInformationVector& outputs) override;

 private:
  vtkTalwegRepair(const vtkTalwegRepair&) = delete;
  void operator=(const vtkTalwegRepair&) = delete;
};

#endif
