/**
 * @class vtkSMTalwegStart
 * @brief first points of a new filter of Talweg, and first looks of its curves
 *
 * An initialization helper of ParaView: <InitializationHelper class="vtkSMTalwegStart" .../> in the
 * hints of a filter. With start_points="1" the property Points begins with points on the mesh that
 * are visible in the active view, unless it was set. With curves="PORT" the curves of this output
 * begin as wide lines with a colour of their own.
 */
#ifndef vtkSMTalwegStart_h
#define vtkSMTalwegStart_h

#include <vtkSMProxyInitializationHelper.h>

#include "TalwegFiltersModule.h"  // for the export macro

class TALWEGFILTERS_EXPORT vtkSMTalwegStart : public vtkSMProxyInitializationHelper {
 public:
  static vtkSMTalwegStart* New();
  vtkTypeMacro(vtkSMTalwegStart, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml,
                           vtkMTimeType initializationTimeStamp) override;

 protected:
  vtkSMTalwegStart() = default;
  ~vtkSMTalwegStart() override = default;

 private:
  vtkSMTalwegStart(const vtkSMTalwegStart&) = delete;
  void operator=(const vtkSMTalwegStart&) = delete;
};

#endif
