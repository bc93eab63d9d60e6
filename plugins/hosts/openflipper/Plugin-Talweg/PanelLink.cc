#include "PanelLink.hh"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "CurveRows.hh"
#include "EditNames.hh"
#include "Report.hh"
#include "SavedSettings.hh"

namespace talweg::openflipper {

using editing::Editor;

namespace {

std::optional<double> own(bool set, double value) {
  return set ? std::optional<double>(value) : std::nullopt;
}

/// Runs short work while the mouse pointer shows that the program is busy.
void use(Session* session, const std::function<void(Session&)>& work) {
  if (session == nullptr) return;
  QApplication::setOverrideCursor(Qt::WaitCursor);
  work(*session);
  QApplication::restoreOverrideCursor();
}

}  // namespace

PanelLink::PanelLink(Sessions& sessions, DrawingHand& hand, HostCalls& host)
    : sessions_(sessions), hand_(hand), host_(host) {
  panel_->setObjectName("talwegPanel");
  connect_drawing();
  connect_use();
  connect_settings();
  connect_curves();
  connect_look();
}

void PanelLink::connect_drawing() {
  connect(panel_, &TalwegPanel::draw_toggled, this, [this](bool on) { hand_.set_draws(on); });
  connect(panel_, &TalwegPanel::finish, this, [this] { hand_.key(Qt::Key_Return); });
  connect(panel_, &TalwegPanel::close_curve, this,
          [this] { sessions_.edit([](Editor& e) { e.close_curve(); }); });
  connect(panel_, &TalwegPanel::take_back, this, [this] { hand_.key(Qt::Key_Backspace); });
  connect(panel_, &TalwegPanel::discard, this, [this] { hand_.key(Qt::Key_Escape); });
  connect(panel_, &TalwegPanel::from_selection, this, [this] {
    if (Session* session = sessions_.target()) session->add_selection();
  });
  const auto from_faces = [this](bool selected) {
    if (Session* session = sessions_.target()) session->add_face_borders(selected);
  };
  connect(panel_, &TalwegPanel::from_face_selection, this, [from_faces] { from_faces(true); });
  connect(panel_, &TalwegPanel::from_face_colours, this, [from_faces] { from_faces(false); });
  connect(panel_, &TalwegPanel::from_lines, this, &PanelLink::from_lines);
  connect(panel_, &TalwegPanel::undo, this, [this] {
    if (Session* session = sessions_.now()) session->undo();
  });
  connect(panel_, &TalwegPanel::redo, this, [this] {
    if (Session* session = sessions_.now()) session->redo();
  });
}

void PanelLink::connect_use() {
  connect(panel_, &TalwegPanel::cut, this,
          [this] { use(sessions_.now(), [](Session& s) { s.cut(false); }); });
  connect(panel_, &TalwegPanel::select_inside, this,
          [this] { use(sessions_.now(), [](Session& s) { s.cut(true); }); });
  connect(panel_, &TalwegPanel::split, this, [this](bool lids) {
    use(sessions_.now(), [lids](Session& s) {
      std::vector<int> parts;
      s.split(lids, parts);
    });
  });
  connect(panel_, &TalwegPanel::offset, this, [this](double distance, const QString& side) {
    use(sessions_.now(), [&](Session& s) {
      std::vector<int> lines;
      s.offset({distance, side}, lines);
    });
  });
  connect(panel_, &TalwegPanel::repair, this, [this] {
    if (Session* session = sessions_.now()) session->repair();
  });
  connect(panel_, &TalwegPanel::write_result, this, [this] { write(true); });
  connect(panel_, &TalwegPanel::cancel, this, &PanelLink::cancel);
}

void PanelLink::connect_settings() {
  connect(panel_, &TalwegPanel::gesture_begun, this,
          [this](const QString& name) { sessions_.begin_gesture(name); });
  connect(panel_, &TalwegPanel::gesture_ended, this, [this] { sessions_.end_gesture(); });
  connect(panel_, &TalwegPanel::tau_changed, this, [this](double tau) {
    if (sessions_.now() == nullptr) return save_settings({tau, {}, {}});
    sessions_.edit([tau](Editor& e) { e.set_tau(tau); });
  });
  connect(panel_, &TalwegPanel::slack_changed, this, [this](bool set, double value) {
    sessions_.edit([&](Editor& e) { e.set_slack(own(set, value)); });
  });
  connect(panel_, &TalwegPanel::max_deviation_changed, this, [this](bool set, double value) {
    sessions_.edit([&](Editor& e) { e.set_max_deviation(own(set, value)); });
  });
  connect(panel_, &TalwegPanel::click_distance_changed, this, [this](bool set, double value) {
    sessions_.edit([&](Editor& e) { e.set_click_distance(own(set, value)); });
  });
  connect(panel_, &TalwegPanel::ends_changed, this, [this](int ends) {
    sessions_.edit([&](Editor& e) { e.set_ends(static_cast<editing::Ends>(ends)); });
  });
  connect(panel_, &TalwegPanel::ridges_changed, this,
          [this](double strength) { sessions_.edit([&](Editor& e) { e.set_ridges(strength); }); });
  connect(panel_, &TalwegPanel::ridge_kind_changed, this, [this](int kind) {
    sessions_.edit([&](Editor& e) { e.set_ridge_kind(static_cast<editing::RidgeKind>(kind)); });
  });
}

void PanelLink::connect_curves() {
  const CurvesBox* box = panel_->curves();
  connect(box, &CurvesBox::read, this, &PanelLink::read);
  connect(box, &CurvesBox::write, this, [this] { write(false); });
  connect(box, &CurvesBox::clear, this, [this] { sessions_.edit([](Editor& e) { e.clear(); }); });
  connect(box, &CurvesBox::selected, this, [this](unsigned number) {
    if (Session* session = sessions_.now()) session->select(index_of(session->drawing(), number));
  });
  connect(box, &CurvesBox::renamed, this, [this](unsigned number, const QString& name) {
    sessions_.edit([&](Editor& e) {
      const auto curve = index_of(e.drawing(), number);
      if (curve) e.rename_curve(*curve, name.toStdString());
    });
  });
  connect(box, &CurvesBox::gesture_begun, this,
          [this](const QString& name) { sessions_.begin_gesture(name); });
  connect(box, &CurvesBox::gesture_ended, this, [this] { sessions_.end_gesture(); });
  using Index = std::size_t;
  connect(box, &CurvesBox::remove, this,
          [this] { sessions_.edit_selected([](Editor& e, Index c) { e.remove_curve(c); }); });
  connect(box, &CurvesBox::pin, this, [this](bool on) {
    sessions_.edit_selected([on](Editor& e, Index c) { e.pin_curve(c, on); });
  });
  connect(box, &CurvesBox::set_closed, this, [this](bool on) {
    sessions_.edit_selected([on](Editor& e, Index c) { e.set_closed(c, on); });
  });
  connect(box, &CurvesBox::go_on, this, [this] {
    sessions_.edit_selected([](Editor& e, Index c) { e.continue_curve(c); });
    hand_.set_draws(true);
  });
  connect(box, &CurvesBox::tau_changed, this, [this](bool set, double tau) {
    sessions_.edit_selected([&](Editor& e, Index c) { e.set_curve_tau(c, own(set, tau)); });
  });
  connect(box, &CurvesBox::tolerance_changed, this, [this](bool set, double tolerance) {
    sessions_.edit_selected(
        [&](Editor& e, Index c) { e.set_curve_tolerance(c, own(set, tolerance)); });
  });
}

void PanelLink::connect_look() {
  const LookBox* box = panel_->look();
  connect(box, &LookBox::colour_by, this, [this](int what) {
    if (Session* session = sessions_.now()) session->colour_by(static_cast<ColourBy>(what));
  });
  connect(box, &LookBox::points, this, [this](bool with) { sessions_.show_points(with); });
  connect(box, &LookBox::comb, this, [this](bool with) {
    if (Session* session = sessions_.now()) session->show_comb(with);
  });
  connect(box, &LookBox::mark, this, [this](int what) {
    if (Session* session = sessions_.now()) session->mark_largest(static_cast<Mark>(what));
  });
}

// ---- Display

void PanelLink::show(const QString& hint) {
  PanelState state;
  state.drawing_mode = hand_.draws();
  state.hint = hint;
  state.settings = saved_settings();
  if (const Session* session = sessions_.now()) {
    show_session(*session, state);
    show_results(*session, state);
    save_settings(state.settings);
  }
  state.look.points = sessions_.with_points();
  panel_->show_state(state);
}

void PanelLink::show_session(const Session& session, PanelState& state) {
  const editing::History& history = session.editor().history();
  state.mesh = session.name();
  state.settings = session.drawing().settings;
  state.scale = session.diagonal() / 10;
  state.mean_edge = session.mean_edge();
  state.unfinished = session.editor().is_drawing();
  state.can_undo = session.can_undo();
  state.can_redo = history.can_redo();
  state.undo_name = name_of_edit(history.undo_name());
  state.redo_name = name_of_edit(history.redo_name());
  state.curves = curves_state(session);
  state.all_clicked = editing::all_clicked(session.drawing());
  state.look = look_state(session);
  state.problem = session.problem();
  state.repair_told = session.repair_told();
}

void PanelLink::show_results(const Session& session, PanelState& state) {
  const host::Results& results = session.results();
  state.rows = result_rows(session);
  state.summary = result_summary(session);
  state.summary_tip = result_settings(session);
  state.notes = result_notes(session);
  if (results.curves.empty()) return;
  state.slack_used = results.number("slack");
  state.deviation_now = results.number("farthest", -1, -1);
}

LookState PanelLink::look_state(const Session& session) {
  const Inspection& inspection = session.inspection();
  LookState state;
  state.coloured_by = static_cast<int>(session.colours().by());
  state.most = session.colours().scale().most;
  state.unit = session.colours().scale().unit;
  state.comb = inspection.with_combs();
  if (state.comb && inspection.longest_tooth() > 0) {
    state.comb_text =
        tr("up to %1 %2").arg(three_digits(inspection.longest_tooth()), curvature_unit());
  }
  state.mark = static_cast<int>(inspection.mark());
  const Inspection::Marked& marked = inspection.marked();
  if (!marked.at) return state;
  const bool bend = inspection.mark() == Mark::kCurvature;
  state.mark_text =
      QString("%1 %2").arg(three_digits(marked.value), bend ? curvature_unit() : length_unit());
  const auto curve = index_of(session.drawing(), marked.curve);
  if (curve) state.mark_text += ", " + title_of(*session.drawing().curves[*curve]);
  return state;
}

// ---- Curves from other objects, and files

void PanelLink::from_lines() {
  Session* session = sessions_.target();
  if (session == nullptr) return;
  bool found = false;
  for (PluginFunctions::ObjectIterator it(PluginFunctions::TARGET_OBJECTS, DATA_POLY_LINE);
       it != PluginFunctions::objectsEnd(); ++it) {
    if (session->owns(it->id())) continue;
    session->add_line(*PluginFunctions::polyLine(*it));
    found = true;
  }
  if (!found) host_.warn(tr("Make a polyline the target first."));
}

QString PanelLink::kinds() {
  return tr("Curves (*.json *.vtp *.vtk *.obj *.ply *.mrk.json *.fcsv *.border *.txt)");
}

void PanelLink::read() {
  Session* session = sessions_.target();
  if (session == nullptr) return;
  const QString path =
      QFileDialog::getOpenFileName(panel_, tr("Read curves"), saved_folder(), kinds());
  if (path.isEmpty()) return;
  save_folder(QFileInfo(path).absolutePath());
  session->read_drawing(path);
}

void PanelLink::write(bool result) {
  Session* session = sessions_.now();
  if (session == nullptr) return;
  QString path = QFileDialog::getSaveFileName(panel_, tr("Write curves"), saved_folder(), kinds());
  if (path.isEmpty()) return;
  save_folder(QFileInfo(path).absolutePath());
  if (QFileInfo(path).suffix().isEmpty()) path += ".json";
  if (result) {
    session->wait();
    session->write_result(path);
  } else {
    session->write_drawing(path);
  }
}

}  // namespace talweg::openflipper
