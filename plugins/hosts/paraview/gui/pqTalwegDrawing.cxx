#include "pqTalwegDrawing.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QList>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include <vtkAbstractWidget.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkClientServerStream.h>
#include <vtkCommand.h>
#include <vtkCurveRepresentation.h>
#include <vtkMapper.h>
#include <vtkPVGeneralSettings.h>
#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSMNewWidgetRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMRenderViewProxy.h>
#include <vtkSMSession.h>

#include "../filter/depth_offset.hpp"
#include "pqUndoStack.h"
#include "pqView.h"
#include "properties_panel.hpp"
#include "talweg/editing/screen_line.hpp"

namespace {

constexpr double kNear = 9;     // pixels from a point
constexpr double kOnLine = 5;   // pixels from a line between points
constexpr double kOnCurve = 7;  // pixels from the middle of the curve, which is wider
constexpr double kClick = 3;    // pixels that a click may move
constexpr double kForward = 8;  // pixels; the curve is brought forward by half of this
constexpr float kBeforeOthers = 10;

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

pqTalwegDrawing::pqTalwegDrawing(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
    : Superclass(proxy, group, pqSplinePropertyWidget::POLYLINE, parent),
      Draw(new QCheckBox(tr("Draw on the mesh"), this)) {
  this->Draw->setObjectName("DrawOnMesh");
  this->Draw->setChecked(true);
  auto* hint = new QLabel(tr("A click adds a point; a click on the first closes the drawing. Drag "
                             "a point to move it; drag the curve to insert a point. Delete removes "
                             "the chosen point. Dragging anywhere else turns the view."),
                          this);
  hint->setWordWrap(true);
  if (auto* box = qobject_cast<QBoxLayout*>(this->layout())) {
    box->insertWidget(0, this->Draw);
    box->insertWidget(1, hint);
  } else if (auto* grid = qobject_cast<QGridLayout*>(this->layout())) {
    const int row = grid->rowCount();
    grid->addWidget(this->Draw, row, 0, 1, grid->columnCount());
    grid->addWidget(hint, row + 1, 0, 1, grid->columnCount());
  }
  this->Command->SetClientData(this);
  this->Command->SetCallback(handle);
  this->setLineColor(QColor(255, 200, 40));
  QObject::connect(this, &pqSplinePropertyWidget::pointsChanged, this,
                   [this] { this->bringForward(); });  // new points have new actors
}

pqTalwegDrawing::~pqTalwegDrawing() {
  this->Step.reset();
  this->watch(nullptr);
}

void pqTalwegDrawing::setView(pqView* view) {
  this->Superclass::setView(view);
  this->RenderView =
      view == nullptr ? nullptr : vtkSMRenderViewProxy::SafeDownCast(view->getProxy());
  this->bringForward();
  this->watch(this->RenderView == nullptr ? nullptr : this->RenderView->GetInteractor());
}

void pqTalwegDrawing::watch(vtkRenderWindowInteractor* interactor) {
  if (interactor == this->Interactor) return;
  this->letGo();
  if (this->Interactor != nullptr) this->Interactor->RemoveObserver(this->Command);
  if (this->Rendered != nullptr) this->Rendered->RemoveObserver(this->Command);
  this->Interactor = interactor;
  this->Rendered = interactor == nullptr ? nullptr : this->RenderView->GetRenderer();
  if (interactor == nullptr) return;
  if (this->Rendered != nullptr) {
    this->Rendered->AddObserver(vtkCommand::StartEvent, this->Command);
  }
  for (const auto event : {vtkCommand::LeftButtonPressEvent, vtkCommand::MouseMoveEvent,
                           vtkCommand::LeftButtonReleaseEvent, vtkCommand::KeyPressEvent}) {
    interactor->AddObserver(event, this->Command, kBeforeOthers);
  }
}

void pqTalwegDrawing::handle(vtkObject*, unsigned long event, void* self, void*) {
  auto& widget = *static_cast<pqTalwegDrawing*>(self);
  if (event == vtkCommand::StartEvent) return widget.bringForward();
  bool taken = false;
  if (event == vtkCommand::LeftButtonPressEvent) taken = widget.press();
  if (event == vtkCommand::MouseMoveEvent) taken = widget.move();
  if (event == vtkCommand::LeftButtonReleaseEvent) taken = widget.release();
  if (event == vtkCommand::KeyPressEvent) taken = widget.key();
  widget.Command->SetAbortFlag(taken ? 1 : 0);
}

bool pqTalwegDrawing::isDrawing() const {
  return this->Draw->isChecked() && this->isSelected() && this->isWidgetVisible() &&
         this->isVisible() && this->RenderView != nullptr;
}

void pqTalwegDrawing::take(int point) {
  this->Dragged = point;
  this->Step = std::make_unique<pqScopedUndoSet>(tr("Move a point"));
}

void pqTalwegDrawing::letGo() {
  this->Dragged = -1;
  if (!this->Step) return;
  if (vtkPVGeneralSettings::GetInstance()->GetAutoApply() && !this->isApplied()) {
    apply_panel_of(*this);  // a later change would be another step of undo
  }
  this->Step.reset();
}

bool pqTalwegDrawing::press() {
  this->letGo();
  this->Down.reset();
  this->Moved = false;
  const bool plain = this->Interactor->GetShiftKey() == 0 &&
                     this->Interactor->GetControlKey() == 0 && this->Interactor->GetAltKey() == 0;
  const bool ours = this->isDrawing() && plain;
  this->setOwnWidgetActive(!ours);
  if (!ours) return false;
  const Pixel at = this->mouse();
  const int point = this->pointAt(at);
  if (point >= 0) {
    this->take(point);
    this->setCurrentRow(point);
    return true;
  }
  const int segment = this->segmentAt(at);
  const std::optional<Point> place = segment < 0 ? std::nullopt : this->onMesh();
  if (!place) {
    this->Down = at;  // the start of a click, or of a turn of the view
    return false;
  }
  std::vector<Point> points = this->clicked();
  points.insert(points.begin() + segment + 1, *place);
  this->take(segment + 1);
  this->give(points, segment + 1);
  this->Moved = true;
  return true;
}

bool pqTalwegDrawing::move() {
  if (this->Dragged < 0) return false;
  const std::optional<Point> place = this->onMesh();
  if (!place) return true;
  std::vector<Point> points = this->clicked();
  if (static_cast<std::size_t>(this->Dragged) >= points.size()) return true;
  if (!this->Moved &&
      talweg::editing::distance(this->mouse(), this->seenAt(points[this->Dragged])) <= kClick)
    return true;
  points[static_cast<std::size_t>(this->Dragged)] = *place;
  this->give(points, this->Dragged);
  this->Moved = true;
  return true;
}

bool pqTalwegDrawing::release() {
  const int dragged = this->Dragged;
  const std::optional<Pixel> down = this->Down;
  this->letGo();
  this->Down.reset();
  if (dragged >= 0) {
    const bool closes = dragged == 0 && !this->Moved && this->clicked().size() > 2;
    if (closes && this->closedBox() != nullptr) this->closedBox()->setChecked(true);
    return true;
  }
  if (!down || talweg::editing::distance(*down, this->mouse()) > kClick) return false;
  const std::optional<Point> place = this->onMesh();
  if (!place) return false;
  std::vector<Point> points = this->clicked();
  points.push_back(*place);
  this->give(points, static_cast<int>(points.size()) - 1);
  return false;  // the view got the press, so it also needs the release
}

bool pqTalwegDrawing::key() {
  const char* symbol = this->Interactor->GetKeySym();
  const std::string name = symbol == nullptr ? "" : symbol;
  if (!this->isDrawing() || (name != "Delete" && name != "BackSpace")) return false;
  std::vector<Point> points = this->clicked();
  const int current = this->currentRow();
  if (current < 0 || static_cast<std::size_t>(current) >= points.size()) return true;
  points.erase(points.begin() + current);
  this->give(points, std::max(0, current - 1));
  return true;
}

pqTalwegDrawing::Pixel pqTalwegDrawing::mouse() const {
  const int* at = this->Interactor->GetEventPosition();
  return {static_cast<double>(at[0]), static_cast<double>(at[1])};
}

pqTalwegDrawing::Pixel pqTalwegDrawing::seenAt(const Point& point) const {
  vtkRenderer* renderer = this->RenderView->GetRenderer();
  renderer->SetWorldPoint(point[0], point[1], point[2], 1);
  renderer->WorldToDisplay();
  const double* at = renderer->GetDisplayPoint();
  return {at[0], at[1]};
}

std::string pqTalwegDrawing::ask(const char* question, const std::vector<double>& numbers) const {
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this->proxy()) << question;
  for (const double number : numbers) stream << number;
  stream << vtkClientServerStream::End;
  vtkSMSession* session = this->proxy()->GetSession();
  session->ExecuteStream(this->proxy()->GetLocation(), stream, false);
  const vtkClientServerStream& result = session->GetLastResult(this->proxy()->GetLocation());
  const char* text = nullptr;
  if (result.GetArgument(0, 0, &text) && text != nullptr) return text;
  int number = 0;
  return result.GetArgument(0, 0, &number) ? std::to_string(number) : "";
}

pqTalwegDrawing::Point pqTalwegDrawing::below(const Pixel& pixel, double depth) const {
  vtkRenderer* renderer = this->RenderView->GetRenderer();
  renderer->SetDisplayPoint(pixel[0], pixel[1], depth);
  renderer->DisplayToWorld();
  const double* x = renderer->GetWorldPoint();
  return {x[0] / x[3], x[1] / x[3], x[2] / x[3]};
}

std::optional<pqTalwegDrawing::Point> pqTalwegDrawing::meet(const Point& from,
                                                            const Point& to) const {
  std::istringstream numbers(this->ask("Pick", {from[0], from[1], from[2], to[0], to[1], to[2]}));
  Point place = {};
  if (!(numbers >> place[0] >> place[1] >> place[2])) return std::nullopt;
  return place;
}

std::optional<pqTalwegDrawing::Point> pqTalwegDrawing::onMesh() const {
  const Pixel at = this->mouse();
  return this->meet(this->below(at, 0), this->below(at, 1));
}

double pqTalwegDrawing::length(double pixels, const Point& place) const {
  vtkRenderer* renderer = this->RenderView->GetRenderer();
  renderer->SetWorldPoint(place[0], place[1], place[2], 1);
  renderer->WorldToDisplay();
  const std::array<double, 3> at = {renderer->GetDisplayPoint()[0], renderer->GetDisplayPoint()[1],
                                    renderer->GetDisplayPoint()[2]};
  return distance(place, this->below({at[0] + pixels, at[1]}, at[2]));
}

bool pqTalwegDrawing::isHidden(const Point& place) const {
  const std::optional<Point> before = this->meet(this->below(this->seenAt(place), 0), place);
  return before && distance(*before, place) > this->length(kNear, place);
}

std::vector<pqTalwegDrawing::Point> pqTalwegDrawing::clicked() const {
  const QList<QVariant> numbers = this->points();
  std::vector<Point> result;
  for (int k = 0; k + 2 < numbers.size(); k += 3) {
    result.push_back({numbers[k].toDouble(), numbers[k + 1].toDouble(), numbers[k + 2].toDouble()});
  }
  return result;
}

void pqTalwegDrawing::give(const std::vector<Point>& points, int current) {
  QList<QVariant> numbers;
  for (const Point& point : points) {
    for (const double x : point) numbers.push_back(x);
  }
  this->setPoints(numbers);
  this->setCurrentRow(current);
  this->render();
}

int pqTalwegDrawing::pointAt(const Pixel& mouse) const {
  const std::vector<Point> points = this->clicked();
  int found = -1;
  double nearest = kNear;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double apart = talweg::editing::distance(mouse, this->seenAt(points[k]));
    if (apart >= nearest || this->isHidden(points[k])) continue;
    nearest = apart;
    found = static_cast<int>(k);
  }
  return found;
}

