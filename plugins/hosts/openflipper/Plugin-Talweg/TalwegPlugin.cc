// What scripts can call; the descriptions are what the host's script window shows.
#include <algorithm>
#include <cmath>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "TalwegPlugin.hh"
#include "talweg/editing/curve_files.hpp"

using talweg::editing::Editor;
using talweg::openflipper::Session;
namespace editing = talweg::editing;

namespace {

/// Indices of scripts, where -1 is one that is not there.
std::size_t index(int i) { return i < 0 ? SIZE_MAX : static_cast<std::size_t>(i); }

std::array<double, 3> numbers(const Vector& v) { return {v[0], v[1], v[2]}; }

}  // namespace

bool TalwegPlugin::draw(int meshId, IdList vertices, bool closed) {
  Session* session = session_of(meshId);
  if (session == nullptr) return false;
  emit scriptInfo(QString("draw(%1, [...], %2)").arg(meshId).arg(closed ? "true" : "false"));
  return session->edit([&](Editor& e) {
    std::vector<std::uint32_t> through;
    for (const int v : vertices) {
      if (v < 0) throw editing::Error("Vertices are counted from 0.");
      through.push_back(static_cast<std::uint32_t>(v));
    }
    editing::Curve curve{editing::points_at(session->arrays(), through), closed};
    for (editing::Point& point : curve.points) point.exact = 0;
    e.add_curve(std::move(curve));
  });
}

bool TalwegPlugin::addPoint(int meshId, int face, Vector barycentric) {
  return edit(meshId, [&](Editor& e) {
    e.add_point(editing::picked(static_cast<std::uint32_t>(face), numbers(barycentric)));
  });
}

bool TalwegPlugin::finishCurve(int meshId) {
  return edit(meshId, [](Editor& e) { e.finish_curve(); });
}

bool TalwegPlugin::closeCurve(int meshId) {
  return edit(meshId, [](Editor& e) { e.close_curve(); });
}

bool TalwegPlugin::takeBackPoint(int meshId) {
  return edit(meshId, [](Editor& e) { e.take_back_point(); });
}

bool TalwegPlugin::dropCurve(int meshId) {
  return edit(meshId, [](Editor& e) { e.drop_curve(); });
}

bool TalwegPlugin::fromSelection(int meshId) {
  Session* session = session_of(meshId);
  if (session == nullptr) return false;
  session->add_selection();
  return session->last_error().isEmpty();
}

bool TalwegPlugin::fromFaceSelection(int meshId) {
  Session* session = session_of(meshId);
  if (session == nullptr) return false;
  session->add_face_borders(true);
  return session->last_error().isEmpty();
}

bool TalwegPlugin::fromFaceColours(int meshId) {
  Session* session = session_of(meshId);
  if (session == nullptr) return false;
  session->add_face_borders(false);
  return session->last_error().isEmpty();
}

bool TalwegPlugin::fromPolyLine(int meshId, int polyLineId) {
  Session* session = session_of(meshId);
  const PolyLineObject* line = PluginFunctions::polyLineObject(polyLineId);
  if (session == nullptr || line == nullptr) {
    warn(tr("There is no polyline with the id %1.").arg(polyLineId));
    return false;
  }
  session->add_line(*PluginFunctions::polyLineObject(polyLineId)->line());
  session->wait();
  return session->last_error().isEmpty();
}

bool TalwegPlugin::removeCurve(int meshId, int curve) {
  return edit(meshId, [&](Editor& e) { e.remove_curve(index(curve)); });
}

bool TalwegPlugin::clear(int meshId) {
  return edit(meshId, [](Editor& e) { e.clear(); });
}

bool TalwegPlugin::movePoint(int meshId, int curve, int point, int face, Vector barycentric) {
  return edit(meshId, [&](Editor& e) {
    e.move_point(index(curve), index(point),
                 editing::picked(static_cast<std::uint32_t>(face), numbers(barycentric)));
  });
}

bool TalwegPlugin::setPinned(int meshId, int curve, int point, bool pinned) {
  return edit(meshId, [&](Editor& e) { e.set_pinned(index(curve), index(point), pinned); });
}

bool TalwegPlugin::setClosed(int meshId, int curve, bool closed) {
  return edit(meshId, [&](Editor& e) { e.set_closed(index(curve), closed); });
}

bool TalwegPlugin::setTau(int meshId, double tau) {
  emit scriptInfo(QString("setTau(%1, %2)").arg(meshId).arg(tau));
  return edit(meshId, [&](Editor& e) { e.set_tau(tau); });
}

bool TalwegPlugin::setSlack(int meshId, double slack) {
  return edit(meshId, [&](Editor& e) {
    e.set_slack(slack < 0 ? std::nullopt : std::optional<double>(slack));
  });
}

