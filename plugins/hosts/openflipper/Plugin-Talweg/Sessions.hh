// The sessions are the drawings of all meshes of the host, and which of them a person works on.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "Session.hh"

namespace talweg::openflipper {

/// Whether that object of the host is a target of what people do.
bool is_target(int object_id);

class Sessions {
 public:
  explicit Sessions(HostCalls& host) : host_(host) {}

  /// Finds the plugins.
  void begin();
  /// Waits for threads, though not for ever.
  void end();

  /// The drawing on a mesh, begun where there is none; null, and told, where that cannot be. It is
  /// the one that is worked on then.
  Session* of(int mesh_id);
  [[nodiscard]] Session* existing(int mesh_id) const;
  /// The one that is worked on, which the panel shows; null: none.
  [[nodiscard]] Session* now() const { return existing(now_); }
  /// The mesh of that one, or -1.
  [[nodiscard]] int mesh_now() const { return now_; }
  /// The one on a target; begun where there is none.
  Session* target();
  [[nodiscard]] const std::map<int, std::unique_ptr<Session>>& all() const { return sessions_; }

  /// An edit of the one that is worked on; false where there is none, or it cannot be done.
  bool edit(const std::function<void(editing::Editor&)>& change);
  /// The same, of its selected curve.
  void edit_selected(const std::function<void(editing::Editor&, std::size_t curve)>& change);
  void begin_gesture(const QString& name);
  void end_gesture();

  void show_points(bool with);
  [[nodiscard]] bool with_points() const { return with_points_; }

  void clear();
  /// An object of the host is gone. True if it was a mesh that was drawn on, or an object of ours.
  bool object_deleted(int id);

 private:
  HostCalls& host_;
  std::unique_ptr<editing::Plugins> plugins_;
  std::map<int, std::unique_ptr<Session>> sessions_;  // by mesh
  int now_ = -1;                                      // a mesh
  bool with_points_ = true;
};

}  // namespace talweg::openflipper
