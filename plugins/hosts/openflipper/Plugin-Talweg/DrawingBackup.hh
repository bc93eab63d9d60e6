// A drawing backup is a state of a drawing on the host's list of undo and redo.
#pragma once

#include <cstdint>
#include <functional>

#include <OpenFlipper/common/BackupData.hh>
#include <OpenFlipper/common/BaseBackup.hh>

namespace talweg::openflipper {

/// Polylines have no backups of their own. Applying one brings the drawing to its state.
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

/// The list of an object, made with its first state where there is none yet.
inline BackupData& backups_of(BaseObjectData& object, std::function<void()> restore_original) {
  if (!object.hasObjectData(OBJECT_BACKUPS)) {
    auto* made = new BackupData(&object);  // the object's
    object.setObjectData(OBJECT_BACKUPS, made);
    made->storeBackup(new DrawingBackup(&object, "Original Object", std::move(restore_original)));
  }
  return *dynamic_cast<BackupData*>(object.objectData(OBJECT_BACKUPS));
}

}  // namespace talweg::openflipper