bool TalwegPlugin::setMaxDeviation(int meshId, double bound) {
  return edit(meshId, [&](Editor& e) {
    e.set_max_deviation(bound > 0 ? std::optional<double>(bound) : std::nullopt);
  });
}

bool TalwegPlugin::setEnds(int meshId, QString ends) {
  return edit(meshId, [&](Editor& e) { e.set_ends(editing::ends_named(ends.toStdString())); });
}

bool TalwegPlugin::setClickDistance(int meshId, double distance) {
  return edit(meshId, [&](Editor& e) {
    e.set_click_distance(distance < 0 ? std::nullopt : std::optional<double>(distance));
  });
}

bool TalwegPlugin::undoEdit(int meshId) {
  Session* session = existing(meshId);
  return session != nullptr && session->undo();
}

bool TalwegPlugin::redoEdit(int meshId) {
  Session* session = existing(meshId);
  return session != nullptr && session->redo();
}

bool TalwegPlugin::repairMesh(int meshId) {
  Session* session = session_of(meshId);
  if (session == nullptr) return false;
  emit scriptInfo(QString("repairMesh(%1)").arg(meshId));
  session->repair();
  session->wait();
  return session->problem().isEmpty();
}

IdList TalwegPlugin::smooth(int meshId) {
  Session* session = session_of(meshId);
  if (session == nullptr) return {};
  session->wait();
  emit scriptInfo(QString("smooth(%1)").arg(meshId));
  if (!session->work_error().isEmpty()) return {};
  return session->lines();
}

QString TalwegPlugin::report(int meshId) {
  Session* session = existing(meshId);
  if (session == nullptr) return {};
  session->wait();
  return whole_report(*session);
}

double TalwegPlugin::measure(int meshId, QString key) {
  Session* session = existing(meshId);
  if (session == nullptr) return std::nan("");
  session->wait();
  return session->results().number(key.toStdString(), -1, std::nan(""));
}

QString TalwegPlugin::lastError(int meshId) {
  Session* session = existing(meshId);
  if (session == nullptr) return {};
  session->wait();
  return session->last_error();
}

bool TalwegPlugin::writeResult(int meshId, QString filename) {
  Session* session = existing(meshId);
  if (session == nullptr) return false;
  session->wait();
  return session->attempt([&] {
    editing::write_curves(*plugins_, filename.toStdString(), session->results().curves);
    say(tr("Wrote %1.").arg(filename));
  });
}

bool TalwegPlugin::writeDrawing(int meshId, QString filename) {
  Session* session = existing(meshId);
  if (session == nullptr) return false;
  return session->attempt([&] {
    editing::write_curves(*plugins_, filename.toStdString(),
                          drawn_curves(session->arrays(), session->editor().drawing()));
    say(tr("Wrote %1.").arg(filename));
  });
}

bool TalwegPlugin::readDrawing(int meshId, QString filename) {
  Session* session = session_of(meshId);
  if (session == nullptr) return false;
  const bool read = session->attempt(
      [&] { session->add_curves(editing::read_curves(*plugins_, filename.toStdString())); });
  if (OpenFlipper::Options::nogui()) session->wait();
  return read && session->last_error().isEmpty();
}

bool TalwegPlugin::cut(int meshId) {
  Session* session = existing(meshId);
  if (session == nullptr) return false;
  session->wait();
  emit scriptInfo(QString("cut(%1)").arg(meshId));
  return session->cut(false);
}

bool TalwegPlugin::selectInside(int meshId) {
  Session* session = existing(meshId);
  if (session == nullptr) return false;
  session->wait();
  emit scriptInfo(QString("selectInside(%1)").arg(meshId));
  return session->cut(true);
}

IdList TalwegPlugin::split(int meshId, bool lids) {
  Session* session = existing(meshId);
  IdList parts;
  if (session == nullptr) return parts;
  session->wait();
  emit scriptInfo(QString("split(%1, %2)").arg(meshId).arg(lids ? "true" : "false"));
  session->split(lids, parts);
  return parts;
}

void TalwegPlugin::describe(const char* slot, const QString& what, const char* parameters,
                            const QString& meanings) {
  emit setSlotDescription(slot, what, QString(parameters).split(';'), meanings.split(';'));
}

