#include "DrawingLine.hh"

#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "DrawingBackup.hh"
#include "HostMesh.hh"

namespace talweg::openflipper {

DrawingLine::DrawingLine(HostCalls& host, const QString& mesh_name, const editing::History& history,
                         GoTo go_to)
    : host_(host),
      name_(QString("%1 drawing").arg(mesh_name)),
      go_to_(std::make_shared<GoTo>(std::move(go_to))),
      first_(history.number()),
      kept_(first_) {}

bool DrawingLine::is_hidden() const {
  BaseObjectData* line = nullptr;
  return id_ >= 0 && PluginFunctions::getObject(id_, line) && line != nullptr && !line->visible();
}

bool DrawingLine::was_deleted(int id) {
  if (id_ < 0 || id != id_) return false;
  id_ = -1;
  return true;
}

void DrawingLine::show(const editing::Drawing& drawing, const TriMesh& mesh,
                       const editing::MeshArrays& arrays) {
  if (id_ < 0) {
    if (drawing.curves.empty()) return;
    id_ = host_.add_line(name_);
    if (PolyLineObject* made = PluginFunctions::polyLineObject(id_)) {
      made->setObjectDrawMode(ACG::SceneGraph::DrawModes::NONE, true);
      made->enablePicking(false);
    }
  }
  PolyLineObject* object = PluginFunctions::polyLineObject(id_);
  if (object == nullptr) return;
  if (drawing.curves.empty()) {
    object->line()->clear();
  } else {
    fill(*object->line(), mesh, arrays, *drawing.curves.back());
  }
  host_.show_line(id_);
}

void DrawingLine::keep(const editing::History& history) {
  const std::uint64_t number = history.number();
  if (number == kept_) return;
  BaseObjectData* object = nullptr;
  if (id_ >= 0 && PluginFunctions::getObject(id_, object)) {
    const auto restore = [go_to = std::weak_ptr<GoTo>(go_to_)](std::uint64_t to) {
      return [go_to, to] {
        if (const auto there = go_to.lock()) (*there)(to);
      };
    };
    if (!object->hasObjectData(OBJECT_BACKUPS)) first_ = kept_;
    BackupData& backups = backups_of(*object, restore(first_));
    const QString name = QString::fromStdString(history.undo_name());
    backups.storeBackup(new DrawingBackup(object, name, restore(number)));
    host_.push_backup(id_, name);
  }
  kept_ = number;
}

/// Numbers of states grow along the history; states before first_ are not in the host's list.
bool DrawingLine::undo(const editing::History& history) {
  return id_ >= 0 && history.number() > first_ && host_.host_undo(id_);
}

bool DrawingLine::redo(const editing::History& history) {
  return id_ >= 0 && history.number() >= first_ && host_.host_redo(id_);
}

int DrawingLine::begin_anew(const editing::History& history) {
  go_to_ = std::make_shared<GoTo>(*go_to_);
  first_ = kept_ = history.number();
  return std::exchange(id_, -1);
}

}  // namespace talweg::openflipper
