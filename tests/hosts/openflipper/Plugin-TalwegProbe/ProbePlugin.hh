// The probe is a plugin of the host for tests. It observes Plugin-Talweg from outside: the places
// of its widgets, the place of a vertex on the screen, the objects of the drawing in the scene, and
// the time from a movement of the mouse until a smoothed line changes. Scripts call it
// "talwegprobe"; it writes the scene and the times to the log. A name in the file TALWEG_PROBE
// requests a widget: the probe scrolls to it, and writes its place and its text to the log.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <OpenFlipper/BasePlugin/BaseInterface.hh>
#include <OpenFlipper/BasePlugin/LoggingInterface.hh>
#include <OpenFlipper/BasePlugin/ScriptInterface.hh>
#include <OpenFlipper/BasePlugin/ViewInterface.hh>
#include <OpenFlipper/common/Types.hh>

class ProbePlugin : public QObject,
                    BaseInterface,
                    LoggingInterface,
                    ScriptInterface,
                    ViewInterface {
  Q_OBJECT
  Q_INTERFACES(BaseInterface)
  Q_INTERFACES(LoggingInterface)
  Q_INTERFACES(ScriptInterface)
  Q_INTERFACES(ViewInterface)
  Q_PLUGIN_METADATA(IID "org.OpenFlipper.Plugins.Plugin-TalwegProbe")

 signals:
  void updateView();
  void updatedObject(int _identifier, const UpdateType& _type);
  void setSlotDescription(QString _slotName, QString _slotDescription, QStringList _parameters,
                          QStringList _descriptions);
  void log(Logtype _type, QString _message);
  void log(QString _message);
  void scriptInfo(QString _functionName);

 private slots:
  void pluginsInitialized();
  void slotObjectUpdated(int _identifier, const UpdateType& _type);
  void slotViewChanged() { emit log(LOGINFO, "VIEW CHANGED"); }

 public slots:
  QString version() { return QString("0.1.0"); }
  void noguiSupported() {}

  /// "x y width height" on the screen. The log has it whenever a part of the panel moves.
  QString widgetPosition(QString name);
  /// "x y" in the window of the host.
  QString screenPosition(int meshId, int vertex);

 public:
  QString name() { return QString("TalwegProbe"); }
  QString description() { return QString("For tests of Plugin-Talweg."); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void tell_scene();
  void answer();
  QElapsedTimer clock_;
  QTimer asked_;
  QString what_;         // the movement that no line has followed yet; empty: none
  double began_ms_ = 0;  // the time of the movement
  double paint_ms_ = 0;  // time that the host has spent on painting since
  bool painting_ = false;
  QString scene_;  // as last written to the log
};