void TalwegPlugin::describe_slots() {
  describe_curve_slots();
  describe_look_slots();
  const QString mesh = tr("id of a triangle mesh");
  const QString curve_point = mesh + tr(";curve, from 0;point, from 0;");
  describe("draw(int,IdList,bool)", tr("Adds a curve through vertices, straight over the faces."),
           "meshId;vertices;closed", mesh + tr(";vertices from 0;whether it comes back"));
  describe("addPoint(int,int,Vector)", tr("Adds a point to the curve that is being drawn."),
           "meshId;face;barycentric", mesh + tr(";face from 0;its coordinates there"));
  describe("finishCurve(int)", tr("Ends the curve that is being drawn."), "meshId", mesh);
  describe("closeCurve(int)", tr("Closes the curve that is being drawn."), "meshId", mesh);
  describe("takeBackPoint(int)", tr("Takes the last point back."), "meshId", mesh);
  describe("dropCurve(int)", tr("Drops the curve that is being drawn."), "meshId", mesh);
  describe("fromSelection(int)", tr("Curves from selected vertices or edges."), "meshId", mesh);
  describe("fromFaceSelection(int)", tr("Curves along the border of the selected faces."), "meshId",
           mesh);
  describe("fromFaceColours(int)", tr("Curves along the borders between face colours."), "meshId",
           mesh);
  describe("fromPolyLine(int,int)", tr("A curve from a polyline, put onto the mesh."),
           "meshId;polyLineId", mesh + tr(";id of a polyline"));
  describe("removeCurve(int,int)", tr("Removes a curve."), "meshId;curve", mesh + tr(";from 0"));
  describe("clear(int)", tr("Removes all curves."), "meshId", mesh);
  describe("movePoint(int,int,int,int,Vector)", tr("Moves a drawn point."),
           "meshId;curve;point;face;barycentric",
           curve_point + tr("face from 0;its coordinates there"));
  describe("setPinned(int,int,int,bool)", tr("Pins a drawn point, or lets it go."),
           "meshId;curve;point;pinned", curve_point + tr("whether the result passes through it"));
  describe("setClosed(int,int,bool)", tr("Closes or opens a curve."), "meshId;curve;closed",
           mesh + tr(";from 0;whether it comes back"));
  describe("setTau(int,double)", tr("0: straight lines; more keeps closer to the drawing."),
           "meshId;tau", mesh + tr(";0 or more"));
  describe(
      "setSlack(int,double)", tr("How exact the drawing is."), "meshId;slack",
      mesh + tr(";mesh units; negative: from the drawing").replace("; negative", ", negative"));
  describe("setMaxDeviation(int,double)", tr("The largest deviation; chooses tau and slack."),
           "meshId;bound", mesh + tr(";mesh units, 0: no bound"));
  describe("setEnds(int,QString)", tr("What becomes of the ends of curves that are not closed."),
           "meshId;ends",
           mesh + tr(";auto: painted strokes that come back are loops, closed: all are, open"));
  describe("setClickDistance(int,double)",
           tr("Clicks that follow each other within this distance are one."), "meshId;distance",
           mesh + tr(";mesh units, negative: an edge of the mesh"));
  describe("undoEdit(int)", tr("Takes the last edit back."), "meshId", mesh);
  describe("redoEdit(int)", tr("Does it again."), "meshId", mesh);
  describe("repairMesh(int)",
           tr("Draws on the mesh as if it was repaired, if it is no surface; the mesh stays."),
           "meshId", mesh);
  describe("smooth(int)", tr("Waits for the smoothed curves and returns their polylines' ids."),
           "meshId", mesh);
  describe("report(int)", tr("Everything that was measured, one \"key = value\" a line."), "meshId",
           mesh);
  describe("measure(int,QString)", tr("One number of the report, for all curves together."),
           "meshId;key", mesh + tr(";such as length_after"));
  describe("lastError(int)", tr("Why the last edit or smoothing failed; empty if it did not."),
           "meshId", mesh);
  describe("writeResult(int,QString)", tr("Writes the smoothed curves."), "meshId;filename",
           mesh + tr(";.json, .vtp, .vtk, .obj, .ply, .mrk.json"));
  describe("writeDrawing(int,QString)", tr("Writes the drawn points."), "meshId;filename",
           mesh + tr(";as writeResult"));
  describe("readDrawing(int,QString)", tr("Adds the curves of a file."), "meshId;filename",
           mesh + tr(";as writeResult, or .txt"));
  describe("cut(int)", tr("Makes the smoothed curves edges of the mesh, and selects them."),
           "meshId", mesh);
  describe("selectInside(int)", tr("Cuts, and selects the faces inside the closed curves."),
           "meshId", mesh);
  describe("split(int,bool)", tr("Makes a mesh of each part that the smoothed curves leave."),
           "meshId;lids", mesh + tr(";whether the parts are closed where they were cut"));
  describe("drawMode(bool)", tr("Begins or ends drawing with the mouse."), "on", tr("whether"));
}
