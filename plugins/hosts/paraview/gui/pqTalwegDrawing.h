/**
 * The widget for clicked points: on the mesh in the view, clicks add points, points are dragged
 * over the surface, and a click on the first one closes the drawing. What the mouse meets is found
 * in the filter's mesh, whatever else is shown.
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
  /// True if the event was ours and nobody else shall have it.
  bool press();
  bool move();
  bool release();
  bool key();
  /// From now on a point follows the mouse; Auto Apply shows the curve meanwhile, and one step of
  /// undo takes all of it back.
  void take(int point);
  void letGo();

  void watch(vtkRenderWindowInteractor* interactor);
  [[nodiscard]] bool isDrawing() const;
  [[nodiscard]] Pixel mouse() const;
  [[nodiscard]] Pixel seenAt(const Point& point) const;
  /// Asks the filter on its server; empty if it has no answer.
  [[nodiscard]] std::string ask(const char* question, const std::vector<double>& numbers) const;
  /// The place under a pixel at a depth from 0 to 1.
  [[nodiscard]] Point below(const Pixel& pixel, double depth) const;
  /// Where a ray meets the filter's mesh.
  [[nodiscard]] std::optional<Point> meet(const Point& from, const Point& to) const;
  /// Where the mouse meets it.
  [[nodiscard]] std::optional<Point> onMesh() const;
  /// Whether the mesh is before a place.
  [[nodiscard]] bool isHidden(const Point& place) const;
  /// How long some pixels are there.
  [[nodiscard]] double length(double pixels, const Point& place) const;
  [[nodiscard]] std::vector<Point> clicked() const;
  void give(const std::vector<Point>& points, int current);
  /// -1: none near the mouse.
  [[nodiscard]] int pointAt(const Pixel& mouse) const;
  [[nodiscard]] int segmentAt(const Pixel& mouse) const;
  /// Whether the filter has the points that are shown.
  [[nodiscard]] bool isApplied() const;
  /// Points are drawn before the curve, which is drawn before the mesh. The last one is a ball as
  /// the others are: ParaView's cone would point into the mesh.
  void bringForward();
  /// ParaView's own widget would take hold of points and lines behind the mesh.
  void setOwnWidgetActive(bool active);
  [[nodiscard]] QCheckBox* closedBox() const;

  QCheckBox* Draw;
  vtkNew<vtkCallbackCommand> Command;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkRenderer> Rendered;
  vtkWeakPointer<vtkSMRenderViewProxy> RenderView;
  int Dragged = -1;                       // the point that follows the mouse
  bool Moved = false;                     // since the button went down
  std::optional<Pixel> Down;              // where it did, beside all points
  std::unique_ptr<pqScopedUndoSet> Step;  // all of a drag
};

#endif
