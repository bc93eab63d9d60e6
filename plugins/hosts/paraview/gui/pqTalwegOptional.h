/**
 * The widget for an optional number: Automatic, which sets the property to a value below 0, or a
 * value. A label below it shows the value that the last run used.
 */
#ifndef pqTalwegOptional_h
#define pqTalwegOptional_h

#include <vtkNew.h>

#include "pqPropertyWidget.h"

class QCheckBox;
class QLabel;
class vtkEventQtSlotConnect;
class pqDoubleRangeWidget;

class pqTalwegOptional : public pqPropertyWidget {
  Q_OBJECT
  Q_PROPERTY(double value READ value WRITE setValue NOTIFY valueChanged)
  typedef pqPropertyWidget Superclass;

 public:
  pqTalwegOptional(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqTalwegOptional() override;

  [[nodiscard]] double value() const;
  void setValue(double value);

 Q_SIGNALS:
  void valueChanged();

 private Q_SLOTS:
  void takeRange();
  void tellUsed();

 private:
  /// The value that the last run used, from the property that the hint <InForce property="..."
  /// says="used"/> names; 0 if unknown.
  [[nodiscard]] double inForce() const;

  QCheckBox* Automatic;
  pqDoubleRangeWidget* Slider;
  QLabel* Used;
  vtkNew<vtkEventQtSlotConnect> Events;
};

#endif
