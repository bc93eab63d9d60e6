#include "ProbePlugin.hh"

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollArea>
#include <QSlider>
#include <QTreeWidget>
#include <cmath>

#include <ACG/Scenegraph/LineNode.hh>
#include <ACG/Scenegraph/PointNode.hh>
#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>
// clang-format off
#include <OpenFlipper/common/ObjectTypeDLLDefines.hh>
#include <ObjectTypes/TriangleMesh/TriangleMesh.hh>
#include <ObjectTypes/TriangleMesh/PluginFunctionsTriangleMesh.hh>
// clang-format on

namespace {

bool is_view(QObject* watched) {
  return watched->parent() != nullptr && watched->parent()->inherits("QGraphicsView");
}

/// "x y width height" on the screen.
QString place_of(const QWidget& widget) {
  const QPoint at = widget.mapToGlobal(QPoint(0, 0));
  return QString("%1 %2 %3 %4").arg(at.x()).arg(at.y()).arg(widget.width()).arg(widget.height());
}

QWidget* widget_of(const QString& name) {
  for (QWidget* widget : QApplication::allWidgets()) {
    if (widget->objectName() == name) return widget;
  }
  return nullptr;
}

void scroll_to(QWidget& widget) {
  for (QWidget* parent = widget.parentWidget(); parent != nullptr;
       parent = parent->parentWidget()) {
    if (auto* area = qobject_cast<QScrollArea*>(parent)) area->ensureWidgetVisible(&widget);
  }
}

/// The text of a label, or the rows of a list.
QString text_of(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  const auto* list = qobject_cast<const QTreeWidget*>(&widget);
  QStringList rows;
  for (int row = 0; list != nullptr && row < list->topLevelItemCount(); ++row) {
    const QTreeWidgetItem* item = list->topLevelItem(row);
    QStringList cells(item->isSelected() ? "selected" : "row");
    for (int column = 0; column < list->columnCount(); ++column) cells << item->text(column);
    rows << cells.join(' ');
  }
  return rows.join(", ");
}

/// A visible node of the scene; null if the node or one above it is hidden.
template <class Node>
Node* shown(const char* name) {
  ACG::SceneGraph::BaseNode* found = PluginFunctions::getSceneGraphRootNode()->find(name);
  for (ACG::SceneGraph::BaseNode* node = found; node != nullptr; node = node->parent()) {
    if (node->status() == ACG::SceneGraph::BaseNode::HideSubtree) return nullptr;
  }
  return dynamic_cast<Node*>(found);
}

double longest_segment(const ACG::SceneGraph::LineNode& lines) {
  double longest = 0;
  for (std::size_t k = 0; k + 1 < lines.n_points(); k += 2) {
    longest = std::max(longest, (lines.points()[k + 1] - lines.points()[k]).norm());
  }
  return longest;
}

/// The longest edge of the mesh. A segment on the surface is not longer; a chord through the body
/// is.
double longest_edge() {
  double longest = 0;
  for (PluginFunctions::ObjectIterator it(PluginFunctions::ALL_OBJECTS, DATA_TRIANGLE_MESH);
       it != PluginFunctions::objectsEnd(); ++it) {
    const TriMesh& mesh = *PluginFunctions::triMesh(*it);
    for (const auto e : mesh.edges()) longest = std::max(longest, mesh.calc_edge_length(e));
  }
  return longest;
}

}  // namespace

void ProbePlugin::pluginsInitialized() {
  clock_.start();
  if (!OpenFlipper::Options::gui()) return;
  qApp->installEventFilter(this);
  connect(&asked_, &QTimer::timeout, this, &ProbePlugin::answer);
  if (qEnvironmentVariableIsSet("TALWEG_PROBE")) asked_.start(50);
}

