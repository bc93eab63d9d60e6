/**
 * The widget for clicked points: on the mesh in the view, clicks add points, points are dragged
 * over the surface, and a click on the first one closes the drawing. What the mouse meets is found
 * in the filter's mesh, whatever else is shown.
 */
#ifndef pqTalwegDrawing_h
#define pqTalwegDrawing_h

#include <QPointer>
#include <array>
#include <optional>
#include <vector>

#include <vtkNew.h>
#include <vtkWeakPointer.h>

#include "pqSplinePropertyWidget.h"

class QCheckBox;
class vtkCallbackCommand;
class vtkObject;
class vtkRenderWindowInteractor;
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

  void watch(vtkRenderWindowInteractor* interactor);
  [[nodiscard]] bool isDrawing() const;
  [[nodiscard]] Pixel mouse() const;
  [[nodiscard]] Pixel seenAt(const Point& point) const;
  /// Where the mouse meets the filter's mesh.
  [[nodiscard]] std::optional<Point> onMesh();
  [[nodiscard]] std::vector<Point> clicked() const;
  void give(const std::vector<Point>& points, int current);
  /// -1: none near the mouse.
  [[nodiscard]] int pointAt(const Pixel& mouse) const;
  [[nodiscard]] int segmentAt(const Pixel& mouse) const;
  [[nodiscard]] QCheckBox* closedBox() const;

  QCheckBox* Draw;
  vtkNew<vtkCallbackCommand> Command;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkSMRenderViewProxy> RenderView;
  int Dragged = -1;           // the point that follows the mouse
  bool Moved = false;         // since the button went down
  std::optional<Pixel> Down;  // where it did, beside all points
};

#endif
