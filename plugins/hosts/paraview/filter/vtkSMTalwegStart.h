/**
 * @class vtkSMTalwegStart
 * @brief what a new filter of Talweg begins with, and how its curves look
 *
 * An initialization helper of ParaView: <InitializationHelper class="vtkSMTalwegStart" .../> in the
 * hints of a filter. With start_points="1" the property Points begins with points on the mesh that
 * the active view sees, unless it was set. With curves="PORT" what that output shows is wide and
 * has a colour of its own when it is shown first.
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
