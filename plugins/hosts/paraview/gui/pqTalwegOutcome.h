/**
 * The widget for the outcome of the last run: the filter's text, and a button if a repair is
 * advised. For filters with curves as output it has controls for the curves' width in the view and
 * for the array that colours them. While the filter runs, the widget makes ParaView's abort button
 * work.
 */
#ifndef pqTalwegOutcome_h
#define pqTalwegOutcome_h

#include <memory>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

#include "pqPropertyWidget.h"

class pqTalwegAbort;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;
class vtkEventQtSlotConnect;
class vtkSMProxy;

class pqTalwegOutcome : public pqPropertyWidget {
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

 public:
  pqTalwegOutcome(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqTalwegOutcome() override;

 protected:
  /// ParaView disables widgets of properties that scripts cannot set; the controls for curves must
  /// stay enabled.
  void changeEvent(QEvent* event) override;

 private Q_SLOTS:
  void tell();
  void tellLooks();

 private:
  void addLooks(int port);
  /// Ticks Repair and applies it.
  void repair();
  void setWidth(int pixels);
  void setColouring(const QString& array);
  /// The representation of the curves in the view; null if they are not shown there.
  [[nodiscard]] vtkSMProxy* shown() const;

  QLabel* Text;
  QPushButton* Mend;
  int Port = -1;                       // output with curves; -1: none
  vtkWeakPointer<vtkSMProxy> Watched;  // representation of the curves in the view
  vtkNew<vtkEventQtSlotConnect> Events;
  std::unique_ptr<pqTalwegAbort> Abort;
};

#endif
