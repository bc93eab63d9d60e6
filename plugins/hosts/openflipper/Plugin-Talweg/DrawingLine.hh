// The drawing line is the host's object for a drawing: a polyline with the points of the last
// curve, for files and scripts, and with the host's list of undo and redo.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>

#include "HostCalls.hh"
#include "talweg/editing/history.hpp"
#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::openflipper {

class DrawingLine {
 public:
  using GoTo = std::function<void(std::uint64_t number)>;
  /// `go_to` is called where the host's list goes to a state of the history.
  DrawingLine(HostCalls& host, const QString& mesh_name, const editing::History& history,
              GoTo go_to);

  [[nodiscard]] int id() const { return id_; }  ///< -1: there is none
  [[nodiscard]] bool is_hidden() const;
  /// Whether that object was the line, which a person has deleted.
  bool was_deleted(int id);
  /// The scene does not show the points: between them the line is a chord through the body.
  void show(const editing::Drawing& drawing, const TriMesh& mesh,
            const editing::MeshArrays& arrays);

  /// The host's list gets the state that is there now. A new list begins with the one before.
  void keep(const editing::History& history);
  /// The host's list is at that state.
  void is_at(std::uint64_t number) { kept_ = number; }
  /// By the host's list; false where the state is not on it.
  bool undo(const editing::History& history);
  bool redo(const editing::History& history);
  /// Another history, which needs another list, and so another line. Returns the line before, which
  /// is to be removed; -1: there is none.
  int begin_anew(const editing::History& history);

 private:
  HostCalls& host_;
  QString name_;
  std::shared_ptr<GoTo> go_to_;  // the line with the host's list may outlive this object
  std::uint64_t first_;          // the state with which the host's list begins
  std::uint64_t kept_;           // the state that it has last
  int id_ = -1;
};

}  // namespace talweg::openflipper
