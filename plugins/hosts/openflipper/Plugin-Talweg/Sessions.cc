#include "Sessions.hh"

#include <QCoreApplication>
#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "SavedSettings.hh"

namespace talweg::openflipper {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Sessions)
};

}  // namespace

bool is_target(int object_id) {
  BaseObjectData* object = nullptr;
  return PluginFunctions::getObject(object_id, object) && object->target();
}

void Sessions::begin() {
  plugins_ = std::make_unique<editing::Plugins>();
  with_points_ = saved_points();
}

void Sessions::end() {
  sessions_.clear();
  plugins_.reset();
}

Session* Sessions::existing(int mesh_id) const {
  const auto found = sessions_.find(mesh_id);
  return found == sessions_.end() ? nullptr : found->second.get();
}

Session* Sessions::of(int mesh_id) {
  Session* session = existing(mesh_id);
  if (session == nullptr) {
    TriMeshObject* object = nullptr;
    if (!PluginFunctions::getObject(mesh_id, object) || object == nullptr) {
      host_.warn(Words::tr("There is no triangle mesh with the id %1.").arg(mesh_id));
      return nullptr;
    }
    try {
      auto made = std::make_unique<Session>(host_, *plugins_, *object, saved_settings());
      session = sessions_.emplace(mesh_id, std::move(made)).first->second.get();
    } catch (const std::exception& error) {
      host_.warn(QString::fromStdString(error.what()));
      return nullptr;
    }
    session->show_points(with_points_);
  }
  now_ = mesh_id;
  return session;
}

Session* Sessions::target() {
  if (now() != nullptr && is_target(now_)) return now();
  for (PluginFunctions::ObjectIterator it(PluginFunctions::TARGET_OBJECTS, DATA_TRIANGLE_MESH);
       it != PluginFunctions::objectsEnd(); ++it) {
    return of(it->id());
  }
  host_.warn(Words::tr("Make a triangle mesh the target first."));
  return nullptr;
}

bool Sessions::edit(const std::function<void(editing::Editor&)>& change) {
  return now() != nullptr && now()->edit(change);
}

void Sessions::edit_selected(const std::function<void(editing::Editor&, std::size_t)>& change) {
  const auto curve = now() == nullptr ? std::nullopt : now()->selected();
  if (curve) edit([&](editing::Editor& editor) { change(editor, *curve); });
}

void Sessions::begin_gesture(const QString& name) {
  if (now() != nullptr) now()->begin_gesture(name.toUtf8().constData());
}

void Sessions::end_gesture() {
  if (now() != nullptr) now()->end_gesture();
}

void Sessions::show_points(bool with) {
  with_points_ = with;
  save_points(with);
  for (const auto& [mesh, session] : sessions_) session->show_points(with);
  host_.changed();
}

void Sessions::clear() {
  sessions_.clear();
  now_ = -1;
}

bool Sessions::object_deleted(int id) {
  if (sessions_.erase(id) > 0) {
    if (now_ == id) now_ = -1;
    return true;
  }
  for (const auto& [mesh, session] : sessions_) {
    if (!session->owns(id)) continue;
    session->object_deleted(id);
    return true;
  }
  return false;
}

}  // namespace talweg::openflipper
