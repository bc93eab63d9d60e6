/**
 * The widget for clicked points: on the mesh in the view, clicks add points, points are dragged
 * over the surface, and a click on the first point closes the drawing. The mouse is intersected
 * with the filter's mesh, whatever else is shown.
 */
#ifndef pqTalwegDrawing_h
#define pqTalwegDrawing_h

#include <QPointer>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

#include "pqSplinePropertyWidget.h"

class QCheckBox;
class pqScopedUndoSet;
class vtkCallbackCommand;
class vtkObject;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkSMRenderViewProxy;

class pqTalwegDrawing : public pqSplinePropertyWidget {
  Q_OBJECT
  typedef pqSplinePropertyWidget Superclass;

 public:
  pqTalwegDrawing(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqTalwegDrawing() override;

  void setView(pqView* view) override;

 private:
  using Point = std::array<double, 3>;
  using Pixel = std::array<double, 2>;

  static void handle(vtkObject* caller, unsigned long event, void* self, void* data);
  /// True if the widget has handled the event, which no other object may get then.
  bool press();
  bool move();
  bool release();
  bool key();
  /// Lets a point follow the mouse. Auto Apply shows the curve during the drag, and one step of
  /// undo reverts the whole drag.
  void take(int point);
  void letGo();

  void watch(vtkRenderWindowInteractor* interactor);
  [[nodiscard]] bool isDrawing() const;
  [[nodiscard]] Pixel mouse() const;
  [[nodiscard]] Pixel seenAt(const Point& point) const;
  /// Asks the filter on its server; empty without an answer.
  [[nodiscard]] std::string ask(const char* question, const std::vector<double>& numbers) const;
  /// The place under a pixel at a depth from 0 to 1.
  [[nodiscard]] Point below(const Pixel& pixel, double depth) const;
  /// The first point of the filter's mesh on a ray.
  [[nodiscard]] std::optional<Point> meet(const Point& from, const Point& to) const;
  /// The point of the mesh under the mouse.
  [[nodiscard]] std::optional<Point> onMesh() const;
  /// Whether the mesh hides a place.
  [[nodiscard]] bool isHidden(const Point& place) const;
  /// The length of some pixels at a place.
  [[nodiscard]] double length(double pixels, const Point& place) const;
  [[nodiscard]] std::vector<Point> clicked() const;
  void give(const std::vector<Point>& points, int current);
  /// Both functions return -1 if there is none near the mouse.
  [[nodiscard]] int pointAt(const Pixel& mouse) const;
  [[nodiscard]] int segmentAt(const Pixel& mouse) const;
  /// Whether the shown points are applied to the filter.
  [[nodiscard]] bool isApplied() const;
  /// Points are drawn before the curve, which is drawn before the mesh. The last point is a ball
  /// like the others, since ParaView's cone would point into the mesh.
  void bringForward();
  /// ParaView's own widget would pick points and lines behind the mesh.
  void setOwnWidgetActive(bool active);
  [[nodiscard]] QCheckBox* closedBox() const;

  QCheckBox* Draw;
  vtkNew<vtkCallbackCommand> Command;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkRenderer> Rendered;
  vtkWeakPointer<vtkSMRenderViewProxy> RenderView;
  int Dragged = -1;                       // the point that follows the mouse
  bool Moved = false;                     // since the press
  std::optional<Pixel> Down;              // place of the press, if it was beside all points
  std::unique_ptr<pqScopedUndoSet> Step;  // the whole drag
};

#endif
