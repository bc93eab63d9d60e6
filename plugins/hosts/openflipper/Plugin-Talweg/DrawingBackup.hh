// A state of a drawing in the host's list for undo and redo.
#pragma once

#include <cstdint>
#include <functional>

#include <OpenFlipper/common/BackupData.hh>
#include <OpenFlipper/common/BaseBackup.hh>

namespace talweg::openflipper {

/// The host has no backups of polylines. Applying a backup sets the drawing to its state.
class DrawingBackup : public BaseBackup {
 public:
  DrawingBackup(BaseObjectData* object, const QString& name, std::function<void()> restore)
      : BaseBackup(object, name, UPDATE_ALL), restore_(std::move(restore)) {}

  void apply() override {
    BaseBackup::apply();
    restore_();
  }

 private:
  std::function<void()> restore_;
};

/// The list of an object. A new list begins with the present state.
inline BackupData& backups_of(BaseObjectData& object, std::function<void()> restore_original) {
  if (!object.hasObjectData(OBJECT_BACKUPS)) {
    auto* made = new BackupData(&object);  // owned by the object
    object.setObjectData(OBJECT_BACKUPS, made);
    made->storeBackup(new DrawingBackup(&object, "Original Object", std::move(restore_original)));
  }
  return *dynamic_cast<BackupData*>(object.objectData(OBJECT_BACKUPS));
}

}  // namespace talweg::openflipper
