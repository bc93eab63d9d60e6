// What is done with single curves, from the panel and by scripts.
#include <cmath>

#include "CurveRows.hh"
#include "TalwegPlugin.hh"

using talweg::editing::Editor;
using talweg::openflipper::CurvesBox;
using talweg::openflipper::Session;
namespace editing = talweg::editing;

namespace {

/// Indices of scripts, where -1 is one that is not there.
std::size_t index(int i) { return i < 0 ? SIZE_MAX : static_cast<std::size_t>(i); }

/// Of scripts, where a negative number is none.
std::optional<double> own(double value) {
  return value < 0 ? std::nullopt : std::optional<double>(value);
}

std::optional<double> own(bool set, double value) {
  return set ? std::optional<double>(value) : std::nullopt;
}

}  // namespace

void TalwegPlugin::connect_curves() {
  const CurvesBox* box = panel_->curves();
  connect(box, &CurvesBox::read, this, [this] { ask_for_file(false, false); });
  connect(box, &CurvesBox::write, this, [this] { ask_for_file(true, false); });
  connect(box, &CurvesBox::clear, this, [this] { edit_now([](Editor& e) { e.clear(); }); });
  connect(box, &CurvesBox::selected, this, [this](unsigned number) {
    if (Session* session = existing(current_)) {
      session->select(talweg::openflipper::index_of(session->editor().drawing(), number));
    }
  });
  connect(box, &CurvesBox::renamed, this, [this](unsigned number, const QString& name) {
    edit_now([&](Editor& e) {
      const auto curve = talweg::openflipper::index_of(e.drawing(), number);
      if (curve) e.rename_curve(*curve, name.toStdString());
    });
  });
  connect(box, &CurvesBox::gesture_begun, this, &TalwegPlugin::begin_gesture);
  connect(box, &CurvesBox::gesture_ended, this, &TalwegPlugin::end_gesture);
  using Index = std::size_t;
  connect(box, &CurvesBox::remove, this,
          [this] { edit_selected([](Editor& e, Index c) { e.remove_curve(c); }); });
  connect(box, &CurvesBox::pin, this,
          [this](bool on) { edit_selected([on](Editor& e, Index c) { e.pin_curve(c, on); }); });
  connect(box, &CurvesBox::set_closed, this,
          [this](bool on) { edit_selected([on](Editor& e, Index c) { e.set_closed(c, on); }); });
  connect(box, &CurvesBox::go_on, this, [this] {
    edit_selected([](Editor& e, Index c) { e.continue_curve(c); });
    drawMode(true);
  });
  connect(box, &CurvesBox::tau_changed, this, [this](bool set, double tau) {
    edit_selected([&](Editor& e, Index c) { e.set_curve_tau(c, own(set, tau)); });
  });
  connect(box, &CurvesBox::tolerance_changed, this, [this](bool set, double tolerance) {
    edit_selected([&](Editor& e, Index c) { e.set_curve_tolerance(c, own(set, tolerance)); });
  });
}

void TalwegPlugin::edit_selected(const std::function<void(Editor&, std::size_t)>& change) {
  Session* session = existing(current_);
  const auto curve = session == nullptr ? std::nullopt : session->selected();
  if (curve) session->edit([&](Editor& e) { change(e, *curve); });
}

void TalwegPlugin::begin_gesture(const QString& name) {
  if (Session* session = existing(current_)) session->begin_gesture(name.toUtf8().constData());
}

void TalwegPlugin::end_gesture() {
  if (Session* session = existing(current_)) session->end_gesture();
}

void TalwegPlugin::show_points(bool with) {
  show_points_ = with;
  OpenFlipperSettings().setValue("Plugin-Talweg/points", with);
  for (auto& [mesh, session] : sessions_) session->show_points(with);
  changed();
}

// ---- Scripts

bool TalwegPlugin::renameCurve(int meshId, int curve, QString name) {
  return edit(meshId, [&](Editor& e) { e.rename_curve(index(curve), name.toStdString()); });
}

bool TalwegPlugin::pinCurve(int meshId, int curve, bool pinned) {
  return edit(meshId, [&](Editor& e) { e.pin_curve(index(curve), pinned); });
}

bool TalwegPlugin::continueCurve(int meshId, int curve) {
  return edit(meshId, [&](Editor& e) { e.continue_curve(index(curve)); });
}

bool TalwegPlugin::setCurveTau(int meshId, int curve, double tau) {
  return edit(meshId, [&](Editor& e) { e.set_curve_tau(index(curve), own(tau)); });
}

bool TalwegPlugin::setCurveTolerance(int meshId, int curve, double tolerance) {
  return edit(meshId, [&](Editor& e) { e.set_curve_tolerance(index(curve), own(tolerance)); });
}

bool TalwegPlugin::insertPoint(int meshId, int curve, int before, int face, Vector barycentric) {
  return edit(meshId, [&](Editor& e) {
    e.insert_point(index(curve), index(before),
                   editing::picked(static_cast<std::uint32_t>(face),
                                   {barycentric[0], barycentric[1], barycentric[2]}));
  });
}

bool TalwegPlugin::removePoint(int meshId, int curve, int point) {
  return edit(meshId, [&](Editor& e) { e.remove_point(index(curve), index(point)); });
}

double TalwegPlugin::measureCurve(int meshId, int curve, QString key) {
  Session* session = existing(meshId);
  if (session == nullptr) return std::nan("");
  session->wait();
  const auto& curves = session->editor().drawing().curves;
  if (index(curve) >= curves.size()) return std::nan("");
  const auto result = session->result_of(curves[index(curve)]->number);
  if (!result) return std::nan("");
  return session->results().number(key.toStdString(), static_cast<int>(*result), std::nan(""));
}

void TalwegPlugin::describe_curve_slots() {
  const QString curve = tr("id of a triangle mesh") + tr(";from 0");
  describe("renameCurve(int,int,QString)", tr("Gives a curve a name."), "meshId;curve;name",
           curve + tr(";empty: none"));
  describe("pinCurve(int,int,bool)", tr("Pins all points of a curve, or lets all go."),
           "meshId;curve;pinned", curve + tr(";whether the result passes through them"));
  describe("continueCurve(int,int)", tr("Draws on at the end of a curve, which is the last then."),
           "meshId;curve", curve);
  describe("setCurveTau(int,int,double)", tr("Gives a curve a tau of its own."), "meshId;curve;tau",
           curve + tr(";0 or more, negative: as all curves"));
  describe("setCurveTolerance(int,int,double)", tr("Gives a curve a tolerance of its own."),
           "meshId;curve;tolerance", curve + tr(";mesh units, negative: none"));
  describe(
      "insertPoint(int,int,int,int,Vector)", tr("Inserts a point into a curve."),
      "meshId;curve;before;face;barycentric",
      curve + tr(";the point before which it comes, from 0;face from 0;its coordinates there"));
  describe("removePoint(int,int,int)", tr("Removes a point of a curve."), "meshId;curve;point",
           curve + tr(";from 0"));
  describe("measureCurve(int,int,QString)", tr("One number of the report, for one curve."),
           "meshId;curve;key", curve + tr(";such as length_after"));
}
