// What is under the mouse: a place on a mesh, a drawn point, a curve.
#include <algorithm>
#include <cmath>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "ScreenLine.hh"
#include "TalwegPlugin.hh"

using talweg::openflipper::NearSegment;
using talweg::openflipper::Session;
namespace editing = talweg::editing;
namespace host = talweg::host;

namespace {

constexpr double kReach = 8;      // pixels, of points
constexpr double kLineReach = 5;  // of curves

ACG::GLState& active_view() {
  const int viewer = static_cast<int>(PluginFunctions::activeExaminer());
  return PluginFunctions::viewerProperties(viewer).glState();
}

QPointF on_screen(ACG::GLState& view, const ACG::Vec3d& place) {
  const ACG::Vec3d s = view.project(place);
  return {s[0], view.context_height() - s[1]};
}

}  // namespace

bool TalwegPlugin::is_target(int id) {
  BaseObjectData* object = nullptr;
  return PluginFunctions::getObject(id, object) && object->target();
}

/// The session whose mesh is the only thing that the mouse can meet, so that its own tree of
/// triangles says what it meets. The host draws its whole scene for that.
Session* TalwegPlugin::alone() {
  Session* session = existing(current_);
  if (session == nullptr || !session->can_see() || !is_target(current_)) return nullptr;
  for (PluginFunctions::ObjectIterator it(PluginFunctions::ALL_OBJECTS);
       it != PluginFunctions::objectsEnd(); ++it) {
    if (!it->visible() || it->id() == current_ || it->dataType(DATA_POLY_LINE)) continue;
    if (it->dataType(typeId("Light")) || it->dataType(typeId("Camera"))) continue;
    return nullptr;
  }
  return session;
}

std::optional<TalwegPlugin::Picked> TalwegPlugin::picked_by_us(const QPoint& at) {
  Session* session = alone();
  if (session == nullptr) return std::nullopt;
  ACG::GLState& state = active_view();
  const double y = state.context_height() - at.y();
  const ACG::Vec3d eye = state.unproject(ACG::Vec3d(at.x(), y, 0));
  const ACG::Vec3d far = state.unproject(ACG::Vec3d(at.x(), y, 1));
  return Picked{session, session->seen(eye, far - eye)};
}

std::optional<TalwegPlugin::Picked> TalwegPlugin::picked_by_host(const QPoint& at) {
  size_t node = 0, face = 0;
  ACG::Vec3d hit;
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::scenegraphPick(ACG::SceneGraph::PICK_FACE, at, node, face, &hit) ||
      !PluginFunctions::getPickedObject(node, object) || !object->dataType(DATA_TRIANGLE_MESH)) {
    return std::nullopt;
  }
  const Session* now = existing(current_);
  const bool bound = now != nullptr && (now->editor().is_drawing() || dragged_ || painting_);
  if (bound && object->id() != current_) return std::nullopt;
  if (!bound && !object->target()) {
    emit showStatusMessage(tr("Make this mesh the target to draw on it."), 3000);
    return std::nullopt;
  }
  Session* session = session_of(object->id());
  if (session == nullptr || face >= session->arrays().triangles.size()) return std::nullopt;
  return Picked{session,
                talweg::openflipper::picked_on(session->mesh(), static_cast<unsigned>(face), hit)};
}

/// The point under the mouse, on the mesh that is drawn on or, where nothing is drawn now, on any
/// target.
bool TalwegPlugin::pick(const QPoint& at, Session*& session, editing::Point& point) {
  try {
    auto picked = picked_by_us(at);
    if (!picked) picked = picked_by_host(at);
    if (!picked || !picked->point) return false;
    session = picked->session;
    point = *picked->point;
    return true;
  } catch (const editing::Error&) {
    return false;
  }
}

/// The drawn point within a few pixels of the mouse, the nearest one that can be seen.
std::optional<TalwegPlugin::Handle> TalwegPlugin::handle_near(const QPoint& at) const {
  const auto found = sessions_.find(current_);
  if (found == sessions_.end()) return std::nullopt;
  ACG::GLState& view = active_view();
  struct Candidate {
    double away;
    Handle handle;
    ACG::Vec3d eye;  // where one looks from, on the near plane
  };
  std::vector<Candidate> candidates;
  const Session& session = *found->second;
  const auto& curves = session.editor().drawing().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::vector<ACG::Vec3d> positions = session.drawn_positions(c);
    for (std::size_t p = 0; p < positions.size(); ++p) {
      if (!session.shows_point(c, p)) continue;
      const ACG::Vec3d s = view.project(positions[p]);
      const double away = std::hypot(s[0] - at.x(), view.context_height() - s[1] - at.y());
      if (away > kReach) continue;
      candidates.push_back({away, {c, p}, view.unproject(ACG::Vec3d(s[0], s[1], 0))});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.away < b.away; });
  for (const Candidate& candidate : candidates) {
    const auto [c, p] = candidate.handle;
    if (!session.is_hidden(curves[c]->points[p], candidate.eye)) return candidate.handle;
  }
  return std::nullopt;
}

/// The curve within a few pixels of the mouse, as it is smoothed or as it was drawn, the nearest
/// one that can be seen there.
std::optional<TalwegPlugin::CurvePlace> TalwegPlugin::curve_near(const QPoint& at) const {
  const auto found = sessions_.find(current_);
  if (found == sessions_.end()) return std::nullopt;
  const Session& session = *found->second;
  ACG::GLState& view = active_view();
  struct Candidate {
    double away;
    CurvePlace place;
  };
  std::vector<Candidate> candidates;
  for (std::size_t c = 0; c < session.editor().drawing().curves.size(); ++c) {
    for (const host::Curve* line : session.lines_of(c)) {
      std::vector<QPointF> points;
      for (const auto& p : line->positions) {
        points.push_back(on_screen(view, ACG::Vec3d(p[0], p[1], p[2])));
      }
      const NearSegment near = talweg::openflipper::nearest_segment(points, line->closed, at);
      if (near.away <= kLineReach) candidates.push_back({near.away, {c, line, near.segment}});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.away < b.away; });
  for (const Candidate& candidate : candidates) {
    const auto& [curve, line, segment] = candidate.place;
    const auto& p = line->positions[segment];
    const ACG::Vec3d s = view.project(ACG::Vec3d(p[0], p[1], p[2]));
    const ACG::Vec3d eye = view.unproject(ACG::Vec3d(s[0], s[1], 0));
    if (!session.is_hidden({line->faces[segment], line->barycentrics[segment]}, eye)) {
      return candidate.place;
    }
  }
  return std::nullopt;
}
