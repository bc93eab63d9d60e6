#include "UnderMouse.hh"

#include <QCoreApplication>
#include <algorithm>
#include <vector>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "talweg/editing/screen_line.hpp"

namespace talweg::openflipper {
namespace {

constexpr double kReach = 8;      // pixels, for points
constexpr double kLineReach = 5;  // pixels, for curves

struct Words {
  Q_DECLARE_TR_FUNCTIONS(UnderMouse)
};

ACG::GLState& active_view() {
  const int viewer = static_cast<int>(PluginFunctions::activeExaminer());
  return PluginFunctions::viewerProperties(viewer).glState();
}

editing::Pixel pixel(const QPoint& at) { return {1.0 * at.x(), 1.0 * at.y()}; }

editing::Pixel on_screen(ACG::GLState& view, const ACG::Vec3d& place) {
  const ACG::Vec3d s = view.project(place);
  return {s[0], view.context_height() - s[1]};
}

/// The point on the near plane from which the place is seen.
ACG::Vec3d eye_for(ACG::GLState& view, const ACG::Vec3d& place) {
  const ACG::Vec3d s = view.project(place);
  return view.unproject(ACG::Vec3d(s[0], s[1], 0));
}

/// An object near the mouse, with its distance.
template <class What>
struct Candidate {
  double away;  // pixels
  What what;
};

template <class What>
void nearest_first(std::vector<Candidate<What>>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.away < b.away; });
}

}  // namespace

/// Whether no object other than the mesh of the current drawing can be under the mouse.
bool UnderMouse::is_alone() const {
  const Session* session = sessions_.now();
  const int mesh = sessions_.mesh_now();
  if (session == nullptr || !session->can_see() || !is_target(mesh)) return false;
  for (PluginFunctions::ObjectIterator it(PluginFunctions::ALL_OBJECTS);
       it != PluginFunctions::objectsEnd(); ++it) {
    if (!it->visible() || it->id() == mesh || it->dataType(DATA_POLY_LINE)) continue;
    if (it->dataType(typeId("Light")) || it->dataType(typeId("Camera"))) continue;
    return false;
  }
  return true;
}

std::optional<Picked> UnderMouse::picked_by_us(const QPoint& at) {
  if (!is_alone()) return std::nullopt;
  ACG::GLState& state = active_view();
  const double y = state.context_height() - at.y();
  const ACG::Vec3d eye = state.unproject(ACG::Vec3d(at.x(), y, 0));
  const ACG::Vec3d far = state.unproject(ACG::Vec3d(at.x(), y, 1));
  return Picked{sessions_.now(), sessions_.now()->seen(eye, far - eye)};
}

std::optional<Picked> UnderMouse::picked_by_host(const QPoint& at, bool held) {
  size_t node = 0, face = 0;
  ACG::Vec3d hit;
  BaseObjectData* object = nullptr;
  if (!PluginFunctions::scenegraphPick(ACG::SceneGraph::PICK_FACE, at, node, face, &hit) ||
      !PluginFunctions::getPickedObject(node, object) || !object->dataType(DATA_TRIANGLE_MESH)) {
    return std::nullopt;
  }
  const Session* now = sessions_.now();
  const bool bound = now != nullptr && (held || now->editor().is_drawing());
  if (bound && object->id() != sessions_.mesh_now()) return std::nullopt;
  if (!bound && !object->target()) {
    host_.tell(Words::tr("Make this mesh the target to draw on it."));
    return std::nullopt;
  }
  Session* session = sessions_.of(object->id());
  if (session == nullptr || face >= session->arrays().triangles.size()) return std::nullopt;
  return Picked{session, picked_on(session->mesh(), static_cast<unsigned>(face), hit)};
}

std::optional<Picked> UnderMouse::picked(const QPoint& at, bool held) {
  try {
    auto found = picked_by_us(at);
    if (!found) found = picked_by_host(at, held);
    return found && found->point ? found : std::nullopt;
  } catch (const editing::Error&) {
    return std::nullopt;
  }
}

std::optional<Handle> UnderMouse::handle(const QPoint& at) const {
  const Session* session = sessions_.now();
  if (session == nullptr) return std::nullopt;
  ACG::GLState& view = active_view();
  std::vector<Candidate<Handle>> candidates;
  const auto& curves = session->drawing().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t p = 0; p < curves[c]->points.size(); ++p) {
      if (!session->shows_point(c, p)) continue;
      const ACG::Vec3d place = vector_at(session->arrays(), curves[c]->points[p]);
      const double away = editing::distance(on_screen(view, place), pixel(at));
      if (away <= kReach) candidates.push_back({away, {c, p}});
    }
  }
  nearest_first(candidates);
  for (const auto& candidate : candidates) {
    const editing::Point& point = curves[candidate.what.curve]->points[candidate.what.point];
    const ACG::Vec3d eye = eye_for(view, vector_at(session->arrays(), point));
    if (!session->is_hidden(point, eye)) return candidate.what;
  }
  return std::nullopt;
}

std::optional<CurvePlace> UnderMouse::curve(const QPoint& at) const {
  const Session* session = sessions_.now();
  if (session == nullptr) return std::nullopt;
  ACG::GLState& view = active_view();
  std::vector<Candidate<CurvePlace>> candidates;
  for (std::size_t c = 0; c < session->drawing().curves.size(); ++c) {
    for (const host::Curve* line : session->lines_of(c)) {
      std::vector<editing::Pixel> points;
      for (const auto& p : line->positions) {
        points.push_back(on_screen(view, ACG::Vec3d(p[0], p[1], p[2])));
      }
      const auto near = editing::nearest_segment(points, line->closed, pixel(at));
      if (near.away <= kLineReach) candidates.push_back({near.away, {c, line, near.segment}});
    }
  }
  nearest_first(candidates);
  for (const auto& candidate : candidates) {
    const auto& [curve, line, segment] = candidate.what;
    const auto& p = line->positions[segment];
    const ACG::Vec3d eye = eye_for(view, ACG::Vec3d(p[0], p[1], p[2]));
    if (!session->is_hidden({line->faces[segment], line->barycentrics[segment]}, eye)) {
      return candidate.what;
    }
  }
  return std::nullopt;
}

}  // namespace talweg::openflipper