int pqTalwegDrawing::segmentAt(const Pixel& mouse) const {
  std::vector<Point> points = this->clicked();
  if (points.size() < 2) return -1;
  if (this->closedBox() != nullptr && this->closedBox()->isChecked()) points.push_back(points[0]);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto near = talweg::editing::nearest_segment(
        {this->seenAt(points[k]), this->seenAt(points[k + 1])}, false, mouse);
    if (near.away >= kOnLine) continue;
    Point place;
    for (std::size_t i = 0; i < 3; ++i) {
      place[i] = points[k][i] + near.along * (points[k + 1][i] - points[k][i]);
    }
    if (!this->isHidden(place)) return static_cast<int>(k);
  }
  // The lines between points are often below the mesh; the user sees the curve.
  const std::optional<Point> place = this->onMesh();
  if (!place || !this->isApplied()) return -1;
  const std::string segment = this->ask(
      "SegmentAt", {(*place)[0], (*place)[1], (*place)[2], this->length(kOnCurve, *place)});
  return segment.empty() ? -1 : std::stoi(segment);
}

bool pqTalwegDrawing::isApplied() const {
  const vtkSMPropertyHelper given(this->proxy(), "Points");
  const QList<QVariant> shown = this->points();
  if (given.GetNumberOfElements() != static_cast<unsigned>(shown.size())) return false;
  for (int k = 0; k < shown.size(); ++k) {
    if (given.GetAsDouble(static_cast<unsigned>(k)) != shown[k].toDouble()) return false;
  }
  return true;
}

