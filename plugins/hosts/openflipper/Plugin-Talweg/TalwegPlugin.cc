#include "TalwegPlugin.hh"

#include <cmath>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>
#include <OpenFlipper/common/GlobalOptions.hh>

#include "Report.hh"
#include "ScriptHelp.hh"

using talweg::editing::Editor;
using talweg::openflipper::ColourBy;
using talweg::openflipper::Mark;
using talweg::openflipper::Session;
namespace editing = talweg::editing;

namespace {

/// An index from a script, where -1 stands for none.
std::size_t index(int i) { return i < 0 ? SIZE_MAX : static_cast<std::size_t>(i); }

/// A value from a script, where a negative number stands for none.
std::optional<double> own(double value) {
  return value < 0 ? std::nullopt : std::optional<double>(value);
}

editing::Point picked(int face, const Vector& at) {
  return editing::picked(static_cast<std::uint32_t>(face), {at[0], at[1], at[2]});
}

}  // namespace

void TalwegPlugin::pluginsInitialized() {
  for (const auto& [slot, what, parameters, meanings] : talweg::openflipper::script_help()) {
    emit setSlotDescription(slot, what, QString(parameters).split(';'), meanings.split(';'));
  }
  HostLink::pluginsInitialized();
}

bool TalwegPlugin::edit(int mesh_id, const std::function<void(Editor&)>& change) {
  Session* session = sessions_.of(mesh_id);
  return session != nullptr && session->edit(change);
}

Session* TalwegPlugin::done(int mesh_id) {
  Session* session = sessions_.existing(mesh_id);
  if (session != nullptr) session->wait();
  return session;
}

// ---- Drawing

bool TalwegPlugin::draw(int meshId, IdList vertices, bool closed) {
  Session* session = sessions_.of(meshId);
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
  return edit(meshId, [&](Editor& e) { e.add_point(picked(face, barycentric)); });
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
  Session* session = sessions_.of(meshId);
  if (session == nullptr) return false;
  session->add_selection();
  return session->last_error().isEmpty();
}

bool TalwegPlugin::fromFaceSelection(int meshId) {
  Session* session = sessions_.of(meshId);
  if (session == nullptr) return false;
  session->add_face_borders(true);
  return session->last_error().isEmpty();
}

bool TalwegPlugin::fromFaceColours(int meshId) {
  Session* session = sessions_.of(meshId);
  if (session == nullptr) return false;
  session->add_face_borders(false);
  return session->last_error().isEmpty();
}

bool TalwegPlugin::fromPolyLine(int meshId, int polyLineId) {
  Session* session = sessions_.of(meshId);
  const PolyLineObject* line = PluginFunctions::polyLineObject(polyLineId);
  if (session == nullptr || line == nullptr) {
    warn(tr("There is no polyline with the id %1.").arg(polyLineId));
    return false;
  }
  session->add_line(*PluginFunctions::polyLineObject(polyLineId)->line());
  session->wait();
  return session->last_error().isEmpty();
}

void TalwegPlugin::drawMode(bool on) { hand_.set_draws(on); }

bool TalwegPlugin::undoEdit(int meshId) {
  Session* session = sessions_.existing(meshId);
  return session != nullptr && session->undo();
}

bool TalwegPlugin::redoEdit(int meshId) {
  Session* session = sessions_.existing(meshId);
  return session != nullptr && session->redo();
}

// ---- Curves and points

bool TalwegPlugin::removeCurve(int meshId, int curve) {
  return edit(meshId, [&](Editor& e) { e.remove_curve(index(curve)); });
}

bool TalwegPlugin::clear(int meshId) {
  return edit(meshId, [](Editor& e) { e.clear(); });
}

bool TalwegPlugin::renameCurve(int meshId, int curve, QString name) {
  return edit(meshId, [&](Editor& e) { e.rename_curve(index(curve), name.toStdString()); });
}

bool TalwegPlugin::pinCurve(int meshId, int curve, bool pinned) {
  return edit(meshId, [&](Editor& e) { e.pin_curve(index(curve), pinned); });
}

bool TalwegPlugin::continueCurve(int meshId, int curve) {
  return edit(meshId, [&](Editor& e) { e.continue_curve(index(curve)); });
}

bool TalwegPlugin::setClosed(int meshId, int curve, bool closed) {
  return edit(meshId, [&](Editor& e) { e.set_closed(index(curve), closed); });
}

bool TalwegPlugin::setCurveTau(int meshId, int curve, double tau) {
  return edit(meshId, [&](Editor& e) { e.set_curve_tau(index(curve), own(tau)); });
}

bool TalwegPlugin::setCurveTolerance(int meshId, int curve, double tolerance) {
  return edit(meshId, [&](Editor& e) { e.set_curve_tolerance(index(curve), own(tolerance)); });
}

bool TalwegPlugin::movePoint(int meshId, int curve, int point, int face, Vector barycentric) {
  return edit(meshId, [&](Editor& e) {
    e.move_point(index(curve), index(point), picked(face, barycentric));
  });
}

