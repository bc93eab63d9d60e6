#include "pqTalwegAbort.h"

#include <QGuiApplication>
#include <QToolButton>
#include <QWidget>

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkSMProxy.h>

#include "pqCoreUtilities.h"
#include "pqProgressWidget.h"

namespace {

constexpr qint64 kSoon = 300;  // milliseconds; a shorter run needs no abort button

}  // namespace

pqTalwegAbort::pqTalwegAbort(vtkSMProxy& filter)
    : Filter(vtkAlgorithm::SafeDownCast(filter.GetClientSideObject())) {
  this->Command->SetClientData(this);
  this->Command->SetCallback(handle);
  if (this->Filter == nullptr || QGuiApplication::platformName() != "xcb") return;
  for (const auto event : {vtkCommand::StartEvent, vtkCommand::ProgressEvent, vtkCommand::EndEvent})
    this->Filter->AddObserver(event, this->Command);
}

pqTalwegAbort::~pqTalwegAbort() {
  if (this->Filter != nullptr) this->Filter->RemoveObserver(this->Command);
}

void pqTalwegAbort::handle(vtkObject*, unsigned long event, void* self, void*) {
  auto& abort = *static_cast<pqTalwegAbort*>(self);
  if (event == vtkCommand::StartEvent) abort.Since.start();
  if (event == vtkCommand::ProgressEvent) abort.step();
  if (event != vtkCommand::EndEvent) return;
  abort.close();
  if (abort.Stopped) abort.Filter->SetAbortExecute(0);  // otherwise the filter would never run
                                                        // again
  abort.Stopped = false;
}

void pqTalwegAbort::step() {
  if (this->Window == nullptr && this->Since.isValid() && this->Since.elapsed() > kSoon) {
    this->open();
  }
  if (this->Window == nullptr || !this->Window->clicked()) return;
  this->Filter->SetAbortExecute(1);
  this->Stopped = true;
  this->close();
}

void pqTalwegAbort::open() {
  QWidget* main = pqCoreUtilities::mainWidget();
  auto* progress = main == nullptr ? nullptr : main->findChild<pqProgressWidget*>();
  this->Button = progress == nullptr ? nullptr : progress->abortButton();
  if (this->Button == nullptr || !this->Button->isVisible()) return;
  const QWidget* window = this->Button->nativeParentWidget();
  if (window == nullptr) return;
  const double scale = window->devicePixelRatioF();
  const QPoint corner = this->Button->mapTo(const_cast<QWidget*>(window), QPoint(0, 0));
  this->Window = talweg::paraview::ClickWindow::make(
      static_cast<std::uint32_t>(window->winId()), qRound(corner.x() * scale),
      qRound(corner.y() * scale), qRound(this->Button->width() * scale),
      qRound(this->Button->height() * scale));
  if (this->Window == nullptr) return;
  this->Button->setEnabled(true);
  this->Button->repaint();
}

void pqTalwegAbort::close() {
  this->Since.invalidate();
  if (this->Window == nullptr) return;
  this->Window.reset();
  if (this->Button == nullptr) return;
  this->Button->setEnabled(false);
  this->Button->repaint();
}
