/**
 * Makes ParaView's abort button work while one filter runs. ParaView handles no events then, so the
 * button is grey: events in the midst of an update would begin another. Here a window that cannot
 * be seen lies on the button, on a connection of its own to the display, and is asked for clicks
 * between the steps of the filter. Only where the filter is in this process, and on X11.
 */
#ifndef pqTalwegAbort_h
#define pqTalwegAbort_h

#include <QElapsedTimer>
#include <QPointer>
#include <memory>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

#include "click_window.hpp"

class QToolButton;
class vtkAlgorithm;
class vtkCallbackCommand;
class vtkObject;
class vtkSMProxy;

class pqTalwegAbort {
 public:
  explicit pqTalwegAbort(vtkSMProxy& filter);
  ~pqTalwegAbort();
  pqTalwegAbort(const pqTalwegAbort&) = delete;
  pqTalwegAbort& operator=(const pqTalwegAbort&) = delete;

 private:
  static void handle(vtkObject* caller, unsigned long event, void* self, void* data);
  void step();
  void open();
  void close();

  vtkWeakPointer<vtkAlgorithm> Filter;
  vtkNew<vtkCallbackCommand> Command;
  QPointer<QToolButton> Button;
  QElapsedTimer Since;
  bool Stopped = false;
  std::unique_ptr<talweg::paraview::ClickWindow> Window;
};

#endif
