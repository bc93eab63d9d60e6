// How curves look: colours, combs, where something is largest; from the panel and by scripts.
#include <cmath>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/BasePlugin/PluginFunctionsViewControls.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "CurveRows.hh"
#include "ResultTable.hh"
#include "TalwegPlugin.hh"

using talweg::openflipper::ColourBy;
using talweg::openflipper::LookBox;
using talweg::openflipper::LookState;
using talweg::openflipper::Mark;
using talweg::openflipper::Session;

void TalwegPlugin::connect_look() {
  const LookBox* box = panel_->look();
  connect(box, &LookBox::colour_by, this, [this](int what) {
    if (Session* session = existing(current_)) session->colour_by(static_cast<ColourBy>(what));
  });
  connect(box, &LookBox::points, this, &TalwegPlugin::show_points);
  connect(box, &LookBox::comb, this, [this](bool with) {
    if (Session* session = existing(current_)) session->show_comb(with);
  });
  connect(box, &LookBox::mark, this, [this](int what) {
    if (Session* session = existing(current_)) session->mark_largest(static_cast<Mark>(what));
  });
}

LookState TalwegPlugin::look_state(const Session& session) {
  LookState state;
  state.coloured_by = static_cast<int>(session.coloured_by());
  state.most = session.scale().most;
  state.unit = session.scale().unit;
  state.comb = session.with_comb();
  if (session.with_comb() && session.longest_tooth() > 0) {
    state.comb_text = tr("up to %1 %2")
                          .arg(talweg::openflipper::three_digits(session.longest_tooth()),
                               talweg::openflipper::curvature_unit());
  }
  state.mark = static_cast<int>(session.mark());
  const Session::Marked& marked = session.marked();
  if (!marked.at) return state;
  const auto& drawing = session.editor().drawing();
  const auto curve = talweg::openflipper::index_of(drawing, marked.curve);
  const bool bend = session.mark() == Mark::kCurvature;
  state.mark_text = QString("%1 %2").arg(
      talweg::openflipper::three_digits(marked.value),
      bend ? talweg::openflipper::curvature_unit() : talweg::openflipper::length_unit());
  if (curve) state.mark_text += ", " + talweg::openflipper::title_of(*drawing.curves[*curve]);
  return state;
}

/// As near as before, with the place in the middle.
void TalwegPlugin::look_at(const ACG::Vec3d& place, const ACG::Vec3d& normal) {
  if (!OpenFlipper::Options::gui()) return;
  const int viewer = static_cast<int>(PluginFunctions::activeExaminer());
  const double away =
      (PluginFunctions::eyePos(viewer) - PluginFunctions::sceneCenter(viewer)).norm();
  ACG::Vec3d up = PluginFunctions::upVector(viewer);
  if ((up % normal).norm() < 0.1) up = ACG::Vec3d(normal[1], normal[2], normal[0]);
  PluginFunctions::lookAt(place + normal * away, place, up, viewer);
}

// ---- Scripts

bool TalwegPlugin::colourBy(int meshId, QString what) {
  Session* session = existing(meshId);
  const QStringList names = {"nothing", "deviation", "distance", "potential"};
  const auto at = names.indexOf(what);
  if (session == nullptr || at < 0) {
    warn(tr("Colours are: %1.").arg(names.join(", ")));
    return false;
  }
  session->colour_by(static_cast<ColourBy>(at));
  session->wait();
  return true;
}

bool TalwegPlugin::showComb(int meshId, bool with) {
  Session* session = existing(meshId);
  if (session == nullptr) return false;
  session->show_comb(with);
  session->wait();
  return true;
}

Vector TalwegPlugin::largest(int meshId, QString what) {
  Session* session = existing(meshId);
  const QStringList names = {"nothing", "deviation", "curvature"};
  const auto at = names.indexOf(what);
  const double none = std::nan("");
  if (session == nullptr || at < 0) {
    warn(tr("What is largest is: %1.").arg(names.join(", ")));
    return Vector(none, none, none);
  }
  session->wait();
  session->mark_largest(static_cast<Mark>(at));
  session->wait();
  return session->marked().at.value_or(Vector(none, none, none));
}

void TalwegPlugin::describe_look_slots() {
  const QString mesh = tr("id of a triangle mesh");
  describe("colourBy(int,QString)", tr("Colours the curves or the mesh."), "meshId;what",
           mesh + tr(";nothing, deviation, distance or potential"));
  describe("showComb(int,bool)", tr("Shows combs of curvature along the curves."), "meshId;with",
           mesh + tr(";whether"));
  describe("largest(int,QString)", tr("Marks where it is largest, and tells the place."),
           "meshId;what", mesh + tr(";nothing, deviation or curvature"));
}