bool ProbePlugin::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Move && watched->objectName().startsWith("talweg")) {
    const auto* widget = static_cast<QWidget*>(watched);
    emit log(LOGINFO, "WIDGET " + widget->objectName() + " " + place_of(*widget));
  }
  const bool view = is_view(watched);
  if (event->type() == QEvent::Paint && view && !painting_) {
    painting_ = true;
    const qint64 before = clock_.nsecsElapsed();
    QCoreApplication::sendEvent(watched, event);
    paint_ms_ += static_cast<double>(clock_.nsecsElapsed() - before) / 1e6;
    painting_ = false;
    tell_scene();
    return true;
  }
  const bool slider = qobject_cast<QSlider*>(watched) != nullptr;
  if (!what_.isEmpty() || (!view && !slider)) return false;
  if (event->type() == QEvent::MouseButtonPress && view) what_ = "press";
  if (event->type() == QEvent::MouseMove && static_cast<QMouseEvent*>(event)->buttons() != 0) {
    what_ = slider ? "slider" : "move";
  }
  began_ms_ = static_cast<double>(clock_.nsecsElapsed()) / 1e6;
  paint_ms_ = 0;
  return false;
}

void ProbePlugin::slotObjectUpdated(int _identifier, const UpdateType& _type) {
  if (what_.isEmpty() || !_type.contains(UPDATE_GEOMETRY)) return;
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::getObject(_identifier, object) || !object->name().contains("smoothed")) {
    return;
  }
  const double ms = static_cast<double>(clock_.nsecsElapsed()) / 1e6 - began_ms_;
  emit log(LOGINFO, QString("CLOCK %1 %2 ms, besides %3 ms for pictures")
                        .arg(what_)
                        .arg(ms - paint_ms_, 0, 'f', 1)
                        .arg(paint_ms_, 0, 'f', 1));
  what_.clear();
}

/// Logs the nodes of the drawing in the last picture.
void ProbePlugin::tell_scene() {
  using ACG::SceneGraph::LineNode;
  using ACG::SceneGraph::PointNode;
  const auto* lines = shown<LineNode>("Talweg: drawn lines");
  const auto* leg = shown<LineNode>("Talweg: next leg");
  const auto* points = shown<PointNode>("Talweg: points");
  const auto* comb = shown<LineNode>("Talweg: comb");
  QString scene = "SCENE nothing drawn";
  if (lines != nullptr && leg != nullptr && points != nullptr && comb != nullptr) {
    scene = QString("SCENE drawn %1 leg %2 points %3 comb %4")
                .arg(lines->n_points() / 2)
                .arg(leg->n_points() / 2)
                .arg(points->n_points())
                .arg(comb->n_points() / 2);
    if (scene == scene_) return;
    const double longest = std::max(longest_segment(*lines), longest_segment(*leg));
    emit log(LOGINFO, longest <= longest_edge() * 1.000001 ? "ON THE SURFACE" : "OFF THE SURFACE");
  }
  if (scene == scene_) return;
  scene_ = scene;
  emit log(LOGINFO, scene);
}

QString ProbePlugin::widgetPosition(QString name) {
  if (OpenFlipper::Options::nogui()) return {};
  QApplication::processEvents();  // pending layouts
  const QWidget* widget = widget_of(name);
  return widget == nullptr ? QString() : place_of(*widget);
}

void ProbePlugin::answer() {
  QFile file(qEnvironmentVariable("TALWEG_PROBE"));
  if (!file.open(QIODevice::ReadOnly)) return;
  const QString name = QString::fromUtf8(file.readAll()).trimmed();
  if (name.isEmpty()) return;  // the file is still being written
  if (QWidget* widget = widget_of(name)) {
    scroll_to(*widget);
    QApplication::processEvents();
    emit log(LOGINFO, "WIDGET " + name + " " + place_of(*widget));
    emit log(LOGINFO, "TEXT " + name + ": " + text_of(*widget));
  }
  file.remove();
}

QString ProbePlugin::screenPosition(int meshId, int vertex) {
  TriMeshObject* object = nullptr;
  if (OpenFlipper::Options::nogui() || !PluginFunctions::getObject(meshId, object)) return {};
  const TriMesh& mesh = *object->mesh();
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= mesh.n_vertices()) return {};
  auto& state = PluginFunctions::viewerProperties(0).glState();
  const ACG::Vec3d s = state.project(mesh.point(TriMesh::VertexHandle(vertex)));
  QPoint origin;  // top left corner of the viewer
  for (const QWidget* widget : QApplication::allWidgets()) {
    if (!widget->inherits("QGraphicsView") || !widget->isVisible()) continue;
    origin = widget->mapToGlobal(QPoint(0, 0));
    break;
  }
  return QString("%1 %2")
      .arg(origin.x() + std::lround(s[0]))
      .arg(origin.y() + std::lround(state.context_height() - s[1]));
}
