#include "pqTalwegOptional.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>

#include <vtkCommand.h>
#include <vtkEventQtSlotConnect.h>
#include <vtkPVXMLElement.h>
#include <vtkSMDoubleRangeDomain.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include "pqDoubleRangeWidget.h"

pqTalwegOptional::pqTalwegOptional(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
    : Superclass(proxy, parent),
      Automatic(new QCheckBox(tr("Automatic"), this)),
      Slider(new pqDoubleRangeWidget(this)),
      Used(new QLabel(this)) {
  this->setProperty(property);
  this->Automatic->setObjectName("Automatic");
  this->Slider->setObjectName("Value");
  this->Automatic->setChecked(true);
  auto* rows = new QGridLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(this->Automatic, 0, 0);
  rows->addWidget(this->Slider, 0, 1);
  rows->addWidget(this->Used, 1, 0, 1, 2);
  rows->setColumnStretch(1, 1);
  this->takeRange();
  vtkSMDomain* range = property->FindDomain<vtkSMDoubleRangeDomain>();
  if (range != nullptr) {
    this->Events->Connect(range, vtkCommand::DomainModifiedEvent, this, SLOT(takeRange()));
  }
  QObject::connect(this->Automatic, &QCheckBox::toggled, this, [this](bool on) {
    this->Slider->setEnabled(!on);
    if (!on && !(this->Slider->value() > 0)) {
      const double used = this->inForce();
      this->Slider->setValue(used > 0 ? used : this->Slider->maximum() / 2);
    }
    Q_EMIT this->valueChanged();
  });
  QObject::connect(this->Slider, &pqDoubleRangeWidget::valueEdited, this,
                   [this] { Q_EMIT this->valueChanged(); });
  this->Slider->setEnabled(false);
  this->Events->Connect(proxy, vtkCommand::UpdateDataEvent, this, SLOT(tellUsed()));
  this->tellUsed();
  this->addPropertyLink(this, "value", SIGNAL(valueChanged()), property);
}

pqTalwegOptional::~pqTalwegOptional() = default;

double pqTalwegOptional::value() const {
  return this->Automatic->isChecked() ? -1 : this->Slider->value();
}

void pqTalwegOptional::setValue(double value) {
  const QSignalBlocker quiet(this->Automatic);
  this->Automatic->setChecked(value < 0);
  this->Slider->setEnabled(value >= 0);
  if (value >= 0) this->Slider->setValue(value);
}

void pqTalwegOptional::takeRange() {
  auto* range = this->property()->FindDomain<vtkSMDoubleRangeDomain>();
  int below = 0, above = 0;
  const double least = range == nullptr ? 0 : range->GetMinimum(0, below);
  const double most = range == nullptr ? 0 : range->GetMaximum(0, above);
  this->Slider->setMinimum(below != 0 ? std::max(0.0, least) : 0);
  this->Slider->setMaximum(above != 0 && most > 0 ? most : 10);
}

namespace {

vtkPVXMLElement* hint_of(vtkSMProperty& property) {
  vtkPVXMLElement* hints = property.GetHints();
  return hints == nullptr ? nullptr : hints->FindNestedElementByName("InForce");
}

}  // namespace

double pqTalwegOptional::inForce() const {
  vtkPVXMLElement* hint = hint_of(*this->property());
  const char* name = hint == nullptr ? nullptr : hint->GetAttribute("property");
  vtkSMProperty* used = name == nullptr ? nullptr : this->proxy()->GetProperty(name);
  if (used == nullptr) return 0;
  this->proxy()->UpdatePropertyInformation(used);
  return vtkSMPropertyHelper(used, true).GetAsDouble();
}

void pqTalwegOptional::tellUsed() {
  const double value = this->inForce();
  vtkPVXMLElement* hint = hint_of(*this->property());
  const char* says = hint == nullptr ? nullptr : hint->GetAttribute("says");
  this->Used->setVisible(value > 0 && says != nullptr);
  if (says != nullptr) this->Used->setText(QString("%1: %2").arg(says).arg(value, 0, 'g', 4));
}
