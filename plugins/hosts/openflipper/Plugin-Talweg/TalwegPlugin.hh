// The plugin with the functions for scripts. All other work is in the parts that the host link
// connects.
#pragma once

#include <OpenFlipper/BasePlugin/ScriptInterface.hh>

#include "HostLink.hh"

/// Slots of a base class would not become functions of the host's scripts.
class TalwegPlugin : public talweg::openflipper::HostLink, public ScriptInterface {
  Q_OBJECT
  Q_INTERFACES(ScriptInterface)
  Q_PLUGIN_METADATA(IID "org.OpenFlipper.Plugins.Plugin-Talweg")

 signals:
  // ScriptInterface
  void scriptInfo(QString _functionName);

 private slots:
  // BaseInterface
  void pluginsInitialized();

 public slots:
  QString version() { return QString("0.2.0"); }
  void noguiSupported() {}

  // Objects are given by their ids. ScriptHelp describes the functions to the host.
  bool draw(int meshId, IdList vertices, bool closed);
  bool addPoint(int meshId, int face, Vector barycentric);
  bool finishCurve(int meshId);
  bool closeCurve(int meshId);
  bool takeBackPoint(int meshId);
  bool dropCurve(int meshId);
  bool fromSelection(int meshId);
  bool fromFaceSelection(int meshId);
  bool fromFaceColours(int meshId);
  bool fromPolyLine(int meshId, int polyLineId);
  bool removeCurve(int meshId, int curve);
  bool clear(int meshId);
  bool movePoint(int meshId, int curve, int point, int face, Vector barycentric);
  bool setPinned(int meshId, int curve, int point, bool pinned);
  bool setClosed(int meshId, int curve, bool closed);
  bool renameCurve(int meshId, int curve, QString name);
  bool pinCurve(int meshId, int curve, bool pinned);
  bool continueCurve(int meshId, int curve);
  bool setCurveTau(int meshId, int curve, double tau);
  bool setCurveTolerance(int meshId, int curve, double tolerance);
  bool insertPoint(int meshId, int curve, int before, int face, Vector barycentric);
  bool removePoint(int meshId, int curve, int point);
  double measureCurve(int meshId, int curve, QString key);
  bool setTau(int meshId, double tau);
  bool setSlack(int meshId, double slack);
  bool setMaxDeviation(int meshId, double bound);
  bool setEnds(int meshId, QString ends);
  bool setClickDistance(int meshId, double distance);
  bool setRidges(int meshId, double strength);
  bool setRidgeKind(int meshId, QString kind);
  bool undoEdit(int meshId);
  bool redoEdit(int meshId);
  bool repairMesh(int meshId);
  IdList smooth(int meshId);
  QString report(int meshId);
  double measure(int meshId, QString key);
  QString lastError(int meshId);
  bool colourBy(int meshId, QString what);
  bool showComb(int meshId, bool with);
  Vector largest(int meshId, QString what);
  bool writeResult(int meshId, QString filename);
  bool writeDrawing(int meshId, QString filename);
  bool readDrawing(int meshId, QString filename);
  bool cut(int meshId);
  bool selectInside(int meshId);
  IdList split(int meshId, bool lids);
  IdList offset(int meshId, double distance, QString side);
  void drawMode(bool on);

 public:
  QString name() { return QString("Talweg"); }
  QString description() {
    return tr("Draws curves on meshes and smooths them while they stay close to the drawing.");
  }

 private:
  using Session = talweg::openflipper::Session;

  bool edit(int mesh_id, const std::function<void(talweg::editing::Editor&)>& change);
  /// The drawing on a mesh, after the thread has answered; null if there is none.
  Session* done(int mesh_id);
};
