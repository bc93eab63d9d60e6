/**
 * Makes ParaView's abort button work while one filter runs. ParaView handles no events during the
 * run, since an event in the midst of an update would start another update; so the button is grey.
 * An invisible window on the button, with its own connection to the display, detects clicks between
 * the steps of the filter. Works on X11, and only if the filter runs in this process.
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
