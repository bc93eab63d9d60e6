/**
 * The widget for what the last run says of itself: a text that the filter gives, and a button where
 * a repair is advised. Below it, for filters that give curves, how wide these are in the view, and
 * by what they are coloured. While the filter runs it makes ParaView's abort button work.
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
  /// ParaView disables widgets of what scripts cannot set, and the looks of curves with them.
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
  /// Of the curves in the view; null if they are not shown there.
  [[nodiscard]] vtkSMProxy* shown() const;

  QLabel* Text;
  QPushButton* Mend;
  int Port = -1;                       // of the curves
  vtkWeakPointer<vtkSMProxy> Watched;  // the curves in the view
  vtkNew<vtkEventQtSlotConnect> Events;
  std::unique_ptr<pqTalwegAbort> Abort;
};

#endif