bool TalwegPlugin::setPinned(int meshId, int curve, int point, bool pinned) {
  return edit(meshId, [&](Editor& e) { e.set_pinned(index(curve), index(point), pinned); });
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

// ---- Settings

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

bool TalwegPlugin::setRidges(int meshId, double strength) {
  return edit(meshId, [&](Editor& e) { e.set_ridges(strength); });
}

bool TalwegPlugin::setRidgeKind(int meshId, QString kind) {
  return edit(meshId,
              [&](Editor& e) { e.set_ridge_kind(editing::ridges_named(kind.toStdString())); });
}

// ---- Results

IdList TalwegPlugin::smooth(int meshId) {
  Session* session = sessions_.of(meshId);
  if (session == nullptr) return {};
  session->wait();
  emit scriptInfo(QString("smooth(%1)").arg(meshId));
  if (!session->work_error().isEmpty()) return {};
  return session->lines();
}

QString TalwegPlugin::report(int meshId) {
  Session* session = done(meshId);
  if (session == nullptr) return {};
  return whole_report(*session);
}

double TalwegPlugin::measure(int meshId, QString key) {
  Session* session = done(meshId);
  if (session == nullptr) return std::nan("");
  return session->results().number(key.toStdString(), -1, std::nan(""));
}

double TalwegPlugin::measureCurve(int meshId, int curve, QString key) {
  Session* session = done(meshId);
  if (session == nullptr) return std::nan("");
  const auto& curves = session->drawing().curves;
  if (index(curve) >= curves.size()) return std::nan("");
  const auto result = session->result_of(curves[index(curve)]->number);
  if (!result) return std::nan("");
  return session->results().number(key.toStdString(), static_cast<int>(*result), std::nan(""));
}

QString TalwegPlugin::lastError(int meshId) {
  Session* session = done(meshId);
  if (session == nullptr) return {};
  return session->last_error();
}

bool TalwegPlugin::writeResult(int meshId, QString filename) {
  Session* session = done(meshId);
  return session != nullptr && session->write_result(filename);
}

bool TalwegPlugin::writeDrawing(int meshId, QString filename) {
  Session* session = sessions_.existing(meshId);
  return session != nullptr && session->write_drawing(filename);
}

bool TalwegPlugin::readDrawing(int meshId, QString filename) {
  Session* session = sessions_.of(meshId);
  if (session == nullptr) return false;
  const bool read = session->read_drawing(filename);
  if (OpenFlipper::Options::nogui()) session->wait();
  return read && session->last_error().isEmpty();
}

// ---- The mesh

bool TalwegPlugin::repairMesh(int meshId) {
  Session* session = sessions_.of(meshId);
  if (session == nullptr) return false;
  emit scriptInfo(QString("repairMesh(%1)").arg(meshId));
  session->repair();
  session->wait();
  return session->problem().isEmpty();
}

bool TalwegPlugin::cut(int meshId) {
  Session* session = done(meshId);
  if (session == nullptr) return false;
  emit scriptInfo(QString("cut(%1)").arg(meshId));
  return session->cut(false);
}

bool TalwegPlugin::selectInside(int meshId) {
  Session* session = done(meshId);
  if (session == nullptr) return false;
  emit scriptInfo(QString("selectInside(%1)").arg(meshId));
  return session->cut(true);
}

IdList TalwegPlugin::split(int meshId, bool lids) {
  Session* session = done(meshId);
  IdList parts;
  if (session == nullptr) return parts;
  emit scriptInfo(QString("split(%1, %2)").arg(meshId).arg(lids ? "true" : "false"));
  session->split(lids, parts);
  return parts;
}

IdList TalwegPlugin::offset(int meshId, double distance, QString side) {
  Session* session = done(meshId);
  IdList lines;
  if (session == nullptr) return lines;
  emit scriptInfo(QString("offset(%1, %2, \"%3\")").arg(meshId).arg(distance).arg(side));
  session->offset({distance, side}, lines);
  return lines;
}

// ---- How curves look

bool TalwegPlugin::colourBy(int meshId, QString what) {
  Session* session = sessions_.existing(meshId);
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
  Session* session = sessions_.existing(meshId);
  if (session == nullptr) return false;
  session->show_comb(with);
  session->wait();
  return true;
}

Vector TalwegPlugin::largest(int meshId, QString what) {
  Session* session = sessions_.existing(meshId);
  const QStringList names = {"nothing", "deviation", "curvature"};
  const auto at = names.indexOf(what);
  const double none = std::nan("");
  if (session == nullptr || at < 0) {
    warn(tr("largest() takes the id of a mesh with a drawing, and one of: %1.")
             .arg(names.join(", ")));
    return Vector(none, none, none);
  }
  session->wait();
  session->mark_largest(static_cast<Mark>(at));
  session->wait();
  return session->inspection().marked().at.value_or(Vector(none, none, none));
}
