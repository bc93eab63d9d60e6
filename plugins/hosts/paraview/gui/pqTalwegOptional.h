/**
 * The widget for a number that need not be given: Automatic, or a value. Below 0 the property is
 * not given. Below it stands what the last run used.
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
  /// What the last run used, in the property that the hint <InForce property="..." says="used"/>
  /// names; 0 if nothing is known.
  [[nodiscard]] double inForce() const;

  QCheckBox* Automatic;
  pqDoubleRangeWidget* Slider;
  QLabel* Used;
  vtkNew<vtkEventQtSlotConnect> Events;
};

#endif
