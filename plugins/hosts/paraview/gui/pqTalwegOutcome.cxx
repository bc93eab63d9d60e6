#include "pqTalwegOutcome.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <string>

#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkEventQtSlotConnect.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>

#include "pqTalwegAbort.h"
#include "pqView.h"
#include "properties_panel.hpp"

namespace {

/// The index of the output with curves, from the filter's hints; -1: none.
int port_of_curves(vtkSMProxy& filter) {
  int port = -1;
  vtkPVXMLElement* hints = filter.GetHints();
  vtkPVXMLElement* start =
      hints == nullptr ? nullptr : hints->FindNestedElementByName("InitializationHelper");
  if (start != nullptr) start->GetScalarAttribute("curves", &port);
  return port;
}

}  // namespace

pqTalwegOutcome::pqTalwegOutcome(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
    : Superclass(proxy, parent),
      Text(new QLabel(this)),
      Mend(new QPushButton(tr("Repair the mesh"), this)),
      Abort(std::make_unique<pqTalwegAbort>(*proxy)) {
  this->setProperty(property);
  this->Text->setObjectName("Outcome");
  this->Text->setWordWrap(true);
  this->Text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->Text);
  this->Mend->setObjectName("Mend");
  this->Mend->setFocusPolicy(Qt::NoFocus);  // the button disappears at a click, and the widget with
                                            // the focus would get Ctrl-Z
  this->Mend->setVisible(false);
  QObject::connect(this->Mend, &QPushButton::clicked, this, [this] { this->repair(); });
  column->addWidget(this->Mend, 0, Qt::AlignLeft);
  this->addLooks(port_of_curves(*proxy));
  this->Events->Connect(proxy, vtkCommand::UpdateDataEvent, this, SLOT(tell()));
  this->tell();
}

pqTalwegOutcome::~pqTalwegOutcome() = default;

void pqTalwegOutcome::changeEvent(QEvent* event) {
  this->Superclass::changeEvent(event);
  if (event->type() == QEvent::EnabledChange && !this->isEnabled()) this->setEnabled(true);
}

void pqTalwegOutcome::addLooks(int port) {
  this->Port = port;
  if (port < 0) return;
  auto* width = new QSpinBox(this);
  width->setObjectName("LineWidth");
  width->setRange(1, 30);
  width->setValue(4);
  auto* colour = new QComboBox(this);
  colour->setObjectName("CurveColour");
  colour->addItem(tr("own colour"), "");
  for (const char* array : {"deviation", "turning", "arc_length"}) colour->addItem(array, array);
  auto* rows = new QFormLayout;  // two rows, so that the panel may be narrow
  rows->addRow(tr("Line width"), width);
  rows->addRow(tr("Coloured by"), colour);
  // Only smoothed curves have these arrays.
  const bool smooths = this->proxy()->GetProperty("DistanceField") != nullptr;
  colour->setVisible(smooths);
  rows->labelForField(colour)->setVisible(smooths);
  qobject_cast<QVBoxLayout*>(this->layout())->addLayout(rows);
  QObject::connect(width, QOverload<int>::of(&QSpinBox::valueChanged), this,
                   [this](int pixels) { this->setWidth(pixels); });
  QObject::connect(colour, QOverload<int>::of(&QComboBox::activated), this,
                   [this, colour](int) { this->setColouring(colour->currentData().toString()); });
}

void pqTalwegOutcome::repair() {
  auto* shown = this->parentWidget() == nullptr
                    ? nullptr
                    : this->parentWidget()->findChild<QWidget*>("Repair");
  auto* box = shown == nullptr ? nullptr : shown->findChild<QCheckBox*>();
  if (box == nullptr) return;
  box->setChecked(true);
  apply_panel_of(*this);
}

vtkSMProxy* pqTalwegOutcome::shown() const {
  auto* view =
      this->view() == nullptr ? nullptr : vtkSMViewProxy::SafeDownCast(this->view()->getProxy());
  auto* filter = vtkSMSourceProxy::SafeDownCast(this->proxy());
  if (view == nullptr || filter == nullptr) return nullptr;
  return view->FindRepresentation(filter, this->Port);
}

void pqTalwegOutcome::setWidth(int pixels) {
  vtkSMProxy* curves = this->shown();
  if (curves == nullptr || curves->GetProperty("LineWidth") == nullptr) return;
  vtkSMPropertyHelper(curves, "LineWidth").Set(pixels);
  curves->UpdateVTKObjects();
  this->view()->render();
}

void pqTalwegOutcome::setColouring(const QString& array) {
  vtkSMProxy* curves = this->shown();
  if (curves == nullptr) return;
  const std::string name = array.toStdString();
  vtkSMProxy* view = this->view()->getProxy();
  if (vtkSMPVRepresentationProxy::GetUsingScalarColoring(curves)) {
    vtkSMPVRepresentationProxy::SetScalarBarVisibility(curves, view, false);  // the scalar bar of
                                                                              // the earlier array
  }
  vtkSMPVRepresentationProxy::SetScalarColoring(curves, name.c_str(), vtkDataObject::POINT);
  if (!name.empty()) {
    vtkSMPVRepresentationProxy::RescaleTransferFunctionToDataRange(curves);
    vtkSMPVRepresentationProxy::SetScalarBarVisibility(curves, view, true);
  }
  this->view()->render();
}

void pqTalwegOutcome::tell() {
  this->proxy()->UpdatePropertyInformation(this->property());
  const char* text = vtkSMPropertyHelper(this->property(), true).GetAsString();
  this->Text->setText(QString::fromUtf8(text == nullptr ? "" : text));
  this->Mend->setVisible(this->Text->text().contains("Tick Repair"));
  vtkSMProxy* curves = this->shown();
  if (curves == nullptr) return;
  if (curves != this->Watched) {  // follows choices under Coloring and Styling, and undo
    this->Watched = curves;
    for (const char* name : {"ColorArrayName", "LineWidth"}) {
      vtkSMProperty* looks = curves->GetProperty(name);
      if (looks != nullptr) {
        this->Events->Connect(looks, vtkCommand::ModifiedEvent, this, SLOT(tellLooks()));
      }
    }
  }
  this->tellLooks();
}

void pqTalwegOutcome::tellLooks() {
  vtkSMProxy* curves = this->shown();
  auto* width = this->findChild<QSpinBox*>("LineWidth");
  if (curves == nullptr || width == nullptr || curves->GetProperty("LineWidth") == nullptr) return;
  const QSignalBlocker quiet(width);
  width->setValue(vtkSMPropertyHelper(curves, "LineWidth").GetAsInt());
  auto* colour = this->findChild<QComboBox*>("CurveColour");
  const char* array =
      vtkSMPVRepresentationProxy::GetUsingScalarColoring(curves)
          ? vtkSMPropertyHelper(curves, "ColorArrayName").GetInputArrayNameToProcess()
          : "";
  if (colour->findData(array) < 0) colour->addItem(array, array);  // an array chosen under Coloring
  colour->setCurrentIndex(colour->findData(array));
}
