// The plugin as a class of OpenFlipper's interfaces: their signals and slots, and the calls of the
// plugin's parts to the host. The class also connects these parts.
#pragma once

#include <QObject>
#include <QTimer>
#include <QTranslator>

#include <OpenFlipper/BasePlugin/BackupInterface.hh>
#include <OpenFlipper/BasePlugin/BaseInterface.hh>
#include <OpenFlipper/BasePlugin/ContextMenuInterface.hh>
#include <OpenFlipper/BasePlugin/LoadSaveInterface.hh>
#include <OpenFlipper/BasePlugin/LoggingInterface.hh>
#include <OpenFlipper/BasePlugin/MouseInterface.hh>
#include <OpenFlipper/BasePlugin/PickingInterface.hh>
#include <OpenFlipper/BasePlugin/ProcessInterface.hh>
#include <OpenFlipper/BasePlugin/StatusbarInterface.hh>
#include <OpenFlipper/BasePlugin/ToolboxInterface.hh>
#include <OpenFlipper/common/Types.hh>

#include "PanelLink.hh"

namespace talweg::openflipper {

class HostLink : public QObject,
                 public BaseInterface,
                 public BackupInterface,
                 public ContextMenuInterface,
                 public LoadSaveInterface,
                 public LoggingInterface,
                 public MouseInterface,
                 public PickingInterface,
                 public ProcessInterface,
                 public StatusbarInterface,
                 public ToolboxInterface,
                 protected HostCalls {
  Q_OBJECT
  Q_INTERFACES(BaseInterface)
  Q_INTERFACES(BackupInterface)
  Q_INTERFACES(ContextMenuInterface)
  Q_INTERFACES(LoadSaveInterface)
  Q_INTERFACES(LoggingInterface)
  Q_INTERFACES(MouseInterface)
  Q_INTERFACES(PickingInterface)
  Q_INTERFACES(ProcessInterface)
  Q_INTERFACES(StatusbarInterface)
  Q_INTERFACES(ToolboxInterface)

 signals:
  // BaseInterface
  void updateView();
  void updatedObject(int _identifier, const UpdateType& _type);
  void setSlotDescription(QString _slotName, QString _slotDescription, QStringList _parameters,
                          QStringList _descriptions);
  // BackupInterface
  void createBackup(int _objectid, QString _name, UpdateType _type = UPDATE_ALL);
  void undo(int _objectid);
  void redo(int _objectid);
  // ContextMenuInterface
  void addContextMenuItem(QAction* _action, DataType _objectType, ContextMenuType _type);
  // LoadSaveInterface
  void addEmptyObject(DataType _type, int& _id);
  void deleteObject(int _id);
  // LoggingInterface
  void log(Logtype _type, QString _message);
  void log(QString _message);
  // PickingInterface
  void addHiddenPickMode(const std::string& _mode);
  void setPickModeCursor(const std::string& _mode, QCursor _cursor);
  void setPickModeMouseTracking(const std::string& _mode, bool _mouseTracking);
  // ProcessInterface
  void startJob(QString _jobId, QString _description, int _min, int _max, bool _blocking = false);
  void setJobState(QString _jobId, int _value);
  void finishJob(QString _jobId);
  void setJobName(QString _jobId, QString _name);  // unused, but the host expects it
  void setJobDescription(QString _jobId, QString _description);
  // StatusbarInterface
  void showStatusMessage(QString _message, int _timeout = 0);
  void clearStatusMessage();
  // ToolboxInterface
  void addToolbox(QString _name, QWidget* _widget, QIcon* _icon);

 protected slots:
  // BaseInterface
  void initializePlugin();
  void pluginsInitialized();
  void slotObjectUpdated(int _identifier, const UpdateType& _type);
  void slotAllCleared();
  void slotVisibilityChanged(int _identifier);
  // LoadSaveInterface
  void objectDeleted(int _id);
  // MouseInterface
  void slotMouseEvent(QMouseEvent* _event);
  // PickingInterface
  void slotPickModeChanged(const std::string& _mode);
  // ProcessInterface
  void canceledJob(QString _job);
  // ContextMenuInterface
  void slotUpdateContextMenu(int _objectId);

  void look_at_sessions();  ///< the threads may have answers
  void look_at_progress();

 public slots:
  void exit();

 protected:
  // HostCalls
  int add_line(const QString& name) override;
  void show_line(int id) override;
  void show_colours(int id) override;
  void show_selection(int id) override;
  void show_mesh(int id) override;
  int add_mesh(const QString& name, TriMesh&& mesh) override;
  void remove_object(int id) override;
  void push_backup(int id, const QString& name) override;
  bool host_undo(int id) override;
  bool host_redo(int id) override;
  void say(const QString& sentence) override;
  void warn(const QString& sentence) override;
  void tell(const QString& sentence) override { emit showStatusMessage(sentence, 3000); }
  void hint(const QString& sentence, bool on_something) override;
  void changed() override;
  void redraw() override { emit updateView(); }
  void look_at(const ACG::Vec3d& place, const ACG::Vec3d& normal) override;
  void wake() override;

  Sessions sessions_{*this};
  DrawingHand hand_{sessions_, *this};

 private:
  void speak_the_hosts_language();
  void make_menus();
  void tell_updated(int id, const UpdateType& type);

  PanelLink* panel_ = nullptr;  // null without a window
  QAction *draw_action_ = nullptr, *selection_action_ = nullptr, *line_action_ = nullptr;
  QMenu *mesh_menu_ = nullptr, *line_menu_ = nullptr;
  int menu_object_ = -1;
  QTimer timer_;
  QTranslator translator_;
  double busy_since_ = 0;
  bool job_shown_ = false;
  bool updating_ = false;  // the update that the host reports was made by this plugin
  QString hint_;
};

}  // namespace talweg::openflipper
