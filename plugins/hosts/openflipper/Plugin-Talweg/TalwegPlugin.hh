// This is the plugin as OpenFlipper sees it.
#pragma once

#include <QObject>
#include <QTimer>
#include <QTranslator>
#include <map>
#include <memory>

#include <OpenFlipper/BasePlugin/BackupInterface.hh>
#include <OpenFlipper/BasePlugin/BaseInterface.hh>
#include <OpenFlipper/BasePlugin/ContextMenuInterface.hh>
#include <OpenFlipper/BasePlugin/LoadSaveInterface.hh>
#include <OpenFlipper/BasePlugin/LoggingInterface.hh>
#include <OpenFlipper/BasePlugin/MouseInterface.hh>
#include <OpenFlipper/BasePlugin/PickingInterface.hh>
#include <OpenFlipper/BasePlugin/ProcessInterface.hh>
#include <OpenFlipper/BasePlugin/ScriptInterface.hh>
#include <OpenFlipper/BasePlugin/StatusbarInterface.hh>
#include <OpenFlipper/BasePlugin/ToolboxInterface.hh>
#include <OpenFlipper/common/Types.hh>

#include "Session.hh"
#include "TalwegPanel.hh"
#include "ViewHand.hh"

class TalwegPlugin : public QObject,
                     BaseInterface,
                     BackupInterface,
                     ContextMenuInterface,
                     LoadSaveInterface,
                     LoggingInterface,
                     MouseInterface,
                     PickingInterface,
                     ProcessInterface,
                     ScriptInterface,
                     StatusbarInterface,
                     ToolboxInterface,
                     talweg::openflipper::HostCalls {
  Q_OBJECT
  Q_INTERFACES(BaseInterface)
  Q_INTERFACES(BackupInterface)
  Q_INTERFACES(ContextMenuInterface)
  Q_INTERFACES(LoadSaveInterface)
  Q_INTERFACES(LoggingInterface)
  Q_INTERFACES(MouseInterface)
  Q_INTERFACES(PickingInterface)
  Q_INTERFACES(ProcessInterface)
  Q_INTERFACES(ScriptInterface)
  Q_INTERFACES(StatusbarInterface)
  Q_INTERFACES(ToolboxInterface)
  Q_PLUGIN_METADATA(IID "org.OpenFlipper.Plugins.Plugin-Talweg")

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
  void setJobName(QString _jobId, QString _name);  // not used, but missed by the host
  void setJobDescription(QString _jobId, QString _description);
  // ScriptInterface
  void scriptInfo(QString _functionName);
  // StatusbarInterface
  void showStatusMessage(QString _message, int _timeout = 0);
  void clearStatusMessage();
  // ToolboxInterface
  void addToolbox(QString _name, QWidget* _widget, QIcon* _icon);

 private slots:
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

  void look_at_sessions();  ///< the threads have something
  void look_at_progress();

 public slots:
  QString version() { return QString("0.2.0"); }
  void noguiSupported() {}
  void exit();

  // Scripting, described to the host in describe_slots(). Objects by their ids.
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
  void drawMode(bool on);

 public:
  ~TalwegPlugin() override;
  QString name() { return QString("Talweg"); }
  QString description() {
    return tr("Draws curves on meshes and smooths them while they stay close to the drawing.");
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Session = talweg::openflipper::Session;
  static constexpr const char* kPickMode = "Talweg: draw";
  struct Handle {
    std::size_t curve, point;
  };

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
  void changed() override;
  void redraw() override { emit updateView(); }
  void look_at(const ACG::Vec3d& place, const ACG::Vec3d& normal) override;
  void wake() override;

  void speak_the_hosts_language();
  void make_panel();
  void connect_panel();
  void connect_curves();
  void connect_look();
  void make_menus();
  void describe_slots();
  void describe_curve_slots();
  void describe_look_slots();
  [[nodiscard]] static talweg::openflipper::LookState look_state(const Session& session);
  /// Parameters and their meanings are separated by ';'.
  void describe(const char* slot, const QString& what, const char* parameters,
                const QString& meanings);
  /// The drawing on a mesh, begun where there is none; null, and told, where that cannot be.
  Session* session_of(int mesh_id);
  [[nodiscard]] Session* existing(int mesh_id);
  Session* target_session();
  bool edit(int mesh_id, const std::function<void(talweg::editing::Editor&)>& change);
  bool edit_now(const std::function<void(talweg::editing::Editor&)>& change);
  void edit_selected(
      const std::function<void(talweg::editing::Editor&, std::size_t curve)>& change);
  void begin_gesture(const QString& name);
  void end_gesture();
  void show_points(bool with);
  void use(const std::function<void(Session&)>& work);
  void from_lines();
  void ask_for_file(bool write, bool result);
  [[nodiscard]] talweg::editing::Settings saved_settings() const;
  void save_settings(const talweg::editing::Settings& settings) const;

  // Drawing with the mouse.
  [[nodiscard]] bool in_draw_mode() const;
  struct CurvePlace {
    std::size_t curve;
    const talweg::host::Curve* line;  // on which it was met; until the session changes
    std::size_t segment;              // of that
  };
  void press(const QMouseEvent& event);
  void press_point(Session& session, const Handle& handle, Qt::KeyboardModifiers modifiers);
  void insert_point(Session& session, const CurvePlace& place, const QPoint& at);
  void begin_stroke(const QPoint& at);
  void move(const QMouseEvent& event);
  void release();
  void let_go();
  void double_click(const QMouseEvent& event);
  void give_mouse(bool to_host);
  bool key(int key);
  bool key_event(QEvent* event);
  struct Picked {
    Session* session;
    std::optional<talweg::editing::Point> point;  // none: beside the mesh
  };
  static bool is_target(int id);
  Session* alone();
  std::optional<Picked> picked_by_us(const QPoint& at);
  std::optional<Picked> picked_by_host(const QPoint& at);
  bool pick(const QPoint& at, Session*& session, talweg::editing::Point& point);
  [[nodiscard]] std::optional<Handle> handle_near(const QPoint& at) const;
  [[nodiscard]] std::optional<CurvePlace> curve_near(const QPoint& at) const;
  void hint(const std::optional<Handle>& handle, const std::optional<CurvePlace>& curve);
  void reach(const QPoint& at, const std::optional<Handle>& handle);
  void reach_no_more();

  std::unique_ptr<talweg::editing::Plugins> plugins_;
  std::map<int, std::unique_ptr<Session>> sessions_;   // by mesh
  int current_ = -1;                                   // the mesh that the panel shows
  talweg::openflipper::TalwegPanel* panel_ = nullptr;  // the host's
  QAction *draw_action_ = nullptr, *selection_action_ = nullptr, *line_action_ = nullptr;
  QMenu *mesh_menu_ = nullptr, *line_menu_ = nullptr;
  int menu_object_ = -1;
  QTimer timer_;
  QTranslator translator_;
  double busy_since_ = 0;
  bool job_shown_ = false;
  bool updating_ = false;  // what the host says is updated is our own doing
  std::optional<Handle> dragged_;
  std::optional<CurvePlace> pressed_curve_;  // a click on it if the mouse moves no more
  QPoint pressed_at_;
  bool painting_ = false;
  bool show_points_ = true;
  bool reaching_ = false;    // the scene shows a leg to the mouse
  bool drops_moves_ = true;  // whether Qt does, but for a stroke
  QPoint last_painted_;
  talweg::openflipper::ViewHand view_hand_{[this](bool host) { give_mouse(host); }};
  QString hint_;
};
