/**
 * @class vtkTalwegRun
 * @brief runs any plugin that makes meshes
 *
 * Input 0 is the mesh, input 1 the curves, if the plugin takes curves. Outputs are as in
 * vtkTalwegCut.
 */
#ifndef vtkTalwegRun_h
#define vtkTalwegRun_h

#include <string>  // for std::string

#include "TalwegFiltersModule.h"  // for the export macro
#include "vtkTalwegCut.h"

class TALWEGFILTERS_EXPORT vtkTalwegRun : public vtkTalwegCut {
 public:
  static vtkTalwegRun* New();
  vtkTypeMacro(vtkTalwegRun, vtkTalwegCut);

  ///@{
  /// The plugin's id, and values of its numbers and choices as "share=0.1 task=copy". The next
  /// run reports wrong values. A change opens the mesh again.
  void SetPlugin(const char* id);
  void SetParameters(const char* text);
  ///@}

 protected:
  vtkTalwegRun();
  ~vtkTalwegRun() override = default;

  void WorkOn(vtkDataObject& mesh, vtkDataObject* curves, vtkDataObject* others,
              vtkInformationVector& outputs) override;

  /// The panel names parameters by their ids.
  std::string InWordsOfPanel(const std::string& sentence) override { return sentence; }

 private:
  vtkTalwegRun(const vtkTalwegRun&) = delete;
  void operator=(const vtkTalwegRun&) = delete;

  void Change(std::string& member, const char* text);
  void Begin();

  std::string Plugin = "talweg.cut";
  std::string Parameters;
  bool Changed = true;
};

#endif
