/**
 * @class vtkTalwegCut
 * @brief cuts a mesh along curves, which become edges of the mesh exactly
 *
 * Input 0 is the mesh, input 1 the curves. Output 0 is a multi-block data set with the cut mesh or
 * its pieces, all arrays kept; output 1 has the curves as chains of edges. The plugin talweg.cut
 * does the work.
 */
#ifndef vtkTalwegCut_h
#define vtkTalwegCut_h

#include "TalwegFiltersModule.h"  // for the export macro
#include "vtkTalwegFilter.h"

class vtkMultiBlockDataSet;
class vtkPolyData;

class TALWEGFILTERS_EXPORT vtkTalwegCut : public vtkTalwegFilter {
 public:
  static vtkTalwegCut* New();
  vtkTypeMacro(vtkTalwegCut, vtkTalwegFilter);

 protected:
  vtkTalwegCut();
  /// For derived filters with another plugin that makes meshes.
  explicit vtkTalwegCut(const char* plugin);
  ~vtkTalwegCut() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /// Each leaf of a composite data set becomes a block with its pieces. By default ParaView would
  /// make one mesh of each leaf.
  void WorkOn(vtkDataObject& mesh, vtkDataObject* curves, vtkDataObject* others,
              vtkInformationVector& outputs) override;
  void Work(vtkDataSet& mesh, vtkDataObject* curves, vtkDataObject* others,
            vtkInformationVector& outputs) override;

 private:
  vtkTalwegCut(const vtkTalwegCut&) = delete;
  void operator=(const vtkTalwegCut&) = delete;

  void Cut(vtkDataSet& mesh, vtkDataObject* curves, vtkMultiBlockDataSet& pieces,
           vtkPolyData& chains);
};

#endif