void pqTalwegDrawing::bringForward() {
  vtkSMNewWidgetRepresentationProxy* widget = this->widgetProxy();
  vtkSMProxy* shown = widget == nullptr ? nullptr : widget->GetRepresentationProxy();
  auto* prop = shown == nullptr ? nullptr : vtkProp::SafeDownCast(shown->GetClientSideObject());
  if (prop == nullptr) return;
  auto* curve = vtkCurveRepresentation::SafeDownCast(prop);
  if (curve != nullptr) curve->SetDirectional(false);
  vtkRenderer* renderer = this->RenderView == nullptr ? nullptr : this->RenderView->GetRenderer();
  if (renderer == nullptr) return;
  vtkNew<vtkPropCollection> parts;
  prop->GetActors(parts);
  for (int k = 0; k < parts->GetNumberOfItems(); ++k) {
    auto* part = vtkActor::SafeDownCast(parts->GetItemAsObject(k));
    if (part == nullptr || part->GetMapper() == nullptr) continue;
    const double units = talweg::paraview::forward_by(kForward, part->GetCenter(), *renderer);
    part->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, units);
  }
}

void pqTalwegDrawing::setOwnWidgetActive(bool active) {
  vtkSMNewWidgetRepresentationProxy* widget = this->widgetProxy();
  if (widget == nullptr || widget->GetWidget() == nullptr) return;
  widget->GetWidget()->SetProcessEvents(active ? 1 : 0);
}

QCheckBox* pqTalwegDrawing::closedBox() const { return this->findChild<QCheckBox*>("Closed"); }
